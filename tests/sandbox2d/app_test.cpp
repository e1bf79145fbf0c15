// The program itself by mouse and keys: what is dragged moves, what is pressed happens, and undo mends it.
#include "sandbox2d/app.h"

#include <set>
#include <tuple>

#include "core/image/theme.h"
#include "sandbox2d/gallery.h"
#include "tests/sandbox2d/app_stage.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;

// Of a hand on whole pixels: half of one in each direction, at both ends.
double reach(AppStage& stage) { return 2 * stage.pixel(); }

Document<2> entry_scene(const std::string& scene) {
  for (const GalleryEntry& entry : gallery())
    if (entry.scene == scene) return read_scene(entry);
  ADD_FAILURE() << scene;
  return {};
}

TEST(App, StartsWithTheFirstFigureOfThePapers) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  EXPECT_EQ(bits_of(stage.document()), bits_of(entry_scene("turk2002-fig01-left.json")));
  EXPECT_FALSE(stage.desk().unsaved());
  ASSERT_TRUE(stage.desk().shape().function);
  stage.picture();
  EXPECT_EQ(stage.curve().closed, 1);
  for (Index i = 0; i < 4; ++i) EXPECT_NEAR(stage.f(stage.at(i)), 0, 1e-12);
  EXPECT_NEAR(stage.f(stage.at(4)), 1, 1e-12);
  EXPECT_FALSE(stage.dialog());
}

TEST(App, EveryFigureOpensByAClickOnItsPicture) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 1280, .height = 900});
  AppStage stage(window);
  for (const GalleryEntry& entry : gallery()) {
    SCOPED_TRACE(entry.scene);
    const std::size_t steps = stage.steps();
    stage.play("key f2\nframes 2");
    ASSERT_TRUE(stage.dialog());
    stage.play(std::string("click \"") + entry.title + "\"");
    ASSERT_FALSE(stage.dialog());
    EXPECT_EQ(bits_of(stage.document()), bits_of(read_scene(entry)));
    EXPECT_SAID(stage, entry.try_this);
    EXPECT_FALSE(stage.desk().unsaved());
    EXPECT_TRUE(stage.desk().path().empty()) << "it is a copy";
    // The first is what is shown already.
    EXPECT_EQ(stage.steps(), steps + (&entry == &gallery().front() ? 0 : 1))
        << "one goes from figure to figure and back";
    if (entry.plate) {
      EXPECT_TRUE(stage.app().shown().plate);
      EXPECT_GT(stage.app().layout().plate.width, 100);
    }
    ASSERT_TRUE(stage.desk().shape().function);
    EXPECT_GT(stage.curve().components, 0);
    for (const auto& each : stage.document().constraints)
      EXPECT_NEAR(stage.f(each.constraint.at), each.constraint.value, 1e-9);
  }
  // All the way back.
  for (std::size_t i = 0; i < gallery().size(); ++i) stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), bits_of(read_scene(gallery().front())));
}

TEST(App, AConstraintFollowsTheMouseAndTheCurveFollowsIt) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  stage.picture();
  const std::string before = bits_of(stage.document());
  const double area = stage.curve().area, length = stage.curve().length;
  const Point<2> from = stage.at(0), to = from * 1.4 + Point<2>(0.05, 0.1);
  stage.play(stage.drag(from, to));
  EXPECT_LT((stage.at(0) - to).norm(), reach(stage));
  EXPECT_EQ(stage.desk().gesture(), Gesture::none);
  EXPECT_EQ(stage.steps(), 1u) << "a drag is one step";
  EXPECT_NEAR(stage.f(stage.at(0)), 0, 1e-12);
  EXPECT_GT(std::abs(stage.f(from)), 1e-3) << "the curve has left";
  EXPECT_TRUE(stage.desk().unsaved());
  stage.picture();
  EXPECT_GT(stage.curve().area, 1.02 * area);
  stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), before);
  EXPECT_FALSE(stage.desk().unsaved());
  stage.picture();
  EXPECT_NEAR(stage.curve().area, area, 1e-9);
  EXPECT_NEAR(stage.curve().length, length, 1e-9);
  stage.play("key ctrl+y");
  EXPECT_LT((stage.at(0) - to).norm(), reach(stage));
}

TEST(App, EscapeTakesBackADragInMidAir) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string before = bits_of(stage.document());
  const Point<2> from = stage.at(0);
  stage.play("move " + stage.place(from) + "\npress\nmove " + stage.place(from + Point<2>(0.2, 0.1)) +
             "\nmove " + stage.place(from + Point<2>(0.3, 0.2)));
  EXPECT_NE(bits_of(stage.document()), before);
  stage.play("key escape");
  EXPECT_EQ(bits_of(stage.document()), before);
  stage.play("move " + stage.place(from) + "\nrelease");
  EXPECT_EQ(bits_of(stage.document()), before);
  EXPECT_EQ(stage.steps(), 0u);
}

