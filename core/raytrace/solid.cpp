#include "core/raytrace/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/raytrace/walk.h"

namespace seesaw {

namespace {

// A ray's stretches in one subexpression.
struct Stretches {
  bool inside_at_begin = false;
  std::vector<SolidCrossing> crossings;
};

template <class Rule>
Stretches combine(const Stretches& a, const Stretches& b, const Rule& rule) {
  bool in_a = a.inside_at_begin, in_b = b.inside_at_begin;
  Stretches result;
  bool in = result.inside_at_begin = rule(in_a, in_b);
  std::size_t i = 0, j = 0;
  while (i < a.crossings.size() || j < b.crossings.size()) {
    const bool from_a =
        j == b.crossings.size() || (i < a.crossings.size() && a.crossings[i].t <= b.crossings[j].t);
    const SolidCrossing first = from_a ? a.crossings[i] : b.crossings[j];
    // All that happens at one t happens at once: no stretch of no length is left where surfaces coincide.
    for (; i < a.crossings.size() && a.crossings[i].t == first.t; ++i) in_a = !in_a;
    for (; j < b.crossings.size() && b.crossings[j].t == first.t; ++j) in_b = !in_b;
    if (rule(in_a, in_b) == in) continue;
    in = !in;
    result.crossings.push_back(first);
    result.crossings.back().entering = in;
  }
  return result;
}

bool either(bool a, bool b) { return a || b; }
bool both(bool a, bool b) { return a && b; }
bool only_first(bool a, bool b) { return a && !b; }

}  // namespace

Solid::Solid(std::shared_ptr<const SurfaceTracer> surface, const Material& material)
    : leaves_{{std::move(surface), material}}, steps_{{Step::push, 0}}, box_(leaves_[0].surface->box()) {}

Solid Solid::combined(const Solid& a, const Solid& b, Step::Kind kind) {
  Solid result = a;
  const int shift = static_cast<int>(a.leaves_.size());
  result.leaves_.insert(result.leaves_.end(), b.leaves_.begin(), b.leaves_.end());
  for (Step step : b.steps_) {
    if (step.kind == Step::push) step.leaf += shift;
    result.steps_.push_back(step);
  }
  result.steps_.push_back({kind, -1});
  if (kind == Step::unite) result.box_.extend(b.box_);
  if (kind == Step::intersect) result.box_ = a.box_.intersection(b.box_);
  return result;
}

void Solid::trace(std::span<const Ray> rays, HowMany how_many, std::span<SolidCrossings> result) const {
  SEESAW_CHECK_EQ(rays.size(), result.size());
  std::fill(result.begin(), result.end(), SolidCrossings{});
  const bool alone = leaves_.size() == 1;
  std::vector<Ray> asked;
  std::vector<std::size_t> whose;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray part = within(rays[i], box_);
    if (!(part.begin <= part.end)) continue;
    asked.push_back(rays[i]);
    // Beyond the solid's box the leaves are of no interest; a little room keeps caps from being cut in two.
    if (!alone) asked.back().end = std::min(rays[i].end, part.end + 1e-6 * box_.sizes().norm());
    whose.push_back(i);
  }
  if (asked.empty()) return;

  std::vector<std::vector<RayCrossings>> leaf_crossings(leaves_.size());
  for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
    leaf_crossings[leaf].resize(asked.size());
    leaves_[leaf].surface->trace(asked, alone ? how_many : HowMany::all, leaf_crossings[leaf]);
  }

  std::vector<Stretches> stack;
  for (std::size_t r = 0; r < asked.size(); ++r) {
    SolidCrossings& mine = result[whose[r]];
    stack.clear();
    for (const Step& step : steps_) {
      if (step.kind == Step::push) {
        const RayCrossings& from = leaf_crossings[static_cast<std::size_t>(step.leaf)][r];
        mine.evaluations += from.evaluations;
        mine.unproven = std::max(mine.unproven, from.unproven);
        Stretches stretches{from.inside_at_begin, {}};
        bool in = from.inside_at_begin;
        for (const Crossing& crossing : from.crossings)
          stretches.crossings.push_back({crossing.t, step.leaf, crossing.cap, in = !in});
        stack.push_back(std::move(stretches));
        continue;
      }
      const Stretches b = std::move(stack.back());
      stack.pop_back();
      Stretches& a = stack.back();
      a = step.kind == Step::unite       ? combine(a, b, either)
          : step.kind == Step::intersect ? combine(a, b, both)
                                         : combine(a, b, only_first);
    }
    mine.inside_at_begin = stack.back().inside_at_begin;
    mine.crossings = std::move(stack.back().crossings);
    if (how_many == HowMany::first && mine.crossings.size() > 1) mine.crossings.resize(1);
  }
}

