// Constraints that many tests start from.
#pragma once

#include "core/base/random.h"
#include "core/rbf/constraints.h"
#include "core/rbf/energy.h"
#include "core/rbf/interpolant.h"

namespace seesaw {

/// Fig. 1 left of T&O 2002 in spirit: four zeros around one interior constraint.
inline Constraints<2> four_around_one() {
  return {boundary<2>({-1, -0.2}), boundary<2>({0.3, -0.9}), boundary<2>({1, 0.1}), boundary<2>({-0.1, 0.8}),
          interior<2>({0, 0})};
}

/// `n` constraints of all kinds at random places of [-1, 1]^Dim, every third one with a normal.
template <int Dim>
Constraints<Dim> random_constraints(Index n, Random& random) {
  const Box<Dim> box(Point<Dim>::Constant(-1), Point<Dim>::Constant(1));
  Constraints<Dim> result;
  for (Index i = 0; i < n; ++i) {
    const Point<Dim> at = random.points_in<Dim>(box, 1).col(0);
    if (i % 3 == 0) result.push_back(boundary<Dim>(at, random.direction<Dim>(), 0.02));
    if (i % 3 == 1) result.push_back(interior<Dim>(at, random.uniform(0.5, 2)));
    if (i % 3 == 2) result.push_back(exterior<Dim>(at, -random.uniform(0.5, 2)));
  }
  return result;
}

/// Random values at random points of [-1, 1]^Dim.
template <int Dim>
struct ScatteredData {
  Points<Dim> points;
  Values values;

  ScatteredData(Index n, Random& random)
      : points(random.points_in<Dim>(Box<Dim>(Point<Dim>::Constant(-1), Point<Dim>::Constant(1)), n)),
        values(n) {
    for (Index i = 0; i < n; ++i) values[i] = random.uniform(-1, 1);
  }
};

/// What rounding leaves of f(c) = h: the sum's terms are exact to some 1e-16 of their size.
template <int Dim>
double rounding_of(const Interpolant<Dim>& f) {
  const double reach = 2 * std::sqrt(static_cast<double>(Dim));
  return 1e-15 + 4e-16 * f.normalized_weights().cwiseAbs().sum() * std::pow(reach, growth_of(f.kernel()));
}

}  // namespace seesaw
