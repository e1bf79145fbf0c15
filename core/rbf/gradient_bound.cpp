#include "core/rbf/gradient_bound.h"

#include <array>
#include <cmath>

namespace seesaw {

namespace {

// The radial factors of the derivatives at distance r > 0, with n the unit vector away from the center:
//     gradient  g r n            Hessian  g I + h n n'
//     third     t (n_a I_bc + n_b I_ac + n_c I_ab) + q n_a n_b n_c
struct Derivatives {
  double g, h, t, q, fourth_times_power;
  int power;  // M4(r) = fourth_times_power / r^power
};

// `unit` is the length that log r is measured in.
Derivatives derivatives_at(Kernel kernel, double r, double unit) {
  switch (kernel) {
    case Kernel::cubic:
      return {3 * r, 3 * r, 3, -3, 9, 1};
    case Kernel::thin_plate_spline:
      return {2 * std::log(r / unit) + 1, 2, 2 / r, -4 / r, 6, 2};
    case Kernel::linear:
      return {1 / r, -1 / r, -1 / (r * r), 3 / (r * r), 3, 3};
  }
  return {};
}

}  // namespace

template <int Dim>
double kernel_gradient_bound(Kernel kernel, const PointsRef<Dim>& centers,
                             const Eigen::Ref<const Values>& weights, const Point<Dim>& slope,
                             const Box<Dim>& box) {
  const Point<Dim> m = box.center();
  const double radius = 0.5 * box.sizes().norm();
  Point<Dim> gradient = slope;
  Eigen::Matrix<double, Dim, Dim> hessian = Eigen::Matrix<double, Dim, Dim>::Zero();
  std::array<Eigen::Matrix<double, Dim, Dim>, Dim> third;
  third.fill(hessian);
  double fourth = 0.0, near = 0.0;
  double magnitude = slope.norm();  // of everything that was added up, for the rounding

  for (Index j = 0; j < centers.cols(); ++j) {
    const double w = weights[j], size = std::abs(w);
    const Point<Dim> away = m - centers.col(j);
    const double d = away.norm();
    const bool is_near = d <= 2 * radius;
    if (is_near && kernel == Kernel::linear) {
      near += size;
      continue;
    }
    if (d == 0.0) {  // its gradient is zero there, and its Hessian too for r^3
      near += kernel == Kernel::cubic ? 3 * size * radius * radius : 6.4 * size * radius;
      continue;
    }
    const Derivatives k = derivatives_at(kernel, d, radius > 0 ? radius : 1.0);
    const Point<Dim> n = away / d;
    gradient += (w * k.g * d) * n;
    magnitude += size * std::abs(k.g) * d;
    if (is_near && kernel == Kernel::thin_plate_spline) {
      near += 6.4 * size * radius;
      continue;
    }
    hessian += w * k.h * n * n.transpose();
    hessian.diagonal().array() += w * k.g;
    magnitude += size * (std::abs(k.g) + std::abs(k.h)) * radius;
    if (is_near) {
      near += 3 * size * radius * radius;
      continue;
    }
    for (int a = 0; a < Dim; ++a) {
      auto& slice = third[static_cast<std::size_t>(a)];
      slice += (w * k.q * n[a]) * n * n.transpose();
      slice.diagonal().array() += w * k.t * n[a];
      slice.row(a) += w * k.t * n.transpose();
      slice.col(a) += w * k.t * n;
    }
    magnitude += size * (std::abs(k.t) + std::abs(k.q)) * radius * radius;
    fourth += size * k.fourth_times_power / std::pow(d - radius, k.power);
  }
  double third_squared = 0.0;  // the Frobenius norm bounds the operator norm
  for (const auto& slice : third) third_squared += slice.squaredNorm();
  const double bound = gradient.norm() + radius * hessian.norm() +
                       radius * radius / 2 * std::sqrt(third_squared) +
                       radius * radius * radius / 6 * fourth + near;
  return bound * (1 + 1e-9) + 1e-13 * magnitude;
}

#define SEESAW_INSTANTIATE(Dim)                                                                              \
  template double kernel_gradient_bound<Dim>(Kernel, const PointsRef<Dim>&, const Eigen::Ref<const Values>&, \
                                             const Point<Dim>&, const Box<Dim>&);
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
SEESAW_INSTANTIATE(4)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
