// A figure's files: ID.png, one PNG a panel, and ID.json with what was measured.
#pragma once

#include "figures/figure.h"

namespace seesaw {

/// The content of ID.json: figure, paper, title, shows, caption, panels (name, png, facts), checks, holds.
Facts description_of(const Figure& figure);

/// What stands for it where the figure could not be made: figure, title, no panels, no checks, and `missing`,
/// the reason.
Facts description_of_missing(const FigureEntry& entry, const std::string& reason);

/// Writes ID.png, ID-<panel>.png and ID.json into `folder`, which is made if it is missing; `scale` pixels a
/// point. Throws FileError.
void write_figure(const Figure& figure, const std::filesystem::path& folder, double scale = 2);

/// Writes ID.png alone, one pixel a point, into `folder`: the reference that later pictures are compared
/// with.
void write_reference(const Figure& figure, const std::filesystem::path& folder);

}  // namespace seesaw
