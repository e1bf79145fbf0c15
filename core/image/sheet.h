// Inside core/image: what a Canvas remembers, and how far from the sheet a coordinate may be.
//
// Each mark is a function that paints itself with a Cairo context; the three kinds of picture replay the
// same list. Cairo itself keeps coordinates in 24 bits before the point and wraps around beyond: a point at
// 1e9 would come back in the middle of the picture. So marks are cut to `reach` before Cairo sees them.
//
// Before it: canvas.cpp, which fills the list. After it: canvas_output.cpp and raster.cpp, which replay it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/image/canvas.h"

struct _cairo;  // cairo_t, by Cairo's own name for it: its headers stay out of ours

namespace seesaw {

/// What a mark paints itself with. Pixels draw letters as outlines, at their exact places; Cairo's own
/// letters snap to whole pixels there.
struct Brush {
  _cairo* cairo;
  bool pixels;
};

struct Canvas::Marks {
  double width, height;  // points
  Color background;
  std::vector<std::function<void(const Brush&)>> list;
  /// What ends each scope that is still open, innermost last.
  std::vector<std::function<void(const Brush&)>> open;
  /// Every text drawn, for the SVG's description.
  std::vector<std::string> words;

  /// The sheet grown by its own size on every side and by a stroke's width: whatever lies outside is
  /// invisible.
  Box<2> reach(double stroke_width = 0) const;
};

/// The parts of a polyline that lie in `box`, cut exactly at its border and broken at points that are not
/// numbers.
std::vector<Points<2>> pieces_within(const PointsRef<2>& points, const Box<2>& box);

/// A closed ring cut to `box` (Sutherland and Hodgman 1974): inside the box it covers the same area, with
/// the same winding. Points that are not numbers are left out.
Points<2> ring_within(const PointsRef<2>& ring, const Box<2>& box);

/// Paints the background and all marks, in the units of Brush's context: points. Throws Error where Cairo
/// cannot.
void replay_marks(const Canvas::Marks& marks, const Brush& brush);

/// Throws Error for a cairo_status_t that is not success.
void require_cairo(int status);

/// A color as Cairo must have it: clamped to 0 .. 1, not a number is 0.
Color safe(const Color& color);

}  // namespace seesaw
