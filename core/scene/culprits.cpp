#include "core/scene/culprits.h"

#include <algorithm>

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
std::string in_words(const ConstraintError& error, const Constraints<Dim>& constraints) {
  std::string words = error.what();
  const std::vector<Index>& culprits = error.culprits();
  for (std::size_t i = 0; i < std::min(culprits.size(), most_culprits); ++i)
    words += line_about<Dim>(culprits[i], constraints[static_cast<std::size_t>(culprits[i])]);
  if (culprits.size() > most_culprits)
    words += "\n  and " + std::to_string(culprits.size() - most_culprits) + " more";
  return words;
}

template std::string in_words<2>(const ConstraintError&, const Constraints<2>&);
template std::string in_words<3>(const ConstraintError&, const Constraints<3>&);

}  // namespace seesaw
