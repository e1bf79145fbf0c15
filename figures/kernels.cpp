#include "figures/figure.h"
namespace seesaw { Figure kernels_figure(const FigureContext&) { return {}; } }
