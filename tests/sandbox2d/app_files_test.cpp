// The program and files: what is saved is what is there, what is unsaved is asked about, and no file that
// falls on the window can harm the document that is open.
#include <fstream>

#include "core/editing/session.h"
#include "core/image/png.h"
#include "core/scene/document_picture.h"
#include "sandbox2d/gallery.h"
#include "tests/sandbox2d/app_stage.h"

namespace seesaw {
namespace {

const std::string scenes_of_figures = std::string(SEESAW_SOURCE_DIR) + "/figures/scenes/";

std::string typed(const std::filesystem::path& path) { return "text \"" + path.string() + "\"\n"; }

// In a dialog that asks where to save: the suggested name goes, the path comes.
std::string saved_as(const std::filesystem::path& path) {
  return "frames 3\nkey ctrl+a\n" + typed(path) + "key enter\nframes 3\n";
}

TEST(AppFiles, SaveAsThenSaveThenOpen) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  AppStage stage(window);
  stage.play(stage.drag(stage.at(0), stage.at(0) * 1.3) + "key ctrl+s\n" + saved_as(folder / "mine.json"));
  ASSERT_FALSE(stage.dialog()) << stage.app().file_dialog().trouble();
  EXPECT_EQ(stage.desk().path(), folder / "mine.json");
  EXPECT_FALSE(stage.desk().unsaved());
  EXPECT_EQ(bits_of(read_document<2>(folder / "mine.json")), bits_of(stage.desk().to_save()));
  // It has a file now, so nothing is asked.
  stage.play(stage.drag(stage.at(1), stage.at(1) * 1.2));
  EXPECT_TRUE(stage.desk().unsaved());
  EXPECT_NE(bits_of(read_document<2>(folder / "mine.json")), bits_of(stage.desk().to_save()));
  stage.play("key ctrl+s\nframes 2");
  EXPECT_FALSE(stage.dialog());
  EXPECT_EQ(bits_of(read_document<2>(folder / "mine.json")), bits_of(stage.desk().to_save()));
  // Without the ending, which is added; and there already, which is asked about.
  stage.play("key ctrl+shift+s\n" + saved_as(folder / "other"));
  EXPECT_EQ(stage.desk().path(), folder / "other.json");
  const std::string other = bits_of(stage.desk().to_save());
  stage.play("key ctrl+shift+s\n" + saved_as(folder / "mine.json"));
  EXPECT_TRUE(stage.has("Replace the file?/Keep"));
  stage.play("key escape\nframes 2\nkey escape\nframes 2");
  EXPECT_EQ(stage.desk().path(), folder / "other.json");
  // Opened by typing.
  stage.play("key ctrl+a\nkey delete\nkey ctrl+s\nkey ctrl+o\nframes 3\n" + typed(folder / "mine.json") +
             "key enter\nframes 3");
  EXPECT_EQ(stage.desk().path(), folder / "mine.json");
  EXPECT_EQ(bits_of(stage.desk().to_save()), other);
}

TEST(AppFiles, AFolderThatCannotBeWrittenIsSaid) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  AppStage stage(window);
  stage.play(stage.drag(stage.at(0), stage.at(0) * 1.3) + "key ctrl+s\n" +
             saved_as(folder / "gone/mine.json"));
  EXPECT_TRUE(stage.dialog());
  EXPECT_THAT(stage.app().file_dialog().trouble(), ::testing::HasSubstr("gone"));
  EXPECT_TRUE(stage.desk().unsaved());
}

TEST(AppFiles, ClosingAsksAboutWhatIsUnsaved) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  {
    AppStage stage(window);
    stage.play("quit");
    EXPECT_TRUE(stage.app().done()) << "nothing is unsaved";
  }
  AppStage stage(window);
  stage.play(stage.drag(stage.at(0), stage.at(0) * 1.3) + "quit\nframes 2");
  EXPECT_FALSE(stage.app().done());
  for (const char* answer : {"Save", "Don't save", "Cancel"})
    EXPECT_TRUE(stage.has(std::string("Unsaved changes/") + answer));
  stage.play("click \"Unsaved changes/Cancel\"\nframes 2");
  EXPECT_FALSE(stage.app().done());
  EXPECT_FALSE(stage.dialog());
  // Saving asks where, and then it goes; not where that is cancelled.
  stage.play("key ctrl+q\nframes 2\nclick \"Unsaved changes/Save\"\nframes 3\nkey escape\nframes 2");
  EXPECT_FALSE(stage.app().done());
  EXPECT_TRUE(stage.desk().unsaved());
  stage.play("quit\nframes 2\nclick \"Unsaved changes/Save\"\n" + saved_as(folder / "kept.json"));
  EXPECT_TRUE(stage.app().done());
  EXPECT_EQ(bits_of(read_document<2>(folder / "kept.json")), bits_of(stage.desk().to_save()));

  AppStage careless(window);
  careless.play(careless.drag(careless.at(0), careless.at(0) * 1.3) +
                "quit\nframes 2\nclick \"Unsaved changes/Don't save\"\nframes 2");
  EXPECT_TRUE(careless.app().done());
}

