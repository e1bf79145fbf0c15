// The list of all figures. A new figure is one file, figures/<id>.cpp, and one line here and in
// CMakeLists.txt.
#pragma once

#include "figures/figure.h"

namespace seesaw {

/// In the order of the papers.
const std::vector<FigureEntry>& catalog();

/// The entry of that id, or nullptr.
const FigureEntry* figure_named(const std::string& id);

}  // namespace seesaw
