#include "core/modelling/model_constraints.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/mesh/vertex_normals.h"
#include "core/modelling/crowding.h"
#include "core/modelling/room.h"

namespace seesaw {

namespace {

// Unit normals; zero where there is none to be known.
Points<3> unit_normals(const PointsRef<3>& normals) {
  Points<3> result(3, normals.cols());
  for (Index i = 0; i < normals.cols(); ++i) {
    // Scaled first: a normal of length 1e-200 is as good as any.
    const double size = normals.col(i).cwiseAbs().maxCoeff();
    const bool known = normals.col(i).allFinite() && size > 0;
    result.col(i) = known ? Point<3>((normals.col(i) / size).normalized()) : Point<3>::Zero();
  }
  return result;
}

// What was measured at one vertex.
struct Measured {
  Room inside, outside;
};

void check(const ModelConstraintOptions& options) {
  SEESAW_CHECK_LT(0.0, options.offset);
  SEESAW_CHECK_LT(0.0, options.value);
  SEESAW_CHECK_LT(0.0, options.crowded);
}

/// Steps from the chosen points in unit coordinates; `measure(vertex, direction, options)` as in room.h.
template <class Measure>
std::vector<Measured> measure_all(const std::vector<Index>& chosen, const PointsRef<3>& normals,
                                  const ModelConstraintOptions& options, const Measure& measure,
                                  const Progress& progress) {
  std::vector<Measured> result(chosen.size());
  const RoomOptions asked{.step = options.offset};
  const auto room = [&](Index i, const Point<3>& direction) {
    return options.shrink ? measure(i, direction, asked) : Room{options.offset, 1.0};
  };
  // In rounds, so that the listener can stop it; each block of a round writes its own.
  constexpr Index round = 8192, block = 64;
  const Index n = static_cast<Index>(chosen.size());
  for (Index first = 0; first < n; first += round) {
    report(progress, static_cast<double>(first) / static_cast<double>(n));
    parallel_blocks(std::min(round, n - first), block, [&](Index begin, Index end) {
      for (Index k = first + begin; k < first + end; ++k) {
        const Index i = chosen[static_cast<std::size_t>(k)];
        const Point<3> normal = normals.col(i);
        if (normal.isZero()) continue;
        Measured& mine = result[static_cast<std::size_t>(k)];
        if (options.side != NormalSide::outside) mine.inside = room(i, -normal);
        if (options.side != NormalSide::inside) mine.outside = room(i, normal);
      }
    });
  }
  return result;
}

/// Constraints from measurements. `points` in scene units, `unit` the same in the unit cube.
class Assembly {
 public:
  Assembly(const ModelConstraintOptions& options, const UnitCube& cube)
      : options_(options), cube_(cube), rows_(options.crowded) {
    made_.report.cube = cube;
  }

  ModelConstraints run(const PointsRef<3>& points, const PointsRef<3>& unit, const PointsRef<3>& normals,
                       const std::vector<Index>& chosen, const std::vector<Measured>& measured) {
    made_.report.vertices = static_cast<Index>(chosen.size());
    // All boundary constraints first: no companion may stand in the way of one.
    std::vector<bool> kept(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const Point<3> at = unit.col(chosen[k]);
      kept[k] = !rows_.near(at);
      if (kept[k])
        rows_.add(at);
      else
        ++made_.report.crowded;
    }
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (!kept[k]) continue;
      const Index i = chosen[k];
      Constraint<3> constraint =
          boundary<3>(options_.to_unit_cube ? Point<3>(unit.col(i)) : Point<3>(points.col(i)));
      const Point<3> normal = normals.col(i);
      if (normal.isZero()) {
        ++made_.report.normals_unknown;
        made_.constraints.push_back(constraint);
        continue;
      }
      const Room& inside = measured[k].inside;
      const Room& outside = measured[k].outside;
      if (options_.side != NormalSide::outside && admit(unit.col(i), -normal, inside))
        constraint.normal = {normal, inside.step * length(), inside.value * options_.value};
      if (options_.side == NormalSide::outside && admit(unit.col(i), normal, outside))
        constraint.normal = {normal, -outside.step * length(), -outside.value * options_.value};
      made_.constraints.push_back(constraint);
      if (options_.side == NormalSide::both && admit(unit.col(i), normal, outside))
        made_.constraints.push_back(
            exterior<3>(constraint.at + outside.step * length() * normal, -outside.value * options_.value));
    }
    made_.report.boundary = made_.report.vertices - made_.report.crowded;
    return std::move(made_);
  }

