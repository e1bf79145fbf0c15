// Ten thousand random actions, sensible and not: what must always hold does, nothing is lost, and undo all
// the way back equals the start to the bit.
#include <gtest/gtest.h>

#include <map>

#include "core/editing/replay.h"
#include "tests/core/editing/documents.h"

namespace seesaw {
namespace {

// Under the sanitizers, where a solve takes twenty times as long, a quarter finds what is theirs to find.
#ifdef __SANITIZE_ADDRESS__
constexpr int actions = 2'500;
#else
constexpr int actions = 10'000;
#endif

template <int Dim>
class Monkey {
 public:
  explicit Monkey(std::uint64_t seed) : random_(seed) {}

  Command<Dim> next(const Editor<Dim>& editor) {
    const Index n = editor.size();
    const int what = n > 18 ? 100 : static_cast<int>(random_.index(100));
    if (what < 12) return undo_or_redo();
    if (what < 24) return gesture(editor);
    if (what < 44) return Action<Dim>(Move<Dim>{some(n), 0.3 * random_.normal() * random_.direction<Dim>()});
    if (what < 52) return Action<Dim>(MoveTo<Dim>{one(n), place()});
    if (what < 58) return Action<Dim>(Add<Dim>{fresh()});
    if (what < 60) return Action<Dim>(AddOnSurface<Dim>{3 * random_.direction<Dim>(), toward()});
    if (what < 65) return Action<Dim>(AddNormal{one(n)});
    if (what < 70)
      return Action<Dim>(SetNormal<Dim>{one(n), {number() * random_.direction<Dim>(), number(), number()}});
    if (what < 76) return Action<Dim>(TurnNormal<Dim>{one(n), number() * random_.direction<Dim>(), maybe()});
    if (what < 80) return Action<Dim>(RemoveNormal{some(n)});
    if (what < 86) return Action<Dim>(SetKind{some(n), kind(), std::nullopt});
    if (what < 92) return Action<Dim>(SetValue{some(n), number()});
    if (what < 94) return Action<Dim>(SetKernel{all_kernels[random_.index(3)]});
    if (what < 96) return Action<Dim>(SetSmoothing{random_.index(2) ? 0.0 : number()});
    if (what < 97) return Action<Dim>(Restore<Dim>{start_document<Dim>()});
    if (what < 98) return Label{"here"};
    return Action<Dim>(Delete{some(n)});
  }

 private:
  Command<Dim> undo_or_redo() {
    if (random_.index(2)) return Undo{};
    return Redo{};
  }
  Command<Dim> gesture(const Editor<Dim>& editor) {
    if (!editor.in_gesture() && random_.index(8)) return BeginGesture{};
    if (random_.index(4)) return EndGesture{};
    return CancelGesture{};
  }
  // Now and then one that is not there.
  Index one(Index n) { return random_.index(n + 1 + (random_.index(20) == 0)); }
  std::vector<Index> some(Index n) {
    std::vector<Index> result;
    for (Index left = 1 + random_.index(3); left > 0; --left) result.push_back(one(n));
    return result;
  }
  // Corners of a lattice too, so that constraints meet.
  Point<Dim> place() {
    Point<Dim> p = 1.5 * random_.normal() * random_.direction<Dim>();
    if (random_.index(3) == 0) p = p.array().round();
    return p;
  }
  double number() {
    const double all[] = {1, -1, 0.5, 0.01, 0, -0.0, 1e-12, 1e12, 1.0 / 3};
    return random_.index(2) ? random_.normal() : all[random_.index(9)];
  }
  std::optional<double> maybe() {
    if (random_.index(2)) return std::nullopt;
    return number();
  }
  ConstraintKind kind() { return static_cast<ConstraintKind>(random_.index(3)); }
  Point<Dim> toward() {
    if (Dim == 2) return Point<Dim>::Zero();
    return random_.direction<Dim>();
  }
  std::vector<SceneConstraint<Dim>> fresh() {
    std::vector<SceneConstraint<Dim>> result;
    for (Index left = 1 + random_.index(3); left > 0; --left) {
      SceneConstraint<Dim> each{boundary<Dim>(place())};
      if (random_.index(3) == 0) each.constraint = interior<Dim>(each.constraint.at, number());
      each.label = random_.index(2) ? "new" : "";
      result.push_back(each);
    }
    return result;
  }

