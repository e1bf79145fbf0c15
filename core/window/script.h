// A written-down hand: what a test or a screenshot does to a window, one command a line.
//
//     # Pull the interior value up, and take a picture.
//     size 1280 800
//     click "Select"
//     drag 400 300 520 260 20
//     key ctrl+z
//     screenshot out/window.png
//
//     size W H                     the window's size, logical pixels
//     move PLACE                   the pointer goes there
//     press [BUTTON]               left, middle or right; left where none is named
//     release [BUTTON]
//     click PLACE [BUTTON]         goes there, and a frame later presses, and a frame later releases
//     doubleclick PLACE [BUTTON]
//     drag PLACE PLACE [STEPS] [BUTTON]   in STEPS moves, 10 where no number is given
//     wheel RIGHT UP               notches, where the pointer is
//     key CHORD                    f1, z, ctrl+shift+z: pressed, and a frame later released; no letters are
//     typed keydown KEY   keyup KEY      held meanwhile: keydown shift text "WORDS"                 typed
//     into what has the caret; \" \\ \n as in C drop FILE                    a file falls on the window;
//     relative to the script's folder frames N                     N frames in which nothing is done
//     screenshot FILE              this frame as PNG; relative to where the program was started
//     quit                         the window's closing button
//
// A PLACE is two numbers, X Y in logical pixels from the top left, or the name of a widget, "Undo" or, where
// several are called that, "Panel/Undo": its middle, or so much beside it: "Smoothing" +40 +0. Names with
// blanks, and files with blanks, stand in quotes. What follows a # is a comment.
//
// The commands become SDL's own events in SDL's own queue, so everything that a person's hand passes through
// is passed through. Before it: a file. After it: Window::play.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/window/input.h"

namespace seesaw {

/// Where on the window: `at`, or so far from the middle of the widget called `widget`.
struct ScriptPlace {
  std::string widget = {};
  Point<2> at = Point<2>::Zero();
};

namespace script {

struct Size {
  int width = 0, height = 0;
};
struct MoveTo {
  ScriptPlace to;
};
struct Press {
  MouseButton button = MouseButton::left;
};
struct Release {
  MouseButton button = MouseButton::left;
};
struct Click {
  ScriptPlace at;
  MouseButton button = MouseButton::left;
  int times = 1;
};
struct Drag {
  ScriptPlace from, to;
  int steps = 10;
  MouseButton button = MouseButton::left;
};
struct Wheel {
  double right = 0, up = 0;
};
struct Type {
  KeyChord chord;
};
struct Hold {
  Key key;
  bool down;
};
struct Text {
  std::string words;
};
struct Drop {
  std::filesystem::path file;
};
struct Frames {
  int count = 1;
};
struct Screenshot {
  std::filesystem::path file;
};
struct Quit {};

using Command = std::variant<Size, MoveTo, Press, Release, Click, Drag, Wheel, Type, Hold, Text, Drop, Frames,
                             Screenshot, Quit>;

}  // namespace script

struct ScriptLine {
  script::Command command;
  int line = 0;  ///< of the file, counted from 1; 0 for none
};

struct Script {
  std::string name = "script";  ///< what errors call it
  std::vector<ScriptLine> lines = {};
};

/// Throws FileError with the line and what was expected. `folder` is where dropped files are looked for.
Script parse_script(std::string_view text, const std::string& name = "script",
                    const std::filesystem::path& folder = {});
Script read_script(const std::filesystem::path& path);

}  // namespace seesaw
