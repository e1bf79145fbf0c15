// Numbers in the side panel and in their dialog: pulled, typed, of one constraint and of several.
#include "sandbox2d/app.h"
#include "sandbox2d/gallery.h"
#include "tests/sandbox2d/app_stage.h"

namespace seesaw {
namespace {

TEST(AppNumbers, TheInteriorValueIsPulledInOneStep) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string before = bits_of(stage.document());
  const Constraint<2> was = stage.desk().constraint(4);
  ASSERT_EQ(was.kind, ConstraintKind::interior);
  stage.play("drag \"interior value\" \"interior value\" +40 +0 10");
  const Constraint<2> now = stage.desk().constraint(4);
  EXPECT_GT(now.value, 1.5);
  EXPECT_EQ(now.at, was.at);
  EXPECT_NEAR(stage.f(now.at), now.value, 1e-12);
  EXPECT_EQ(stage.steps(), 1u);
  stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), before);
  // The lever by keys moves what is selected.
  stage.play(stage.click(stage.at(4)) + "key right_bracket\nkey right_bracket");
  EXPECT_NEAR(stage.desk().constraint(4).value, 1.21, 1e-12);
  // With nothing selected they move what the slider moves.
  stage.play("key ctrl+shift+a\nkey left_bracket");
  EXPECT_NEAR(stage.desk().constraint(4).value, 1.1, 1e-12);
}

TEST(AppNumbers, SmoothingIsPulledAndTyped) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string before = bits_of(stage.document());
  stage.play("drag \"smoothing\" \"smoothing\" +30 +0 6");
  EXPECT_GT(stage.document().smoothing, 0);
  EXPECT_EQ(stage.desk().shape().report.smoothing, stage.document().smoothing);
  EXPECT_GT(std::abs(stage.f(stage.at(0))), 1e-6) << "it no longer interpolates";
  EXPECT_EQ(stage.steps(), 1u);
  stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), before);
  const std::string typing = "keydown ctrl\nclick \"smoothing\"\nkeyup ctrl\nframes 2\nkey ctrl+a\n";
  stage.play(typing + "text \"0,25\"\nkey enter");
  EXPECT_EQ(stage.document().smoothing, 0.25) << "with a comma, too";
  stage.play(typing + "text \"0\"\nkey enter");
  EXPECT_EQ(stage.document().smoothing, 0);
}

TEST(AppNumbers, TheLeverMayBeTypedBeyondItsEnd) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  stage.play(
      "keydown ctrl\nclick \"interior value\"\nkeyup ctrl\nframes 2\nkey ctrl+a\ntext \"7,5\"\nkey enter");
  EXPECT_EQ(stage.desk().constraint(4).value, 7.5);
}

TEST(AppNumbers, NumbersAreTypedAsOneStep) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string before = bits_of(stage.document());
  stage.play(stage.click(stage.at(4)) + "key enter\nframes 3");
  ASSERT_TRUE(stage.dialog());
  stage.play(
      "doubleclick \"Numbers of a constraint/x\"\nkey ctrl+a\ntext \"0.125\"\nkey tab\n"
      "doubleclick \"Numbers of a constraint/y\"\nkey ctrl+a\ntext \"-0.25\"\nkey tab\n"
      "doubleclick \"Numbers of a constraint/value\"\nkey ctrl+a\ntext \"1.5\"\nkey tab\n"
      "click \"Numbers of a constraint/Apply\"");
  EXPECT_FALSE(stage.dialog());
  EXPECT_EQ(stage.at(4), Point<2>(0.125, -0.25));
  EXPECT_EQ(stage.desk().constraint(4).value, 1.5);
  EXPECT_EQ(stage.steps(), 1u);
  stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), before);
  // The first field has the caret; Enter in it is enough.
  stage.play("key enter\nframes 3\ntext \"0.5\"\nkey enter\nframes 2");
  EXPECT_EQ(stage.at(4).x(), 0.5);
  EXPECT_FALSE(stage.dialog());
  EXPECT_EQ(stage.steps(), 1u);
  // Refused in words: an interior constraint is above 0, and nothing has changed.
  const std::string moved = bits_of(stage.document());
  stage.play(
      "key enter\nframes 3\ntext \"0.1\"\nkey tab\n"
      "doubleclick \"Numbers of a constraint/value\"\nkey ctrl+a\ntext \"-1\"\nkey tab\n"
      "click \"Numbers of a constraint/Apply\"");
  EXPECT_TRUE(stage.dialog());
  EXPECT_EQ(bits_of(stage.document()), moved);
  EXPECT_EQ(stage.steps(), 1u);
  EXPECT_SAID(stage, "expected a number above 0");
  EXPECT_THAT(stage.desk().message().text, testing::Not(testing::HasSubstr("set_value")));
  // Once, wherever the caret is.
  stage.play("key escape");
  EXPECT_FALSE(stage.dialog());
  stage.play("key enter\nframes 3\ntext \"0.3\"\nkey escape");
  EXPECT_FALSE(stage.dialog());
  EXPECT_EQ(bits_of(stage.document()), moved);
}

TEST(AppNumbers, NumbersOfSeveralAreOfAllOfThem) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window, {.file = scenes_folder() / "turk2002-fig05-left.json"});
  const Document<2> before = stage.document();
  const std::size_t steps = stage.steps();
  stage.play("key shift+b");
  const auto typed = [&](const std::string& field, const std::string& number) {
    stage.play("doubleclick \"Side/" + field + "\"\nkey ctrl+a\ntext \"" + number + "\"\nkey enter\n");
  };
  typed("offset", "0.2");
  for (const auto& each : stage.document().constraints) EXPECT_EQ(each.constraint.normal->offset, 0.2);
  EXPECT_EQ(stage.steps(), steps + 1) << "one step for all";
  typed("value there", "0.7");
  for (const auto& each : stage.document().constraints) EXPECT_EQ(each.constraint.normal->value, 0.7);
  for (std::size_t i = 0; i < before.constraints.size(); ++i)
    EXPECT_EQ(stage.document().constraints[i].constraint.normal->direction,
              before.constraints[i].constraint.normal->direction);
  typed("offset", "0,25");
  EXPECT_EQ(stage.document().constraints[0].constraint.normal->offset, 0.25) << "half the world's point";
  stage.play("key ctrl+z");
  typed("middle x", "3");
  Point<2> middle = Point<2>::Zero();
  for (const auto& each : stage.document().constraints)
    middle += each.constraint.at / static_cast<double>(before.constraints.size());
  EXPECT_NEAR(middle.x(), 3, 1e-12);
  EXPECT_NEAR((stage.at(1) - stage.at(0) -
               (before.constraints[1].constraint.at - before.constraints[0].constraint.at))
                  .norm(),
              0, 1e-12);
  EXPECT_EQ(stage.steps(), steps + 3);
  stage.play("key ctrl+z\nkey ctrl+z\nkey ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), bits_of(before));
}

}  // namespace
}  // namespace seesaw
