// Inside core/image: what Cairo's SVG needs before it leaves the house.
//
// Before it: canvas_output.cpp, with the bytes that Cairo wrote. After it: Canvas::svg.
#pragma once

#include <string>
#include <vector>

namespace seesaw {

/// The same document, with three things put right.
///
/// Its parts are named part0, part1, ...: Cairo names them by counters that run on for as long as the program
/// does ("surface17"), so the second picture of a program would differ from the first.
///
/// Numbers are rounded to 1/1000 (of a point, of a percent), and settings that say no more than the default
/// are left out: much smaller, and no eye can tell.
///
/// `words`, one a line, stand in a <desc>: letters are drawn as outlines, so without it neither a search nor
/// a screen reader would find them. There is none when there are no words.
std::string tidied_svg(const std::string& svg, const std::vector<std::string>& words);

}  // namespace seesaw
