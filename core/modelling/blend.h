// One smooth object from several that overlap: the soft union of Turk & O'Brien 2002, section 6.
//
// Before it: each object's constraints (model_constraints.h, a scene) and its own function (core/rbf/fit.h).
// After it: core/rbf/fit.h fits the constraints that are left.
//
// The paper's rule: "a constraint from A with position c_i will be kept if f_B(c_i) < 0", for every other
// object B: what lies in another object is no longer surface. The gaps that are left where the objects meet
// are bridged by the smoothest function, without the bulges of summed blobbies (blobby.h).
//
//     const Fit<3> a = fit(constraints_a), b = fit(constraints_b);
//     const Blend<3> mixed = blend<3>({{constraints_a, &a.function}, {constraints_b, &b.function}});
//     const Fit<3> soft_union = fit(mixed.constraints);
//
// A normal constraint has a position of its own and is judged by it; but it is a companion, and goes when its
// boundary constraint goes. A position exactly on another object's surface is not outside it.
#pragma once

#include <vector>

#include "core/implicit/field.h"
#include "core/rbf/constraints.h"

namespace seesaw {

template <int Dim>
struct BlendObject {
  Constraints<Dim> constraints;
  /// The object alone, f > 0 inside. Not kept.
  const Field<Dim>* function = nullptr;
};

template <int Dim>
struct Blend {
  /// All that was kept: the first object's, in its order, then the second's, ...
  Constraints<Dim> constraints;
  /// Where each came from: object and index in that object's constraints.
  struct Origin {
    std::size_t object = 0;
    std::size_t constraint = 0;
  };
  std::vector<Origin> origins;
  /// Of each object, constraints kept and dropped, normal constraints counted as constraints.
  std::vector<Index> kept, dropped;
};

/// One evaluation of every other object's function at every constraint. One object alone is kept whole. The
/// order of the objects changes the order of the result and nothing else. Throws Error where nothing is kept:
/// then no object has a surface outside the others.
template <int Dim>
Blend<Dim> blend(const std::vector<BlendObject<Dim>>& objects);

extern template Blend<2> blend(const std::vector<BlendObject<2>>& objects);
extern template Blend<3> blend(const std::vector<BlendObject<3>>& objects);

}  // namespace seesaw
