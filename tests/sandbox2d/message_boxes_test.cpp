#include "sandbox2d/message_boxes.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/window/ui.h"
#include "tests/core/window/stage.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct QuestionStage {
  Questions questions;
  std::vector<std::string> answers;

  Question question(const std::string& title, const std::vector<std::string>& labels) {
    Question result{title, "What is to be done?", {}};
    for (const std::string& label : labels)
      result.answers.push_back({label, [this, title, label] { answers.push_back(title + ": " + label); }});
    return result;
  }
  Played play(Window& window, const std::string& text) {
    return seesaw::play(window, text, [this] { questions.frame(); });
  }
};

const WindowOptions question_window = {.width = 640, .height = 400};

TEST(Questions, EnterGivesTheFirstAndEscapeTheLast) {
  SEESAW_WINDOW_OR_SKIP(window, question_window);
  QuestionStage stage;
  const std::pair<const char*, const char*> ways[] = {{"key enter", "Q: Save"},
                                                      {"key escape", "Q: Cancel"},
                                                      {"click \"Don't save\"", "Q: Don't save"},
                                                      {"click \"Q/Cancel\"", "Q: Cancel"}};
  for (const auto& [way, answer] : ways) {
    stage.questions.ask(stage.question("Q", {"Save", "Don't save", "Cancel"}));
    stage.play(window, "frames 3");
    EXPECT_TRUE(stage.questions.open());
    EXPECT_TRUE(stage.answers.empty());
    stage.play(window, std::string(way) + "\nframes 2");
    EXPECT_FALSE(stage.questions.open());
    EXPECT_THAT(stage.answers, ElementsAre(answer));
    stage.answers.clear();
  }
  stage.questions.ask(stage.question("Told", {"Good"}));
  stage.play(window, "frames 3\nkey escape\nframes 1");
  EXPECT_THAT(stage.answers, ElementsAre("Told: Good"));
}

TEST(Questions, WaitForOneAnother) {
  SEESAW_WINDOW_OR_SKIP(window, question_window);
  QuestionStage stage;
  stage.questions.ask(stage.question("First", {"Yes", "No"}));
  stage.questions.ask(stage.question("Second", {"Yes", "No"}));
  stage.questions.ask(stage.question("Second", {"Yes", "No"}));
  stage.play(window, "frames 3\nclick \"First/No\"\nframes 3\nkey enter\nframes 3\nkey escape\nframes 2");
  EXPECT_THAT(stage.answers, ElementsAre("First: No", "Second: Yes", "Second: No"));
  EXPECT_FALSE(stage.questions.open());
}

TEST(Questions, AnAnswerMayAskTheNext) {
  SEESAW_WINDOW_OR_SKIP(window, question_window);
  QuestionStage stage;
  stage.questions.ask({"First",
                       "Go on?",
                       {{"Yes",
                         [&] {
                           stage.questions.ask(stage.question("First", {"A", "B"}));
                         }},
                        {"No"}}});
  stage.play(window, "frames 3\nkey enter\nframes 3\n");
  EXPECT_TRUE(stage.questions.open());
  EXPECT_THAT(stage.answers, IsEmpty());
  stage.play(window, "click \"B\"\nframes 2\n");
  EXPECT_THAT(stage.answers, ElementsAre("First: B"));
}

TEST(Questions, BlockWhatIsBelowAndLetGoOfIt) {
  SEESAW_WINDOW_OR_SKIP(window, question_window);
  QuestionStage stage;
  int below = 0;
  const auto draw = [&] {
    if (const auto panel = ui::panel("P", {0, 0, 640, 60}))
      if (ui::button("Below")) ++below;
    stage.questions.frame();
  };
  stage.questions.ask(stage.question("Q", {"Yes", "No"}));
  play(window, "frames 3\nclick \"Below\"\nframes 1", draw);
  EXPECT_EQ(below, 0);
  stage.questions.clear();
  play(window, "frames 3\nclick \"Below\"\nframes 1", draw);
  EXPECT_EQ(below, 1);
  EXPECT_THAT(stage.answers, IsEmpty());
}

TEST(Questions, ComeBackWhenAnotherDialogPushedThemAway) {
  SEESAW_WINDOW_OR_SKIP(window, question_window);
  QuestionStage stage;
  bool push = false;
  const auto draw = [&] {
    stage.questions.frame();
    if (push) ui::open_dialog("Other");
    push = false;
    if (const auto dialog = ui::dialog("Other")) ui::text("Here");
  };
  stage.questions.ask(stage.question("Q", {"Yes", "No"}));
  play(window, "frames 3", draw);
  push = true;
  play(window, "frames 4\nkey enter\nframes 1", draw);
  EXPECT_THAT(stage.answers, ElementsAre("Q: Yes"));
}

TEST(Questions, WhatAnAnswerThrowsComesOut) {
  SEESAW_WINDOW_OR_SKIP(window, question_window);
  QuestionStage stage;
  stage.questions.ask({"Q", "Save?", {{"Save", [] { throw Error("the disk is full"); }}, {"No"}}});
  std::string said;
  play(window, "frames 3\nkey enter\nframes 2", [&] {
    try {
      stage.questions.frame();
    } catch (const Error& error) {
      said = error.what();
    }
  });
  EXPECT_EQ(said, "the disk is full");
  EXPECT_FALSE(stage.questions.open());
}

TEST(Questions, FitIntoTheWindowAtAnyScale) {
  const ScratchFolder folder;
  for (const bool dark : {false, true})
    for (const double scale : {1.0, 1.75, 3.0}) {
      SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 900, .height = 560, .scale = scale, .dark = dark});
      QuestionStage stage;
      Question question = stage.question("Unsaved changes", {"Save", "Don't save", "Cancel"});
      question.text = "The scene “torus.json” has changes that are not saved.\nWithout saving they are lost.";
      stage.questions.ask(question);
      const auto path =
          folder / (std::to_string(static_cast<int>(100 * scale)) + (dark ? "_dark" : "_light") + ".png");
      stage.play(window, "frames 3\nmove \"Cancel\"\nframes 1\nscreenshot \"" + path.string() +
                             "\"\nclick \"Cancel\"\nframes 2");
      EXPECT_THAT(stage.answers, ElementsAre("Unsaved changes: Cancel")) << scale;
    }
}

}  // namespace
}  // namespace seesaw
