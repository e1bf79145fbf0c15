// From panels to one sheet: pictures in rows, titles above them, the caption below.
#pragma once

#include "figures/figure.h"

namespace seesaw {

/// The whole figure, as large as it needs.
Canvas compose(const Figure& figure);

/// One panel with nothing around it but a margin.
Canvas compose_panel(const Panel& panel);

}  // namespace seesaw
