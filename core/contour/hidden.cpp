#include "core/contour/hidden.h"

#include <Eigen/Eigenvalues>

#include "core/contour/roots.h"

namespace seesaw {
namespace {

using Matrix = Eigen::Matrix2d;
using Vector = Eigen::Vector2d;

// A climber works in lattice units on F, which is f for a summit outside, -f for a valley inside; F starts
// below 0.
struct Climber {
  int i, j;
  double sign;
  Vector freedom;   // (1, 1), or (1, 0) or (0, 1) for one that keeps to a side of the box
  Vector x;         // where it stands
  double F;         // how high
  Vector gradient;  // of F there
  Matrix B;         // minus the Hessian of F, kept positive definite
  double radius;    // no step is longer
  Vector trial;     // where it looks next
  int rises = -1;   // how often it has risen; -1 before its first look around
};

// Is f at corner (i, j) beyond all its neighbors in the directions of `freedom`, upward for sign = 1? Among
// equals, the first counts.
bool is_extreme(const Lattice& lattice, int i, int j, double sign, const Vector& freedom) {
  const double mine = sign * lattice.values[lattice.corner(i, j)];
  const int reach_x = static_cast<int>(freedom.x()), reach_y = static_cast<int>(freedom.y());
  for (int dj = -reach_y; dj <= reach_y; ++dj)
    for (int di = -reach_x; di <= reach_x; ++di) {
      const int x = i + di, y = j + dj;
      if ((di == 0 && dj == 0) || x < 0 || y < 0 || x > lattice.nx || y > lattice.ny) continue;
      const double theirs = sign * lattice.values[lattice.corner(x, y)];
      const bool earlier = dj < 0 || (dj == 0 && di < 0);
      if (earlier ? theirs >= mine : theirs > mine) return false;
    }
  return true;
}

// The nearest positive definite matrix, more or less: eigenvalues made positive, none much smaller than the
// other.
Matrix made_definite(const Matrix& symmetric, double scale) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(symmetric);
  Vector values = solver.eigenvalues().cwiseAbs();
  values = values.cwiseMax(std::max(1e-3 * values.maxCoeff(), 1e-12 * scale));
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

// Minus the Hessian of sign * f by differences over the corner's neighbors, made positive definite. A
// direction that is not free takes the curvature of the one that is.
Matrix curvature_at(const Lattice& lattice, int i, int j, double sign, const Vector& freedom) {
  // At the box's sides the differences across are those of the nearest inner corner.
  const int x = freedom.x() > 0 ? std::clamp(i, std::min(1, lattice.nx), std::max(0, lattice.nx - 1)) : i;
  const int y = freedom.y() > 0 ? std::clamp(j, std::min(1, lattice.ny), std::max(0, lattice.ny - 1)) : j;
  const auto F = [&](int di, int dj) {
    const double value =
        lattice.values[lattice.corner(std::clamp(x + di, 0, lattice.nx), std::clamp(y + dj, 0, lattice.ny))];
    return std::isfinite(value) ? sign * value : sign * lattice.values[lattice.corner(i, j)];
  };
  Matrix hessian;
  hessian(0, 0) = F(1, 0) - 2 * F(0, 0) + F(-1, 0);
  hessian(1, 1) = F(0, 1) - 2 * F(0, 0) + F(0, -1);
  hessian(0, 1) = hessian(1, 0) = 0.25 * (F(1, 1) - F(1, -1) - F(-1, 1) + F(-1, -1));
  if (freedom.sum() < 2) {
    const double free = std::abs(freedom.x() > 0 ? hessian(0, 0) : hessian(1, 1));
    hessian = -std::max(free, 1e-12 * std::abs(F(0, 0))) * Matrix::Identity();
  }
  return made_definite(-hessian, std::abs(lattice.values[lattice.corner(i, j)]));
}

std::vector<Climber> start(const Lattice& lattice) {
  std::vector<Climber> climbers;
  for (int j = 0; j <= lattice.ny; ++j)
    for (int i = 0; i <= lattice.nx; ++i) {
      const double value = lattice.values[lattice.corner(i, j)];
      if (value == 0 || !std::isfinite(value)) continue;
      const double sign = value < 0 ? 1 : -1;
      // Nearly all corners go here, quickly.
      const bool inner = i > 0 && j > 0 && i < lattice.nx && j < lattice.ny;
      if (inner && (sign * lattice.values[lattice.corner(i - 1, j)] >= sign * value ||
                    sign * lattice.values[lattice.corner(i + 1, j)] > sign * value))
        continue;
      const auto start_if_extreme = [&](const Vector& freedom) {
        if (!is_extreme(lattice, i, j, sign, freedom)) return;
        const Vector corner(i, j);
        climbers.push_back({i, j, sign, freedom, corner, sign * value, Vector::Zero(),
                            curvature_at(lattice, i, j, sign, freedom), 0.75, corner});
      };
      start_if_extreme({1, 1});
      // A curve may also poke into the box between two corners of its side. The climb is along the side then:
      // one that is free presses against it.
      if (j == 0 || j == lattice.ny) start_if_extreme({1, 0});
      if (i == 0 || i == lattice.nx) start_if_extreme({0, 1});
    }
  return climbers;
}

// Takes the trial point's value and gradient (along its freedom), and chooses the next trial point. False
// when there is no hope left.
bool advance(Climber& climber, double F, const Vector& gradient, const Lattice& lattice) {
  if (climber.rises < 0) {
    climber.rises = 0;
    climber.gradient = gradient;
  } else if (F > climber.F) {
    const Vector s = climber.trial - climber.x, y = climber.gradient - gradient;
    if (const double curvature = s.dot(y); curvature > 1e-9 * s.norm() * y.norm()) {
      const Vector Bs = climber.B * s;
      climber.B += y * y.transpose() / curvature - Bs * Bs.transpose() / s.dot(Bs);
    }
    climber.x = climber.trial, climber.F = F, climber.gradient = gradient;
    ++climber.rises;
  } else {
    climber.radius = 0.25 * std::min(climber.radius, (climber.trial - climber.x).norm());
  }
  Vector step = climber.B.ldlt().solve(climber.gradient);
  if (!step.allFinite()) return false;
  // Once the steps have taught B the curvature: a summit twenty times as far up as it says is still below
  // zero.
  if (climber.rises >= 2 && climber.F + 20 * 0.5 * climber.gradient.dot(step) < 0) return false;
  if (step.norm() > climber.radius) step *= climber.radius / step.norm();
  // No further than a cell and a half from its corner, and never out of the box.
  const Vector corner(climber.i, climber.j), reach(1.5, 1.5), top(lattice.nx, lattice.ny);
  climber.trial = (climber.x + step)
                      .cwiseMax(corner - reach)
                      .cwiseMin(corner + reach)
                      .cwiseMax(Vector::Zero())
                      .cwiseMin(top);
  return (climber.trial - climber.x).norm() > 1e-9;
}

}  // namespace

Points<2> hidden_points(const Lattice& lattice, Sampler& sampler, double tolerance) {
  std::vector<Climber> open = start(lattice), found;
  const Vector per_cell = lattice.box.sizes().cwiseQuotient(Vector(lattice.nx, lattice.ny));
  Points<2> at;
  Values f;
  Points<2> gradients;
  for (int step = 0; step < 20 && !open.empty(); ++step) {
    at.resize(2, static_cast<Index>(open.size()));
    for (Index k = 0; k < at.cols(); ++k)
      at.col(k) = lattice.position(open[static_cast<std::size_t>(k)].trial);
    sampler.evaluate(at, f, gradients);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      Climber climber = open[k];
      const Index column = static_cast<Index>(k);
      const double F = std::isfinite(f[column]) ? climber.sign * f[column] : -infinity;
      if (F > 0) {
        climber.F = F;
        climber.x = climber.trial;
        found.push_back(climber);
      } else if (advance(climber, F,
                         climber.sign *
                             gradients.col(column).cwiseProduct(per_cell).cwiseProduct(climber.freedom),
                         lattice)) {
        open[kept++] = climber;
      }
    }
    open.resize(kept);
  }

  const Index n = static_cast<Index>(found.size());
  Points<2> inside(2, n), outside(2, n);
  Values inside_values(n), outside_values(n);
  for (Index k = 0; k < n; ++k) {
    const Climber& climber = found[static_cast<std::size_t>(k)];
    const Point<2> corner = lattice.position(Vector(climber.i, climber.j)),
                   peak = lattice.position(climber.x);
    const double corner_value = lattice.values[lattice.corner(climber.i, climber.j)];
    const bool peak_inside = climber.sign > 0;
    inside.col(k) = peak_inside ? peak : corner;
    outside.col(k) = peak_inside ? corner : peak;
    inside_values[k] = peak_inside ? climber.F : corner_value;
    outside_values[k] = peak_inside ? corner_value : -climber.F;
  }
  return find_roots(sampler, inside, outside, inside_values, outside_values, tolerance).positions;
}

}  // namespace seesaw
