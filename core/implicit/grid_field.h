// A field as its values and gradients on a grid, and smooth in between: costs the same whatever it was
// before.
//
// A function of 3,000 centers takes microseconds a point. A picture that is gone in a thirtieth of a second
// asks for it at a few thousand points of a grid, and draws from those: colors, isolines, curve. Between its
// corners a cell is a bicubic Hermite patch through values, gradients and the mixed derivative (by
// differences of the gradients): continuous with its gradient, off by O(h^4) for cells of size h.
//
//     const GridField draft(function, seen, 96, 60);
//     contour(draft, seen);
//
// It is not the function: what passes through a constraint here passes near it there. For pictures in a
// hurry.
//
// Before it: any Field<2>. After it: contour and colors, as with any Field.
#pragma once

#include <vector>

#include "core/implicit/field.h"

namespace seesaw {

class GridField final : public Field<2> {
 public:
  /// `columns` x `rows` cells, at least 1 each, over `box`, which has width and height. Evaluates `field` at
  /// all (columns + 1) (rows + 1) corners with gradients. Beyond the box the patches at its rim go on.
  GridField(const Field<2>& field, const Box<2>& box, int columns, int rows);

  void evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<2>> gradients) const override;
  /// Infinite.
  double gradient_bound(const Box<2>& box) const override;
  Box<2> bounding_box() const override { return box_; }

 private:
  // f, and its derivatives by x, y and both, in units of a cell.
  struct Corner {
    double f = 0, fx = 0, fy = 0, fxy = 0;
  };
  const Corner& corner(int column, int row) const {
    return corners_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
                    static_cast<std::size_t>(column)];
  }
  /// The value, and the gradient in scene units where `gradient` is not null.
  double at(const Point<2>& p, Point<2>* gradient) const;

  Box<2> box_;
  int columns_, rows_;
  Point<2> cell_;
  std::vector<Corner> corners_;
};

}  // namespace seesaw
