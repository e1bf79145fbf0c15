#include "core/rbf/gradient_bound.h"

#include <array>
#include <cmath>

namespace seesaw {

namespace {

// A form of some degree in Dim variables: a coefficient for every monomial.
template <int Dim>
using Form = std::array<double, Monomials<Dim>::most>;

constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }

// The norm of the symmetric tensor T whose form it is, as a vector of all its entries: that of the form's
// values on unit vectors is no larger.
template <int Dim>
double norm_of(const Form<Dim>& form, int degree) {
  const auto& table = monomials<Dim>;
  double squares = 0.0;
  for (int k = 0; k < table.count[degree]; ++k) squares += form[at(k)] * form[at(k)] / table.ways[degree][k];
  return std::sqrt(squares);
}

// The form times |u|^2.
template <int Dim>
Form<Dim> times_square(const Form<Dim>& form, int degree) {
  const auto& table = monomials<Dim>;
  Form<Dim> result{};
  for (int k = 0; k < table.count[degree]; ++k)
    for (int d = 0; d < Dim; ++d)
      result[at(table.raised[degree + 1][table.raised[degree][k][d]][d])] += form[at(k)];
  return result;
}

// D^order f(m)[u, ..., u], without the polynomial, from the sums over the centers.
template <int Dim>
Form<Dim> derivative_of(const double* sums, int order) {
  const auto& table = monomials<Dim>;
  Form<Dim> result{};
  double pairings = 1.0;  // order! / (p! 2^p (order - 2p)!)
  for (int p = 0; 2 * p <= order; ++p) {
    const int degree = order - 2 * p;
    const double* moment = sums + ball_sums<Dim>.moment[order - p][degree];
    Form<Dim> part{};
    for (int k = 0; k < table.count[degree]; ++k) part[at(k)] = table.ways[degree][k] * moment[k];
    for (int n = degree; n < order; n += 2) part = times_square<Dim>(part, n);
    for (int k = 0; k < table.count[order]; ++k) result[at(k)] += pairings * part[at(k)];
    pairings *= 0.5 * degree * (degree - 1) / (p + 1);
  }
  return result;
}

struct Rule {
  double near;   // in radii
  double sixth;  // M6(r) r^{6 - growth}
};
Rule rule_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::cubic:
      return {1.5, 45};
    case Kernel::thin_plate_spline:
      return {1.5, 60};
    case Kernel::linear:
      return {1.8, 45};
  }
  return {};
}

// How much the gradient of a near center of weight 1 may differ from what has been counted of it.
double near_part(Kernel kernel, double radius) {
  switch (kernel) {
    case Kernel::cubic:
      return 3 * radius * radius;
    case Kernel::thin_plate_spline:
      return 6.4 * radius;
    case Kernel::linear:
      return 1;
  }
  return 0;
}

}  // namespace

template <int Dim>
double kernel_gradient_bound(Kernel kernel, const CenterArrays& centers, const Point<Dim>& slope,
                             const Box<Dim>& box) {
  // Squared distances beyond this leave the range that the fast loops' square roots start from; and centers
  // closer to m than this are no different from one on m.
  constexpr double far = 1e15, same = 1e-15;
  const Point<Dim> m = box.center();
  const double radius = 0.5 * box.sizes().norm();
  if (!m.allFinite() || !std::isfinite(radius)) return infinity;
  const Rule rule = rule_of(kernel);
  const Ball ball{m.data(), radius, std::max(rule.near * radius, same)};
  const bool is_far = !(m.cwiseAbs().maxCoeff() < far && radius < far);
  const KernelSums& loops = is_far ? *kernel_sums_named("portable") : kernel_sums();
  std::array<double, at(ball_sums<Dim>.count)> sums;
  loops.ball(kernel, Dim, centers, ball, sums.data());

  double bound = 0.0, factor = 1.0;  // R^{k-1} / (k-1)!
  for (int order = 1; order <= BallSums<Dim>::orders; ++order) {
    Form<Dim> form = derivative_of<Dim>(sums.data(), order);
    if (order == 1)
      for (int d = 0; d < Dim; ++d) form[at(d)] += slope[d];
    bound += factor * norm_of<Dim>(form, order);
    factor *= radius / order;
  }
  bound += factor * rule.sixth * sums[at(ball_sums<Dim>.remainder)];
  bound += near_part(kernel, radius) * sums[at(ball_sums<Dim>.near)];
  return bound * (1 + 1e-9) + 1e-13 * (3 * sums[at(ball_sums<Dim>.magnitude)] + slope.norm());
}

#define SEESAW_INSTANTIATE(Dim) \
  template double kernel_gradient_bound<Dim>(Kernel, const CenterArrays&, const Point<Dim>&, const Box<Dim>&);
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
SEESAW_INSTANTIATE(4)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
