#include "sandbox2d/file_dialog.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <ctime>
#include <fstream>

#include "core/base/error.h"
#include "core/window/ui.h"
#include "tests/core/window/stage.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Paths = std::vector<std::filesystem::path>;

/// A dialog on a folder with scenes, and what it was told.
struct DialogStage {
  ScratchFolder folder;
  FileDialog dialog;
  Paths chosen;
  std::string refuse;  // what the function throws

  DialogStage() {
    for (const char* name : {"fig2.json", "fig10.json", "notes.txt", "scenes/deep.json", "scenes/torus.json"})
      folder.with(name);
    dialog.set_places({folder / "scenes", {{"Examples", folder / "scenes"}}, {folder / "scenes/deep.json"}});
  }
  FileDialog::Done done() {
    return [this](const std::filesystem::path& path) {
      if (!refuse.empty()) throw Error(refuse);
      chosen.push_back(path);
    };
  }
  void ask_open() { dialog.ask_open("Open a scene", {{".json", "Scene"}}, folder.path(), done()); }
  void ask_save(const std::string& name) {
    dialog.ask_save("Export", {{".png", "Picture"}, {".svg", "Drawing"}, {".pdf", "Page"}}, folder / name,
                    done());
  }
  Played play(Window& window, const std::string& text) {
    return seesaw::play(window, "frames 3\n" + text + "\nframes 3\n", [this] { dialog.frame(); });
  }
};

const WindowOptions dialog_window = {.width = 1000, .height = 640};

TEST(FileDialog, AFileIsClickedAndOpened) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  for (const char* way :
       {"click \"fig10.json\"\nclick \"Open\"", "click \"fig10.json\"\nkey enter",
        "doubleclick \"fig10.json\"", "text \"fig10\"\nkey enter", "key up\nkey enter",
        "key down\nkey down\nkey down\nkey enter", "click \"fig2.json\"\nclick \"fig10.json\"\nkey enter"}) {
    stage.chosen.clear();
    stage.ask_open();
    stage.play(window, way);
    EXPECT_FALSE(stage.dialog.open()) << way;
    EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "fig10.json")) << way;
  }
}

TEST(FileDialog, FoldersAreEnteredByEveryDoor) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  const std::string scenes = (stage.folder / "scenes").string();
  for (const std::string& way :
       {std::string("doubleclick \"scenes\""), std::string("click \"scenes\"\nkey enter"),
        std::string("text \"scenes\"\nkey enter"), std::string("key down\nkey enter"),
        std::string("click \"Examples\""), std::string("click \"Home\""),
        std::string("text \"~\"\nkey enter"), "text \"" + scenes + "/\"\nkey enter"}) {
    stage.ask_open();
    stage.play(window, way);
    EXPECT_TRUE(stage.dialog.open()) << way;
    EXPECT_EQ(stage.dialog.folder(), stage.folder / "scenes") << way;
  }
  // Back by the line of folders, and deeper from there.
  stage.play(window, "click \"" + stage.folder.path().filename().string() + "\"");
  EXPECT_EQ(stage.dialog.folder(), stage.folder.path());
  stage.play(window, "text \"scenes/torus\"\nkey enter");
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "scenes/torus.json"));
}

TEST(FileDialog, ARecentFileIsTwoClicksAway) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  stage.ask_open();
  stage.play(window, "click \"deep.json\"\nframes 2\nclick \"Open\"");
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "scenes/deep.json"));
  std::filesystem::remove(stage.folder / "scenes/deep.json");
  stage.ask_open();
  stage.play(window, "click \"deep.json\"\nframes 2\nkey enter");
  EXPECT_TRUE(stage.dialog.open());
  EXPECT_EQ(stage.chosen.size(), 1u);
}

TEST(FileDialog, CancelAndEscapeCloseIt) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  for (const char* way :
       {"key escape", "click \"Cancel\"", "text \"fig2\"\nkey escape", "click \"fig2.json\"\nkey escape"}) {
    stage.ask_open();
    stage.play(window, way);
    EXPECT_FALSE(stage.dialog.open()) << way;
  }
  EXPECT_THAT(stage.chosen, IsEmpty());
  // Closed by the program: nothing is left that would block the window.
  stage.ask_open();
  stage.play(window, "");
  stage.dialog.close();
  stage.play(window, "");
  EXPECT_FALSE(stage.play(window, "press\nrelease").inputs.at(0).for_ui);
}

