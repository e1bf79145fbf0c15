// A hundred thousand random events at a desk: presses, moves, releases, wheel, keys, sensible and not. What
// must always hold does, nothing is lost, and undo all the way back equals the start to the bit.
#include <gtest/gtest.h>

#include <map>

#include "core/editing/desk.h"
#include "core/editing/replay.h"
#include "tests/core/editing/documents.h"

namespace seesaw {
namespace {

constexpr int desk_events = 100'000;

class DeskMonkey {
 public:
  explicit DeskMonkey(std::uint64_t seed) : random_(seed) {}

  DeskEvent next(const Desk& desk) {
    const int what = static_cast<int>(random_.index(1000));
    if (pressed_) {
      if (what < 600) return PointerMoved{near(desk), later()};
      if (what < 800) {
        pressed_ = false;
        return PointerUp{place(desk), button_, later()};
      }
      if (what < 830) return WheelTurned{place(desk), random_.normal(), 0, later()};
      if (what < 850) return KeyDown{DeskKey::escape};
      if (what < 860) return FocusLost{};
      return key(desk);
    }
    if (what < 350) {
      pressed_ = true;
      const Index which = random_.index(12);
      button_ = which == 0 ? PointerButton::middle : which == 1 ? PointerButton::right : PointerButton::left;
      return PointerDown{place(desk), button_, held(), random_.index(5) == 0 ? 2 : 1};
    }
    if (what < 420) return PointerMoved{place(desk), held()};
    if (what < 450) return WheelTurned{place(desk), 2 * random_.normal(), random_.normal(), held()};
    if (what < 455) return PointerUp{place(desk), PointerButton::left, held()};
    if (what < 460) return PointerMoved{Point<2>(NAN, 1e308), held()};
    return key(desk);
  }

  Random& random() { return random_; }

 private:
  /// Mostly in the window, often on a constraint, the end of a normal or a corner of the grid.
  Point<2> place(const Desk& desk) {
    const Index n = desk.editor().size(), what = random_.index(10);
    if (n > 0 && what < 5) {
      const Constraint<2>& each = desk.constraint(random_.index(n));
      if (each.normal && random_.index(2)) return spike_end(each, 26, desk.view().pixel());
      return each.at + desk.view().pixel() * 6 * random_.normal() * random_.direction<2>();
    }
    const View2D& view = desk.view();
    if (what == 5) return view.scene_from_pixel({100.0 * static_cast<double>(random_.index(9)), 300});
    return view.scene_from_pixel({random_.uniform(-50, 850), random_.uniform(-50, 650)});
  }
  Point<2> near(const Desk& desk) {
    if (random_.index(4) == 0 || !desk.cursor()) return place(desk);
    return *desk.cursor() + desk.view().pixel() * 20 * random_.normal() * random_.direction<2>();
  }
  Held held() {
    const bool plain = random_.index(2);
    return {!plain && random_.index(3) == 0, !plain && random_.index(2) == 0,
            !plain && random_.index(4) == 0};
  }
  Held later() { return random_.index(3) ? Held{} : held(); }

  DeskEvent key(const Desk& desk) {
    // What is held is let go sooner or later; a crowd is thinned.
    const Index what = random_.index(20);
    if (what < 5) return KeyUp{last_key_};
    if (desk.editor().size() > 14 && what < 12) {
      const bool some = !desk.selection().empty() && desk.selection().size() < 6;
      last_key_ = some ? DeskKey::del : DeskKey::tab;
      return KeyDown{last_key_};
    }
    if (what < 7) {
      last_key_ = random_.index(2) ? DeskKey::z : DeskKey::y;
      return KeyDown{last_key_, {.ctrl = true}, random_.index(4) == 0};
    }
    if (what == 18) return KeyDown{random_.index(2) ? DeskKey::n : DeskKey::del, {.shift = true}};
    // Any key of the table, those that select or paste everything less often; now and then one that is in
    // none.
    if (what == 19) return KeyDown{static_cast<DeskKey>(random_.index(desk_keys)), held()};
    const auto rows = key_bindings();
    const KeyBinding& row = rows[static_cast<std::size_t>(random_.index(static_cast<Index>(rows.size())))];
    const bool heavy = row.command == DeskCommand::paste_scene || row.command == DeskCommand::select_all ||
                       row.command == DeskCommand::fit || row.command == DeskCommand::duplicate;
    if (heavy && random_.index(4)) return KeyDown{DeskKey::v};
    last_key_ = row.key;
    return KeyDown{row.key, row.held, random_.index(4) == 0};
  }

