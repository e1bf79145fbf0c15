// Where rays pass through the surface of one field: the question that sphere tracing answers.
//
// The solid is { x in the field's bounding box : f(x) >= 0 }. Cut off at the box it is always closed, so that
// a ray that enters also leaves, which Roth's booleans need (solid.h).
//
// Two answers to the same question, to be compared:
//   rigorous_tracer.h    steps that provably cannot pass the surface
//   heuristic_tracer.h   the paper's: steps by the steepest of 2,000 samples
//
// Before it: a Field<3>. After it: solid.h, render.h.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/implicit/field.h"
#include "core/raytrace/ray.h"

namespace seesaw {

/// A place where a ray passes from outside to inside or back.
struct Crossing {
  double t = 0;
  bool cap = false;  ///< on a face of the field's bounding box, which cuts the solid off
};

/// One ray's way through the solid. Crossings go in and out by turns, in order of t.
struct RayCrossings {
  bool inside_at_begin = false;
  std::vector<Crossing> crossings = {};
  Index evaluations = 0;  ///< of the field, on this ray
  /// No two crossings farther apart than this were passed over: proven. Infinite where nothing is.
  double unproven = 0;
};

enum class HowMany { first, all };

class SurfaceTracer {
 public:
  /// The field is shared and must not change.
  explicit SurfaceTracer(std::shared_ptr<const Field<3>> field);
  virtual ~SurfaceTracer() = default;

  /// result[i] = where rays[i] crosses the surface between its begin and end; only the first place when that
  /// is all that is asked for. Rays go forward together, so that the field is evaluated in batches. Called
  /// from many threads; a ray's answer does not depend on its company.
  void trace(std::span<const Ray> rays, HowMany how_many, std::span<RayCrossings> result) const;

  const Field<3>& field() const { return *field_; }
  const Box<3>& box() const { return box_; }

 protected:
  /// A ray that has been cut to the box, with what is found on it.
  struct Task {
    Ray ray;
    bool one_is_enough;
    RayCrossings* found;  ///< inside_at_begin and crossings but the caps, with t as in `ray`
  };
  virtual void trace_in_box(std::span<const Task> tasks) const = 0;

 private:
  std::shared_ptr<const Field<3>> field_;
  Box<3> box_;
};

/// The part of the ray in the box, or one with end < begin. Exact zeros in the direction are taken as they
/// are.
Ray within(const Ray& ray, const Box<3>& box);

}  // namespace seesaw