TEST(AppFiles, AFileThatIsDroppedIsOpened) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  stage.play("drop \"" + scenes_of_figures + "turk2002-fig05-left.json\"\nframes 2");
  EXPECT_EQ(bits_of(stage.desk().to_save()),
            bits_of(read_document<2>(scenes_of_figures + "turk2002-fig05-left.json")));
  EXPECT_EQ(stage.steps(), 0u);
  // What is unsaved is asked about before.
  stage.play(stage.drag(stage.at(0), stage.at(0) * 1.2));
  const std::string mine = bits_of(stage.document());
  stage.play("drop \"" + scenes_of_figures + "seesaw.json\"\nframes 2");
  EXPECT_TRUE(stage.app().asks());
  EXPECT_EQ(bits_of(stage.document()), mine);
  stage.play("key escape\nframes 2");
  EXPECT_EQ(bits_of(stage.document()), mine);
  stage.play("drop \"" + scenes_of_figures + "seesaw.json\"\nframes 2\nclick \"Don't save\"\nframes 2");
  EXPECT_EQ(bits_of(stage.desk().to_save()), bits_of(read_document<2>(scenes_of_figures + "seesaw.json")));
}

TEST(AppFiles, BrokenHugeAndForeignFilesAreRefusedInWords) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  AppStage stage(window);
  write_png(folder / "picture.png", Image(8, 8, Color{1, 0, 0, 1}));
  std::string many = R"({"seesaw": 1, "dimension": 2, "constraints": [)";
  for (int i = 0; i < 6000; ++i)
    many +=
        R"({"kind": "boundary", "at": [)" + std::to_string(i) + ", " + std::to_string(i * i % 977) + "]},";
  many.back() = ']';
  const std::pair<std::filesystem::path, const char*> bad[] = {
      {folder.with("broken.json", R"({"seesaw": 1, "dimension": 2, "constraints": [)"), "broken.json:1"},
      {folder.with("half.json", read_file(scenes_of_figures + "seesaw.json").substr(0, 300)), "half.json"},
      {folder.with("empty.json", ""), "empty.json"},
      {folder.with("text.json", "Dear Ada,\n"), "text.json"},
      {folder.with("newer.json", R"({"seesaw": 9, "dimension": 2, "constraints": []})"), "version"},
      {folder.with(
           "nan.json",
           R"({"seesaw": 1, "dimension": 2, "constraints": [{"kind": "boundary", "at": [1, null]}]})"),
       "constraints[0].at"},
      {folder.with("many.json", many + "}"), "6000 constraints"},
      {folder / "picture.png", "picture.png"},
      {scenes_of_figures + "kernels-3d.json", "dimension"},
      {folder / "none.json", "none.json"},
      {folder.path(), "is a folder"},
      {folder / "zeros.json", "zeros.json"},
      {folder / "huge.json", "huge.json"}};
  // Sparse: no disk is needed.
  std::ofstream(folder / "zeros.json");
  std::filesystem::resize_file(folder / "zeros.json", 200'000'000);
  std::ofstream(folder / "huge.json");
  std::filesystem::resize_file(folder / "huge.json", 3'000'000'000);

  // One that has been saved, and has steps to undo.
  const std::filesystem::path mine = folder / "mine.json";
  stage.play(stage.drag(stage.at(0), stage.at(0) * 1.3) + "key ctrl+s\n" + saved_as(mine) +
             stage.click(stage.at(4)));
  const std::string document = bits_of(stage.document());
  const std::uint64_t revision = stage.desk().revision();
  for (const auto& [file, words] : bad) {
    SCOPED_TRACE(file);
    stage.desk().say("");
    stage.play("drop \"" + file.string() + "\"\nframes 1");
    EXPECT_SAID(stage, words);
    EXPECT_TRUE(stage.desk().message().trouble);
    EXPECT_EQ(bits_of(stage.document()), document);
    EXPECT_EQ(stage.desk().revision(), revision);
    EXPECT_EQ(stage.steps(), 1u);
    EXPECT_EQ(stage.desk().path(), mine);
    EXPECT_FALSE(stage.desk().unsaved());
    EXPECT_FALSE(stage.dialog());
    EXPECT_EQ(stage.desk().selection().size(), 1);
  }
  // By the dialog: it says so, and stays.
  stage.play("key ctrl+o\nframes 3\n" + typed(folder / "newer.json") + "key enter\nframes 2");
  EXPECT_TRUE(stage.dialog());
  EXPECT_THAT(stage.app().file_dialog().trouble(), ::testing::HasSubstr("version"));
  stage.play("key escape\nframes 2\nkey ctrl+z");
  EXPECT_EQ(stage.steps(), 0u) << "and the history goes back as before";
}

