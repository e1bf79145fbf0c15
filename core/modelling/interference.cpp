#include "core/modelling/interference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace seesaw {

namespace {

/// What is known of one solid in a cell.
enum class State { open, inside, presumed };  // outside is not kept

struct Part {
  State state = State::open;
  double value = 0;
  Point<3> gradient = Point<3>::Zero();
  double slope = infinity;  // a bound that holds in the cell
  int age = 0;              // generations since it was asked for
};

struct Cell {
  Point<3> middle;
  std::array<Part, 2> parts;
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

/// Of both solids, as if the functions were linear in the cell; where both surfaces run through it by smaller
/// boxes, in each of which the smaller share counts.
double share_inside(const Cell& cell, const Point<3>& sides) {
  const bool open[2] = {cell.parts[0].state == State::open, cell.parts[1].state == State::open};
  if (!open[0] || !open[1]) {
    const Part& part = cell.parts[open[0] ? 0 : 1];
    return share_inside(part.value, part.gradient, sides);
  }
  constexpr int cut = 4;
  double sum = 0;
  for (int p = 0; p < cut * cut * cut; ++p) {
    const Point<3> step(p % cut, p / cut % cut, p / (cut * cut));
    const Point<3> at = sides.cwiseProduct((step - Point<3>::Constant(0.5 * (cut - 1))) / cut);
    double share = 1;
    for (const Part& part : cell.parts)
      share = std::min(share, share_inside(part.value + part.gradient.dot(at), part.gradient, sides / cut));
    sum += share;
  }
  return sum / (cut * cut * cut);
}

class InterferenceSearch {
 public:
  InterferenceSearch(const Field<3>& a, const Field<3>& b, const InterferenceOptions& options,
                     const Progress& progress)
      : fields_{&a, &b}, options_(options), progress_(progress) {
    box_ = options.box ? *options.box : a.bounding_box().intersection(b.bounding_box());
  }

  Interference run() {
    if (box_.isEmpty() || !(box_.volume() > 0)) {
      result_.certain = true;
      return result_;
    }
    sides_ = box_.sizes();
    cells_ = {Cell{box_.min() + 0.5 * box_.sizes(), {}}};
    for (std::size_t k = 0; k < 2; ++k) cells_[0].parts[k].slope = fields_[k]->gradient_bound(box_);
    result_.bounds = 2;
    while (!cells_.empty()) {
      refine();
      const double before = result_.volume;
      estimate();
      result_.error = std::abs(result_.volume - before);
      const double open = static_cast<double>(cells_.size()) * sides_.prod();
      result_.high = result_.low + presumed_ + open;
      if (open <= options_.width * (result_.low + presumed_inside_)) break;
      if (result_.evaluations + 8 * static_cast<Index>(cells_.size()) > options_.evaluations) break;
      report(progress_, std::min(0.99, static_cast<double>(result_.evaluations) /
                                           static_cast<double>(options_.evaluations)));
    }
    finish_where();
    if (result_.overlap) deepen();
    result_.certain = result_.overlap || (cells_.empty() && presumed_ == 0);
    return result_;
  }

 private:
  // Halves all cells in each direction; the halves that stay open become the cells.
  void refine() {
    const auto count = static_cast<Index>(cells_.size());
    presume_ = generation_ >= 4 && (2 * count > options_.bounds - result_.bounds ||
                                    64 * count > options_.evaluations - result_.evaluations);
    if (!presume_) ask();
    sides_ /= 2;
    ++generation_;
    std::vector<Cell> next;
    constexpr std::size_t batch = 4096;  // cells whose halves are treated together
    for (std::size_t first = 0; first < cells_.size(); first += batch) {
      const std::size_t last = std::min(first + batch, cells_.size());
      std::vector<Cell> halves;
      halves.reserve(8 * (last - first));
      for (std::size_t c = first; c < last; ++c)
        for (int p = 0; p < 8; ++p) {
          const Point<3> side(p % 2 ? 0.5 : -0.5, p / 2 % 2 ? 0.5 : -0.5, p / 4 ? 0.5 : -0.5);
          halves.push_back(cells_[c]);
          halves.back().middle += side.cwiseProduct(sides_);
        }
      result_.evaluations += static_cast<Index>(halves.size());
      std::vector<std::array<Side, 2>> sides(halves.size(), {Side::unknown, Side::unknown});
      for (std::size_t k = 0; k < 2; ++k) settle(k, halves, sides);
      for (std::size_t i = 0; i < halves.size(); ++i) sort(halves[i], sides[i], next);
    }
    cells_ = std::move(next);
  }

  // Evaluates function k in the middle of the cells that are open for it, and proves what the bounds prove.
  void settle(std::size_t k, std::vector<Cell>& cells, std::vector<std::array<Side, 2>>& sides) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i].parts[k].state == State::open) open.push_back(i);
    const Index n = static_cast<Index>(open.size());
    Points<3> middles(3, n), gradients(3, n);
    Values values(n);
    for (Index j = 0; j < n; ++j) middles.col(j) = cells[open[static_cast<std::size_t>(j)]].middle;
    fields_[k]->evaluate(middles, values, gradients);