 private:
  double length() const { return options_.to_unit_cube ? 1.0 : cube_.scale; }

  // Whether there is room for a companion; counts it.
  bool admit(const Point<3>& from, const Point<3>& direction, const Room& room) {
    ModelConstraintReport& report = made_.report;
    const Point<3> at = from + room.step * direction;
    bool same = false;
    if (room.step < options_.crowded || rows_.near(at, &same)) {
      ++report.no_room;
      return false;
    }
    if (!same) rows_.add(at);
    report.smallest = report.normal == 0 ? room.step : std::min(report.smallest, room.step);
    ++report.normal;
    if (room.step < options_.offset * (1 - 1e-9))
      ++report.shrunk;
    else if (room.value < 1 - 1e-9)
      ++report.lowered;
    return true;
  }

  ModelConstraintOptions options_;
  UnitCube cube_;
  Crowding rows_;
  ModelConstraints made_;
};

std::vector<Index> all_of(Index n) {
  std::vector<Index> result(static_cast<std::size_t>(n));
  std::iota(result.begin(), result.end(), Index{0});
  return result;
}

std::vector<Index> vertices_in_faces(const TriangleMesh& mesh) {
  std::vector<bool> used(static_cast<std::size_t>(mesh.vertices.cols()), false);
  for (Index f = 0; f < mesh.faces.cols(); ++f)
    for (int k = 0; k < 3; ++k) used[static_cast<std::size_t>(mesh.faces(k, f))] = true;
  std::vector<Index> result;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) result.push_back(static_cast<Index>(i));
  return result;
}

Box<3> box_of(const PointsRef<3>& points, const std::vector<Index>& chosen) {
  Box<3> box;
  for (const Index i : chosen) box.extend(Point<3>(points.col(i)));
  return box;
}

}  // namespace

ModelConstraints constraints_from(const TriangleMesh& mesh, const ModelConstraintOptions& options,
                                  const Progress& progress) {
  check(options);
  const std::vector<Index> used = vertices_in_faces(mesh);
  if (used.empty()) throw Error("the model has no faces, so there is nothing to fit");
  const std::vector<Index>& vertices = options.chosen.empty() ? used : options.chosen;
  const UnitCube cube = UnitCube::of(box_of(mesh.vertices, used));
  const Points<3> unit = cube.apply(mesh.vertices);
  const Points<3> normals = unit_normals(mesh.has_normals() ? mesh.normals : vertex_normals(mesh));
  const MeshRoom room(unit, mesh.faces);
  const auto measure = [&](Index i, const Point<3>& direction, const RoomOptions& asked) {
    return room.measure(i, direction, asked);
  };
  return Assembly(options, cube)
      .run(mesh.vertices, unit, normals, vertices,
           measure_all(vertices, normals, options, measure, progress));
}

ModelConstraints constraints_from(const PointCloud& cloud, const ModelConstraintOptions& options,
                                  const Progress& progress) {
  check(options);
  const Index count = cloud.points.cols();
  if (count == 0) throw Error("the model has no points, so there is nothing to fit");
  const std::vector<Index> points = options.chosen.empty() ? all_of(count) : options.chosen;
  const UnitCube cube = UnitCube::of(bounding_box_of<3>(cloud.points));
  const Points<3> unit = cube.apply(cloud.points);
  const Points<3> normals =
      cloud.has_normals() ? unit_normals(cloud.normals) : Points<3>(Points<3>::Zero(3, count));
  const CloudRoom room(unit, normals);
  const auto measure = [&](Index i, const Point<3>& direction, const RoomOptions& asked) {
    return room.measure(i, direction, asked);
  };
  return Assembly(options, cube)
      .run(cloud.points, unit, normals, points, measure_all(points, normals, options, measure, progress));
}

}  // namespace seesaw