TEST(App, EveryToolByItsLetter) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  stage.play("key ctrl+n");
  ASSERT_EQ(stage.document().constraints.size(), 0u);
  EXPECT_SAID(stage, "B, I and E");

  const struct {
    const char* key;
    Tool tool;
    ConstraintKind kind;
    double value;
  } kinds[] = {{"b", Tool::boundary, ConstraintKind::boundary, 0},
               {"i", Tool::interior, ConstraintKind::interior, 1},
               {"e", Tool::exterior, ConstraintKind::exterior, -1}};
  Index count = 0;
  for (const auto& [key, tool, kind, value] : kinds) {
    const Point<2> at(-1 + 0.5 * static_cast<double>(count), 0.3);
    stage.play(std::string("key ") + key + "\n" + stage.click(at));
    EXPECT_EQ(stage.desk().tool(), tool);
    ASSERT_EQ(stage.desk().editor().size(), ++count) << key;
    EXPECT_EQ(stage.desk().constraint(count - 1).kind, kind);
    EXPECT_EQ(stage.desk().constraint(count - 1).value, value);
    EXPECT_LT((stage.at(count - 1) - at).norm(), reach(stage));
    EXPECT_EQ(stage.steps(), static_cast<std::size_t>(count));
  }
  // A normal to the boundary constraint, then a boundary constraint with one.
  stage.play("key n\n" + stage.click(stage.at(0)));
  EXPECT_TRUE(stage.desk().constraint(0).normal);
  EXPECT_EQ(stage.desk().editor().size(), count);
  stage.play(stage.drag({1, -1}, {1.4, -1}));
  ASSERT_EQ(stage.desk().editor().size(), ++count);
  ASSERT_TRUE(stage.desk().constraint(3).normal);
  EXPECT_NEAR(stage.desk().constraint(3).normal->direction.normalized().x(), 1, 1e-3);
  // A line and a circle of exterior constraints, the last kind in hand: they end where the hand does.
  const int along = stage.desk().count();
  stage.play("key e\nkey l\n" + stage.drag({-1.4, -1.5}, {0.4, -1.5}));
  ASSERT_EQ(stage.desk().editor().size(), count + along);
  EXPECT_LT((stage.at(count) - Point<2>(-1.4, -1.5)).norm(), reach(stage));
  EXPECT_LT((stage.at(count + along - 1) - Point<2>(0.4, -1.5)).norm(), reach(stage));
  EXPECT_EQ(stage.desk().constraint(count).kind, ConstraintKind::exterior);
  count += along;
  stage.play("key c\n" + stage.drag({-1, 1.2}, {-0.6, 1.2}));
  ASSERT_EQ(stage.desk().editor().size(), count + along);
  for (Index i = count; i < count + along; ++i)
    EXPECT_NEAR((stage.at(i) - Point<2>(-1, 1.2)).norm(), 0.4, reach(stage));
  count += along;
  // The profile is no constraint, panning no change.
  const std::string before = bits_of(stage.document());
  stage.play("key p\n" + stage.drag({-1.5, 0.7}, {1, 0.5}));
  ASSERT_TRUE(stage.desk().profile());
  EXPECT_LT((stage.desk().profile()->from - Point<2>(-1.5, 0.7)).norm(), reach(stage));
  EXPECT_GT(stage.app().layout().profile.width, 100) << "its chart is shown";
  const Point<2> center = stage.desk().view().center();
  stage.play("key h\n" + stage.drag({0, 0}, {0.5, 0}));
  EXPECT_LT((stage.desk().view().center() - (center - Point<2>(0.5, 0))).norm(), reach(stage));
  EXPECT_EQ(bits_of(stage.document()), before);
  // The select tool: a click, a band.
  stage.play("key v\n" + stage.click(stage.at(1)));
  EXPECT_THAT(stage.desk().selection().indices(), ElementsAre(1));
  stage.play(stage.drag({-1.2, 0.15}, {0.4, 0.45}));
  EXPECT_THAT(stage.desk().selection().indices(), ElementsAre(0, 1, 2));
  stage.play("key delete");
  EXPECT_EQ(stage.desk().editor().size(), count - 3);
}