  Random random_;
};

/// Nothing is touched in secret: what is left of `after` without `touched` was in `before`, in that order.
template <int Dim>
bool rest_is_old(const Document<Dim>& before, const Document<Dim>& after, const std::vector<Index>& touched) {
  std::size_t old = 0, t = 0;
  for (std::size_t i = 0; i < after.constraints.size(); ++i) {
    if (t < touched.size() && touched[t] == static_cast<Index>(i)) {
      ++t;
      continue;
    }
    while (old < before.constraints.size() && !(before.constraints[old] == after.constraints[i])) ++old;
    if (old++ == before.constraints.size()) return false;
  }
  return true;
}

struct Dimension2 {
  static constexpr int dim = 2;
};
struct Dimension3 {
  static constexpr int dim = 3;
};
template <class T>
class RandomActions : public ::testing::Test {};
using RandomDimensions = ::testing::Types<Dimension2, Dimension3>;
TYPED_TEST_SUITE(RandomActions, RandomDimensions);

TYPED_TEST(RandomActions, KeepWhatMustHold) {
  constexpr int D = TypeParam::dim;
  Editor<D> editor(start_document<D>());
  Session<D> session;
  record(editor, session);
  Monkey<D> monkey(11);
  std::map<std::uint64_t, std::string> text_of_state = {{0, bits_of(editor.document())}};
  int refused = 0, changed = 0, impossible = 0;
  for (int i = 0; i < actions; ++i) {
    const Command<D> command = monkey.next(editor);
    const Document<D> document = editor.document();
    const std::string before = bits_of(document);
    const auto revision = editor.revision();
    const auto good = editor.shape().function;
    try {
      const Outcome outcome = editor.perform(command);
      ASSERT_EQ(editor.revision(), revision + (outcome.changed ? 1 : 0)) << i;
      changed += outcome.changed;
      for (std::size_t k = 0; k < outcome.touched.size(); ++k) {
        ASSERT_LT(outcome.touched[k], editor.size()) << i;
        ASSERT_LT(k ? outcome.touched[k - 1] : Index{-1}, outcome.touched[k]) << i;
      }
      ASSERT_TRUE(rest_is_old<D>(document, editor.document(), outcome.touched)) << i;
    } catch (const Refused& error) {
      ++refused;
      ASSERT_EQ(bits_of(editor.document()), before) << i << ": " << error.what();
      ASSERT_EQ(editor.revision(), revision) << i;
      ASSERT_EQ(std::string(error.what()).find(name_of<D>(command)), 0u) << error.what();
    }
    // It can be saved, and read again (the rules of documents hold); a state's name is the state's alone.
    const std::string text = bits_of(editor.document());
    if (i % 10 == 0) {
      ASSERT_EQ(bits_of(parse_document<D>(text)), text) << i;
    }
    ASSERT_EQ(text_of_state.try_emplace(editor.state(), text).first->second, text) << i;
    const Shape<D>& shape = editor.shape();
    ASSERT_NE(shape.function, nullptr);
    if (shape.impossible) {
      ++impossible;
      ASSERT_EQ(shape.function, good) << i;
      ASSERT_LT(shape.revision, editor.revision()) << i;
      ASSERT_FALSE(shape.impossible->message.empty());
      for (const Index culprit : shape.impossible->culprits) ASSERT_LT(culprit, editor.size()) << i;
    } else if (editor.document().smoothing == 0) {
      double largest = 0;
      for (const Constraint<D>& each : constraints_of(editor.document()))
        largest = std::max({largest, std::abs(each.value), each.normal ? std::abs(each.normal->value) : 0.0});
      for (const Constraint<D>& each : constraints_of(editor.document()))
        ASSERT_NEAR(shape.function->value(each.at), each.value, 1.01e-6 * largest)
            << i;  // What fit() promises.
    }
  }
  // A monkey that always succeeds, or never, would test little.
  EXPECT_GT(changed, actions * 4 / 10);
  EXPECT_GT(refused, actions / 10);
  EXPECT_GT(impossible, actions / 50);
  this->RecordProperty("changed", changed);
  this->RecordProperty("refused", refused);
  this->RecordProperty("impossible", impossible);

  if (editor.in_gesture()) editor.end_gesture();
  const std::string end = bits_of(editor.document());

  // The record gives the same, without a solver: it holds no questions.
  ReplayOptions<D> without;
  without.editor.solve_at_once = false;
  without.editor.solver = [](const Constraints<D>&, const FitOptions&) -> Fit<D> {
    throw std::logic_error("asked");
  };
  Editor<D> again = replay(std::get<Session<D>>(parse_session(to_json_text(session))), without);
  EXPECT_EQ(bits_of(again.document()), end);
  EXPECT_EQ(again.undo_size(), editor.undo_size());

  const std::size_t steps = editor.undo_size();
  EXPECT_GT(steps, static_cast<std::size_t>(actions / 100));
  editor.listen({});
  while (again.undo().changed) {
    ASSERT_TRUE(editor.undo().changed);
    ASSERT_EQ(bits_of(editor.document()), bits_of(again.document()));
    ASSERT_EQ(bits_of(editor.document()), text_of_state.at(editor.state()));
  }
  EXPECT_FALSE(editor.undo().changed);
  EXPECT_EQ(bits_of(editor.document()), bits_of(start_document<D>()));
  EXPECT_EQ(editor.state(), 0u);
  while (editor.redo().changed) {
  }
  EXPECT_EQ(editor.undo_size(), steps);
  EXPECT_EQ(bits_of(editor.document()), end);
}

}  // namespace
}  // namespace seesaw
