#include "core/modelling/interference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace seesaw {

namespace {

constexpr int cut = 4;  // each cell into cut x cut x cut
constexpr int parts = cut * cut * cut;

/// A box of the lattice of its generation that neither is proven inside both nor outside one.
struct Cell {
  Point<3> middle;
  std::array<bool, 2> inside = {false, false};  // proven, of each solid
};

/// Values of one function at the parts of some cells, with a bound of its slope in each cell.
struct Sampled {
  Values values;
  std::vector<double> slopes;  // a cell
};

enum class Side { inside, outside, unknown };

Side side_of(double value, double change) {
  const double margin = change * (1 + 1e-12) + 1e-12 * std::abs(value);
  if (value > margin) return Side::inside;
  if (value < -margin) return Side::outside;
  return Side::unknown;  // NaN too
}

/// The share of a box in which value + gradient . (x - middle) is positive, nearly: exact where the plane
/// cuts it square, right on average elsewhere.
double share_inside(double value, const Point<3>& gradient, const Point<3>& sides) {
  const double reach = gradient.cwiseAbs().dot(sides);
  if (!(reach > 0)) return value > 0 ? 1.0 : 0.0;
  return std::clamp(0.5 + value / reach, 0.0, 1.0);
}

/// The same for two functions at once, by smaller boxes, in each of which the smaller share counts.
double share_inside_both(const std::array<double, 2>& values, const std::array<Point<3>, 2>& gradients,
                         const Point<3>& sides) {
  double sum = 0;
  for (int p = 0; p < parts; ++p) {
    const Point<3> step(p % cut, p / cut % cut, p / (cut * cut));
    const Point<3> at = sides.cwiseProduct((step - Point<3>::Constant(0.5 * (cut - 1))) / cut);
    double share = 1;
    for (std::size_t k = 0; k < 2; ++k)
      share = std::min(share, share_inside(values[k] + gradients[k].dot(at), gradients[k], sides / cut));
    sum += share;
  }
  return sum / parts;
}

class Search {
 public:
  Search(const Field<3>& a, const Field<3>& b, const InterferenceOptions& options, const Progress& progress)
      : fields_{&a, &b}, options_(options), progress_(progress) {
    box_ = options.box ? *options.box : a.bounding_box().intersection(b.bounding_box());
  }

  Interference run() {
    if (box_.isEmpty() || !(box_.volume() > 0)) {
      result_.certain = true;
      return result_;
    }
    sides_ = box_.sizes();
    cells_ = {Cell{box_.min() + 0.5 * box_.sizes()}};
    while (!cells_.empty()) {
      refine();
      const double left = static_cast<double>(cells_.size()) * sides_.prod();
      result_.high = result_.low + left;
      if (left <= options_.width * result_.low) break;
      const Index next = parts * static_cast<Index>(cells_.size());
      if (result_.evaluations + next > options_.evaluations) break;
      report(progress_, std::min(0.99, static_cast<double>(result_.evaluations) /
                                           static_cast<double>(options_.evaluations)));
    }
    estimate();
    if (result_.overlap) deepen();
    result_.certain = result_.overlap || cells_.empty();
    return result_;
  }

 private:
  // Cuts all cells; their parts become the cells.
  void refine() {
    const Point<3> part = sides_ / cut;
    const double radius = 0.5 * part.norm();
    std::vector<Cell> next;
    constexpr std::size_t batch = 1024;  // cells whose parts are evaluated together
    for (std::size_t first = 0; first < cells_.size(); first += batch) {
      const std::size_t last = std::min(first + batch, cells_.size());
      const Index count = static_cast<Index>(last - first);
      Points<3> middles(3, parts * count);
      for (Index c = 0; c < count; ++c)
        for (int p = 0; p < parts; ++p) {
          const Point<3> step(p % cut, p / cut % cut, p / (cut * cut));
          middles.col(parts * c + p) = cells_[first + static_cast<std::size_t>(c)].middle +
                                       part.cwiseProduct(step - Point<3>::Constant(0.5 * (cut - 1)));
        }
      const std::array<Sampled, 2> sampled = {sample(0, first, middles), sample(1, first, middles)};
      result_.evaluations += middles.cols();
      for (Index i = 0; i < middles.cols(); ++i) {
        Cell child = cells_[first + static_cast<std::size_t>(i / parts)];
        child.middle = middles.col(i);
        bool outside = false;
        for (std::size_t k = 0; k < 2; ++k) {
          const Side side = child.inside[k]
                                ? Side::inside
                                : side_of(sampled[k].values[i],
                                          radius * sampled[k].slopes[static_cast<std::size_t>(i / parts)]);
          child.inside[k] = side == Side::inside;
          outside |= side == Side::outside;
        }
        note(child.middle, std::min(sampled[0].values[i], sampled[1].values[i]));
        if (outside) continue;
        if (child.inside[0] && child.inside[1]) {
          result_.low += part.prod();
          result_.where.extend(Point<3>(child.middle - 0.5 * part))
              .extend(Point<3>(child.middle + 0.5 * part));
        } else {
          next.push_back(child);
        }
      }
    }
    cells_ = std::move(next);
    sides_ = part;
  }