TEST(FileDialog, TroubleIsSaidAndItStaysOpen) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  stage.ask_open();
  stage.play(window, "key enter\nframes 3\ntext \"none\"\nkey enter");
  EXPECT_TRUE(stage.dialog.open());
  EXPECT_EQ(stage.dialog.trouble(), "there is no file none in " + stage.folder.path().string());
  stage.refuse = "fig2.json:3: expected a comma";
  stage.play(window, "click \"fig2.json\"\nkey enter");
  EXPECT_TRUE(stage.dialog.open());
  EXPECT_EQ(stage.dialog.trouble(), stage.refuse);
  stage.refuse.clear();
  stage.play(window, "key enter");
  EXPECT_FALSE(stage.dialog.open());
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "fig2.json"));
  // A folder that goes while it is shown.
  stage.ask_open();
  stage.play(window, "");
  std::filesystem::remove_all(stage.folder / "scenes");
  stage.play(window, "doubleclick \"scenes\"");
  EXPECT_TRUE(stage.dialog.open());
  EXPECT_THAT(stage.dialog.trouble(), ::testing::HasSubstr("scenes: cannot be read"));
  EXPECT_EQ(stage.dialog.folder(), stage.folder.path());
}

TEST(FileDialog, AFileIsSavedWithTheEndingThatIsChosen) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  stage.ask_save("curve.png");
  stage.play(window, "key enter");
  stage.ask_save("curve.png");
  stage.play(window, "click \"Picture (.png)\"\nframes 2\nclick \"Page (.pdf)\"\nframes 3\nclick \"Save\"");
  stage.ask_save("curve");
  stage.play(window, "text \"other\"\nkey enter");
  stage.ask_save("curve.png");
  stage.play(window, "text \"typed.svg\"\nkey enter");
  stage.ask_save("curve.svg");
  stage.play(window, "text \"scenes/new\"\nkey enter");
  EXPECT_THAT(stage.chosen,
              ElementsAre(stage.folder / "curve.png", stage.folder / "curve.pdf", stage.folder / "other.png",
                          stage.folder / "typed.svg", stage.folder / "scenes/new.svg"));
  // The name is kept on the way into a folder.
  stage.ask_save("kept.svg");
  stage.play(window, "doubleclick \"scenes\"\nframes 2\nclick \"Save\"");
  EXPECT_EQ(stage.chosen.back(), stage.folder / "scenes/kept.svg");
}

TEST(FileDialog, AFileIsReplacedAfterAQuestionOnly) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  stage.folder.with("curve.svg");
  for (const char* way : {"key escape", "click \"Keep\""}) {
    stage.ask_save("curve.svg");
    stage.play(window, std::string("key enter\nframes 3\n") + way);
    EXPECT_TRUE(stage.dialog.open()) << "the question is gone, the dialog is not";
    EXPECT_THAT(stage.chosen, IsEmpty());
    stage.play(window, "key escape");
    EXPECT_FALSE(stage.dialog.open());
  }
  for (const char* way : {"key enter", "click \"Replace\""}) {
    stage.ask_save("curve.svg");
    stage.play(window, std::string("click \"Save\"\nframes 3\n") + way);
    EXPECT_FALSE(stage.dialog.open());
    EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "curve.svg"));
    stage.chosen.clear();
  }
  // A double click on what is there asks, too.
  stage.ask_save("new.svg");
  stage.play(window, "doubleclick \"curve.svg\"");
  EXPECT_TRUE(stage.dialog.open());
  stage.play(window, "click \"Replace\"");
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "curve.svg"));
}

TEST(FileDialog, AFolderIsMade) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  stage.ask_save("curve.svg");
  stage.play(window, "click \"New folder\"\nframes 3\ntext \"scenes\"\nkey enter\nframes 2");
  EXPECT_EQ(stage.dialog.folder(), stage.folder.path()) << "exists already";
  stage.play(window, "key ctrl+a\ntext \"out\"\nkey enter\nframes 3\nkey enter");
  EXPECT_TRUE(std::filesystem::is_directory(stage.folder / "out"));
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "out/curve.svg"));
  stage.ask_save("curve.svg");
  stage.play(window, "click \"New folder\"\nframes 3\ntext \"no\"\nkey escape");
  EXPECT_TRUE(stage.dialog.open());
  EXPECT_FALSE(std::filesystem::exists(stage.folder / "no"));
}

