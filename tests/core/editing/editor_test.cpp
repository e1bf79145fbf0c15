// Every action: what it does, that it can be undone to the bit, and what it refuses.
#include "core/editing/editor.h"

#include <gmock/gmock.h>

#include "tests/core/editing/documents.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <int Dim>
std::string refusal(Editor<Dim>& editor, const Command<Dim>& command) {
  const std::string before = bits_of(editor.document());
  const auto revision = editor.revision();
  const auto steps = editor.undo_size();
  try {
    editor.perform(command);
  } catch (const Refused& refused) {
    EXPECT_EQ(bits_of(editor.document()), before) << refused.what();
    EXPECT_EQ(editor.revision(), revision);
    EXPECT_EQ(editor.undo_size(), steps);
    return refused.what();
  }
  return "not refused";
}

template <int Dim>
struct Of {
  static constexpr int dim = Dim;
};
template <class T>
class Actions : public ::testing::Test {};
using ActionDimensions = ::testing::Types<Of<2>, Of<3>>;
TYPED_TEST_SUITE(Actions, ActionDimensions);

TYPED_TEST(Actions, EachIsUndoneAndRedoneToTheBit) {
  constexpr int D = TypeParam::dim;
  Document<D> start = start_document<D>();
  start.constraints[1].constraint.at[0] = -0.0;
  start.constraints[2].constraint.normal = NormalConstraint<D>{Point<D>::UnitX(), 0.1, 0.25};
  Point<D> third = Point<D>::Constant(1.0 / 3);
  Document<D> other = start;
  other.title = "pasted";
  other.constraints.erase(other.constraints.begin() + 1, other.constraints.begin() + 6);
  AddOnSurface<D> pick{.from = Point<D>::Constant(0.9), .direction = Point<D>::Zero()};
  if (D == 3) pick.direction = -Point<D>::Constant(1) + 0.1 * Point<D>::UnitX();

  struct Case {
    Action<D> action;
    std::vector<Index> touched, touched_by_undo;
  };
  const std::vector<Case> cases = {
      {Add<D>{{{boundary<D>(third)}, {exterior<D>(5 * third, -2), true}}}, {12, 13}, {}},
      {pick, {12}, {}},
      {Move<D>{{3, 1}, third}, {1, 3}, {1, 3}},
      {MoveTo<D>{2, third}, {2}, {2}},
      {Delete{{0, 11, 4}}, {}, {0, 4, 11}},
      {SetValue{{5, 7}, -0.3}, {5, 7}, {5, 7}},
      {SetKind{{1, 2}, ConstraintKind::interior}, {1, 2}, {1, 2}},
      {AddNormal{0}, {0}, {0}},
      {SetNormal<D>{1, {Point<D>::UnitY(), 0.01, 1}}, {1}, {1}},
      {TurnNormal<D>{2, third}, {2}, {2}},
      {RemoveNormal{{2}}, {2}, {2}},
      {SetKernel{Kernel::linear}, {}, {}},
      {SetSmoothing{0.1}, {}, {}},
      {Restore<D>{other}, {0, 1, 2, 3, 4, 5, 6}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
  };
  std::vector<std::size_t> kinds;
  for (const Case& each : cases) {
    Editor<D> editor(start);
    const std::string name = name_of<D>(each.action);
    const Outcome done = editor.apply(each.action);
    EXPECT_TRUE(done.changed) << name;
    EXPECT_EQ(done.touched, each.touched) << name;
    const std::string after = bits_of(editor.document());
    EXPECT_NE(after, bits_of(start)) << name;
    EXPECT_STREQ(editor.undo_name(), name.c_str());
    EXPECT_NE(in_words(name), name) << "a person is told in words";
    EXPECT_TRUE(editor.shape().current()) << name;
    const Outcome undone = editor.undo();
    EXPECT_EQ(undone.touched, each.touched_by_undo) << name;
    EXPECT_EQ(bits_of(editor.document()), bits_of(start)) << name;
    EXPECT_EQ(editor.state(), 0u);
    EXPECT_STREQ(editor.redo_name(), name.c_str());
    EXPECT_EQ(editor.redo().touched, each.touched) << name;
    EXPECT_EQ(bits_of(editor.document()), after) << name;
    EXPECT_EQ(editor.revision(), 3u);
    kinds.push_back(each.action.index());
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Action<D>>) << "an action that nothing tests";
}

TYPED_TEST(Actions, DoWhatTheySay) {
  constexpr int D = TypeParam::dim;
  Editor<D> editor(start_document<D>());
  const Document<D> before = editor.document();
  editor.apply(Move<D>{{0, 2}, Point<D>::UnitY()});
  for (Index i = 0; i < editor.size(); ++i) {
    const bool moved = i == 0 || i == 2;
    const auto u = static_cast<std::size_t>(i);
    const Point<D> expected = before.constraints[u].constraint.at + (moved ? 1.0 : 0.0) * Point<D>::UnitY();
    EXPECT_EQ(editor.document().constraints[u].constraint.at, expected);
  }
  const auto at = [&](std::size_t i) { return editor.document().constraints[i]; };
  editor.apply(Delete{{1, 0}});
  EXPECT_EQ(editor.size(), 10);
  EXPECT_EQ(at(0), (SceneConstraint<D>{boundary<D>(before.constraints[2].constraint.at + Point<D>::UnitY()),
                                       before.constraints[2].highlight}));
  editor.apply(SetKind{{0}, ConstraintKind::exterior});
  EXPECT_EQ(at(0).constraint.value, -1);
  editor.apply(SetKind{{0}, ConstraintKind::interior, 2.5});
  EXPECT_EQ(at(0).constraint.value, 2.5);
  editor.apply(SetKind{{0}, ConstraintKind::boundary});
  EXPECT_EQ(at(0).constraint.value, 0);
  editor.apply(SetNormal<D>{0, {Point<D>::UnitX(), 0.5, 3}});
  editor.apply(TurnNormal<D>{0, -2 * Point<D>::UnitY()});
  EXPECT_EQ(at(0).constraint.normal->direction, (-2 * Point<D>::UnitY()).eval());
  EXPECT_EQ(at(0).constraint.normal->offset, 0.5);
  EXPECT_EQ(at(0).constraint.normal->value, 3);
  editor.apply(TurnNormal<D>{0, Point<D>::UnitX(), 5});
  EXPECT_EQ(at(0).constraint.normal->direction, Point<D>(Point<D>::UnitX()));
  EXPECT_EQ(at(0).constraint.normal->value, 5);
  editor.apply(SetKind{{0}, ConstraintKind::interior});
  EXPECT_FALSE(at(0).constraint.normal) << "an interior constraint has no normal";
  editor.apply(SetKernel{Kernel::linear});
  editor.apply(SetSmoothing{0.25});
  EXPECT_EQ(editor.document().kernel, Kernel::linear);
  EXPECT_EQ(editor.document().smoothing, 0.25);
  EXPECT_EQ(editor.shape().report.kernel, Kernel::linear);
  EXPECT_EQ(editor.shape().report.smoothing, 0.25);
}

TYPED_TEST(Actions, AreRefusedWholeAndSayWhy) {
  constexpr int D = TypeParam::dim;
  Editor<D> editor(start_document<D>());
  const Point<D> zero = Point<D>::Zero(), x = Point<D>::UnitX();
  Point<D> bad = zero;
  bad[1] = std::nan("");
  const auto expect = [&](const Action<D>& action, const char* words) {
    EXPECT_THAT(refusal<D>(editor, action), HasSubstr(words));
  };
  expect(Move<D>{{0, 12}, x}, "move: constraint 12 does not exist, there are 12 (0 to 11)");
  expect(Move<D>{{-1}, x}, "constraint -1 does not exist");
  expect(Move<D>{{3, 1, 3}, x}, "move: constraint 3 is named twice");
  expect(Move<D>{{}, x}, "move: names no constraint");
  expect(Move<D>{{0, 1}, bad}, "move: constraint 0: at: expected a finite number");
  expect(MoveTo<D>{4, bad}, "move_to: constraint 4: at: ");
  expect(Delete{{99}}, "delete: constraint 99 does not exist");
  expect(SetValue{{4, 0}, -2}, "set_value: constraint 0: value: a boundary constraint is 0 by definition");
  expect(SetValue{{5}, 2}, "set_value: constraint 5: value: expected a number below 0 outside, found 2");
  expect(SetKind{{5}, ConstraintKind::interior, -1}, "set_kind: constraint 5: value: ");
  expect(SetNormal<D>{0, {zero, 0.01, 1}}, "set_normal: constraint 0: normal: the zero vector");
  expect(SetNormal<D>{6, {x, 0.01, 1}}, "set_normal: constraint 6 is exterior");
  expect(TurnNormal<D>{0, x}, "turn_normal: constraint 0 has no normal");
  expect(SetNormal<D>{0, {x, std::nan(""), 1}}, "set_normal: constraint 0: offset: ");
  expect(AddNormal{7}, "add_normal: constraint 7 is exterior");
  expect(AddNormal{70}, "add_normal: constraint 70 does not exist");
  expect(AddNormal{0, 0.0}, "add_normal: offset: expected a number other than 0");
  expect(SetSmoothing{-1}, "set_smoothing: smoothing: ");
  expect(SetSmoothing{std::nan("")}, "set_smoothing: smoothing: ");
  expect(Add<D>{}, "add: there is no constraint to add");
  expect(Add<D>{{{boundary<D>(x)}, {interior<D>(zero, -1)}}}, "add: new constraint 13: value: ");
  Document<D> broken;
  broken.constraints.push_back({interior<D>(bad)});
  expect(Restore<D>{broken}, "restore: constraint 0: at: ");
  expect(AddOnSurface<D>{bad, x}, "add_on_surface: ");
  if constexpr (D == 3) {
    expect(AddOnSurface<3>{{0, 0, 9}, {0, 0, 1}}, "the ray does not meet the surface");
    expect(AddOnSurface<3>{{9, 9, 9}, {1, -1, 0}}, "the ray does not meet the surface");
    expect(AddOnSurface<3>{{0, 0, 9}, {0, 0, 0}}, "the ray has no direction");
  } else {
    expect(AddOnSurface<2>{{0, 0}, {1, 0}}, "leave the direction away");
  }
  EXPECT_THAT(refusal<D>(editor, EndGesture{}), HasSubstr("no gesture has begun"));
  EXPECT_THAT(refusal<D>(editor, CancelGesture{}), HasSubstr("no gesture has begun"));
  editor.begin_gesture();
  EXPECT_THAT(refusal<D>(editor, BeginGesture{}), HasSubstr("begun already"));
  EXPECT_THAT(refusal<D>(editor, Undo{}), HasSubstr("gesture"));
  EXPECT_THAT(refusal<D>(editor, Redo{}), HasSubstr("gesture"));
}

TYPED_TEST(Actions, ThatChangeNothingLeaveNoTrace) {
  constexpr int D = TypeParam::dim;
  Editor<D> editor(start_document<D>());
  editor.apply(SetKernel{Kernel::linear});
  editor.undo();
  for (const Action<D>& action :
       {Action<D>(Move<D>{{1, 2}, Point<D>::Zero()}), Action<D>(SetValue{{4}, -1}),
        Action<D>(SetKind{{0}, ConstraintKind::boundary}), Action<D>(RemoveNormal{{0, 1}}),
        Action<D>(SetSmoothing{0}), Action<D>(SetKernel{editor.document().kernel})})
    EXPECT_FALSE(editor.apply(action).changed) << name_of<D>(action);
  EXPECT_EQ(editor.undo_size(), 0u);
  EXPECT_EQ(editor.redo_size(), 1u) << "what was undone can still be redone";
  EXPECT_FALSE(editor.undo().changed);
  EXPECT_EQ(editor.revision(), 2u);
}

// "Adding a new boundary constraint on the existing surface does not affect the surface shape at all" (T&O
// 2002, section 5), nor does a normal constraint that asks for what f does.
TYPED_TEST(Actions, OnTheSurfaceAndNormalsFromTheGradientChangeFNowhere) {
  constexpr int D = TypeParam::dim;
  for (const double smoothing : {0.0, 0.01}) {
    Document<D> start = start_document<D>();
    start.smoothing = smoothing;
    Editor<D> editor(start);
    const Box<D> box(Point<D>::Constant(-4), Point<D>::Constant(4));
    Random random(7);
    for (int i = 0; i < 12; ++i) {
      const auto before = editor.shape().function;
      const Point<D> from = 2.5 * random.direction<D>();
      AddOnSurface<D> add{.from = from, .direction = Point<D>::Zero()};
      if (D == 3) add.direction = 0.2 * random.direction<D>() - from;
      editor.apply(add);
      const Index added = editor.size() - 1;
      const Point<D> at = editor.document().constraints.back().constraint.at;
      EXPECT_EQ(editor.document().constraints.back(), SceneConstraint<D>{boundary<D>(at)});
      EXPECT_LT(std::abs(before->value(at)), 1e-13);
      const auto between = editor.shape().function;
      ASSERT_NE(before, between);
      EXPECT_LE(greatest_change<D>(*before, *between, box),
                10 * rounding<D>(editor.shape().report, *between, box));
      editor.apply(AddNormal{added});
      const auto normal = editor.document().constraints.back().constraint.normal;
      ASSERT_TRUE(normal);
      EXPECT_NEAR(normal->direction.norm(), 1, 1e-14);
      EXPECT_LT(normal->direction.dot(between->gradient(at)), 0) << "points outward, as f falls";
      EXPECT_GT(normal->value, 0) << "a little inside";
      const auto after = editor.shape().function;
      EXPECT_LE(greatest_change<D>(*between, *after, box),
                10 * rounding<D>(editor.shape().report, *after, box));
    }
    // All of it together, so that small steps do not add up to a large one; and moving one does change f.
    const auto last = editor.shape().function;
    EXPECT_LT(greatest_change<D>(*Editor<D>(start).shape().function, *last, box), 1e-9);
    editor.apply(Move<D>{{editor.size() - 1}, Point<D>::Constant(0.2)});
    EXPECT_GT(greatest_change<D>(*last, *editor.shape().function, box), 1e-3);
  }
}

TYPED_TEST(Actions, ImpossibleSetsKeepTheLastGoodShapeAndNameTheCulprits) {
  constexpr int D = TypeParam::dim;
  Editor<D> editor(start_document<D>());
  const auto good = editor.shape().function;
  const Point<D> place = editor.document().constraints[5].constraint.at;
  // Dragged onto an exterior constraint: 0 and -1 are asked of one place.
  editor.apply(MoveTo<D>{2, place});
  EXPECT_EQ(editor.document().constraints[2].constraint.at, place) << "the document holds what was done";
  EXPECT_FALSE(editor.shape().current());
  ASSERT_TRUE(editor.shape().impossible);
  EXPECT_EQ(editor.shape().impossible->reason, ConstraintError::Reason::contradictory);
  EXPECT_THAT(editor.shape().impossible->culprits, ElementsAre(2, 5));
  EXPECT_THAT(editor.shape().impossible->message, HasSubstr("2, 5"));
  EXPECT_EQ(editor.shape().function, good);
  EXPECT_EQ(editor.shape().revision, 0u);
  EXPECT_EQ(editor.revision(), 1u);
  // Off again by a hair that no digit tells.
  editor.apply(MoveTo<D>{2, place + Point<D>::Constant(1e-10)});
  ASSERT_TRUE(editor.shape().impossible);
  EXPECT_EQ(editor.shape().impossible->reason, ConstraintError::Reason::too_close);
  EXPECT_THAT(editor.shape().impossible->culprits, ElementsAre(2, 5));
  EXPECT_EQ(editor.shape().function, good);
  // Two that agree are one.
  editor.apply(MoveTo<D>{2, editor.document().constraints[3].constraint.at});
  EXPECT_TRUE(editor.shape().current());
  EXPECT_EQ(editor.shape().report.merged, 1);
  EXPECT_EQ(editor.shape().revision, 3u);
  EXPECT_NE(editor.shape().function, good);
  while (editor.undo().changed) {
  }
  EXPECT_TRUE(editor.shape().current());
  // Of nothing at all, nothing is to be seen.
  editor.apply(Delete{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
  ASSERT_TRUE(editor.shape().impossible);
  EXPECT_EQ(editor.shape().impossible->reason, ConstraintError::Reason::none_given);
  EXPECT_EQ(editor.shape().function, nullptr);
  editor.undo();
  EXPECT_TRUE(editor.shape().current());
}

TEST(Editor, KeepsTheLastGoodShapeWhenMemoryEnds) {
  EditorOptions<2> options;
  options.solver = [](const Constraints<2>& c, const FitOptions& o) {
    if (c.size() > 12) throw std::bad_alloc();
    return fit<2>(c, o);
  };
  Editor<2> editor(start_document<2>(), options);
  const auto good = editor.shape().function;
  editor.apply(Add<2>{{{boundary<2>({0.5, 0.5})}}});
  ASSERT_TRUE(editor.shape().impossible);
  EXPECT_FALSE(editor.shape().impossible->reason);
  EXPECT_THAT(editor.shape().impossible->message, HasSubstr("memory to solve for 13 constraints"));
  EXPECT_EQ(editor.shape().function, good);
  editor.undo();
  EXPECT_TRUE(editor.shape().current());
}

TEST(Editor, RefusesASmoothingThatIsNone) {
  Document<3> document = start_document<3>();
  document.smoothing = -1;
  EXPECT_THROW(Editor<3>{document}, Error);
}

TEST(Editor, WithoutAShapeSaysSo) {
  Editor<2> editor{Document<2>{}};
  EXPECT_EQ(editor.shape().function, nullptr);
  EXPECT_THAT(refusal<2>(editor, Action<2>(AddOnSurface<2>{})), HasSubstr("there is no shape yet"));
  editor.apply(Add<2>{{{boundary<2>({1, 2})}}});
  EXPECT_TRUE(editor.shape().current());
  EXPECT_THAT(refusal<2>(editor, Action<2>(AddNormal{0})), HasSubstr("constraint 0: the function is flat"));
}

TYPED_TEST(Actions, AGestureIsOneStep) {
  constexpr int D = TypeParam::dim;
  Editor<D> editor(start_document<D>());
  editor.apply(SetSmoothing{0.5});
  const std::string before = bits_of(editor.document());
  const auto state = editor.state();
  editor.begin_gesture();
  for (int i = 0; i < 100; ++i) editor.apply(Move<D>{{0, 3}, Point<D>::Constant(0.001 * (i + 1))});
  editor.apply(AddNormal{0});
  editor.end_gesture();
  const std::string after = bits_of(editor.document());
  EXPECT_EQ(editor.undo_size(), 2u);
  EXPECT_THAT(editor.undo().touched, ElementsAre(0, 3));
  EXPECT_EQ(bits_of(editor.document()), before);
  EXPECT_EQ(editor.state(), state);
  editor.redo();
  EXPECT_EQ(bits_of(editor.document()), after);

  // Nothing done is nothing to undo; and what was undone survives it.
  editor.undo();
  editor.begin_gesture();
  editor.end_gesture();
  EXPECT_EQ(editor.undo_size(), 1u);
  EXPECT_EQ(editor.redo_size(), 1u);
  // Cancelled is as if it had not been.
  editor.begin_gesture();
  editor.apply(Delete{{0, 1}});
  editor.apply(Move<D>{{0}, Point<D>::UnitX()});
  EXPECT_EQ(editor.redo_size(), 0u);
  EXPECT_THAT(editor.cancel_gesture().touched, ElementsAre(0, 1, 2));
  EXPECT_EQ(bits_of(editor.document()), before);
  EXPECT_EQ(editor.state(), state);
  EXPECT_EQ(editor.redo_size(), 1u);
  editor.redo();
  EXPECT_EQ(bits_of(editor.document()), after);
}

TEST(Editor, ALongDragTakesTheRoomOfOneMove) {
  History<2> history;
  Document<2> document = start_document<2>();
  history.open();
  for (int i = 0; i < 1000; ++i) {
    SceneConstraint<2> next = document.constraints[1];
    next.constraint.at.x() += 0.1;
    Change<2> move = {Replace<2>{{1}, {document.constraints[1]}, {next}}};
    apply_change(move, document);
    history.push("move", std::move(move));
  }
  history.close();
  EXPECT_EQ(history.next_undo()->change.size(), 1u);
  history.undo(document);
  EXPECT_EQ(bits_of(document), bits_of(start_document<2>()));
}

// Unasked, so that the last good shape does not hang on who looked when.
TEST(Editor, SolvesAfterEveryChange) {
  int solves = 0;
  EditorOptions<2> options;
  options.solver = [&](const Constraints<2>& c, const FitOptions& o) { return ++solves, fit<2>(c, o); };
  Editor<2> editor(start_document<2>(), options);
  EXPECT_EQ(solves, 1);
  editor.apply(Move<2>{{0}, {0.01, 0}});
  EXPECT_EQ(solves, 2);
  editor.undo();
  EXPECT_EQ(solves, 3);
  editor.apply(Move<2>{{0}, {0, 0}});
  editor.label("nothing changes");
  editor.shape();
  EXPECT_EQ(solves, 3);
  editor.apply(Move<2>{{0}, {0.02, 0}});
  editor.apply(MoveTo<2>{0, editor.document().constraints[5].constraint.at});
  ASSERT_TRUE(editor.shape().impossible);
  EXPECT_EQ(editor.shape().revision, 3u) << "of the change before the impossible one";
}

TEST(Editor, SolvesWhenAskedIfToldSo) {
  int solves = 0;
  EditorOptions<2> options;
  options.solve_at_once = false;
  options.solver = [&](const Constraints<2>& c, const FitOptions& o) { return ++solves, fit<2>(c, o); };
  Editor<2> editor(start_document<2>(), options);
  for (int i = 0; i < 10; ++i) editor.apply(Move<2>{{0}, {0.01, 0}});
  EXPECT_EQ(solves, 0);
  EXPECT_EQ(editor.shape().revision, 10u);
  editor.shape();
  EXPECT_EQ(solves, 1);
  editor.apply(AddOnSurface<2>{.from = {0, 1}});
  EXPECT_EQ(solves, 1);
  EXPECT_TRUE(editor.shape().current());
  EXPECT_EQ(solves, 2);
}

TEST(Editor, TellsItsListenerWhatAReplayWants) {
  Editor<3> editor(start_document<3>());
  std::vector<std::string> heard;
  Command<3> last;
  editor.listen([&](const Command<3>& command, const Editor<3>&) {
    heard.push_back(name_of<3>(command)), last = command;
  });
  editor.apply(AddOnSurface<3>{{0, 0, 9}, {0, 0, -1}});
  EXPECT_TRUE(std::holds_alternative<Add<3>>(std::get<Action<3>>(last))) << "the answer, not the question";
  editor.apply(AddNormal{12});
  EXPECT_THROW(editor.apply(Delete{{50}}), Refused);
  editor.apply(Move<3>{{0}, {0, 0, 0}});
  editor.label("here");
  editor.undo();
  EXPECT_THAT(heard, ElementsAre("add", "set_normal", "label", "undo"));
}

}  // namespace
}  // namespace seesaw
