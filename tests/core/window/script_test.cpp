#include "core/window/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::HasSubstr;

template <class Command>
Command only_command(const std::string& line) {
  const Script script = parse_script(line);
  EXPECT_EQ(script.lines.size(), 1u) << line;
  return std::get<Command>(script.lines.at(0).command);
}

TEST(Script, EveryCommandIsRead) {
  const auto size = only_command<script::Size>("size 1280 800");
  EXPECT_EQ(size.width, 1280);
  EXPECT_EQ(size.height, 800);
  EXPECT_EQ(only_command<script::MoveTo>("move 10 20.5").to.at, Point<2>(10, 20.5));
  EXPECT_EQ(only_command<script::Press>("press").button, MouseButton::left);
  EXPECT_EQ(only_command<script::Press>("press middle").button, MouseButton::middle);
  EXPECT_EQ(only_command<script::Release>("release right").button, MouseButton::right);
  const auto click = only_command<script::Click>("click \"File/Save as\" +5 -3 right");
  EXPECT_EQ(click.at.widget, "File/Save as");
  EXPECT_EQ(click.at.at, Point<2>(5, -3));
  EXPECT_EQ(click.button, MouseButton::right);
  EXPECT_EQ(click.times, 1);
  EXPECT_EQ(only_command<script::Click>("doubleclick 1 2").times, 2);
  const auto drag = only_command<script::Drag>("drag 1 2 \"Here\" 7 middle");
  EXPECT_EQ(drag.from.at, Point<2>(1, 2));
  EXPECT_EQ(drag.to.widget, "Here");
  EXPECT_EQ(drag.to.at, Point<2>(0, 0));
  EXPECT_EQ(drag.steps, 7);
  EXPECT_EQ(drag.button, MouseButton::middle);
  EXPECT_EQ(only_command<script::Drag>("drag -1 2 3 4").steps, 10);
  const auto wheel = only_command<script::Wheel>("wheel 0 -1.5");
  EXPECT_EQ(wheel.right, 0);
  EXPECT_EQ(wheel.up, -1.5);
  EXPECT_EQ(only_command<script::Type>("key ctrl+shift+Z").chord,
            (KeyChord{Key::z, {.shift = true, .ctrl = true}}));
  EXPECT_EQ(only_command<script::Hold>("keydown shift").key, Key::shift);
  EXPECT_FALSE(only_command<script::Hold>("keyup shift").down);
  EXPECT_EQ(only_command<script::Text>(R"(text "a \"b\" \\ # c\n")").words, "a \"b\" \\ # c\n");
  EXPECT_EQ(only_command<script::Frames>("frames 12").count, 12);
  EXPECT_EQ(only_command<script::Screenshot>("screenshot out/a.png # looks").file, "out/a.png");
  only_command<script::Quit>("quit\r");
}

TEST(Script, LinesAreCountedAndCommentsAndBlankLinesLeftOut) {
  const Script script = parse_script("# a comment\n\n  \t\nquit\n  frames 2\n");
  ASSERT_EQ(script.lines.size(), 2u);
  EXPECT_EQ(script.lines[0].line, 4);
  EXPECT_EQ(script.lines[1].line, 5);
}

TEST(Script, DroppedFilesAreLookedForBesideTheScript) {
  const ScratchFolder folder;
  write_file(folder / "a.script", "drop b.json\ndrop \"/c d.json\"\n");
  const Script script = read_script(folder / "a.script");
  EXPECT_EQ(std::get<script::Drop>(script.lines.at(0).command).file, folder / "b.json");
  EXPECT_EQ(std::get<script::Drop>(script.lines.at(1).command).file, "/c d.json");
  EXPECT_THROW(read_script(folder / "b.script"), FileError);
}

TEST(Script, FaultsNameTheFileTheLineAndWhatWasExpected) {
  const std::pair<const char*, const char*> faults[] = {
      {"jump 1 2", "\"jump\" is no command; there are click, doubleclick, drag"},
      {"size 100", "expected the height, found the end of the line"},
      {"size 0 100", "a whole number from 1 to 16384, found 0"},
      {"size 10.5 100", "found 10.5"},
      {"move", "expected a place, X Y or the name of a widget in quotes, found the end of the line"},
      {"move x 2", "in quotes, found \"x\""},
      {"move nan 2", "found \"nan\""},
      {"move 3", "expected Y, found the end of the line"},
      {"move \"A\" +3", "expected two offsets with their signs"},
      {"move \"A\" +3 4", "expected two offsets with their signs"},
      {"move \"\"", "a widget without a name"},
      {"click 1 2 3", "expected left, middle or right, found \"3\""},
      {"press both", "expected left, middle or right, found \"both\""},
      {"release left right", "\"right\" is one word too many"},
      {"drag 1 2", "expected a place"},
      {"drag 1 2 3 4 0", "expected the number of steps, a whole number from 1 to 100000, found 0"},
      {"wheel 1", "expected the notches up"},
      {"key", "expected a key, as in ctrl+z"},
      {"key ctrl+", "there is no key \"ctrl+\""},
      {"key hyper+z", "there is no key \"hyper+z\""},
      {"keydown f13", "there is no key \"f13\""},
      {"text", "expected the text"},
      {"text \"abc", "a quote is opened and not closed"},
      {"text \"a\\t\"", "after a backslash stands one of"},
      {"text \"a\"b", "expected a blank after the closing quote"},
      {"drop \"\"", "expected the name of a file, found an empty one"},
      {"frames -1", "a whole number from 1 to 100000, found -1"},
      {"screenshot", "expected a file"},
      {"quit now", "\"now\" is one word too many"},
  };
  for (const auto& [line, message] : faults) {
    try {
      parse_script(std::string("frames 1\n") + line + "\nquit\n", "a.script");
      ADD_FAILURE() << "not refused: " << line;
    } catch (const FileError& error) {
      EXPECT_EQ(error.line(), 2) << line;
      EXPECT_THAT(error.what(), HasSubstr("a.script:2: ")) << line;
      EXPECT_THAT(error.what(), HasSubstr(message)) << line;
    }
  }
}

TEST(Keys, EveryKeyIsFoundByItsNameAndItsLabel) {
  for (int i = 0; i < key_count; ++i) {
    const Key key = static_cast<Key>(i);
    EXPECT_EQ(key_named(name_of(key)), key) << name_of(key);
    EXPECT_EQ(key_named(label_of({key})), key) << name_of(key);
    for (const Modifiers modifiers : {Modifiers{}, Modifiers{.ctrl = true}, Modifiers{true, true, true}}) {
      const KeyChord chord{key, modifiers};
      EXPECT_EQ(chord_named(label_of(chord)), chord) << label_of(chord);
    }
  }
  EXPECT_EQ(label_of({Key::z, {.shift = true, .ctrl = true}}), "Ctrl+Shift+Z");
  EXPECT_EQ(chord_named("ctrl++"), (KeyChord{Key::plus, {.ctrl = true}}));
  EXPECT_EQ(chord_named("+"), KeyChord{Key::plus});
  for (const char* wrong : {"", "ctrl+", "shift+shift+z", "a+z", "ctrl+zz"})
    EXPECT_EQ(chord_named(wrong), std::nullopt) << wrong;
}

}  // namespace
}  // namespace seesaw