  Sampled sample(std::size_t k, std::size_t first, const Points<3>& middles) const {
    Sampled sampled{Values(middles.cols()),
                    std::vector<double>(static_cast<std::size_t>(middles.cols() / parts))};
    fields_[k]->evaluate(middles, sampled.values);
    parallel_blocks(static_cast<Index>(sampled.slopes.size()), 16, [&](Index begin, Index end) {
      for (Index c = begin; c < end; ++c) {
        const Cell& cell = cells_[first + static_cast<std::size_t>(c)];
        if (cell.inside[k]) continue;
        sampled.slopes[static_cast<std::size_t>(c)] =
            fields_[k]->gradient_bound(Box<3>(cell.middle - 0.5 * sides_, cell.middle + 0.5 * sides_));
      }
    });
    return sampled;
  }

  void note(const Point<3>& at, double depth) {
    if (!(depth > 0) || (result_.overlap && !(depth > deepest_))) return;
    result_.overlap = true;
    result_.deepest = at;
    deepest_ = depth;
  }

  // Climbs from the deepest point seen to the deepest around: min(f_A, f_B) has edges, so no gradients.
  void deepen() {
    constexpr int around = 26;
    Points<3> ring(3, around);
    Values a(around), b(around);
    Point<3> step = sides_ * cut * cut;
    for (int round = 0; round < 100 && step.maxCoeff() > 1e-4 * sides_.minCoeff(); ++round) {
      for (int i = 0; i < around; ++i) {
        const int j = i < around / 2 ? i : i + 1;  // all neighbors but the middle
        const Point<3> to(j % 3 - 1, j / 3 % 3 - 1, j / 9 - 1);
        ring.col(i) = result_.deepest + step.cwiseProduct(to);
      }
      fields_[0]->evaluate(ring, a);
      fields_[1]->evaluate(ring, b);
      const double before = deepest_;
      for (int i = 0; i < around; ++i)
        if (box_.contains(Point<3>(ring.col(i)))) note(ring.col(i), std::min(a[i], b[i]));
      if (!(deepest_ > before)) step /= 2;
    }
  }

  // The volume of what is left, as if the functions were linear in each cell.
  void estimate() {
    result_.volume = result_.low;
    const Index count = static_cast<Index>(cells_.size());
    constexpr Index batch = 65536;
    for (Index first = 0; first < count; first += batch) {
      const Index n = std::min(batch, count - first);
      Points<3> middles(3, n);
      for (Index i = 0; i < n; ++i) middles.col(i) = cells_[static_cast<std::size_t>(first + i)].middle;
      std::array<Values, 2> values = {Values(n), Values(n)};
      std::array<Points<3>, 2> gradients = {Points<3>(3, n), Points<3>(3, n)};
      for (std::size_t k = 0; k < 2; ++k) fields_[k]->evaluate(middles, values[k], gradients[k]);
      for (Index i = 0; i < n; ++i) {
        const Cell& cell = cells_[static_cast<std::size_t>(first + i)];
        double share = 0;
        if (cell.inside[0] || cell.inside[1]) {
          const std::size_t k = cell.inside[0] ? 1 : 0;
          share = share_inside(values[k][i], gradients[k].col(i), sides_);
        } else {
          share = share_inside_both({values[0][i], values[1][i]}, {gradients[0].col(i), gradients[1].col(i)},
                                    sides_);
        }
        if (!(share > 0)) continue;
        result_.volume += share * sides_.prod();
        result_.where.extend(Point<3>(middles.col(i) - 0.5 * sides_))
            .extend(Point<3>(middles.col(i) + 0.5 * sides_));
      }
    }
    if (!result_.overlap) {  // planes of two cells may cross where the solids do not
      result_.volume = 0;
      result_.where.setEmpty();
    }
  }

  std::array<const Field<3>*, 2> fields_;
  InterferenceOptions options_;
  const Progress& progress_;
  Box<3> box_;
  Point<3> sides_ = Point<3>::Zero();  // of the cells
  std::vector<Cell> cells_;
  Interference result_;
  double deepest_ = 0;
};

}  // namespace

Interference interference(const Field<3>& a, const Field<3>& b, const InterferenceOptions& options,
                          const Progress& progress) {
  return Search(a, b, options, progress).run();
}

}  // namespace seesaw
