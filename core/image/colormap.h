// Values to colors.
//
// *Diverging*, for the field f itself, whose zero is the shape: outside (f < 0) is blue, inside (f > 0) is
// orange, and zero is nearly paper. Three reasons for this map and no rainbow: blue and orange are the pair
// of hues that all common kinds of color blindness keep apart; lightness falls in a straight line from the
// middle to both ends, so that equal steps of f look equal and a gray print still shows |f|; and both sides
// have the same lightness at the same |f|, so neither seems to matter more. It stops at middle lightness (L
// = 46), so that ink-dark curves and symbols stay legible on it everywhere. It is built in CIE Lab, along
// one hue a side with a gentle turn.
//
// *Sequential*, for amounts without a sign (errors, counts, times): from pale yellow over green-blue to
// deep indigo, lightness falling all the way.
//
// Before it: color.h. After it: pictures of fields, height_plot.h, the heat panel of compare.h.
#pragma once

#include "core/image/color.h"

namespace seesaw {

/// `value` in -1 .. 1, clamped: -1 deep blue (far outside), 0 nearly white, 1 deep orange (deep inside).
/// Opaque. Not a number is theme::missing.
Color diverging_color(double value);

/// `value` in 0 .. 1, clamped: 0 pale, 1 dark. Opaque. Not a number is theme::missing.
Color sequential_color(double value);

}  // namespace seesaw
