#include "core/mesh/predicates.h"

#include <array>
#include <cmath>
#include <utility>

namespace seesaw {

namespace {

// A number as a sum of doubles that do not overlap, the smallest first. Adding a double keeps it so
// (Shewchuk's Grow-Expansion), and the last one that is not zero has the sign of the sum.
template <int Capacity>
class ExactSum {
 public:
  void add(double x) {
    for (int i = 0; i < size_; ++i) {
      const double a = terms_[static_cast<std::size_t>(i)];
      const double sum = a + x;
      const double b_part = sum - a;
      terms_[static_cast<std::size_t>(i)] = (a - (sum - b_part)) + (x - b_part);
      x = sum;
    }
    terms_[static_cast<std::size_t>(size_++)] = x;
  }
  int sign() const {
    for (int i = size_ - 1; i >= 0; --i) {
      const double term = terms_[static_cast<std::size_t>(i)];
      if (term != 0) return term > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  std::array<double, Capacity> terms_;
  int size_ = 0;
};

// sum += sign * x * y
template <int Capacity>
void add_product(ExactSum<Capacity>& sum, double sign, double x, double y) {
  const double product = x * y;
  sum.add(sign * std::fma(x, y, -product));
  sum.add(sign * product);
}

// sum += sign * x * y * z
template <int Capacity>
void add_product(ExactSum<Capacity>& sum, double sign, double x, double y, double z) {
  const double product = x * y;
  const double rest = std::fma(x, y, -product);
  add_product(sum, sign, rest, z);
  add_product(sum, sign, product, z);
}

// | a_x a_y 1 |
// | b_x b_y 1 |  expanded, so that no difference is rounded.
// | c_x c_y 1 |
int exact_side_of_line(const Point<2>& a, const Point<2>& b, const Point<2>& c) {
  ExactSum<12> sum;
  for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    add_product(sum, 1, p.x(), q.y());
    add_product(sum, -1, p.y(), q.x());
  }
  return sum.sign();
}

int exact_side_of_plane(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d) {
  ExactSum<96> sum;
  const auto add_determinant = [&](double sign, const Point<3>& p, const Point<3>& q, const Point<3>& r) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      add_product(sum, sign, p[i], q[j], r[k]);
      add_product(sum, -sign, p[i], q[k], r[j]);
    }
  };
  // (b - a) x (c - a) . (d - a), multiplied out: the four minors of the determinant with a column of ones.
  add_determinant(1, b, c, d);
  add_determinant(-1, a, c, d);
  add_determinant(1, a, b, d);
  add_determinant(-1, a, b, c);
  return sum.sign();
}

int sign_of(double x) { return (x > 0) - (x < 0); }

}  // namespace

int side_of_line(const Point<2>& a, const Point<2>& b, const Point<2>& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  const double determinant = left - right;
  // Shewchuk's bound is (3 + 16 eps) eps with eps = 2^-53.
  const double bound = 4e-16 * (std::abs(left) + std::abs(right));
  return std::abs(determinant) > bound ? sign_of(determinant) : exact_side_of_line(a, b, c);
}

int side_of_plane(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d) {
  const Point<3> u = b - a, v = c - a, w = d - a;
  double determinant = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double left = u[j] * v[k], right = u[k] * v[j];
    determinant += (left - right) * w[i];
    size += (std::abs(left) + std::abs(right)) * std::abs(w[i]);
  }
  // Shewchuk's bound is (7 + 56 eps) eps.
  return std::abs(determinant) > 9e-16 * size ? sign_of(determinant) : exact_side_of_plane(a, b, c, d);
}

}  // namespace seesaw
