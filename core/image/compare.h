// Would a person call these two pictures the same?
//
// Byte for byte is too strict: another version of a library moves an edge by a tenth of a pixel. A mean
// over raw pixels is too lax: a missing symbol is lost among a million pixels of paper. So both pictures
// are taken to CIE Lab, where distance is what the eye sees, and blurred by about two pixels: a line
// shifted by one pixel then differs a little along itself, while a symbol that is there in one and not in
// the other still stands out.
//
//     difference = blur(Lab(a)) - blur(Lab(b)),   Delta E = |difference| in each pixel.
//
// Before it: two Images. After it: the figure tests, which judge `worst` and `noticeable`, and keep the
// difference picture for a person to look at.
#pragma once

#include "core/image/image.h"

namespace seesaw {

struct CompareOptions {
  double blur = 2.0;             ///< standard deviation of the blur, pixels; 0 for none
  double just_noticeable = 2.3;  ///< Delta E from which a pixel counts as noticeable
};

/// Color differences are CIE 1976 Delta E after the blur: 0 alike, 2.3 just noticeable, 100 black against
/// white.
struct Comparison {
  bool same_size = false;   ///< if not, the other numbers say "as different as can be": 100, 100, 100 and 1
  double mean = 100;        ///< over all pixels
  double percentile = 100;  ///< exceeded by one pixel in a thousand
  double worst = 100;       ///< the largest
  double noticeable = 1;    ///< fraction of pixels that differ noticeably, 0 .. 1
};

/// Compares as shown on white paper. Two images without pixels are alike.
Comparison compare_images(const Image& a, const Image& b, const CompareOptions& options = {});

/// a, b, and a heat picture of Delta E (pale 0, dark 20 and more) side by side on paper, with a gap of 8
/// pixels. Where the sizes differ, the heat picture is as large as both and dark wherever only one of them
/// is.
Image difference_picture(const Image& a, const Image& b, const CompareOptions& options = {});

}  // namespace seesaw
