#include "core/modelling/blend.h"

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/rbf/system.h"

namespace seesaw {

template <int Dim>
Blend<Dim> blend(const std::vector<BlendObject<Dim>>& objects) {
  for (const BlendObject<Dim>& object : objects) SEESAW_CHECK_EQ(object.function == nullptr, false);
  Blend<Dim> result;
  for (std::size_t a = 0; a < objects.size(); ++a) {
    const Constraints<Dim>& constraints = objects[a].constraints;
    result.kept.push_back(0);
    result.dropped.push_back(0);
    if (constraints.empty()) continue;
    // core/rbf/system.h knows where a normal constraint stands.
    const Rows<Dim> rows = rows_of<Dim>(constraints);
    Values highest = Values::Constant(rows.values.size(), -1.0);
    for (std::size_t b = 0; b < objects.size(); ++b)
      if (b != a) highest = highest.cwiseMax(objects[b].function->values(rows.centers));
    for (Index row = 0; row < rows.values.size(); ++row) {
      const auto& origin = rows.origins[static_cast<std::size_t>(row)];
      const auto index = static_cast<std::size_t>(origin.constraint);
      const bool outside = highest[row] < 0;
      if (origin.normal) {
        // A companion's row follows its boundary constraint's.
        const bool whole = !result.origins.empty() && result.origins.back().object == a &&
                           result.origins.back().constraint == index;
        if (whole && !outside) result.constraints.back().normal.reset();
        ++(whole && outside ? result.kept : result.dropped)[a];
        continue;
      }
      ++(outside ? result.kept : result.dropped)[a];
      if (!outside) continue;
      result.constraints.push_back(constraints[index]);
      result.origins.push_back({a, index});
    }
  }
  if (result.constraints.empty())
    throw Error(objects.empty() ? "there is nothing to blend"
                                : "nothing is left to blend: every constraint lies in another object");
  return result;
}

template Blend<2> blend(const std::vector<BlendObject<2>>& objects);
template Blend<3> blend(const std::vector<BlendObject<3>>& objects);

}  // namespace seesaw
