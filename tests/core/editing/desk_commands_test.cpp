// Keys, commands, fields and sliders of the desk, and what it keeps.
#include "core/editing/desk.h"

#include <gmock/gmock.h>

#include "core/editing/replay.h"
#include "tests/core/editing/desk_at_hand.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using K = DeskKey;
using C = DeskCommand;

TEST_F(DeskTest, KeysNudgeAndAHeldKeyIsOneStep) {
  hand.click(place(2));
  one_step([&] { hand.key(K::left); });
  EXPECT_LE((place(2) - Point<2>(1 - pixel_of_tests, 0.1)).norm(), 1e-15);
  one_step([&] {
    desk.handle(KeyDown{K::up, shift_key});
    for (int i = 0; i < 9; ++i) desk.handle(KeyDown{K::up, shift_key, true});
    EXPECT_TRUE(desk.editor().in_gesture());
    desk.handle(KeyUp{K::up});
  });
  EXPECT_NEAR(place(2).y(), 1.1, 1e-12) << "ten times ten pixels";
  one_step([&] { desk.perform(C::nudge_right); });
  EXPECT_LE((place(2) - Point<2>(1, 1.1)).norm(), 1e-12);
  hand.key(K::g);
  one_step([&] { hand.key(K::down); });
  EXPECT_NEAR(place(2).y(), 0.6, 1e-12);
  no_step([&] {
    desk.handle(KeyDown{K::down});
    hand.key(K::escape);
  });
  // A press ends a nudge whose key was not let go.
  desk.handle(KeyDown{K::down});
  hand.click({3, 2});
  EXPECT_FALSE(desk.editor().in_gesture());
}

TEST_F(DeskTest, DeleteDuplicateAndTheSelectionAfterwards) {
  hand.click(place(1));
  hand.click(place(3), shift_key);
  one_step([&] { hand.key(K::d, ctrl_key); });
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5, 6));
  EXPECT_LE((place(5) - place(1) - 12 * pixel_of_tests * Point<2>(1, -1)).norm(), 1e-15);
  desk.select({0, 4, 99, -1});
  one_step([&] { hand.key(K::del); });
  EXPECT_EQ(desk.editor().size(), 5);
  EXPECT_TRUE(desk.selection().empty());
  hand.key(K::z, ctrl_key);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 4)) << "what came back";
  no_step([&] {
    hand.key(K::escape);
    hand.key(K::del);
    hand.key(K::d, ctrl_key);
  });
}

TEST_F(DeskTest, ConstraintsAreCopiedAsJson) {
  desk.select({2, 4});
  no_step([&] { hand.key(K::c, ctrl_key); });
  one_step([&] { hand.key(K::v, ctrl_key); });
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5, 6));
  EXPECT_EQ(desk.constraint(6).kind, ConstraintKind::interior);
  const Point<2> step = place(5) - place(2);
  EXPECT_NEAR(step.norm(), 12 * std::sqrt(2) * pixel_of_tests, 1e-15) << "beside the original";
  one_step([&] { hand.key(K::v, ctrl_key); });
  EXPECT_LE((place(7) - place(2) - 2 * step).norm(), 1e-15) << "and beside the first copy";
  desk.select({5, 6, 7, 8});
  one_step([&] { hand.key(K::x, ctrl_key); });
  one_step([&] { hand.key(K::v, ctrl_key); });
  EXPECT_EQ(desk.editor().size(), 9);
}

TEST_F(DeskTest, TheSceneIsCopiedAndPastedAndForeignTextIsRefused) {
  std::string text;
  DeskOptions options;
  options.clipboard = {[&](const std::string& t) { text = t; }, [&] { return text; }};
  options.most_constraints = 10;
  Desk other({}, options);
  other.start(small_scene());
  TestHand there{other};
  there.key(K::c, {.shift = true, .ctrl = true});
  EXPECT_EQ(text, start);
  there.key(K::a, ctrl_key);
  there.key(K::del);
  EXPECT_EQ(other.editor().size(), 0);
  there.key(K::v, {.shift = true, .ctrl = true});
  EXPECT_EQ(bits_of(other.document()), start);
  EXPECT_TRUE(other.selection().empty());
  EXPECT_EQ(other.editor().undo_size(), 2u);
  there.key(K::z, ctrl_key);
  EXPECT_EQ(other.editor().size(), 0);
  there.key(K::z, ctrl_key);
  EXPECT_EQ(bits_of(other.document()), start);

  const std::string whole = bits_of(other.document());
  for (const char* foreign :
       {"", "hello", "{}", "[1, 2]", R"({"seesaw": 1, "dimension": 3, "constraints": []})",
        R"({"seesaw": 1, "dimension": 2, "constraints": [{"kind": "boundary"}]})",
        R"({"seesaw": 1, "dimension": 2, "constraints": []})"}) {
    text = foreign;
    const auto number = other.message().number;
    there.key(K::v, ctrl_key);
    EXPECT_TRUE(other.message().trouble) << foreign;
    EXPECT_GT(other.message().number, number) << foreign;
    EXPECT_EQ(bits_of(other.document()), whole);
  }
  Document<2> large;
  for (int i = 0; i < 11; ++i) large.constraints.push_back({boundary<2>({0.1 * i, 3})});
  text = bits_of(large);
  EXPECT_FALSE(other.paste(text));
  EXPECT_FALSE(other.paste_scene(text));
  EXPECT_THAT(other.message().text, HasSubstr("11 constraints; up to 10 can be edited"));
  EXPECT_EQ(bits_of(other.document()), whole);
}

