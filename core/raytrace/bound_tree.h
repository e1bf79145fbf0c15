// Boxes that shrink: how steep the field can be in each, and which of them hold no surface.
//
// An octree over the field's bounding box. A box with center m and half diagonal R in which |grad f| <= L
// holds no surface when |f(m)| > L R: rays skip it. Others are cut in eight while that makes L much smaller;
// L of the smallest box around a point then says how far a ray may step there (Kalra and Barr 1989 had the
// idea of boxes with bounds; here the bounds are Field::gradient_bound).
//
// A bound of an interpolant costs some twenty values of it. So a box that is nearly empty by the bound of
// the box it was cut from is cut again with that bound, which holds in it too; only where that would lead far
// does it ask for a bound of its own. And boxes are made only when a ray comes along: what is hidden or off
// the picture costs nothing. What a box holds, and whether it is cut, depends on the box alone, so that
// answers are the same whichever ray, or thread, asks first.
//
// Before it: Field::gradient_bound. After it: rigorous_tracer.cpp.
#pragma once

#include <atomic>
#include <memory>

#include "core/implicit/field.h"

namespace seesaw {

struct BoundTreeOptions {
  /// A box is cut when its bound exceeds `pays` times the gradient in its middle ...
  double pays = 2;
  /// ... and its longest side is more than this, relative to the longest side of the tree.
  double smallest_side = 1.0 / 256;
  /// A box asks for a bound of its own where the bound that it inherits is more than this many times too
  /// large to prove it empty, 1 or more.
  double inherits = 3;
};

class BoundTree {
 public:
  /// What is known of the smallest box that holds a point.
  struct Leaf {
    Box<3> box;
    double bound = 0;    ///< |grad f| exceeds it nowhere in the box
    double middle = 0;   ///< f in the middle of the box
    bool empty = false;  ///< then f has the sign of `middle` everywhere in the box
  };

  /// `box` must not be empty.
  BoundTree(std::shared_ptr<const Field<3>> field, const Box<3>& box, const BoundTreeOptions& options = {});
  ~BoundTree();
  BoundTree(const BoundTree&) = delete;
  BoundTree& operator=(const BoundTree&) = delete;

  /// The leaf that holds `point`, which lies in the tree's box, or next to it by rounding; of several, the
  /// one on the side that `direction` leads to. Called from many threads.
  Leaf leaf_at(const Point<3>& point, const Point<3>& direction) const;

  // How many boxes rays have come upon so far: in all, those found empty, those with a bound of their own.
  Index boxes() const { return boxes_; }
  Index empty_boxes() const { return empty_boxes_; }
  Index bounds() const { return bounds_; }

 private:
  struct Node;
  struct Children;
  struct Facts;
  Children& children_of(Node& node, const Box<3>& box) const;
  Facts facts_of(Node& node, const Box<3>& box, double inherited) const;

  std::shared_ptr<const Field<3>> field_;
  Box<3> box_;
  BoundTreeOptions options_;
  std::unique_ptr<Node> root_;
  mutable std::atomic<Index> boxes_ = 0, empty_boxes_ = 0, bounds_ = 0;
};

}  // namespace seesaw