TEST(App, SwitchesByTheirKeys) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const Display<2>& display = stage.desk().display();
  const auto weights = [&] { return stage.app().shown().weights; };
  const std::pair<const char*, std::function<bool()>> switches[] = {
      {"1", [&] { return display.field; }},
      {"2", [&] { return display.isolines; }},
      {"3", [&] { return display.gradient; }},
      {"4", [&] { return display.constraints; }},
      {"6", [&] { return display.scale_bar; }},
      {"7", [&] { return display.grid; }},
      {"w", weights},
      {"t", [&] { return stage.app().shown().plate; }},
      {"shift+p", [&] { return stage.desk().profile().has_value(); }},
      {"f9", [&] { return stage.app().layout().side.width > 0; }},
      {"f10", [&] { return window.dark(); }}};
  const std::string document = bits_of(stage.document());
  const Image plain = stage.picture();
  for (const auto& [key, on] : switches) {
    SCOPED_TRACE(key);
    const bool was = on();
    stage.play(std::string("key ") + key);
    EXPECT_EQ(on(), !was);
    EXPECT_NE(stage.picture(), plain) << "it is seen";
    stage.play(std::string("key ") + key);
    EXPECT_EQ(on(), was);
  }
  EXPECT_EQ(bits_of(stage.document()), document);
  EXPECT_EQ(stage.steps(), 0u) << "how one looks at it is not undone";
  stage.play("key ctrl++\nkey ctrl++");
  EXPECT_NEAR(window.scale(), 1.125 * 1.125, 1e-9);
  stage.play("key ctrl+-\nkey ctrl+-");
  EXPECT_EQ(window.scale(), 1);
}

TEST(App, ThePlateStandsBesideTheScene) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const Rect alone = stage.app().layout().scene;
  stage.play("key t\nframes 3");
  const Layout& layout = stage.app().layout();
  EXPECT_LT(layout.scene.width, alone.width);
  ASSERT_GT(layout.plate.width, 200);
  const auto colors = [&](const Image& image) {
    std::set<std::tuple<int, int, int>> seen;
    for (int y = static_cast<int>(layout.plate.top()); y < layout.plate.bottom(); y += 2)
      for (int x = static_cast<int>(layout.plate.left()); x < layout.plate.right(); x += 2) {
        const std::uint8_t* p = image.pixel(x, y);
        seen.insert({p[0], p[1], p[2]});
      }
    return seen.size();
  };
  EXPECT_GT(colors(stage.picture()), 200u) << "it is lit";
  const Image before = stage.picture();
  // It turns under the hand, and tips with the constraint.
  const std::string document = bits_of(stage.document());
  const std::string middle =
      std::to_string(layout.plate.center().x()) + " " + std::to_string(layout.plate.center().y());
  stage.play("drag " + middle + " " + std::to_string(layout.plate.center().x() + 80) + " " +
             std::to_string(layout.plate.center().y() + 10));
  EXPECT_NE(stage.picture(), before);
  EXPECT_EQ(bits_of(stage.document()), document);
  stage.play("key t");
  EXPECT_EQ(stage.app().layout().scene.width, alone.width);
}

TEST(App, DialogsOpenByTheirKeysAndCloseByEscape) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string before = bits_of(stage.document());
  stage.play(stage.click(stage.at(0)));
  for (const auto& [key, widget] : {std::pair("f1", "Keys and gestures/Close"),
                                    {"f2", "The papers' figures/Close"},
                                    {"enter", "Numbers of a constraint/Apply"},
                                    {"ctrl+o", "Open/Cancel"},
                                    {"ctrl+s", "Save/Cancel"},
                                    {"ctrl+shift+s", "Save/Cancel"},
                                    {"ctrl+shift+e", "Export/Cancel"}}) {
    SCOPED_TRACE(key);
    stage.play(std::string("key ") + key + "\nframes 2");
    EXPECT_TRUE(stage.dialog());
    EXPECT_TRUE(stage.has(widget));
    // Keys are the dialog's while it is open.
    stage.play("key escape\nframes 1");
    if (stage.dialog()) stage.play("key escape\nframes 1");  // out of a field first
    EXPECT_FALSE(stage.dialog());
    EXPECT_FALSE(stage.has(widget));
    EXPECT_THAT(stage.desk().selection().indices(), ElementsAre(0)) << "Escape was the dialog's";
  }
  EXPECT_EQ(bits_of(stage.document()), before);
}