TEST_F(DeskTest, TheLeverIsOneStep) {
  hand.click(place(4));
  one_step([&] {
    for (double value = 1; value <= 3; value += 0.25) EXPECT_TRUE(desk.slide(SetValue{{4}, value}));
    EXPECT_NEAR(desk.shape().function->value(place(4)), 3, 1e-12) << "live";
    desk.let_go();
  });
  EXPECT_EQ(desk.constraint(4).value, 3);
  no_step([&] {
    desk.slide(SetValue{{4}, 2});
    hand.key(K::escape);
  });
  no_step([&] {
    EXPECT_FALSE(desk.slide(SetValue{{4}, -2}));
    EXPECT_THAT(desk.message().text, HasSubstr("expected a number above 0"));
    desk.let_go();
  });
  one_step([&] {
    desk.handle(KeyDown{K::right_bracket});
    desk.handle(KeyDown{K::right_bracket, {}, true});
    desk.handle(KeyUp{K::right_bracket});
  });
  EXPECT_NEAR(desk.constraint(4).value, 3 * 1.21, 1e-12);
  one_step([&] { hand.key(K::left_bracket); });
  EXPECT_NEAR(desk.constraint(4).value, 3 * 1.1, 1e-12);
  one_step([&] {
    desk.slide(SetSmoothing{0.1});
    desk.slide(SetSmoothing{0.2});
    desk.let_go();
  });
}

TEST_F(DeskTest, FieldsSetExactNumbers) {
  one_step([&] { EXPECT_TRUE(desk.apply(MoveTo<2>{2, {1.0 / 3, -0.125}})); });
  EXPECT_EQ(place(2), Point<2>(1.0 / 3, -0.125));
  one_step([&] { EXPECT_TRUE(desk.apply(SetValue{{4}, 0.3})); });
  one_step([&] { EXPECT_TRUE(desk.apply(SetKind{{2}, ConstraintKind::exterior, -0.5})); });
  one_step([&] { EXPECT_TRUE(desk.apply(SetKernel{Kernel::cubic})); });
  no_step([&] { EXPECT_FALSE(desk.apply(MoveTo<2>{2, {NAN, 0}})); });
  no_step([&] { EXPECT_FALSE(desk.apply(Delete{{17}})); });
  EXPECT_THAT(desk.message().text, HasSubstr("constraint 17 does not exist"));
}

TEST_F(DeskTest, CulpritsAreSelectedAndTheLastGoodCurveStays) {
  const auto good = desk.shape().function;
  hand.key(K::u);
  EXPECT_TRUE(desk.selection().empty());
  hand.drag(place(4), place(2));
  ASSERT_TRUE(desk.shape().impossible);
  EXPECT_NE(desk.shape().function, nullptr);
  hand.key(K::escape);
  hand.key(K::u);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(2, 4));
  hand.key(K::z, ctrl_key);
  EXPECT_FALSE(desk.shape().impossible);
  EXPECT_EQ(bits_of(desk.document()), start);
  EXPECT_NE(good, nullptr);
}

TEST_F(DeskTest, BeforeAndAfterAndAnotherKernel) {
  no_step([&] {
    EXPECT_EQ(desk.other(), nullptr);
    hand.key(K::o);
    EXPECT_TRUE(desk.message().trouble) << "nothing is remembered yet";
    hand.key(K::m);
    hand.key(K::o);
  });
  EXPECT_EQ(desk.other(), desk.shape().function);
  EXPECT_EQ(desk.other_name(), "before");
  const std::shared_ptr<const Interpolant<2>> before = desk.other();
  hand.drag(place(4), {0.2, 0.1});
  EXPECT_EQ(desk.other(), before);
  EXPECT_NE(desk.other(), desk.shape().function);
  hand.key(K::o);
  EXPECT_EQ(desk.other(), nullptr);
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) {
    hand.key(K::o, shift_key);
    names.push_back(desk.other_name());
    if (desk.other()) {
      EXPECT_NE(desk.other()->kernel(), desk.document().kernel);
      EXPECT_EQ(std::string(name_of(desk.other()->kernel())), desk.other_name());
      EXPECT_NEAR(desk.other()->value(place(4)), 1, 1e-9) << "it follows the document";
      hand.key(K::right);
      EXPECT_NEAR(desk.other()->value(place(4)), 1, 1e-9);
    }
  }
  EXPECT_EQ(names.back(), "");
  EXPECT_NE(names[0], names[1]);
}