    const double radius = 0.5 * sides_.norm();
    for (Index j = 0; j < n; ++j) {
      const std::size_t i = open[static_cast<std::size_t>(j)];
      Part& part = cells[i].parts[k];
      part.value = values[j];
      part.gradient = gradients.col(j);
      ++part.age;
      sides[i][k] = side_of(part.value, radius * part.slope);
    }
  }

  // A bound of its own for each cell that has inherited one for two generations, while there are bounds left;
  // it then serves all that is cut from the cell in the next two.
  void ask() {
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<std::size_t> asking;
      for (std::size_t i = 0; i < cells_.size() && result_.bounds < options_.bounds; ++i) {
        const Part& part = cells_[i].parts[k];
        if (part.state != State::open || part.age < 2) continue;
        // Bounds of interpolants fall about tenfold with each generation, down to the true slope. Not where
        // that is reached already, nor where the next would still be hopeless.
        const double slope = part.gradient.norm();
        if (part.slope <= 1.1 * slope || part.slope * std::pow(0.1, part.age) > 20 * slope) continue;
        asking.push_back(i);
        ++result_.bounds;
      }
      parallel_blocks(static_cast<Index>(asking.size()), 16, [&](Index begin, Index end) {
        for (Index j = begin; j < end; ++j) {
          Cell& cell = cells_[asking[static_cast<std::size_t>(j)]];
          const Box<3> box(cell.middle - 0.5 * sides_, cell.middle + 0.5 * sides_);
          cell.parts[k].slope = std::min(cell.parts[k].slope, fields_[k]->gradient_bound(box));
          cell.parts[k].age = 0;
        }
      });
    }
  }

  // Where a cell goes: nowhere, into one of the sums, or to those that stay open.
  void sort(Cell& cell, const std::array<Side, 2>& sides, std::vector<Cell>& next) {
    const double radius = 0.5 * sides_.norm(), volume = sides_.prod();
    note(cell);
    bool outside = false, presumed_outside = false;
    for (std::size_t k = 0; k < 2; ++k) {
      Part& part = cell.parts[k];
      if (part.state != State::open) continue;
      outside |= sides[k] == Side::outside;
      if (sides[k] == Side::inside) part.state = State::inside;
      // Not before the cells are small: a large one may hide a thin sheet from its middle.
      if (sides[k] != Side::unknown || !presume_) continue;
      if (std::abs(part.value) <= 4 * radius * part.gradient.norm()) continue;
      if (part.value > 0)
        part.state = State::presumed;
      else
        presumed_outside = true;
    }
    if (outside) return;
    const bool open = cell.parts[0].state == State::open || cell.parts[1].state == State::open;
    const bool proven = cell.parts[0].state == State::inside && cell.parts[1].state == State::inside;
    if (presumed_outside) {
      presumed_ += volume;
    } else if (open) {
      next.push_back(cell);
    } else {
      (proven ? result_.low : presumed_) += volume;
      if (!proven) presumed_inside_ += volume;
      extend_where(cell);
    }
  }

  void extend_where(const Cell& cell) {
    result_.where.extend(Point<3>(cell.middle - 0.5 * sides_)).extend(Point<3>(cell.middle + 0.5 * sides_));
  }

  // Called while the open parts still have the values of this very cell; those of the others are forebears'.
  void note(const Cell& cell) {
    double depth = infinity;
    bool exact = true;
    for (const Part& part : cell.parts) {
      if (part.state == State::open) depth = std::min(depth, part.value);
      exact &= part.state == State::open;
    }
    if (!(depth > 0)) return;
    if (exact) return note(cell.middle, depth);
    // Once there is a point to climb from, others need not be looked at closely.
    if (!result_.overlap)
      note(cell.middle, std::min(fields_[0]->value(cell.middle), fields_[1]->value(cell.middle)));
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
    Point<3> step = box_.sizes() / 16;
    for (int round = 0; round < 200 && step.maxCoeff() > 1e-6 * box_.sizes().maxCoeff(); ++round) {
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

  void estimate() {
    shares_.assign(cells_.size(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) sum += shares_[i] = share_inside(cells_[i], sides_);
    result_.volume = result_.low + presumed_inside_ + sum * sides_.prod();
    if (!result_.overlap) result_.volume = 0;  // planes of two functions may cross where the solids do not
  }

  void finish_where() {
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (shares_[i] > 0) extend_where(cells_[i]);
    if (!result_.overlap) result_.where.setEmpty();
  }

  std::array<const Field<3>*, 2> fields_;
  InterferenceOptions options_;
  const Progress& progress_;
  Box<3> box_;
  Point<3> sides_ = Point<3>::Zero();  // of the cells
  int generation_ = 0;
  bool presume_ = false;  // proofs of all cells would take too long
  std::vector<Cell> cells_;
  std::vector<double> shares_;  // of the cells
  double presumed_ = 0;         // volume decided without proof
  double presumed_inside_ = 0;  // of it, inside both
  Interference result_;
  double deepest_ = 0;
};

}  // namespace

Interference interference(const Field<3>& a, const Field<3>& b, const InterferenceOptions& options,
                          const Progress& progress) {
  return InterferenceSearch(a, b, options, progress).run();
}

}  // namespace seesaw
