#include "core/rbf/interpolant.h"

#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/rbf/energy.h"
#include "core/rbf/gradient_bound.h"
#include "core/rbf/kernel_sums.h"

namespace seesaw {

namespace {

// Points that go through the loops together: the loops' arrays stay in the nearest cache.
constexpr Index block = 64;

// Beyond this many sizes of the shape, squared distances leave the range that single precision can start a
// square root from; such points take the portable loops. (The function is linear there to every digit but
// one.)
constexpr double far = 1e15;

// One block of points: their normalized coordinates, one array a coordinate.
template <int Dim>
struct BlockOfPoints {
  std::array<std::array<double, block>, Dim> coordinates{};
  std::array<const double*, Dim> pointers;
  Index count = 0;
  bool any_far = false;

  BlockOfPoints() {
    for (std::size_t d = 0; d < Dim; ++d) pointers[d] = coordinates[d].data();
  }
  // A single point, for those that are far.
  BlockOfPoints(const BlockOfPoints& other, Index i) : BlockOfPoints() {
    for (std::size_t d = 0; d < Dim; ++d)
      coordinates[d][0] = other.coordinates[d][static_cast<std::size_t>(i)];
    count = 1;
  }
  void load(const PointsRef<Dim>& points, Index first, Index n, const Normalization<Dim>& normalization) {
    count = n;
    any_far = false;
    for (std::size_t d = 0; d < Dim; ++d)
      for (Index i = 0; i < n; ++i) {
        const Index row = static_cast<Index>(d);
        const double x = (points(row, first + i) - normalization.center[row]) / normalization.scale;
        coordinates[d][static_cast<std::size_t>(i)] = x;
        any_far = any_far || !(std::abs(x) < far);
      }
  }
  bool is_far(Index i) const {
    bool result = false;
    for (const auto& row : coordinates)
      result = result || !(std::abs(row[static_cast<std::size_t>(i)]) < far);
    return result;
  }
  PointArrays arrays() const { return {pointers.data(), count}; }
  Point<Dim> point(Index i) const {
    Point<Dim> p;
    for (int d = 0; d < Dim; ++d)
      p[d] = coordinates[static_cast<std::size_t>(d)][static_cast<std::size_t>(i)];
    return p;
  }
};

// The results of one block: up to `Rows` numbers a point.
template <int Rows>
struct BlockOfNumbers {
  std::array<std::array<double, block>, Rows> numbers;
  std::array<double*, Rows> pointers;

  BlockOfNumbers() {
    for (std::size_t k = 0; k < Rows; ++k) pointers[k] = numbers[k].data();
  }
  double at(int row, Index i) const {
    return numbers[static_cast<std::size_t>(row)][static_cast<std::size_t>(i)];
  }
};

// Runs `sums(loops, points, numbers)` over all points in blocks and threads, and `take(i, normalized point,
// numbers, j)` for each point i, whose numbers stand in column j.
template <int Dim, int Rows, class Sums, class Take>
void for_blocks(const PointsRef<Dim>& points, const Normalization<Dim>& normalization, Index centers,
                const Sums& sums, const Take& take) {
  // A task should be worth its start: some fifty thousand kernel evaluations.
  const Index blocks = std::max<Index>(1, 50000 / (block * (centers + 1)));
  parallel_blocks(points.cols(), blocks * block, [&](Index begin, Index end) {
    BlockOfPoints<Dim> x;
    BlockOfNumbers<Rows> numbers;
    for (Index first = begin; first < end; first += block) {
      x.load(points, first, std::min(block, end - first), normalization);
      sums(kernel_sums(), x.arrays(), numbers.pointers);
      for (Index i = 0; i < x.count; ++i) {
        if (x.any_far && x.is_far(i)) {
          const BlockOfPoints<Dim> alone(x, i);
          BlockOfNumbers<Rows> its;
          sums(*kernel_sums_named("portable"), alone.arrays(), its.pointers);
          take(first + i, alone.point(0), its, 0);
        } else {
          take(first + i, x.point(i), numbers, i);
        }
      }
    }
  });
}

template <int Dim>
std::array<const double*, Dim> column_starts(const Eigen::Matrix<double, Eigen::Dynamic, Dim>& columns) {
  std::array<const double*, Dim> starts;
  for (int d = 0; d < Dim; ++d) starts[static_cast<std::size_t>(d)] = columns.col(d).data();
  return starts;
}

}  // namespace

template <int Dim>
Interpolant<Dim>::Interpolant(Kernel kernel, const PointsRef<Dim>& centers,
                              const Normalization<Dim>& normalization, const Solution& solution)
    : kernel_(kernel),
      centers_(centers),
      normalization_(normalization),
      normalized_(normalization.apply(centers)),
      solution_(solution),
      box_(grown<Dim>(bounding_box_of<Dim>(centers), 0.5)),
      columns_(normalized_.transpose()) {
  SEESAW_CHECK_EQ(solution.weights.size(), centers.cols());
  SEESAW_CHECK_EQ(solution.polynomial.size(), Dim + 1);
}

template <int Dim>
void Interpolant<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const {
  this->check_shapes(points, values);
  const auto starts = column_starts<Dim>(columns_);
  const CenterArrays centers{starts.data(), solution_.weights.data(), size()};
  const Point<Dim> slope = solution_.polynomial.template tail<Dim>();
  for_blocks<Dim, 1>(
      points, normalization_, size(),
      [&](const KernelSums& loops, const PointArrays& x, const auto& out) {
        loops.values(kernel_, Dim, centers, x, out[0]);
      },
      [&](Index i, const Point<Dim>& x, const auto& numbers, Index j) {
        values[i] = numbers.at(0, j) + (solution_.polynomial[0] + slope.dot(x));
      });
}

template <int Dim>
void Interpolant<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                                Eigen::Ref<Points<Dim>> gradients) const {
  this->check_shapes(points, values);
  SEESAW_CHECK_EQ(points.cols(), gradients.cols());
  const auto starts = column_starts<Dim>(columns_);
  const CenterArrays centers{starts.data(), solution_.weights.data(), size()};
  const Point<Dim> slope = solution_.polynomial.template tail<Dim>();
  for_blocks<Dim, 1 + Dim>(
      points, normalization_, size(),
      [&](const KernelSums& loops, const PointArrays& x, const auto& out) {
        loops.gradients(kernel_, Dim, centers, x, out[0], out.data() + 1);
      },
      [&](Index i, const Point<Dim>& x, const auto& numbers, Index j) {
        values[i] = numbers.at(0, j) + (solution_.polynomial[0] + slope.dot(x));
        for (int d = 0; d < Dim; ++d)
          gradients(d, i) = (numbers.at(1 + d, j) + slope[d]) / normalization_.scale;
      });
}

