#include "core/editing/hit_test.h"

#include <algorithm>
#include <tuple>

#include "core/editing/curve_foot.h"

namespace seesaw {

namespace {

Point<2> nearest_of_line(const ProfileLine& line, const Point<2>& p) {
  const Point<2> along = line.to - line.from;
  const double square = along.squaredNorm();
  return line.from + (square > 0 ? std::clamp((p - line.from).dot(along) / square, 0.0, 1.0) : 0.0) * along;
}

bool is_line(Over over) { return over == Over::profile || over == Over::curve; }

}  // namespace

Point<2> spike_end(const Constraint<2>& constraint, double spike_length, double pixel) {
  return constraint.at + spike_length * pixel * constraint.normal->direction.stableNormalized();
}

std::vector<Hit> hits(const Point<2>& cursor, const HitScene& scene, const Reaches& reaches) {
  std::vector<Hit> found;
  const auto look = [&](Over over, Index which, const Point<2>& at, double reach) {
    const double pixels = (at - cursor).stableNorm() / scene.pixel;
    if (pixels <= reach) found.push_back({over, which, at, pixels});
  };
  for (std::size_t i = 0; i < scene.document.constraints.size(); ++i) {
    const Constraint<2>& each = scene.document.constraints[i].constraint;
    const auto which = static_cast<Index>(i);
    if (scene.display.constraints) look(Over::constraint, which, each.at, reaches.constraint);
    if (scene.display.constraints && scene.display.normals && each.normal)
      look(Over::spike, which, spike_end(each, reaches.spike_length, scene.pixel), reaches.spike);
  }
  if (scene.profile) {
    look(Over::profile_start, -1, scene.profile->from, reaches.profile);
    look(Over::profile_end, -1, scene.profile->to, reaches.profile);
    look(Over::profile, -1, nearest_of_line(*scene.profile, cursor), reaches.profile);
  }
  if (scene.field)
    if (const auto foot = curve_foot(*scene.field, cursor, reaches.curve * scene.pixel))
      look(Over::curve, -1, *foot, infinity);
  std::ranges::sort(found, {}, [](const Hit& hit) {
    return std::tuple(is_line(hit.over), hit.pixels, hit.over, -hit.which);
  });
  return found;
}

Hit first_hit(const Point<2>& cursor, const HitScene& scene, const Reaches& reaches) {
  const std::vector<Hit> found = hits(cursor, scene, reaches);
  return found.empty() ? Hit{} : found.front();
}

}  // namespace seesaw
