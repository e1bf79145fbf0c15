// Where everything is in the window.
//
//     menu bar
//     tools | scene                  | plate   | side
//           |                        | profile |
//           | tour                             |
//     status
//
// Before it: the window's size, and what is shown. After it: app.h.
#pragma once

#include "core/image/rect.h"

namespace seesaw {

struct LayoutWish {
  double width = 1280, height = 800;  ///< of the window, logical pixels
  double menu = 24;                   ///< the menu bar's height
  double scale = 1;                   ///< of letters
  bool panels = true;                 ///< tools and side
  bool plate = false;
  bool profile = false;  ///< the chart of the profile line
  bool tour = false;
};

/// A Rect without width is not shown.
struct Layout {
  Rect tools, scene, plate, profile, tour, side, status;
};

/// The scene is never narrower than a fifth of the window: what does not fit beside it is left out, the
/// tools last.
Layout layout_of(const LayoutWish& wish);

}  // namespace seesaw
