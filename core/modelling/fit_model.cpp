#include "core/modelling/fit_model.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/mesh/mesh_check.h"
#include "core/mesh/simplify.h"
#include "core/mesh/vertex_normals.h"
#include "core/modelling/cage.h"
#include "core/modelling/clean_cloud.h"
#include "core/modelling/point_sampling.h"
#include "core/modelling/tolerant_fit.h"
#include "core/modelling/triangle_tree.h"

namespace seesaw {

namespace {

// The sum of cosines between x - middle and its direction out, and of their weights.
double average_cosine(const Points<3>& at, const Points<3>& directions) {
  const Point<3> middle = bounding_box_of<3>(at).center();
  double sum = 0, weights = 0;
  for (Index i = 0; i < at.cols(); ++i) {
    const double weight = directions.col(i).norm();
    const double distance = (at.col(i) - middle).norm();
    if (!std::isfinite(weight) || !(weight > 0) || !(distance > 0)) continue;
    sum += (at.col(i) - middle).dot(directions.col(i)) / distance;
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0.0;
}

TriangleMesh turned(TriangleMesh mesh) {
  mesh.faces.row(1).swap(mesh.faces.row(2));
  mesh.normals = -mesh.normals;
  return mesh;
}
PointCloud turned(PointCloud cloud) {
  cloud.normals = -cloud.normals;
  return cloud;
}

bool is_open(const TriangleMesh& mesh) { return !check_mesh(mesh).closed; }
bool is_open(const PointCloud&) { return true; }

Points<3> points_of(const TriangleMesh& mesh) {
  std::vector<bool> used(static_cast<std::size_t>(mesh.vertices.cols()), false);
  for (Index i = 0; i < mesh.faces.size(); ++i) used[static_cast<std::size_t>(mesh.faces.data()[i])] = true;
  Points<3> points(3, std::count(used.begin(), used.end(), true));
  Index n = 0;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) points.col(n++) = mesh.vertices.col(static_cast<Index>(i));
  return points;
}
Points<3> points_of(const PointCloud& cloud) { return cloud.points; }

ModelConstraints choose(const TriangleMesh& mesh, Index count, const FitModelOptions& options, Choice& choice,
                        std::string& trouble, const Progress& progress) {
  if (options.simplify) {
    choice = Choice::simplified;
    try {
      return constraints_from(simplify(mesh, count, progress), options.constraints, progress);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      trouble = error.what();
    }
  }
  choice = Choice::farthest;
  ModelConstraintOptions making = options.constraints;
  // Indices of vertices in faces only: an unused one has no normal.
  std::set<Index> used;
  for (Index i = 0; i < mesh.faces.size(); ++i) used.insert(mesh.faces.data()[i]);
  const std::vector<Index> vertices(used.begin(), used.end());
  for (const Index each : farthest_points(points_of(mesh), count).chosen)
    making.chosen.push_back(vertices[static_cast<std::size_t>(each)]);
  return constraints_from(mesh, making, progress);
}

ModelConstraints choose(const PointCloud& cloud, Index count, const FitModelOptions& options, Choice& choice,
                        std::string&, const Progress& progress) {
  choice = Choice::farthest;
  ModelConstraintOptions making = options.constraints;
  making.chosen = farthest_points(cloud.points, count).chosen;
  return constraints_from(cloud, making, progress);
}

Faces faces_of(const TriangleMesh& mesh) { return mesh.faces; }
Faces faces_of(const PointCloud& cloud) {
  Faces faces(3, cloud.points.cols());
  for (Index i = 0; i < faces.cols(); ++i) faces.col(i).setConstant(static_cast<int>(i));
  return faces;
}
const Points<3>& all_points_of(const TriangleMesh& mesh) { return mesh.vertices; }
const Points<3>& all_points_of(const PointCloud& cloud) { return cloud.points; }

/// Exterior constraints on a box around the model, in the coordinates of the result.
template <class Model>
Constraints<3> cage_around(const Model& model, const Box<3>& box, const ModelConstraintOptions& options) {
  constexpr double margin = 0.15;  // of the longest side
  const UnitCube cube = UnitCube::of(box);
  const TriangleTree tree(cube.apply(all_points_of(model)), faces_of(model));
  const Point<3> sides = box.sizes() / cube.scale + Point<3>::Constant(2 * margin);
  Constraints<3> cage = cube_cage(Point<3>::Zero(), 1, 3);
  for (Constraint<3>& each : cage) {
    each.at = each.at.cwiseProduct(sides);
    each.value = -options.value * tree.nearest(each.at).distance / options.offset;
    if (!options.to_unit_cube) each.at = cube.center + cube.scale * each.at;
  }
  return cage;
}

void refuse_without_normals(const ModelConstraintReport& report) {
  if (report.normal > 0 || report.boundary == 0) return;
  throw Error(
      "the model has no usable normals, so nothing says which side of it is inside; give its points normals "
      "that lead out");
}

template <class Model>
FittedModel run(const Model& given, const FitModelOptions& options, const Progress& progress) {
  const bool open = is_open(given);
  const bool inward = open && outwardness(given) < -0.1;
  const bool turn = options.turn_normals && inward;
  const Model turned_model = turn ? turned(given) : Model();
  const Model& model = turn ? turned_model : given;
  const Points<3> points = points_of(model);
  if (points.cols() == 0) constraints_from(model, options.constraints);  // says what is missing

  const Box<3> box = bounding_box_of<3>(points);
  const bool caged = options.cage && open && (turn || !inward) && box.sizes().maxCoeff() > 0;
  const Constraints<3> cage = caged ? cage_around(model, box, options.constraints) : Constraints<3>();

  if (options.tolerance) {
    AdaptiveFit made = fit_adaptively(model,
                                      {.tolerance = *options.tolerance,
                                       .start = options.vertices.value_or(std::min<Index>(400, options.most)),
                                       .most = options.most,
                                       .constraints = options.constraints,
                                       .around = cage,
                                       .kernel = options.kernel},
                                      progress);
    refuse_without_normals(made.made.report);
    const AdaptiveStep last = made.history.back();
    return {.made = std::move(made.made),
            .fitted = std::move(made.fitted),
            .choice = Choice::adaptive,
            .max_error = last.max_error,
            .rms_error = last.rms_error,
            .points = points.cols(),
            .turned = turn,
            .left_out = made.left_out,
            .cage = static_cast<Index>(cage.size()),
            .open = open,
            .met = made.met,
            .history = std::move(made.history)};
  }

  Choice choice = Choice::all;
  std::string trouble;
  const Index all = points.cols();
  const Index count = options.vertices.value_or(all <= FitModelOptions::whole ? all : FitModelOptions::usual);
  ModelConstraints made = count >= all ? constraints_from(model, options.constraints, progress)
                                       : choose(model, count, options, choice, trouble, progress);
  refuse_without_normals(made.report);
  made.constraints.insert(made.constraints.end(), cage.begin(), cage.end());
  report(progress, 0.3);
  TolerantFit tolerant = fit_tolerantly(made.constraints, {.kernel = options.kernel, .condition = false});
  report(progress, 0.9);
  const bool moved = options.constraints.to_unit_cube;
  const UnitCube cube = UnitCube::of(box);
  const Points<3> here = moved ? made.report.cube.apply(points) : points;
  const double unit = moved ? 1.0 : cube.scale;
  const Values errors = distances_to_surface(tolerant.fitted.function, here, 5e-4 * unit) / unit;
  const double rms = std::sqrt(errors.squaredNorm() / static_cast<double>(errors.size()));
  return {.made = std::move(made),
          .fitted = std::move(tolerant.fitted),
          .choice = choice,
          .max_error = errors.maxCoeff(),
          .rms_error = rms,
          .points = points.cols(),
          .turned = turn,
          .left_out = tolerant.left_out,
          .cage = static_cast<Index>(cage.size()),
          .open = open,
          .trouble = std::move(trouble)};
}

}  // namespace

double outwardness(const TriangleMesh& mesh) {
  Points<3> middles(3, mesh.faces.cols()), areas(3, mesh.faces.cols());
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    const Point<3> a = mesh.vertices.col(mesh.faces(0, f)), b = mesh.vertices.col(mesh.faces(1, f)),
                   c = mesh.vertices.col(mesh.faces(2, f));
    middles.col(f) = a + ((b - a) + (c - a)) / 3;
    areas.col(f) = (b - a).cross(c - a);
  }
  return average_cosine(middles, areas);
}

double outwardness(const PointCloud& cloud) {
  if (!cloud.has_normals()) return 0.0;
  Points<3> unit = cloud.normals;
  for (Index i = 0; i < unit.cols(); ++i) {
    const double size = unit.col(i).cwiseAbs().maxCoeff();
    const bool known = unit.col(i).allFinite() && size > 0;
    unit.col(i) = known ? Point<3>((unit.col(i) / size).normalized()) : Point<3>::Zero();
  }
  return average_cosine(cloud.points, unit);
}

FittedModel fit_model(const TriangleMesh& mesh, const FitModelOptions& options, const Progress& progress) {
  return run(mesh, options, progress);
}
FittedModel fit_model(const PointCloud& cloud, const FitModelOptions& options, const Progress& progress) {
  if (!options.clean) return run(cloud, options, progress);
  const CleanCloud clean = cleaned(cloud);
  FittedModel fitted = run(clean.cloud, options, progress);
  fitted.strays = clean.strays;
  fitted.contradicted = clean.contradicted;
  return fitted;
}

}  // namespace seesaw
