#include "sandbox2d/plate_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace seesaw {

namespace {

// The part of the line that lies in the box, as fractions of its length.
std::optional<std::array<double, 2>> part_in_box(const ProfileLine& line, const Box<2>& box) {
  double first = 0, last = 1;
  const Point<2> run = line.to - line.from;
  for (int k = 0; k < 2; ++k) {
    if (run[k] == 0) {
      if (line.from[k] < box.min()[k] || line.from[k] > box.max()[k]) return {};
      continue;
    }
    const double a = (box.min()[k] - line.from[k]) / run[k], b = (box.max()[k] - line.from[k]) / run[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first < last)) return {};
  return std::array<double, 2>{first, last};
}

// The quadrangle between a piece of the line and the zero plane, on one side of it.
void curtain_piece(const Point<3>& a, const Point<3>& b, TriangleMesh& curtain) {
  const Index v = curtain.vertices.cols(), f = curtain.faces.cols();
  curtain.vertices.conservativeResize(3, v + 4);
  curtain.vertices.rightCols(4) << a, b, Point<3>(b.x(), b.y(), 0), Point<3>(a.x(), a.y(), 0);
  curtain.faces.conservativeResize(3, f + 2);
  const int first = static_cast<int>(v);
  curtain.faces.col(f) << first, first + 1, first + 2;
  curtain.faces.col(f + 1) << first, first + 2, first + 3;
}

}  // namespace

std::vector<PlatePole> plate_poles(const Document<2>& document, const PlateSpace& space, const Box<2>& box) {
  std::vector<PlatePole> poles;
  for (const SceneConstraint<2>& each : document.constraints) {
    const Constraint<2>& c = each.constraint;
    if (box.contains(c.at))
      poles.push_back({space.at(c.at, 0), space.at(c.at, c.value), c.kind == ConstraintKind::boundary, false,
                       each.highlight});
    if (!c.normal) continue;
    const Point<2> beside = c.at - c.normal->offset * c.normal->direction.normalized();
    if (box.contains(beside))
      poles.push_back({space.at(beside, 0), space.at(beside, c.normal->value), false, true,
                       each.highlight || each.highlight_normal});
  }
  return poles;
}

PlateProfile plate_profile(const Field<2>& field, const ProfileLine& line, const PlateSpace& space,
                           const Box<2>& box, Index samples) {
  PlateProfile profile;
  const auto part = part_in_box(line, box);
  if (!part || samples < 2) return profile;
  Points<2> ground(2, samples);
  for (Index i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(samples - 1);
    ground.col(i) = line.from + ((*part)[0] + t * ((*part)[1] - (*part)[0])) * (line.to - line.from);
  }
  const Values values = field.values(ground);
  profile.line.resize(3, samples);
  Index n = 0;
  for (Index i = 0; i < samples; ++i)
    if (std::isfinite(values[i])) profile.line.col(n++) = space.at(ground.col(i), values[i]);
  profile.line.conservativeResize(3, n);
  for (Index i = 0; i + 1 < n; ++i) {
    const Point<3> a = profile.line.col(i), b = profile.line.col(i + 1);
    if (a.z() * b.z() < 0) {
      Point<3> middle = a + a.z() / (a.z() - b.z()) * (b - a);
      middle.z() = 0;
      curtain_piece(a, middle, a.z() > 0 ? profile.above : profile.below);
      curtain_piece(middle, b, b.z() > 0 ? profile.above : profile.below);
    } else if (a.z() != 0 || b.z() != 0) {
      curtain_piece(a, b, a.z() + b.z() > 0 ? profile.above : profile.below);
    }
  }
  return profile;
}

}  // namespace seesaw
