// A surface that can be moved: a field with parameters q that somebody sets, and its derivative by them.
//
// Before it: shapes that are given by numbers (spheres, blobby spheres and cylinders in parametric_shapes.h,
// the interpolating surface in core/rbf/parametric_interpolant.h).
// After it: core/particles. Control points solve for dq/dt, floaters follow the surface that moves.
//
// Witkin & Heckbert 1994, section 5, ask four functions of a shape: F, F_x, F_q and a bounding box. The
// first, second and fourth are Field's; this adds F_q. Their F is negative inside and ours positive,
//     f = -F,   f_x = -F_x,   f_q = -F_q,
// converted once, here: eqs. 1 to 8 are linear and homogeneous in F, so they hold for f as they stand.
//
// Any parameter can be frozen "by leaving it out of the q and F_q vectors": q below is what is left.
#pragma once

#include <string>
#include <vector>

#include "core/implicit/field.h"

namespace seesaw {

template <int Dim>
class ParametricField : public Field<Dim> {
 public:
  /// m: how many parameters are free.
  Index parameters() const { return static_cast<Index>(free_.size()); }
  /// The free parameters q (m), in the order of `names()`.
  Values q() const;
  /// Moves the surface; frozen parameters keep their values to the bit. Every entry must be finite. Not to be
  /// called while others evaluate.
  void set_q(const Eigen::Ref<const Values>& q);

  /// Column i of the result is f_q at points.col(i): m x N, value per unit of the parameter. `points` Dim x
  /// N. Called from many threads at once.
  Eigen::MatrixXd q_gradients(const PointsRef<Dim>& points) const;

  /// Of all parameters, free or frozen: "bias", "c0.x", ...
  virtual std::vector<std::string> names() const = 0;
  /// Leaves parameter `index` (of names()) out of q, or takes it in again.
  void freeze(Index index, bool frozen = true);
  bool is_frozen(Index index) const { return frozen_[static_cast<std::size_t>(index)]; }

 protected:
  /// To be called by the constructor of a shape with `count` parameters: all are free.
  void start(Index count);

  /// All parameters; to set those that are free and leave the others as they are.
  virtual Values all() const = 0;
  virtual void set_all(const Values& values) = 0;
  /// count x N.
  virtual Eigen::MatrixXd all_gradients(const PointsRef<Dim>& points) const = 0;

 private:
  std::vector<bool> frozen_;
  std::vector<Index> free_;
};

extern template class ParametricField<2>;
extern template class ParametricField<3>;

}  // namespace seesaw