TEST_F(DeskTest, WhatOnlyAProgramCanDoComesBack) {
  EXPECT_EQ(hand.key(K::s, ctrl_key), C::save);
  EXPECT_EQ(hand.key(K::f1), C::help);
  EXPECT_EQ(hand.key(K::w), C::toggle_weights);
  EXPECT_EQ(hand.key(K::b), std::nullopt);
  EXPECT_EQ(hand.key(K::j), std::nullopt);
  hand.key(K::v);
  EXPECT_EQ(hand.click(place(2), {}, 2), C::edit_values);
  EXPECT_EQ(desk.perform(C::quit), C::quit);
  EXPECT_EQ(desk.perform(C::toggle_field), std::nullopt);
}

TEST_F(DeskTest, WhatIsShownIsSavedButNotUndone) {
  no_step([&] {
    for (const K key : {K::digit1, K::digit2, K::digit3, K::digit4, K::digit5, K::digit6, K::digit7})
      hand.key(key);
  });
  const Display<2> defaults;
  for (const auto& each : display_switches<2>)
    EXPECT_EQ(desk.to_save().display.*each.member, !(defaults.*each.member)) << each.key;
  EXPECT_TRUE(desk.unsaved());
  hand.to(place(2));
  EXPECT_EQ(desk.hover().over, Over::curve) << "hidden constraints are not grabbed";
}

TEST_F(DeskTest, AScaleMakesEverythingLarger) {
  const Point<2> beside = place(2) + Point<2>(0.15, 0);
  hand.to(beside);
  EXPECT_EQ(desk.hover().over, Over::nothing);
  desk.set_scale(2);
  EXPECT_EQ(desk.hover().which, 2);
}

TEST_F(DeskTest, ASessionIsRecordedAndReplayed) {
  EXPECT_FALSE(desk.stop_recording());
  desk.start_recording();
  EXPECT_TRUE(desk.recording());
  hand.key(K::b);
  hand.drag({2, 1}, {2, 2});
  hand.key(K::k);
  hand.key(K::z, ctrl_key);
  const auto session = desk.stop_recording();
  ASSERT_TRUE(session);
  ReplayOptions<2> options;
  options.editor.solve_at_once = false;
  EXPECT_EQ(bits_of(replay(*session, options).document()), bits_of(desk.document()));
  desk.start_recording();
  hand.drag(place(0), {-2, 0});
  const std::string end = bits_of(desk.document());
  desk.start();
  EXPECT_FALSE(desk.recording());
  const auto second = desk.stop_recording();
  ASSERT_TRUE(second) << "another document ends it; nothing is lost";
  EXPECT_EQ(bits_of(replay(*second, options).document()), end);

  // Again, a command at a time, before an audience that interferes.
  Desk shown(small_scene());
  for (const RecordedCommand<2>& each : session->commands) EXPECT_TRUE(shown.do_again(each.command));
  EXPECT_EQ(bits_of(shown.document()), bits_of(replay(*session, options).document()));
  EXPECT_FALSE(shown.editor().in_gesture());
  shown.do_again(BeginGesture{});
  shown.do_again(Action<2>(Move<2>{{0}, {1, 0}}));
  TestHand{shown}.click({3, 2});
  EXPECT_TRUE(shown.do_again(Action<2>(Move<2>{{0}, {1, 0}})));
  EXPECT_TRUE(shown.do_again(EndGesture{}));
  EXPECT_FALSE(shown.do_again(Action<2>(Delete{{99}})));
  EXPECT_FALSE(shown.editor().in_gesture());
}

TEST_F(DeskTest, AReleaseFromNowhereStillLetsGo) {
  hand.down(place(2));
  hand.to({2, 2});
  hand.up({NAN, INFINITY});
  EXPECT_EQ(desk.gesture(), Gesture::none);
  EXPECT_EQ(place(2), Point<2>(2, 2));
}

TEST_F(DeskTest, ASliderAndAKeyAreTwoSteps) {
  hand.click(place(4));
  desk.slide(SetValue{{4}, 2});
  hand.key(K::left);
  EXPECT_EQ(desk.editor().undo_size(), 2u);
  desk.slide(SetValue{{4}, 3});
  hand.key(K::z, ctrl_key);
  EXPECT_EQ(desk.constraint(4).value, 2);
  desk.slide(Action<2>(Add<2>{{{boundary<2>({3, 3})}}}));
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5));
  desk.cancel();
  EXPECT_TRUE(desk.selection().empty());
}

}  // namespace
}  // namespace seesaw
