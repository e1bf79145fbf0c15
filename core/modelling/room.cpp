#include "core/modelling/room.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/base/check.h"

namespace seesaw {

namespace {

// same[i] is the lowest index whose position is exactly that of i.
std::vector<int> first_at_same_position(const PointsRef<3>& points) {
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::tuple(points(0, i), points(1, i), points(2, i)); };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
  std::vector<int> same(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool again = k > 0 && key(order[k]) == key(order[k - 1]);
    same[static_cast<std::size_t>(order[k])] =
        again ? same[static_cast<std::size_t>(order[k - 1])] : order[k];
  }
  return same;
}

Faces faces_of_points(Index n) {
  Faces faces(3, n);
  for (Index i = 0; i < n; ++i) faces.col(i).setConstant(static_cast<int>(i));
  return faces;
}

// The share of the value that a step so much shorter asks for.
double share(double step, const RoomOptions& options) {
  return std::min(1.0, options.steepest * step / options.step);
}

void check(const RoomOptions& options) {
  SEESAW_CHECK_LE(1.0, options.steepest);
  SEESAW_CHECK_LT(0.0, options.step);
  SEESAW_CHECK_LT(0.0, options.safe);
  SEESAW_CHECK_LE(options.safe, 0.5);
}

}  // namespace

MeshRoom::MeshRoom(const PointsRef<3>& vertices, const Faces& faces)
    : vertices_(vertices), same_(first_at_same_position(vertices)), faces_(faces), tree_(vertices, faces) {}

Room MeshRoom::measure(Index vertex, const Point<3>& direction, const RoomOptions& options) const {
  check(options);
  const Point<3> from = vertices_.col(vertex);
  const int mine = same_[static_cast<std::size_t>(vertex)];
  const auto around = [&](int face) {
    for (int k = 0; k < 3; ++k)
      if (same_[static_cast<std::size_t>(faces_(k, face))] == mine) return true;
    return false;
  };
  const double thickness =
      tree_.first_hit(from, direction, options.step / options.safe * (1 + 1e-9), around).distance;
  const double straight = std::min(options.step, options.safe * thickness);
  double step = straight;
  const auto blocked = [&] {
    return tree_.nearest(from + step * direction, options.safe * step, around).face >= 0;
  };
  for (int halvings = 0; blocked(); step /= 2)
    if (halvings++ == 6) {  // a wedge, the same at every scale
      step = straight;
      break;
    }
  const double clearance = tree_.nearest(from + step * direction, options.safe * step).distance;
  return {step, share(step, options) * std::min(1.0, clearance / (options.safe * step))};
}

CloudRoom::CloudRoom(const PointsRef<3>& points, const PointsRef<3>& normals)
    : points_(points), normals_(normals), tree_(points, faces_of_points(points.cols())) {
  SEESAW_CHECK_EQ(points_.cols(), normals_.cols());
}

Room CloudRoom::measure(Index point, const Point<3>& direction, const RoomOptions& options) const {
  check(options);
  const Point<3> from = points_.col(point);
  double thickness = infinity;
  tree_.visit_within(from, options.step / options.safe, [&](int other) {
    const Point<3> away = points_.col(other) - from;
    const double ahead = away.dot(direction);
    if (ahead > 0 && normals_.col(other).dot(normals_.col(point)) < 0)
      thickness = std::min(thickness, away.squaredNorm() / ahead);  // the ball's diameter
  });
  const double step = std::min(options.step, options.safe * thickness);
  return {step, share(step, options)};
}

}  // namespace seesaw
