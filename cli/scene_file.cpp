#include "cli/scene_file.h"

#include "cli/output.h"
#include "core/scene/culprits.h"

namespace seesaw {

template <int Dim>
Fit<Dim> fit_scene(const std::string& path, const Document<Dim>& document, bool condition) {
  const Constraints<Dim> constraints = constraints_of(document);
  try {
    return fit(constraints,
               {.kernel = document.kernel, .smoothing = document.smoothing, .condition = condition},
               percent("solving " + std::to_string(constraints.size()) + " constraints"));
  } catch (const ConstraintError& error) {
    throw FileError(path, in_words(error, constraints));
  }
}

template Fit<2> fit_scene<2>(const std::string&, const Document<2>&, bool);
template Fit<3> fit_scene<3>(const std::string&, const Document<3>&, bool);

}  // namespace seesaw