TEST(AppFiles, ARecordedSessionIsDoneAgain) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  AppStage stage(window);
  stage.play("key ctrl+r\n" + stage.drag(stage.at(0), stage.at(0) * 1.3) + "key b\n" +
             stage.click({0.9, 0.9}) +
             "key ctrl+z\nkey ctrl+y\nkey v\ndrag \"interior value\" \"interior value\" +20 +0 5");
  EXPECT_TRUE(stage.desk().recording());
  const std::string recorded = bits_of(stage.document());
  stage.play("key ctrl+r\nframes 3\nkey enter\n" + saved_as(folder / "session.json"));
  EXPECT_FALSE(stage.desk().recording());
  ASSERT_FALSE(stage.dialog()) << stage.app().file_dialog().trouble();
  EXPECT_NO_THROW(read_session(folder / "session.json"));
  // Something else, then the session.
  stage.play("key ctrl+a\nkey delete\ndrop \"" + (folder / "session.json").string() +
             "\"\nframes 2\nclick \"Don't save\"\nframes 2");
  EXPECT_EQ(bits_of(stage.document()), recorded);
  EXPECT_SAID(stage, "did again");
  // It can be taken back, step by step.
  while (stage.steps() > 0) stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), bits_of(read_scene(gallery().front())));
}

TEST(AppFiles, ASessionIsReplayedBeforeOnesEyes) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 700, .height = 480});
  ScratchFolder folder;
  AppStage stage(window);
  const std::string start = bits_of(stage.document());
  stage.play("key ctrl+r\n" + stage.drag(stage.at(0), stage.at(0) * 1.3, 12) +
             "key k\nkey ctrl+r\nframes 3\nkey enter\n" + saved_as(folder / "session.json"));
  const std::string recorded = bits_of(stage.document());
  const std::string mine = "click \"Don't save\"\nframes 3\n";
  const auto replay = [&](const std::string& unsaved) {
    return "key ctrl+shift+r\nframes 3\n" + unsaved + typed(folder / "session.json") +
           "key enter\nframes 2\n";
  };
  stage.play(replay(mine));
  EXPECT_SAID(stage, "replaying");
  EXPECT_EQ(bits_of(stage.document()), start) << "it begins at the beginning";
  stage.play("frames 130");
  EXPECT_SAID(stage, "all of it");
  EXPECT_EQ(bits_of(stage.document()), recorded);

  // A hand stops it, and what was done until then can be undone.
  stage.play(replay(mine) + "frames 72\nkey escape");
  EXPECT_SAID(stage, "stopped");
  const std::string stopped = bits_of(stage.document());
  EXPECT_NE(stopped, start);
  EXPECT_NE(stopped, recorded);
  stage.play("frames 130");
  EXPECT_EQ(bits_of(stage.document()), stopped);
  EXPECT_GT(stage.steps(), 0u);
  while (stage.steps() > 0) stage.play("key ctrl+z");
  EXPECT_EQ(bits_of(stage.document()), start);

  // It never goes on in a document that has come meanwhile.
  stage.play(replay("") + "frames 72\ndrop \"" + scenes_of_figures +
             "seesaw.json\"\nframes 2\nclick \"Don't save\"");
  stage.play("frames 130");
  EXPECT_EQ(bits_of(stage.desk().to_save()), bits_of(read_document<2>(scenes_of_figures + "seesaw.json")));
  EXPECT_EQ(stage.steps(), 0u);
}

TEST(AppFiles, AFileGivenAtTheStart) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  {
    AppStage stage(window, {.file = scenes_of_figures + "height-field.json"});
    EXPECT_EQ(bits_of(stage.desk().to_save()),
              bits_of(read_document<2>(scenes_of_figures + "height-field.json")));
    EXPECT_EQ(stage.desk().path(), scenes_of_figures + "height-field.json");
  }
  AppStage stage(window, {.file = folder / "none.json"});
  EXPECT_SAID(stage, "none.json");
  EXPECT_TRUE(stage.desk().message().trouble);
  EXPECT_TRUE(stage.desk().path().empty());
  EXPECT_EQ(bits_of(stage.document()), bits_of(read_scene(gallery().front()))) << "there is something to see";
}

