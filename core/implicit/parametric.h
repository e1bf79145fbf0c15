// A surface that can be moved: a field with parameters q that somebody sets, and its derivative by them.
//
// Before it: shapes that are given by numbers (spheres, blobby spheres and cylinders in parametric_shapes.h,
// the interpolating surface in core/rbf/parametric_interpolant.h).
// After it: core/particles. Control points solve for q' = dq/dt (control_points.h), floaters follow the
// surface that moves (floaters.h).
//
// Witkin & Heckbert 1994, section 5, ask four functions of a shape: F, F_x, F_q and a bounding box. The
// first, second and fourth are Field's; this adds F_q. Their F is negative inside and ours positive,
//     f = -F,   f_x = -F_x,   f_q = -F_q,
// converted once, by the shapes. Eqs. 1 to 8 hold for f as they stand: all of them are linear and homogeneous
// in F and the multipliers.
//
// Any parameter can be frozen "by leaving it out of the q and F_q vectors" (section 5): q below is what is
// left.
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
  /// Moves the surface; frozen parameters keep their values to the bit. Throws Error where q is not finite or
  /// the shape has no surface for it (two constraints of an interpolant have met); the surface is then as it
  /// was. Not to be called while others evaluate.
  void set_q(const Eigen::Ref<const Values>& q);

  /// Column i of the result is f_q at points.col(i): m x N, value per unit of the parameter. `points` Dim x
  /// N. One caller at a time for this and `rates`, unlike `evaluate`: an interpolant solves for it.
  Eigen::MatrixXd q_gradients(const PointsRef<Dim>& points) const;
  /// f_t = f_q . q' at points.col(i), N, value per unit of time: how fast f changes where floaters are, while
  /// the parameters move at `q_rates` (m). Shapes whose f_q is long may know a way that never makes f_q.
  Values rates(const PointsRef<Dim>& points, const Eigen::Ref<const Values>& q_rates) const;

  /// Of all parameters, free or frozen: "bias", "c0.x", ...
  virtual std::vector<std::string> names() const = 0;
  /// Leaves parameter `index` (of names()) out of q, or takes it in again.
  void freeze(Index index, bool frozen = true);
  bool is_frozen(Index index) const;

 protected:
  /// To be called by the constructor of a shape with `count` parameters: all are free.
  void start(Index count);

  // What a shape implements. It knows nothing of freezing: these three are about all of its parameters.

  virtual Values all() const = 0;
  /// Values of frozen parameters are those of all(), bit for bit. May throw Error, having changed nothing.
  virtual void set_all(const Values& values) = 0;
  /// count x N.
  virtual Eigen::MatrixXd all_gradients(const PointsRef<Dim>& points) const = 0;
  /// all_gradients' times `rates` (count), N.
  virtual Values all_rates(const PointsRef<Dim>& points, const Values& rates) const;

 private:
  std::vector<bool> frozen_;
  std::vector<Index> free_;
};

/// The names of a point's coordinates: `prefix` + ".x", ".y", ".z".
template <int Dim>
void append_coordinate_names(const std::string& prefix, std::vector<std::string>& names);

extern template class ParametricField<2>;
extern template class ParametricField<3>;

}  // namespace seesaw