std::vector<bool> Solid::contains(const PointsRef<3>& points) const {
  std::vector<std::vector<bool>> stack;
  const auto count = static_cast<std::size_t>(points.cols());
  for (const Step& step : steps_) {
    if (step.kind == Step::push) {
      const SurfaceTracer& surface = *leaves_[static_cast<std::size_t>(step.leaf)].surface;
      const Values values = surface.field().values(points);
      std::vector<bool> in(count);
      for (std::size_t i = 0; i < count; ++i) {
        const Index k = static_cast<Index>(i);
        in[i] = is_inside(values[k]) && surface.box().contains(Point<3>(points.col(k)));
      }
      stack.push_back(std::move(in));
      continue;
    }
    const std::vector<bool> b = std::move(stack.back());
    stack.pop_back();
    std::vector<bool>& a = stack.back();
    for (std::size_t i = 0; i < count; ++i)
      a[i] = step.kind == Step::unite       ? either(a[i], b[i])
             : step.kind == Step::intersect ? both(a[i], b[i])
                                            : only_first(a[i], b[i]);
  }
  return stack.back();
}

Points<3> Solid::normals(int leaf, const PointsRef<3>& places, std::span<const char> cap) const {
  const SurfaceTracer& surface = *leaves_[static_cast<std::size_t>(leaf)].surface;
  Values values(places.cols());
  Points<3> gradients(3, places.cols());
  surface.field().evaluate(places, values, gradients);
  const Point<3> middle = surface.box().center(), half = 0.5 * surface.box().sizes();
  for (Index i = 0; i < places.cols(); ++i) {
    Point<3> normal = -gradients.col(i);
    if (cap[static_cast<std::size_t>(i)]) {
      // The face that is nearest, measured by the box's own proportions.
      const Point<3> from = (places.col(i) - middle).cwiseQuotient(half.cwiseMax(1e-300));
      Index d = 0;
      from.cwiseAbs().maxCoeff(&d);
      normal = std::copysign(1.0, from[d]) * Point<3>::Unit(d);
    }
    const double length = normal.norm();
    gradients.col(i) = length > 0 ? Point<3>(normal / length) : Point<3>(Point<3>::Zero());
  }
  return gradients;
}

Points<3> Solid::surface_points(int cells) const {
  SEESAW_CHECK_LT(0, cells);
  if (box_.isEmpty() || !(box_.sizes().maxCoeff() > 0)) return Points<3>(3, 0);
  const double side = box_.sizes().maxCoeff() / cells;
  // One layer more than the box on every side, so that what is cut off at the box ends within the lattice.
  const Eigen::Array3i counts = (box_.sizes() / side).array().ceil().cast<int>() + 3;
  const Point<3> corner = box_.center() - 0.5 * side * (counts - 1).cast<double>().matrix();
  Points<3> lattice(3, Index{counts[0]} * counts[1] * counts[2]);
  Index next = 0;
  for (int z = 0; z < counts[2]; ++z)
    for (int y = 0; y < counts[1]; ++y)
      for (int x = 0; x < counts[0]; ++x) lattice.col(next++) = corner + side * Point<3>(x, y, z);
  const std::vector<bool> in = contains(lattice);

  std::vector<Index> inner, outer;  // the ends of edges that leave the solid
  const Index strides[3] = {1, counts[0], Index{counts[0]} * counts[1]};
  for (Index i = 0; i < lattice.cols(); ++i)
    for (int d = 0; d < 3; ++d) {
      if (i / strides[d] % counts[d] + 1 == counts[d]) continue;
      const Index j = i + strides[d];
      const bool a = in[static_cast<std::size_t>(i)], b = in[static_cast<std::size_t>(j)];
      if (a == b) continue;
      inner.push_back(a ? i : j);
      outer.push_back(a ? j : i);
    }
  const Index count = static_cast<Index>(inner.size());
  Points<3> a(3, count), b(3, count);
  for (Index k = 0; k < count; ++k) {
    a.col(k) = lattice.col(inner[static_cast<std::size_t>(k)]);
    b.col(k) = lattice.col(outer[static_cast<std::size_t>(k)]);
  }
  for (int halving = 0; halving < 8; ++halving) {
    const Points<3> middle = 0.5 * (a + b);
    const std::vector<bool> inside = contains(middle);
    for (Index k = 0; k < count; ++k) (inside[static_cast<std::size_t>(k)] ? a : b).col(k) = middle.col(k);
  }
  return a;
}

}  // namespace seesaw
