// What was drawn, as an Image: for screenshots, and for tests that look at what a person would see.
//
// Before it: a frame that is drawn and not yet shown. After it: core/image/png.h, core/image/compare.h.
#pragma once

#include "core/image/image.h"

namespace seesaw {

/// The lower left width x height pixels of what OpenGL reads from at present, top row first, opaque.
Image read_pixels(int width, int height);

}  // namespace seesaw
