#include "core/particles/adhesion.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace seesaw {
namespace {

void evaluate(const Field<3>& field, const Points<3>& positions, Values& values, Points<3>& gradients) {
  values.resize(positions.cols());
  gradients.resize(3, positions.cols());
  parallel_blocks(positions.cols(), 256, [&](Index begin, Index end) {
    field.evaluate(positions.middleCols(begin, end - begin), values.segment(begin, end - begin),
                   gradients.middleCols(begin, end - begin));
  });
  for (Index i = 0; i < positions.cols(); ++i)
    if (!std::isfinite(values[i]) || !gradients.col(i).allFinite()) gradients.col(i).setZero();
}

// The point where f = 0 in first order, seen from where f and its gradient are known.
Point<3> newton_step(double value, const Point<3>& gradient) {
  return -value / gradient.squaredNorm() * gradient;
}

}  // namespace

Values Contact::distances() const {
  Values result(size());
  for (Index i = 0; i < size(); ++i)
    result[i] = values[i] == 0                          ? 0.0
                : definite[static_cast<std::size_t>(i)] ? std::abs(values[i]) / gradients.col(i).norm()
                                                        : infinity;
  return result;
}

Points<3> Contact::normals() const {
  Points<3> result = Points<3>::Zero(3, size());
  for (Index i = 0; i < size(); ++i)
    if (definite[static_cast<std::size_t>(i)]) result.col(i) = -gradients.col(i).normalized();
  return result;
}

Contact touch(const Field<3>& field, const PointsRef<3>& positions) {
  Contact contact;
  evaluate(field, positions, contact.values, contact.gradients);
  std::vector<double> sizes(static_cast<std::size_t>(positions.cols()));
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sizes[i] = contact.gradients.col(static_cast<Index>(i)).norm();
  contact.definite.assign(sizes.size(), 0);
  if (sizes.empty()) return contact;
  std::vector<double> sorted = sizes;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<Index>(sorted.size() / 2), sorted.end());
  const double least = 1e-5 * sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < sizes.size(); ++i) contact.definite[i] = sizes[i] > least;
  return contact;
}

Points<3> following(const Contact& contact, const Values& rates, double adhesion_gain) {
  if (rates.size() > 0) SEESAW_CHECK_EQ(rates.size(), contact.size());
  Points<3> result = Points<3>::Zero(3, contact.size());
  for (Index i = 0; i < contact.size(); ++i) {
    if (!contact.definite[static_cast<std::size_t>(i)]) continue;
    const double rate = rates.size() > 0 ? rates[i] : 0.0;
    result.col(i) = newton_step(rate + adhesion_gain * contact.values[i], contact.gradients.col(i));
  }
  return result;
}

Points<3> along(const Contact& contact, const Points<3>& desired) {
  SEESAW_CHECK_EQ(desired.cols(), contact.size());
  Points<3> result = Points<3>::Zero(3, contact.size());
  for (Index i = 0; i < contact.size(); ++i) {
    if (!contact.definite[static_cast<std::size_t>(i)]) continue;
    const Point<3> normal = contact.gradients.col(i).normalized();
    result.col(i) = desired.col(i) - normal.dot(desired.col(i)) * normal;
  }
  return result;
}

PutOn put_on(const Field<3>& field, const PointsRef<3>& positions, const Values& leashes,
             const Values& tolerances) {
  const Index n = positions.cols();
  SEESAW_CHECK_EQ(leashes.size(), n);
  SEESAW_CHECK_EQ(tolerances.size(), n);
  PutOn result = {positions, Points<3>::Zero(3, n), std::vector<char>(static_cast<std::size_t>(n), 0),
                  Values::Zero(n)};
  std::vector<Index> active(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) active[static_cast<std::size_t>(i)] = i;
  Points<3> at = positions, step = Points<3>::Zero(3, n), gradients;
  Values least = Values::Constant(n, infinity), values;
  for (int round = 0; round <= 10 && !active.empty(); ++round) {
    evaluate(field, at(Eigen::all, active), values, gradients);
    std::vector<Index> next;
    for (std::size_t k = 0; k < active.size(); ++k) {
      const Index i = active[k], column = static_cast<Index>(k);
      const double slope = gradients.col(column).norm(), value = std::abs(values[column]);
      if (!(slope > 0)) continue;
      if (value <= tolerances[i] * slope) {
        result.positions.col(i) = at.col(i);
        result.gradients.col(i) = gradients.col(column);
        result.on[static_cast<std::size_t>(i)] = 1;
        result.moved[i] = (at.col(i) - positions.col(i)).norm();
        continue;
      }
      if (value < least[i]) {
        least[i] = value;
        // Where f is flat the first order promises too much: no step longer than half the leash.
        step.col(i) = newton_step(values[column], gradients.col(column));
        const double length = step.col(i).norm();
        if (length > 0.5 * leashes[i]) step.col(i) *= 0.5 * leashes[i] / length;
      } else {
        at.col(i) -= step.col(i);  // too far: back, and half as far
        step.col(i) *= 0.5;
      }
      if (!((at.col(i) + step.col(i) - positions.col(i)).norm() <= leashes[i])) continue;
      at.col(i) += step.col(i);
      next.push_back(i);
    }
    active = std::move(next);
  }
  return result;
}

}  // namespace seesaw