TEST(FileDialog, NewFilesAreSeenAfterReload) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  stage.ask_open();
  stage.play(window, "click \"fig2.json\"");
  stage.folder.with("fig3.json");
  EXPECT_THROW(stage.play(window, "click \"fig3.json\""), FileError) << "not read every frame";
  stage.play(window, "click \"Reload\"\nframes 2\nclick \"fig3.json\"\nkey enter");
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "fig3.json"));
}

TEST(FileDialog, AskedAgainByItsOwnFunction) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  stage.dialog.ask_open("First", {{".json", "Scene"}}, stage.folder.path(), [&](const auto& path) {
    stage.chosen.push_back(path);
    stage.ask_open();
  });
  stage.play(window, "text \"fig2\"\nkey enter\nframes 3\ntext \"fig10\"\nkey enter");
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "fig2.json", stage.folder / "fig10.json"));
  EXPECT_FALSE(stage.dialog.open());
}

TEST(FileDialog, MakesRoomForAQuestionAndComesBack) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage stage;
  Questions questions;
  const auto draw = [&] {
    stage.dialog.frame();
    questions.frame();
  };
  stage.ask_open();
  play(window, "frames 3\nclick \"fig2.json\"", draw);
  bool quit = false;
  questions.ask({"Unsaved changes", "Save them?", {{"Save"}, {"Cancel", [&] { quit = true; }}}});
  play(window, "frames 3\nkey escape\nframes 3", draw);
  EXPECT_TRUE(quit);
  EXPECT_TRUE(stage.dialog.open());
  play(window, "click \"Open\"\nframes 2", draw);
  EXPECT_THAT(stage.chosen, ElementsAre(stage.folder / "fig2.json"));
}

/// Of this thread on its processor, however many others there are.
double seconds_of_thread() {
  timespec time = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What the dialog costs in most frames while its list is gone through; without the pixels, which are the
/// same for every list and take far longer.
double cost_of_a_frame(Window& window, DialogStage& stage) {
  stage.ask_open();
  stage.play(window, "");
  std::vector<double> costs;
  play(window, "key up\nkey up\nkey page_up\nframes 30", [&] {
    const double start = seconds_of_thread();
    stage.dialog.frame();
    costs.push_back(seconds_of_thread() - start);
  });
  const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
  std::nth_element(costs.begin(), middle, costs.end());
  return *middle;
}

TEST(FileDialog, ManyFilesStayQuick) {
  SEESAW_WINDOW_OR_SKIP(window, dialog_window);
  DialogStage few, many;
  for (int i = 0; i < 10000; ++i)
    std::ofstream((i < 10 ? few : many).folder / ("s" + std::to_string(i) + ".json"));
  const double usual = cost_of_a_frame(window, few);
  few.dialog.close();
  // The same, for only what can be seen is drawn. All of them cost 45 times as much.
  EXPECT_LT(cost_of_a_frame(window, many), 8 * usual);
  many.play(window, "click \"s9988.json\"\nkey enter");
  EXPECT_THAT(many.chosen, ElementsAre(many.folder / "s9988.json")) << "the list was scrolled to its end";
}

TEST(FileDialog, FitsIntoTheWindowAtAnyScale) {
  for (const bool dark : {false, true})
    for (const double scale : {1.0, 1.75})
      for (const bool save : {false, true}) {
        SEESAW_WINDOW_OR_SKIP(window,
                              WindowOptions{.width = 1280, .height = 800, .scale = scale, .dark = dark});
        DialogStage stage;
        stage.folder.with(
            "a scene with a very long name that tells everything about what is in it, twice over.json");
        double pixels = 2;
        const std::string name = std::to_string(static_cast<int>(100 * scale)) + (dark ? "_dark" : "_light") +
                                 (save ? "_save.png" : "_open.png");
        const auto path = stage.folder / name;
        if (save)
          stage.dialog.ask_save("Export", {{".png", "Picture"}, {".svg", "Drawing"}},
                                stage.folder / "curve.png", stage.done(), [&](const FileKind& kind) {
                                  const auto off = ui::disabled(kind.ending != ".png");
                                  ui::slider("Pixels a point", pixels, 1, 8);
                                });
        else
          stage.ask_open();
        stage.play(window, std::string(save ? "text \"none/x\"\nkey enter" : "key down\nkey down") +
                               "\nframes 3\nmove \"Cancel\" +0 +0\nframes 1\nscreenshot \"" + path.string() +
                               "\"\nclick \"Cancel\"");
        EXPECT_FALSE(stage.dialog.open()) << "Cancel can be seen and clicked";
      }
}

}  // namespace
}  // namespace seesaw
