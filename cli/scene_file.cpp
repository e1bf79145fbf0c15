#include "cli/scene_file.h"

#include <algorithm>

#include "cli/output.h"
#include "core/scene/document_rules.h"
#include "core/scene/json_text.h"

namespace seesaw {

namespace {

// A message about a thousand culprits helps nobody.
constexpr std::size_t most_culprits = 10;

template <int Dim>
std::string line_about(Index index, const Constraint<Dim>& constraint) {
  // Positions in full: culprits often differ in the last digits only.
  std::string at;
  for (int d = 0; d < Dim; ++d) at += (d ? ", " : "") + json_number(constraint.at[d]);
  return "\n  constraints[" + std::to_string(index) + "]: " + name_of(constraint.kind) +
         (constraint.normal ? " with a normal" : "") + " at (" + at + "), value " +
         json_number(constraint.value);
}

}  // namespace

template <int Dim>
Fit<Dim> fit_scene(const std::string& path, const Document<Dim>& document, bool condition) {
  const Constraints<Dim> constraints = constraints_of(document);
  try {
    return fit(constraints,
               {.kernel = document.kernel, .smoothing = document.smoothing, .condition = condition},
               percent("solving " + std::to_string(constraints.size()) + " constraints"));
  } catch (const ConstraintError& error) {
    std::string message = error.what();
    const std::vector<Index>& culprits = error.culprits();
    for (std::size_t i = 0; i < std::min(culprits.size(), most_culprits); ++i)
      message += line_about<Dim>(culprits[i], constraints[static_cast<std::size_t>(culprits[i])]);
    if (culprits.size() > most_culprits)
      message += "\n  and " + std::to_string(culprits.size() - most_culprits) + " more";
    throw FileError(path, message);
  }
}

template Fit<2> fit_scene<2>(const std::string&, const Document<2>&, bool);
template Fit<3> fit_scene<3>(const std::string&, const Document<3>&, bool);

}  // namespace seesaw
