#include "figures/figure.h"
namespace seesaw { Figure seesaw_figure(const FigureContext&) { return {}; } }
