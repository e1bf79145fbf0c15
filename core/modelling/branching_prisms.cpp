#include "core/modelling/branching_prisms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/check.h"

namespace seesaw {

namespace {

constexpr double degree = 0.017453292519943295;

// A prism in space: columns of `frame` are its own axes, the third along its height.
struct Prism {
  Point<3> foot = Point<3>::Zero();
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  double radius = 1, height = 1;

  Point<3> corner_direction(int k) const {
    const double angle = 120 * degree * k;
    return frame * Point<3>(std::cos(angle), std::sin(angle), 0);
  }
  Point<3> up() const { return frame.col(2); }
};

Prism child_of(const Prism& parent, int k, const BranchingPrismsOptions& options) {
  Prism child;
  child.radius = options.shrink * parent.radius;
  child.height = options.shrink * parent.height;
  // Leaning out over the corner turns about the horizontal axis across it. The child's first corner then
  // looks outward too.
  const Point<3> outward = parent.corner_direction(k);
  const Point<3> across = parent.up().cross(outward);
  const double c = std::cos(options.tilt * degree), s = std::sin(options.tilt * degree);
  child.frame.col(0) = c * outward - s * parent.up();
  child.frame.col(1) = across;
  child.frame.col(2) = s * outward + c * parent.up();
  // In parent radii along `outward`, the top reaches from -1/2 to 1, and the foot above it sinks by
  // tan(tilt): it is nearest at one end of what they share.
  const double from = std::max(-0.5, options.spread - 0.5 * options.shrink * c);
  const double to = std::min(1.0, options.spread + options.shrink * c);
  const double sunk = ((options.tilt < 0 ? from : to) - options.spread) * s / c;
  child.foot = parent.foot + (parent.height + (options.gap + sunk) * parent.radius) * parent.up() +
               options.spread * parent.radius * outward;
  return child;
}

}  // namespace

BranchingPrisms branching_prisms(const BranchingPrismsOptions& options) {
  SEESAW_CHECK_LE(1, options.generations);
  SEESAW_CHECK_LE(options.generations, 8);
  SEESAW_CHECK_LT(0.0, options.radius);
  SEESAW_CHECK_LT(0.0, options.height);
  SEESAW_CHECK_LT(0.0, options.shrink);
  SEESAW_CHECK_LT(std::abs(options.tilt), 90.0);

  std::vector<Prism> all(1);
  all[0].radius = options.radius;
  all[0].height = options.height;
  std::size_t first = 0;
  for (int generation = 1; generation < options.generations; ++generation) {
    const std::size_t last = all.size();
    for (std::size_t parent = first; parent < last; ++parent)
      for (int k = 0; k < 3; ++k) all.push_back(child_of(all[parent], k, options));
    first = last;
  }

  BranchingPrisms result;
  const auto count = static_cast<Index>(all.size());
  result.prisms.vertices.resize(3, 6 * count);
  result.prisms.faces.resize(3, 8 * count);
  constexpr std::array<std::array<int, 3>, 8> faces = {
      {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
  for (Index p = 0; p < count; ++p) {
    const Prism& prism = all[static_cast<std::size_t>(p)];
    const Point<3> rise = prism.height * prism.up();
    for (int k = 0; k < 6; ++k) {
      const Point<3> corner =
          prism.foot + prism.radius * prism.corner_direction(k % 3) + (k < 3 ? Point<3>::Zero() : rise);
      result.prisms.vertices.col(6 * p + k) = corner;
      result.constraints.push_back(boundary<3>(corner));
    }
    result.constraints.push_back(
        interior<3>(prism.foot + 0.5 * rise, options.value * prism.radius / options.radius));
    for (int f = 0; f < 8; ++f)
      for (int k = 0; k < 3; ++k)
        result.prisms.faces(k, 8 * p + f) =
            static_cast<int>(6 * p) + faces[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)];
  }
  return result;
}

}  // namespace seesaw
