// The function of a scene file, or an error that says which of its constraints stand in the way.
#pragma once

#include <string>

#include "core/rbf/fit.h"
#include "core/scene/document.h"

namespace seesaw {

/// The function that meets the constraints of `document`, which came from the file `path`. `condition` as in
/// FitOptions. Throws FileError: what is impossible, then a line for each culprit with its index, kind and
/// position.
template <int Dim>
Fit<Dim> fit_scene(const std::string& path, const Document<Dim>& document, bool condition = false);

}  // namespace seesaw