TEST(AppFiles, ARecordingIsNotLostWithoutAWord) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  AppStage stage(window);
  stage.play("key ctrl+r\nkey k\nkey ctrl+n\nframes 3");
  ASSERT_TRUE(stage.has("Recording/Discard"));
  stage.play("key escape\nframes 2");
  EXPECT_TRUE(stage.desk().recording());
  EXPECT_GT(stage.document().constraints.size(), 5u) << "nothing was given up for it";
  // A file that is not to be: the recording goes on.
  stage.play("key ctrl+r\nframes 3\nkey enter\nframes 3\nkey escape\nframes 2");
  EXPECT_FALSE(stage.dialog());
  EXPECT_TRUE(stage.desk().recording());
  // Saved on the way to another document; then what is unsaved is asked about.
  stage.play("key ctrl+n\nframes 3\nkey enter\n" + saved_as(folder / "session.json") + "frames 3");
  EXPECT_FALSE(stage.desk().recording());
  EXPECT_EQ(std::get<Session<2>>(read_session(folder / "session.json")).commands.size(), 1u);
  stage.play("click \"Don't save\"\nframes 3");
  EXPECT_EQ(stage.document().constraints.size(), 0u);
  // Nothing was recorded: nothing is asked. Discarded: gone.
  stage.play("key ctrl+r\nkey ctrl+r\nframes 2");
  EXPECT_FALSE(stage.dialog());
  EXPECT_SAID(stage, "nothing was recorded");
  stage.play("key ctrl+r\nkey k\nkey ctrl+r\nframes 3\nclick \"Discard\"\nframes 2");
  EXPECT_FALSE(stage.desk().recording());
}

TEST(AppFiles, WhatCannotBeReadIsSaidBeforeAnythingIsGivenUpForIt) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  AppStage stage(window);
  std::ofstream(folder / "bad.json") << "{\"seesaw\": 1,";
  stage.play(stage.drag(stage.at(0), stage.at(0) * 1.3) + "drop \"" + (folder / "bad.json").string() + "\"");
  EXPECT_FALSE(stage.dialog()) << "no question whether to save";
  EXPECT_SAID(stage, "bad.json");
  EXPECT_EQ(stage.steps(), 1u);
}

// The plate, the profile and the panels with it, as they are seen when the dialog is gone.
TEST(AppFiles, ExportsTheWindow) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  ScratchFolder folder;
  AppStage stage(window);
  stage.play("key t\nkey ctrl+shift+p\n" + saved_as(folder / "window.png") + "frames 20");
  ASSERT_FALSE(stage.dialog()) << stage.app().file_dialog().trouble();
  EXPECT_SAID(stage, "exported");
  const Image exported = read_png(folder / "window.png"), shown = stage.picture();
  ASSERT_EQ(exported.width(), shown.width());
  ASSERT_EQ(exported.height(), shown.height());
  // But for the words that say so, at the bottom.
  const int rows = static_cast<int>(stage.app().layout().status.top());
  const auto bytes = static_cast<std::ptrdiff_t>(4) * rows * shown.width();
  EXPECT_TRUE(std::equal(shown.bytes().begin(), shown.bytes().begin() + bytes, exported.bytes().begin()));
  // Where nothing can be written that is said in the dialog.
  stage.play("key ctrl+shift+p\n" + saved_as(folder / "none" / "window.png"));
  EXPECT_TRUE(stage.dialog());
  EXPECT_THAT(stage.app().file_dialog().trouble(), testing::HasSubstr("none"));
}

// The dialog's way, by a typed name: the same bytes as `figures render` of the scene.
TEST(AppFiles, ExportsOfTheGalleryAreTheFigures) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 640, .height = 480});
  ScratchFolder folder;
  AppStage stage(window);
  for (const GalleryEntry& entry : gallery()) {
    SCOPED_TRACE(entry.scene);
    const std::string name = std::filesystem::path(entry.scene).stem().string();
    stage.play("drop \"" + scenes_of_figures + entry.scene + "\"\nkey ctrl+shift+e\n" +
               saved_as(folder / (name + ".png")));
    ASSERT_FALSE(stage.dialog()) << stage.app().file_dialog().trouble();
    EXPECT_SAID(stage, "exported");
    const Document<2> document = read_document<2>(scenes_of_figures + entry.scene);
    picture_of(document, fit(document).function).save(folder / (name + "-figure.png"));
    EXPECT_EQ(read_file(folder / (name + ".png")), read_file(folder / (name + "-figure.png")));
  }
  // The other kinds, by the ending that is typed.
  for (const char* ending : {".svg", ".pdf", ".csv", ".json"}) {
    stage.play("key ctrl+shift+e\n" + saved_as(folder / (std::string("curve") + ending)));
    EXPECT_GT(std::filesystem::file_size(folder / (std::string("curve") + ending)), 200u) << ending;
  }
}

}  // namespace
}  // namespace seesaw
