#include "sandbox2d/settings.h"

#include <gmock/gmock.h>

#include "tests/sandbox2d/random_place.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

Settings unusual_settings() {
  Settings settings;
  settings.scale = 1.1;
  settings.dark = true;
  settings.window_width = 1920;
  settings.window_height = 1080;
  settings.tour_seen = true;
  settings.last_folder = "/home/ada/my scenes ";
  settings.panels = {{"equations", false}, {"list", true}};
  return settings;
}

TEST(Settings, AreTheSameAfterARun) {
  EXPECT_EQ(parse_settings(settings_text(unusual_settings())), unusual_settings());
  EXPECT_EQ(parse_settings(settings_text({})), Settings());
  ScratchFolder folder;
  const auto path = folder / "state/seesaw/sandbox2d.settings";
  {
    SettingsFile file(path);
    EXPECT_EQ(file.settings(), Settings());
    EXPECT_TRUE(file.keep(unusual_settings()));
    EXPECT_EQ(file.settings(), unusual_settings());
  }
  EXPECT_EQ(SettingsFile(path).settings(), unusual_settings());
  EXPECT_FALSE(SettingsFile(path).settings().shows("equations"));
  EXPECT_TRUE(SettingsFile(path).settings().shows("help"));
  EXPECT_FALSE(SettingsFile(path).settings().shows("help", false));
}

TEST(Settings, OnlyChangesAreWritten) {
  ScratchFolder folder;
  SettingsFile file(folder / "settings");
  EXPECT_TRUE(file.keep(Settings()));
  EXPECT_FALSE(std::filesystem::exists(folder / "settings"));
  EXPECT_TRUE(file.keep(unusual_settings()));
  folder.with("settings", "somebody else's");
  EXPECT_TRUE(file.keep(unusual_settings()));
  EXPECT_EQ(read_file(folder / "settings"), "somebody else's");
}

TEST(Settings, WhatIsNotKnownIsKept) {
  ScratchFolder folder;
  const auto path = folder.with("settings", "future 1 2 3\ndark on\n# a note\n\npanel. on");
  SettingsFile file(path);
  Settings settings = file.settings();
  EXPECT_TRUE(settings.dark);
  settings.scale = 2;
  EXPECT_TRUE(file.keep(settings));
  const std::string text = read_file(path);
  for (const char* line : {"future 1 2 3\n", "# a note\n", "panel. on\n", "scale 2\n", "dark on\n"})
    EXPECT_THAT(text, ::testing::HasSubstr(line));
  EXPECT_EQ(SettingsFile(path).settings(), settings);
}

TEST(Settings, NonsenseIsTheUsual) {
  EXPECT_EQ(
      parse_settings("scale nan\ndark yes\nwindow_width\nwindow_height 1e99\ntour_seen  on\npanel.x 1\n"),
      (Settings{.window_height = 16384}));
  EXPECT_EQ(parse_settings("scale 0\nwindow_width -3").scale, 0.5);
  EXPECT_EQ(parse_settings("scale 1e400").scale, 1);
  EXPECT_EQ(parse_settings(std::string_view("dark on\n\0", 9)), Settings());
  ScratchFolder folder;
  EXPECT_EQ(SettingsFile(folder.path()).settings(), Settings()) << "a folder is no file";
  Random random(3);
  for (int run = 0; run < 2000; ++run) {
    std::string text = settings_text(unusual_settings());
    for (int i = 0; i < 5; ++i) text[below(random, text.size())] = static_cast<char>(below(random, 256));
    const Settings read = parse_settings(text);
    EXPECT_GE(read.scale, 0.5);
    EXPECT_LE(read.scale, 4);
    EXPECT_GE(read.window_width, 320);
    EXPECT_LE(read.window_height, 16384);
  }
}

TEST(Settings, APathWithALineFeedBringsNoLineOfItsOwn) {
  Settings settings;
  settings.last_folder = "/a\ndark on";
  EXPECT_EQ(parse_settings(settings_text(settings)), Settings());
}

TEST(Settings, WhereNothingCanBeWrittenTheProgramGoesOn) {
  ScratchFolder folder;
  folder.with("file");
  SettingsFile file(folder / "file/settings");
  EXPECT_FALSE(file.keep(unusual_settings()));
  EXPECT_TRUE(file.keep(unusual_settings())) << "asked once";
  EXPECT_EQ(file.settings(), unusual_settings());
  EXPECT_TRUE(SettingsFile().keep(unusual_settings()));
}

}  // namespace
}  // namespace seesaw
