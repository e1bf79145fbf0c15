// Constructive solid geometry: solids cut by, joined to and shared with solids, to any depth.
//
//     const Solid bowl = (Solid(ball, clay) - Solid(smaller_ball, blue)) & Solid(lower_half, clay);
//
// "Standard ray tracing CSG techniques" (Turk & O'Brien 2002, section 7.2) are Roth's (1982, "Ray casting for
// modeling solids"): a ray is in each leaf for some stretches of t; a boolean of two solids is the boolean of
// their stretches. What is left of a stretch's end keeps its leaf, so its normal and material come from
// there, the normal turned around where a leaf was cut away. Ends are not moved: two surfaces that meet along
// an edge meet at the same t, so no gap opens between them.
//
// Before it: surface_tracer.h. After it: scene.h, render.h; csg_expression.h makes one from text.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/raytrace/material.h"
#include "core/raytrace/surface_tracer.h"

namespace seesaw {

/// Where a ray enters or leaves a solid.
struct SolidCrossing {
  double t = 0;
  int leaf = 0;      ///< whose surface it is
  bool cap = false;  ///< on a face of that leaf's bounding box
  bool entering = true;
};

/// A ray's way through a solid.
struct SolidCrossings {
  bool inside_at_begin = false;
  std::vector<SolidCrossing> crossings = {};  ///< in order of t
  Index evaluations = 0;                      ///< of all leaves' fields
  double unproven = 0;                        ///< the most of all leaves, see RayCrossings
};

class Solid {
 public:
  /// One leaf. The tracer may be shared among solids, and with it the boxes it has found.
  explicit Solid(std::shared_ptr<const SurfaceTracer> surface, const Material& material = {});

  // Inside either, inside both, inside `a` and not inside `b`. A leaf may appear several times.

  friend Solid operator|(const Solid& a, const Solid& b) { return combined(a, b, Step::unite); }
  friend Solid operator&(const Solid& a, const Solid& b) { return combined(a, b, Step::intersect); }
  friend Solid operator-(const Solid& a, const Solid& b) { return combined(a, b, Step::subtract); }

  struct Leaf {
    std::shared_ptr<const SurfaceTracer> surface;
    Material material;
  };
  const std::vector<Leaf>& leaves() const { return leaves_; }

  /// A box around the solid: leaves that are only subtracted do not count. Empty for a solid without inside.
  const Box<3>& box() const { return box_; }

  /// result[i] = where rays[i] enters and leaves; at most the first place when that is all that is asked for.
  /// Called from many threads.
  void trace(std::span<const Ray> rays, HowMany how_many, std::span<SolidCrossings> result) const;

  /// Whether each point (3 x N) is inside, by the leaves' values and their boxes.
  std::vector<bool> contains(const PointsRef<3>& points) const;

  /// Points on the solid's surface (3 x N), about `cells` along its box's longest side: where the edges of a
  /// lattice leave the solid. For framing and placing: parts thinner than a cell may go unseen. None for
  /// nothing seen.
  Points<3> surface_points(int cells = 40) const;

  /// Outward unit normals of leaf `leaf` at `places` (3 x N) on its surface; `cap` says which lie on its box
  /// instead. Zero where the gradient is.
  Points<3> normals(int leaf, const PointsRef<3>& places, std::span<const char> cap) const;

 private:
  // The expression with operators after what they work on: no recursion, so no depth is too deep.
  struct Step {
    enum Kind { push, unite, intersect, subtract };
    Kind kind;
    int leaf;
  };
  Solid() = default;
  static Solid combined(const Solid& a, const Solid& b, Step::Kind kind);

  std::vector<Leaf> leaves_;
  std::vector<Step> steps_;
  Box<3> box_;
};

}  // namespace seesaw
