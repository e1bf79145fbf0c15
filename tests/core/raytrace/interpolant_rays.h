// Rays through interpolants, and the truth about them by brute force: many samples, then bisection.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/base/random.h"
#include "core/raytrace/surface_tracer.h"
#include "core/rbf/fit.h"

namespace seesaw {

// The whole claim is about 10^5 rays; under the sanitizers a tenth keeps the time bearable.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr Index rays_in_all = 10000;
#else
inline constexpr Index rays_in_all = 100000;
#endif

/// Constraints of all kinds at random places: a crumpled, many-lobed surface.
inline Constraints<3> crumpled(Random& random) {
  Constraints<3> result;
  const Box<3> box(Point<3>::Constant(-1), Point<3>::Constant(1));
  for (int i = 0; i < 36; ++i) {
    const Point<3> at = random.points_in<3>(box, 1).col(0);
    if (i % 3 == 0) result.push_back(boundary<3>(at, random.direction<3>(), 0.02));
    if (i % 3 == 1) result.push_back(interior<3>(at, random.uniform(0.5, 2)));
    if (i % 3 == 2) result.push_back(exterior<3>(at, -random.uniform(0.5, 2)));
  }
  return result;
}

/// A wavy sheet a hundredth of its width thin, held by normals on both sides: 60 rows.
inline Constraints<3> thin_sheet(Random& random) {
  Constraints<3> result;
  for (int i = 0; i < 15; ++i) {
    const Point<3> at(random.uniform(-1, 1), random.uniform(-1, 1), 0.1 * random.normal());
    result.push_back(boundary<3>(at, {0, 0, 1}, 0.004));
    result.push_back(boundary<3>(at - Point<3>(0, 0, 0.02), {0, 0, -1}, 0.004));
  }
  return result;
}

/// A small blade within a wide, calm surrounding. For the kernel r, whose gradient is steep only right beside
/// such pairs of constraints: 2,000 samples of the box do not come near.
inline Constraints<3> blade(Random& random) {
  Constraints<3> result;
  for (int i = 0; i < 12; ++i) result.push_back(exterior<3>(1.5 * random.direction<3>()));
  for (int i = 0; i < 12; ++i) {
    const Point<3> at(0.1 * (i % 4) - 0.15, 0.1 * (i / 4) - 0.1, 0.02 * random.normal());
    result.push_back(boundary<3>(at, {0, 0, 1}, 0.004));
    result.push_back(boundary<3>(at - Point<3>(0, 0, 0.016), {0, 0, -1}, 0.004));
  }
  return result;
}

/// Rays from a sphere around the field's box toward points in its middle: within `reach` of its sides.
inline std::vector<Ray> rays_toward(const Field<3>& field, Index count, Random& random, double reach = 0.25) {
  const Box<3> box = field.bounding_box();
  const Box<3> middle(box.center() - reach * box.sizes(), box.center() + reach * box.sizes());
  std::vector<Ray> rays(static_cast<std::size_t>(count));
  for (Ray& ray : rays) {
    ray.origin = box.center() + box.sizes().norm() * random.direction<3>();
    ray.direction = (random.points_in<3>(middle, 1).col(0) - ray.origin).normalized();
  }
  return rays;
}

/// Where f changes sign on the ray within the box, as `samples` evenly spaced values and bisection see it.
inline std::vector<double> crossings_by_samples(const Field<3>& field, const Ray& ray, Index samples) {
  const Ray part = within(ray, field.bounding_box());
  if (!(part.begin < part.end)) return {};
  const auto place = [&](Index k) {
    return part.begin + (part.end - part.begin) * static_cast<double>(k) / static_cast<double>(samples);
  };
  Points<3> points(3, samples + 1);
  for (Index k = 0; k <= samples; ++k) points.col(k) = part.at(place(k));
  const Values values = field.values(points);
  std::vector<double> low, high;
  std::vector<bool> low_inside;
  for (Index k = 0; k < samples; ++k)
    if ((values[k] >= 0) != (values[k + 1] >= 0)) {
      low.push_back(place(k));
      high.push_back(place(k + 1));
      low_inside.push_back(values[k] >= 0);
    }
  Points<3> middles(3, static_cast<Index>(low.size()));
  for (int halving = 0; halving < 40 && !low.empty(); ++halving) {
    for (std::size_t i = 0; i < low.size(); ++i)
      middles.col(static_cast<Index>(i)) = part.at(0.5 * (low[i] + high[i]));
    const Values at_middles = field.values(middles);
    for (std::size_t i = 0; i < low.size(); ++i)
      ((at_middles[static_cast<Index>(i)] >= 0) == low_inside[i] ? low[i] : high[i]) =
          0.5 * (low[i] + high[i]);
  }
  return low;
}

/// How many of the true crossings the tracer did not find within `near`.
inline Index missed(const std::vector<double>& truth, const RayCrossings& found, double near) {
  Index count = 0;
  for (const double t : truth)
    count += std::none_of(found.crossings.begin(), found.crossings.end(),
                          [&](const Crossing& crossing) { return std::abs(crossing.t - t) <= near; });
  return count;
}

}  // namespace seesaw
