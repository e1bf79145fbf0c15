#include "core/modelling/adaptive_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/check.h"
#include "core/mesh/vertex_normals.h"
#include "core/modelling/foot_points.h"
#include "core/modelling/point_sampling.h"
#include "core/modelling/tolerant_fit.h"

namespace seesaw {

Values distances_to_surface(const Field<3>& field, const PointsRef<3>& points, double small) {
  Values result = first_order_distances(field, points);
  std::vector<Index> far;
  for (Index i = 0; i < result.size(); ++i)
    if (!(result[i] <= small)) far.push_back(i);
  if (far.empty()) return result;
  Points<3> doubtful(3, static_cast<Index>(far.size()));
  for (std::size_t k = 0; k < far.size(); ++k) doubtful.col(static_cast<Index>(k)) = points.col(far[k]);
  const Values feet = foot_distances(field, doubtful, 10 * small);
  for (std::size_t k = 0; k < far.size(); ++k) result[far[k]] = feet[static_cast<Index>(k)];
  return result;
}

namespace {

/// The points of a model that count, as columns, and which of its vertices they are.
struct Samples {
  Points<3> points;
  std::vector<Index> vertices;
};

Samples samples_of(const TriangleMesh& mesh) {
  std::vector<bool> used(static_cast<std::size_t>(mesh.vertices.cols()), false);
  for (Index i = 0; i < mesh.faces.size(); ++i) used[static_cast<std::size_t>(mesh.faces.data()[i])] = true;
  Samples samples;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) samples.vertices.push_back(static_cast<Index>(i));
  samples.points.resize(3, static_cast<Index>(samples.vertices.size()));
  for (std::size_t k = 0; k < samples.vertices.size(); ++k)
    samples.points.col(static_cast<Index>(k)) = mesh.vertices.col(samples.vertices[k]);
  return samples;
}

Samples samples_of(const PointCloud& cloud) {
  Samples samples{cloud.points, std::vector<Index>(static_cast<std::size_t>(cloud.points.cols()))};
  std::iota(samples.vertices.begin(), samples.vertices.end(), Index{0});
  return samples;
}

// Normals are computed once, not every round.
TriangleMesh prepared(const TriangleMesh& mesh) {
  TriangleMesh result = mesh;
  if (!result.has_normals()) result.normals = vertex_normals(mesh);
  return result;
}
PointCloud prepared(const PointCloud& cloud) { return cloud; }

/// The worst points, each at least `apart` from the others chosen here; no more than `count`, and none that
/// is better than `enough`.
std::vector<Index> worst(const Points<3>& points, const Values& errors, double enough, double apart,
                         Index count) {
  std::vector<Index> order;
  for (Index i = 0; i < errors.size(); ++i)
    if (!(errors[i] <= enough)) order.push_back(i);
  const auto size = [&](Index i) { return std::isnan(errors[i]) ? infinity : errors[i]; };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return size(a) > size(b) || (size(a) == size(b) && a < b); });
  std::vector<Index> result;
  for (const Index each : order) {
    if (static_cast<Index>(result.size()) >= count) break;
    bool near = false;
    for (const Index other : result)
      near |= (points.col(each) - points.col(other)).squaredNorm() < apart * apart;
    if (!near) result.push_back(each);
  }
  return result;
}

template <class Model>
AdaptiveFit run(const Model& given, const AdaptiveFitOptions& options, const Progress& progress) {
  SEESAW_CHECK_LT(0.0, options.tolerance);
  SEESAW_CHECK_LE(1, options.start);
  SEESAW_CHECK_LT(0.0, options.growth);
  const Model model = prepared(given);
  const Samples samples = samples_of(model);
  const double longest = UnitCube::of(bounding_box_of<3>(samples.points)).scale;
  const Index most = std::max(options.start, options.most);
  const PointSample start = farthest_points(samples.points, options.start);
  std::vector<bool> taken(samples.vertices.size(), false);
  std::vector<Index> chosen = start.chosen;  // of samples
  for (const Index each : chosen) taken[static_cast<std::size_t>(each)] = true;

  std::vector<AdaptiveStep> history;
  while (true) {
    report(progress, 0.98 * static_cast<double>(chosen.size()) / static_cast<double>(most));
    ModelConstraintOptions making = options.constraints;
    making.chosen.clear();
    for (const Index each : chosen) making.chosen.push_back(samples.vertices[static_cast<std::size_t>(each)]);
    ModelConstraints made = constraints_from(model, making);
    made.constraints.insert(made.constraints.end(), options.around.begin(), options.around.end());
    TolerantFit tolerant = fit_tolerantly(made.constraints, {.kernel = options.kernel, .condition = false});
    const Fit<3>& fitted = tolerant.fitted;
    // Where the model was moved to the unit cube, so are its points.
    const Points<3> points =
        making.to_unit_cube ? made.report.cube.apply(samples.points) : Points<3>(samples.points);
    const double unit = making.to_unit_cube ? 1.0 : longest;
    Values errors = distances_to_surface(fitted.function, points, 0.25 * options.tolerance * unit) / unit;
    AdaptiveStep step;
    step.vertices = made.report.boundary;
    step.rows = fitted.report.rows;
    step.max_error = errors.size() > 0 ? errors.maxCoeff() : 0.0;
    step.rms_error =
        errors.size() > 0 ? std::sqrt(errors.squaredNorm() / static_cast<double>(errors.size())) : 0.0;
    step.fit_seconds = fitted.report.seconds;
    history.push_back(step);

    const bool met = step.max_error <= options.tolerance;
    std::vector<Index> next;
    if (!met) {
      for (std::size_t i = 0; i < taken.size(); ++i)
        if (taken[i]) errors[static_cast<Index>(i)] = 0;  // thinned ones too: again would not help
      const double size = static_cast<double>(chosen.size());
      const double apart =
          0.7 * start.covering_radius * std::sqrt(static_cast<double>(start.chosen.size()) / size);
      const Index room = std::min(most - static_cast<Index>(chosen.size()),
                                  std::max<Index>(16, static_cast<Index>(options.growth * size)));
      next = worst(samples.points, errors, 0.5 * options.tolerance, apart, room);
    }
    if (next.empty()) {
      std::vector<Index> vertices = making.chosen;
      report(progress, 1.0);
      return {std::move(made),    std::move(tolerant.fitted), std::move(vertices),
              std::move(history), tolerant.left_out,          met};
    }
    for (const Index each : next) {
      chosen.push_back(each);
      taken[static_cast<std::size_t>(each)] = true;
    }
  }
}

}  // namespace

AdaptiveFit fit_adaptively(const TriangleMesh& mesh, const AdaptiveFitOptions& options,
                           const Progress& progress) {
  return run(mesh, options, progress);
}

AdaptiveFit fit_adaptively(const PointCloud& cloud, const AdaptiveFitOptions& options,
                           const Progress& progress) {
  return run(cloud, options, progress);
}

}  // namespace seesaw