  Random random_;
  bool pressed_ = false;
  PointerButton button_ = PointerButton::left;
  DeskKey last_key_ = DeskKey::v;
};

TEST(DeskRandom, AHundredThousandEventsKeepWhatMustHold) {
  DeskOptions options;
  options.editor.solve_at_once = false;
  options.editor.solver = [](const Constraints<2>& c, FitOptions o) {
    o.condition = false;
    return fit<2>(c, o);
  };
  options.most_constraints = 24;
  Desk desk(start_document<2>(), options);
  desk.view().resize(800, 600);
  desk.fit();
  desk.start_recording();
  const std::string start = bits_of(desk.document());
  std::map<std::uint64_t, std::size_t> hash_of_state = {{0, std::hash<std::string>()(start)}};
  DeskMonkey monkey(2026);
  std::map<Gesture, int> gestures;
  std::map<std::string, int> steps_by_name;
  std::uint64_t revision = desk.revision(), state = 0, messages = 0;
  int commands_left = 0, drags = 0, impossible = 0;

  for (int i = 0; i < desk_events; ++i) {
    // Else it would soon be among constraints 1e40 apart, and stay there.
    if (i % 500 == 499) desk.apply(Restore<2>{start_document<2>()});
    if (i % 500 == 499) desk.fit();
    // Now and then a slider, or a field.
    if (const Index n = desk.editor().size(); n > 0 && i % 40 < 3)
      desk.slide(SetValue{{monkey.random().index(n)}, monkey.random().normal()});
    if (i % 40 == 5) desk.let_go();
    const DeskEvent event = monkey.next(desk);
    const auto steps = static_cast<Index>(desk.editor().undo_size());
    if (desk.handle(event)) ++commands_left;
    if (std::holds_alternative<PointerDown>(event)) ++gestures[desk.gesture()];
    drags += desk.band() || desk.preview().cols() > 0;

    // The selection names what is there.
    Index last = -1;
    for (const Index each : desk.selection().indices()) {
      ASSERT_GT(each, last) << i;
      last = each;
    }
    ASSERT_LT(last, desk.editor().size()) << i;
    ASSERT_LE(desk.editor().size(), 24) << i;
    // The view can be seen through, both ways.
    const View2D& view = desk.view();
    ASSERT_TRUE(view.center().allFinite() && std::isfinite(view.pixel()) && view.pixel() > 0) << i;
    ASSERT_LE((view.pixel_from_scene(view.scene_from_pixel({790, 10})) - Point<2>(790, 10)).norm(), 0.01)
        << i;
    // Revisions and messages only grow; a state is one document.
    ASSERT_GE(desk.revision(), revision) << i;
    ASSERT_GE(desk.message().number, messages) << i;
    revision = desk.revision(), messages = desk.message().number;
    // One event makes, takes back or does again no more than one step.
    ASSERT_LE(std::abs(static_cast<Index>(desk.editor().undo_size()) - steps), 1) << i;
    if (desk.editor().state() != state) {
      state = desk.editor().state();
      const std::string text = bits_of(desk.document());
      const std::size_t hash = std::hash<std::string>()(text);
      ASSERT_EQ(hash_of_state.try_emplace(state, hash).first->second, hash) << i;
      if (i % 20 == 0) {
        ASSERT_EQ(bits_of(parse_document<2>(text)), text) << i;
      }
      if (const char* name = desk.editor().undo_name()) ++steps_by_name[name];
    }
    if (i % 7 == 0) {
      const Hit hit = desk.hover();
      if (hit.over == Over::constraint || hit.over == Over::spike) {
        ASSERT_LT(hit.which, desk.editor().size()) << i;
        ASSERT_GE(hit.which, 0) << i;
        if (hit.over == Over::spike && desk.gesture() == Gesture::none) {
          ASSERT_TRUE(desk.constraint(hit.which).normal) << i;
        }
      }
      if (desk.profile()) {
        ASSERT_TRUE(desk.profile()->from.allFinite() && desk.profile()->to.allFinite()) << i;
      }
    }
    if (i % 50 == 0) {
      impossible += desk.shape().impossible.has_value();
      desk.other();
      ASSERT_EQ(bits_of(parse_document<2>(desk.selection_text())), desk.selection_text()) << i;
    }
  }
  // A monkey that never draws a line would test no lines.
  for (int g = 1; g <= static_cast<int>(Gesture::values); ++g)
    EXPECT_GT(gestures[static_cast<Gesture>(g)], 0) << "gesture " << g;
  for (const char* name : {"add", "move", "move_to", "delete", "set_value", "set_kind", "add_normal",
                           "turn_normal", "remove_normal", "restore"})
    EXPECT_GT(steps_by_name[name], 0) << name;
  EXPECT_GT(commands_left, 0);
  EXPECT_GT(drags, desk_events / 200);
  EXPECT_GT(impossible, 0);

  desk.let_go();
  EXPECT_FALSE(desk.editor().in_gesture());
  const std::string end = bits_of(desk.document());
  // What was recorded gives the same, without a solver.
  ReplayOptions<2> without;
  without.editor.solve_at_once = false;
  without.editor.solver = [](const Constraints<2>&, const FitOptions&) -> Fit<2> {
    throw std::logic_error("asked");
  };
  const Session<2> session = *desk.stop_recording();
  const Editor<2> again = replay(session, without);
  EXPECT_EQ(bits_of(again.document()), end);
  EXPECT_EQ(again.undo_size(), desk.editor().undo_size());
  const std::size_t steps = desk.editor().undo_size();
  EXPECT_GT(steps, static_cast<std::size_t>(desk_events / 100));
  while (desk.editor().undo_size() > 0) {
    desk.perform(DeskCommand::undo);
    const auto known = hash_of_state.find(desk.editor().state());
    if (known != hash_of_state.end()) {
      ASSERT_EQ(std::hash<std::string>()(bits_of(desk.document())), known->second);
    }
    ASSERT_TRUE(desk.selection().empty() || desk.selection().indices().back() < desk.editor().size());
  }
  EXPECT_EQ(bits_of(desk.document()), start);
  EXPECT_EQ(desk.editor().state(), 0u);
  while (desk.editor().undo_size() < steps) desk.perform(DeskCommand::redo);
  EXPECT_EQ(bits_of(desk.document()), end);
  RecordProperty("steps", static_cast<int>(steps));
}

}  // namespace
}  // namespace seesaw
