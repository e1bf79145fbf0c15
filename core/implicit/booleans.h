// Union, intersection and difference of solids: constructive solid geometry on functions.
//
// Before it: any fields: interpolants, blobbies, primitives, or other booleans, to any depth.
// After it: core/implicit/field.h: a boolean is a Field like every other, so it can be meshed, traced, cut
// again.
//
// With f > 0 inside (Witkin & Heckbert 1994, section 2; Ricci 1973):
//     union          max(a, b, ...)         inside any
//     intersection   min(a, b, ...)         inside all
//     difference     min(a, -b)             inside a, not inside b
// Signs are exact: the zero set is precisely the boundary of the solid. Values elsewhere are bounds, not
// distances, even where the leaves' are. Zero counts as inside, so a difference keeps the wall that b cuts.
//
// On a seam, where the winning leaf changes, the gradient jumps. There it is the first winner's: one of the
// limits from the sides, so that a vertex on the sharp edge still has a normal.
#pragma once

#include <memory>
#include <vector>

#include "core/implicit/field.h"

namespace seesaw {

/// How fields are held by fields built from them: shared and never changed.
template <int Dim>
using FieldPointer = std::shared_ptr<const Field<Dim>>;

/// A field moved to where others can share it: Union<3>({share(Sphere<3>(...)), share(Torus(...))}).
template <class Leaf>
std::shared_ptr<const Leaf> share(Leaf leaf) {
  return std::make_shared<const Leaf>(std::move(leaf));
}

/// A field that somebody else keeps, and keeps longer than all that is built from the result.
template <int Dim>
FieldPointer<Dim> borrow(const Field<Dim>& field) {
  return FieldPointer<Dim>(FieldPointer<Dim>(), &field);
}

/// What the three have in common: f = outer * max_i(inner_i * f_i), with signs of +-1.
template <int Dim>
class Boolean : public Field<Dim> {
 public:
  /// One evaluation of every leaf a point.
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override;
  /// The largest bound of all leaves that can win somewhere in the box: one that is proven to lose everywhere
  /// in it, by its value at the middle and its own bound, does not count.
  double gradient_bound(const Box<Dim>& box) const override;

  /// For each point (Dim x N), which leaf's value is the boolean's: 0 .. size() - 1, the first of equals.
  std::vector<int> winners(const PointsRef<Dim>& points) const;
  const std::vector<FieldPointer<Dim>>& leaves() const { return leaves_; }

 protected:
  Boolean(std::vector<FieldPointer<Dim>> leaves, std::vector<double> inner, double outer);

 private:
  std::vector<FieldPointer<Dim>> leaves_;
  std::vector<double> inner_;
  double outer_;
};

/// Everything that is inside any of them.
template <int Dim>
class Union final : public Boolean<Dim> {
 public:
  /// At least one field, none of them null.
  explicit Union(std::vector<FieldPointer<Dim>> leaves);
  /// Around the boxes of all.
  Box<Dim> bounding_box() const override;
};

/// Everything that is inside all of them.
template <int Dim>
class Intersection final : public Boolean<Dim> {
 public:
  /// At least one field, none of them null.
  explicit Intersection(std::vector<FieldPointer<Dim>> leaves);
  /// What the boxes of all have in common; empty where they have nothing.
  Box<Dim> bounding_box() const override;
};

/// Everything that is inside `solid` and not inside `tool`.
template <int Dim>
class Difference final : public Boolean<Dim> {
 public:
  Difference(FieldPointer<Dim> solid, FieldPointer<Dim> tool);
  /// The solid's.
  Box<Dim> bounding_box() const override;
};

extern template class Boolean<2>;
extern template class Boolean<3>;
extern template class Union<2>;
extern template class Union<3>;
extern template class Intersection<2>;
extern template class Intersection<3>;
extern template class Difference<2>;
extern template class Difference<3>;

}  // namespace seesaw
