#include "core/modelling/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/modelling/foot_points.h"
#include "core/modelling/point_tree.h"

namespace seesaw {

namespace {

/// The boxes of one generation of one surface: all of one size.
struct Boxes {
  const Field<3>* field;
  Point<3> sides;
  std::vector<Point<3>> middles;

  Index size() const { return static_cast<Index>(middles.size()); }
};

Boxes first_of(const Field<3>& field) {
  const Box<3> box = field.bounding_box();
  if (box.isEmpty()) return {&field, Point<3>::Zero(), {}};
  return {&field, box.sizes(), {box.min() + 0.5 * box.sizes()}};
}

/// The halves, in each direction, of all boxes that may hold a zero of the field.
Boxes halved(const Boxes& boxes) {
  Boxes result{boxes.field, 0.5 * boxes.sides, {}};
  const double radius = 0.5 * result.sides.norm();
  std::vector<double> slopes(boxes.middles.size());
  parallel_blocks(boxes.size(), 16, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      const Point<3> middle = boxes.middles[static_cast<std::size_t>(i)];
      slopes[static_cast<std::size_t>(i)] =
          boxes.field->gradient_bound(Box<3>(middle - 0.5 * boxes.sides, middle + 0.5 * boxes.sides));
    }
  });
  Points<3> middles(3, 8 * boxes.size());
  for (Index i = 0; i < middles.cols(); ++i) {
    const Point<3> side(i % 2 ? 1 : -1, i / 2 % 2 ? 1 : -1, i / 4 % 2 ? 1 : -1);
    middles.col(i) = boxes.middles[static_cast<std::size_t>(i / 8)] + 0.5 * side.cwiseProduct(result.sides);
  }
  const Values values = boxes.field->values(middles);
  for (Index i = 0; i < middles.cols(); ++i) {
    const double change = radius * slopes[static_cast<std::size_t>(i / 8)];
    const bool free = std::abs(values[i]) > change * (1 + 1e-12) + 1e-12 * std::abs(values[i]);
    if (!free) result.middles.push_back(middles.col(i));
  }
  return result;
}

/// For each box of `from` its nearest box of `to`: index and distance between the boxes.
std::vector<PointTree::Nearest> nearest(const Boxes& from, const Boxes& to) {
  std::vector<PointTree::Nearest> result(from.middles.size());
  const PointTree tree(to.middles);
  const Point<3> reach = 0.5 * (from.sides + to.sides);
  parallel_blocks(from.size(), 64, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i)
      result[static_cast<std::size_t>(i)] = tree.nearest(from.middles[static_cast<std::size_t>(i)], reach);
  });
  return result;
}

/// Two points, each on its surface.
struct Pair {
  std::array<Point<3>, 2> at;
  double distance() const { return (at[0] - at[1]).norm(); }
};

/// Slides the points along their surfaces toward each other while that helps.
Pair slide(const std::array<const Field<3>*, 2>& fields, Pair pair, double scale) {
  std::array<double, 2> rate = {1.0, 1.0};
  for (int step = 0; step < 400; ++step) {
    bool moved = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const Point<3> toward = pair.at[1 - k] - pair.at[k];
      const Point<3> gradient = fields[k]->gradient(pair.at[k]);
      const double square = gradient.squaredNorm();
      if (!(square > 0)) continue;
      const Point<3> along = toward - toward.dot(gradient) / square * gradient;
      if (along.norm() < 1e-12 * scale) continue;
      for (int attempt = 0; attempt < 8; ++attempt, rate[k] /= 2) {
        const std::optional<Point<3>> foot =
            foot_point(*fields[k], pair.at[k] + rate[k] * along, 1e-13 * scale);
        if (!foot || !((*foot - pair.at[1 - k]).norm() < pair.distance())) continue;
        moved |= pair.distance() - (*foot - pair.at[1 - k]).norm() > 1e-15 * scale;
        pair.at[k] = *foot;
        rate[k] = std::min(1.0, 1.5 * rate[k]);
        break;
      }
      rate[k] = std::max(rate[k], 1e-3);
    }
    if (!moved) break;
  }
  return pair;
}

class ClearanceSearch {
 public:
  ClearanceSearch(const Field<3>& a, const Field<3>& b, const ClearanceOptions& options)
      : fields_{&a, &b}, boxes_{first_of(a), first_of(b)}, options_(options) {
    const Box<3> both = Box<3>(a.bounding_box()).extend(b.bounding_box());
    scale_ = both.isEmpty() ? 0.0 : both.sizes().maxCoeff();
    best_.distance = infinity;
  }

  Clearance run(const Progress& progress) {
    for (int generation = 0; generation < 40; ++generation) {
      report(progress, generation / 40.0);
      for (Boxes& boxes : boxes_) boxes = halved(boxes);
      if (boxes_[0].size() == 0 || boxes_[1].size() == 0) {
        best_.low = best_.distance = infinity;
        return best_;
      }
      std::array<std::vector<PointTree::Nearest>, 2> near = {nearest(boxes_[0], boxes_[1]),
                                                             nearest(boxes_[1], boxes_[0])};
      improve(near[0]);
      best_.low = infinity;
      for (const PointTree::Nearest& each : near[0]) best_.low = std::min(best_.low, each.distance);
      best_.low = std::min(best_.low, best_.distance);
      if (best_.distance - best_.low <= options_.width * scale_) break;
      for (std::size_t k = 0; k < 2; ++k) discard(boxes_[k], near[k]);
      if (boxes_[0].size() + boxes_[1].size() > options_.boxes) break;
    }
    return best_;
  }

 private:
  /// Walks and slides from the nearest pairs of boxes.
  void improve(const std::vector<PointTree::Nearest>& near) {
    std::vector<Index> order(near.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    constexpr std::size_t tries = 6;
    const std::size_t count = std::min(tries, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](Index i, Index j) {
                        const double a = near[static_cast<std::size_t>(i)].distance;
                        const double b = near[static_cast<std::size_t>(j)].distance;
                        return a < b || (a == b && i < j);
                      });
    for (std::size_t k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(order[k]);
      const std::optional<Point<3>> a = foot_point(*fields_[0], boxes_[0].middles[i], 1e-13 * scale_);
      const std::optional<Point<3>> b =
          foot_point(*fields_[1], boxes_[1].middles[static_cast<std::size_t>(near[i].index)], 1e-13 * scale_);
      if (!a || !b) continue;
      const Pair pair = slide(fields_, {{*a, *b}}, scale_);
      if (!(pair.distance() < best_.distance)) continue;
      best_.distance = pair.distance();
      best_.on_a = pair.at[0];
      best_.on_b = pair.at[1];
    }
  }

  void discard(Boxes& boxes, const std::vector<PointTree::Nearest>& near) const {
    std::vector<Point<3>> kept;
    for (std::size_t i = 0; i < boxes.middles.size(); ++i)
      if (!(near[i].distance > best_.distance * (1 + 1e-12))) kept.push_back(boxes.middles[i]);
    boxes.middles = std::move(kept);
  }

  std::array<const Field<3>*, 2> fields_;
  std::array<Boxes, 2> boxes_;
  ClearanceOptions options_;
  double scale_ = 0;
  Clearance best_;
};

}  // namespace

Clearance clearance(const Field<3>& a, const Field<3>& b, const ClearanceOptions& options,
                    const Progress& progress) {
  return ClearanceSearch(a, b, options).run(progress);
}

}  // namespace seesaw
