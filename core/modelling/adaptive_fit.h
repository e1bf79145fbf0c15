// A scan has a hundred thousand points, a dense solver takes a few thousand: which ones does this model need?
//
// Before it: the full-resolution model.  After it: core/rbf's function, and how far it is from the model.
//
// Carr et al. 2001, section 4 ("center reduction"): fit a few, look where the surface misses the model most,
// add centers there, fit again. The distance of each point of the model from the surface is |f| / |grad f|,
// and where that is not small the distance to the point's foot on the surface (foot_points.h), which is never
// too short. The worst points are added in batches, spread out: the next one is taken only where none was
// added nearby.
//
// What is measured is how far the model is from the surface. The surface may still do more than the model
// says where the model says nothing: across the hole of a scan.
#pragma once

#include <optional>
#include <vector>

#include "core/modelling/model_constraints.h"
#include "core/rbf/fit.h"

namespace seesaw {

struct AdaptiveFitOptions {
  /// No point of the model may be farther from the surface than this fraction of the model's longest side.
  double tolerance = 0.002;
  /// Boundary constraints to begin with, by farthest_points.
  Index start = 400;
  /// No more boundary constraints than this: time goes with its cube, memory with its square (with a normal
  /// each, 3,000 take 0.3 GB and some seconds).
  Index most = 3000;
  /// Each round adds at most this fraction of what there is.
  double growth = 0.3;
  /// How points become constraints; `chosen` is ours.
  ModelConstraintOptions constraints = {};
  /// Further constraints of every round, such as a cage around an open scan, in the coordinates of the
  /// result.
  Constraints<3> around = {};
  /// None: the papers' |x|^3.
  std::optional<Kernel> kernel = std::nullopt;
};

/// One round.
struct AdaptiveStep {
  Index vertices = 0;      ///< boundary constraints
  Index rows = 0;          ///< rows of the system
  double max_error = 0;    ///< over all points of the model, as a fraction of its longest side
  double rms_error = 0;    ///< likewise
  double fit_seconds = 0;  ///< wall time of the solver
};

struct AdaptiveFit {
  ModelConstraints made;              ///< of the last round
  Fit<3> fitted;                      ///< likewise
  std::vector<Index> chosen;          ///< indices of its points in the model
  std::vector<AdaptiveStep> history;  ///< at least one round; the last is what was returned
  Index left_out = 0;                 ///< constraints of the last round that the solver could not take
  bool met = false;                   ///< the tolerance holds at every point of the model
};

/// Fits until the tolerance is met, `most` is reached or nothing is left to add. Throws as constraints_from
/// and fit_tolerantly do; Cancelled.
AdaptiveFit fit_adaptively(const TriangleMesh& mesh, const AdaptiveFitOptions& options = {},
                           const Progress& progress = {});
AdaptiveFit fit_adaptively(const PointCloud& cloud, const AdaptiveFitOptions& options = {},
                           const Progress& progress = {});

/// How far each point (3 x N) is from f = 0, scene units: first order, and the foot where that is more than
/// `small` > 0.
Values distances_to_surface(const Field<3>& field, const PointsRef<3>& points, double small);

}  // namespace seesaw
