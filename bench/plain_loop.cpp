#include "bench/plain_loop.h"

#include <cmath>

namespace seesaw::bench {

namespace {

template <int Dim, class Phi>
void sum_over_centers(const CenterArrays& centers, const PointArrays& points, double* values,
                      const Phi& phi) {
  for (std::int64_t i = 0; i < points.count; ++i) {
    double sum = 0.0;
    for (std::int64_t j = 0; j < centers.count; ++j) {
      double squared = 0.0;
      for (int d = 0; d < Dim; ++d) {
        const double difference = points.coordinates[d][i] - centers.coordinates[d][j];
        squared += difference * difference;
      }
      sum += centers.weights[j] * phi(squared);
    }
    values[i] = sum;
  }
}

template <int Dim>
void in_dimension(Kernel kernel, const CenterArrays& centers, const PointArrays& points, double* values) {
  switch (kernel) {
    case Kernel::cubic:
      return sum_over_centers<Dim>(centers, points, values, [](double s) { return s * std::sqrt(s); });
    case Kernel::thin_plate_spline:
      return sum_over_centers<Dim>(centers, points, values,
                                   [](double s) { return s > 0.0 ? 0.5 * s * std::log(s) : 0.0; });
    case Kernel::linear:
      return sum_over_centers<Dim>(centers, points, values, [](double s) { return std::sqrt(s); });
  }
}

}  // namespace

void plain_loop(Kernel kernel, int dimension, const CenterArrays& centers, const PointArrays& points,
                double* values) {
  return dimension == 2 ? in_dimension<2>(kernel, centers, points, values)
                        : in_dimension<3>(kernel, centers, points, values);
}

}  // namespace seesaw::bench