TEST(App, ComparesWithBefore) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const Point<2> from = stage.at(0), probe(0.2, 0.1);
  const double before = stage.f(probe);
  stage.play("key m\n" + stage.drag(from, from * 1.3));
  const Image alone = stage.picture();
  EXPECT_EQ(stage.desk().other(), nullptr);
  stage.play("key o");
  ASSERT_TRUE(stage.desk().other());
  EXPECT_EQ(stage.desk().other_name(), "before");
  EXPECT_EQ(stage.desk().other()->value(probe), before);
  EXPECT_NE(stage.f(probe), before);
  EXPECT_NE(stage.picture(), alone) << "it is drawn, dashed";
  stage.play("key o");
  EXPECT_EQ(stage.desk().other(), nullptr);
  stage.play("key shift+o");
  ASSERT_TRUE(stage.desk().other());
  EXPECT_NE(stage.desk().other_name(), "before");
  EXPECT_GT(std::abs(stage.desk().other()->value(probe) - stage.f(probe)), 1e-6);
}

// Pixels of what is wrong, in that corner of the scene.
int red_in_the_lower_left(AppStage& stage) {
  const Image picture = stage.picture();
  const Rect scene = stage.app().layout().scene;
  int count = 0;
  for (int y = static_cast<int>(scene.bottom()) - 80; y < static_cast<int>(scene.bottom()); ++y)
    for (int x = static_cast<int>(scene.left()); x < static_cast<int>(scene.left()) + 80; ++x) {
      const Color c = picture.at(x, y);
      count +=
          std::abs(c.r - theme::moved.r) + std::abs(c.g - theme::moved.g) + std::abs(c.b - theme::moved.b) <
          0.1;
    }
  return count;
}

TEST(App, AContradictionIsNamedAndTheLastCurveStays) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string before = bits_of(stage.document());
  // On a grid two constraints meet exactly.
  stage.play("key g\n" + stage.drag(stage.at(0), {0.55, 0.05}));
  const Image good = stage.picture();
  const double f_there = stage.f({0.1, 0.1});
  const Point<2> meet = stage.at(0);
  stage.play(stage.drag(stage.at(4), meet));
  EXPECT_EQ(stage.at(4), meet);
  const Shape<2>& shape = stage.desk().shape();
  ASSERT_TRUE(shape.impossible);
  EXPECT_THAT(shape.impossible->culprits, ElementsAre(0, 4));
  EXPECT_FALSE(shape.impossible->message.empty());
  ASSERT_TRUE(shape.function) << "the last one that could be had";
  // During the drag the last solvable place is near the end of it.
  EXPECT_TRUE(std::isfinite(stage.f({0.1, 0.1})));
  EXPECT_NE(stage.picture(), good) << "it is seen";
  // Out of sight they are pointed to from the rim.
  const View2D view = stage.desk().view();
  stage.desk().view().show({Point<2>(20, 20), Point<2>(21, 21)});
  EXPECT_GT(red_in_the_lower_left(stage), 60);
  stage.play("key ctrl+z");
  EXPECT_EQ(red_in_the_lower_left(stage), 0);
  stage.play("key ctrl+shift+z");
  EXPECT_GT(red_in_the_lower_left(stage), 60);
  stage.desk().view() = view;
  stage.play("key u");
  EXPECT_THAT(stage.desk().selection().indices(), ElementsAre(0, 4));
  stage.play("key ctrl+z");
  EXPECT_FALSE(stage.desk().shape().impossible);
  EXPECT_NEAR(stage.f({0.1, 0.1}), f_there, 1e-9);
  stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), before);
}

TEST(App, TheClipboardHoldsJson) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string whole = bits_of(stage.document());
  stage.play(stage.click(stage.at(4)) + "key ctrl+c");
  const Document<2> one = parse_document<2>(window.clipboard());
  ASSERT_EQ(one.constraints.size(), 1u);
  EXPECT_EQ(one.constraints[0].constraint.kind, ConstraintKind::interior);
  EXPECT_EQ(one.constraints[0].constraint.at, stage.at(4));
  stage.play("key ctrl+v");
  EXPECT_EQ(stage.desk().editor().size(), 6);
  EXPECT_NE(stage.at(5), stage.at(4)) << "beside what it was copied from";
  EXPECT_THAT(stage.desk().selection().indices(), ElementsAre(5));
  stage.play("key ctrl+z\nkey ctrl+shift+c");
  EXPECT_EQ(bits_of(parse_document<2>(window.clipboard())), whole);
  stage.play("key ctrl+a\nkey delete\nkey ctrl+shift+v");
  EXPECT_EQ(bits_of(stage.document()), whole);
  // What somebody else put there.
  window.set_clipboard("Dear Ada,");
  stage.play("key ctrl+v");
  EXPECT_TRUE(stage.desk().message().trouble);
  EXPECT_EQ(bits_of(stage.document()), whole);
}

}  // namespace
}  // namespace seesaw