template <int Dim>
void Interpolant<Dim>::evaluate_hessians(const PointsRef<Dim>& points,
                                         Eigen::Ref<Hessians<Dim>> hessians) const {
  SEESAW_CHECK_EQ(points.cols(), hessians.cols());
  const auto starts = column_starts<Dim>(columns_);
  const CenterArrays centers{starts.data(), solution_.weights.data(), size()};
  for_blocks<Dim, Dim*(Dim + 1) / 2>(
      points, normalization_, size(),
      [&](const KernelSums& loops, const PointArrays& x, const auto& out) {
        loops.hessians(kernel_, Dim, centers, x, out.data());
      },
      [&](Index i, const Point<Dim>&, const auto& numbers, Index j) {
        for (int b = 0, k = 0; b < Dim; ++b)
          for (int a = 0; a <= b; ++a, ++k)
            hessians(a * Dim + b, i) = hessians(b * Dim + a, i) =
                numbers.at(k, j) / normalization_.scale / normalization_.scale;
      });
}

template <int Dim>
Eigen::Matrix<double, Dim, Dim> Interpolant<Dim>::hessian(const Point<Dim>& point) const {
  Hessians<Dim> result(Dim * Dim, 1);
  evaluate_hessians(point, result);
  return Eigen::Map<Eigen::Matrix<double, Dim, Dim>>(result.data());
}

template <int Dim>
double Interpolant<Dim>::gradient_bound(const Box<Dim>& box) const {
  if (box.isEmpty()) return 0.0;
  const Box<Dim> normalized((box.min() - normalization_.center) / normalization_.scale,
                            (box.max() - normalization_.center) / normalization_.scale);
  const auto starts = column_starts<Dim>(columns_);
  return kernel_gradient_bound<Dim>(kernel_, {starts.data(), solution_.weights.data(), size()},
                                    solution_.polynomial.template tail<Dim>(), normalized) /
         normalization_.scale;
}

template <int Dim>
Values Interpolant<Dim>::weights() const {
  return solution_.weights / std::pow(normalization_.scale, growth_of(kernel_));
}

// f(x) = sum_j w'_j phi(|x - c_j| / s) + p'_0 + p' . (x - m) / s, and for r^2 log r the logarithm of the
// scale s leaves -log(s) sum_j w_j |x - c_j|^2, which the side conditions turn into the constant -log(s)
// sum_j w_j |c_j - m|^2.
template <int Dim>
Values Interpolant<Dim>::polynomial() const {
  Values result(Dim + 1);
  result.tail(Dim) = solution_.polynomial.tail(Dim) / normalization_.scale;
  result[0] = solution_.polynomial[0] - result.tail(Dim).dot(normalization_.center);
  if (kernel_ == Kernel::thin_plate_spline)
    result[0] -=
        std::log(normalization_.scale) * (normalized_.colwise().squaredNorm() * solution_.weights).value();
  return result;
}

template <int Dim>
double Interpolant<Dim>::energy() const {
  // w' Phi w by the function itself at its centers: Phi w = f - P p, and P' w = 0.
  const Values f = this->values(centers_);
  const double product = solution_.weights.dot(f) * (kernel_ == Kernel::linear ? -1.0 : 1.0);
  return std::max(0.0,
                  energy_factor(kernel_, Dim) * product / std::pow(normalization_.scale, growth_of(kernel_)));
}

template class Interpolant<2>;
template class Interpolant<3>;
template class Interpolant<4>;

}  // namespace seesaw
