#include "core/image/height_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace seesaw {

Point<2> HeightField::ground_point(double i, double j) const {
  const Point<2> fraction(i / static_cast<double>(nx() - 1), j / static_cast<double>(ny() - 1));
  return ground.min() + fraction.cwiseProduct(ground.sizes());
}

double HeightField::height_at(const Point<2>& p) const {
  const Point<2> place = (p - ground.min()).cwiseQuotient(ground.sizes());
  if (!(place.minCoeff() >= 0 && place.maxCoeff() <= 1)) return std::numeric_limits<double>::quiet_NaN();
  const double u = place.x() * static_cast<double>(nx() - 1), v = place.y() * static_cast<double>(ny() - 1);
  const Index i = std::min(static_cast<Index>(u), nx() - 2), j = std::min(static_cast<Index>(v), ny() - 2);
  const double s = u - static_cast<double>(i), t = v - static_cast<double>(j);
  return (1 - s) * ((1 - t) * heights(i, j) + t * heights(i, j + 1)) +
         s * ((1 - t) * heights(i + 1, j) + t * heights(i + 1, j + 1));
}

HeightProjection::HeightProjection(const Rect& region, const PointsRef<3>& scene, double azimuth,
                                   double elevation, double exaggeration)
    : exaggeration_(exaggeration) {
  const double a = azimuth * std::numbers::pi / 180;
  const double e = std::clamp(elevation, 2.0, 90.0) * std::numbers::pi / 180;
  right_ = {-std::sin(a), std::cos(a), 0};
  up_ = {-std::cos(a) * std::sin(e), -std::sin(a) * std::sin(e), std::cos(e)};
  toward_ = {std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)};

  Box<2> page;  // at one point per scene unit
  for (Index i = 0; i < scene.cols(); ++i)
    if (scene.col(i).allFinite()) page.extend(pixel_from_scene(scene.col(i)));
  const Point<2> sizes = page.sizes();
  scale_ = std::min(sizes.x() > 0 ? region.width / sizes.x() : infinity,
                    sizes.y() > 0 ? region.height / sizes.y() : infinity);
  if (!std::isfinite(scale_)) scale_ = 1;
  origin_ = region.center() - scale_ * page.center();
}

Point<2> HeightProjection::pixel_from_scene(const Point<3>& scene) const {
  const Point<3> p(scene.x(), scene.y(), scene.z() * exaggeration_);
  return origin_ + scale_ * Point<2>(right_.dot(p), -up_.dot(p));
}

bool HeightProjection::sees(const Point<3>& scene, const HeightField& field, double slack) const {
  const double across = toward_.head<2>().norm();
  if (across < 1e-9) {  // from straight above
    const double height = field.height_at(scene.head<2>());
    return !(height * exaggeration_ > scene.z() * exaggeration_ + slack);
  }
  // Walk toward the camera in steps of a third of a cell until the ground ends.
  const Point<2> cell(field.ground.sizes().x() / static_cast<double>(field.nx() - 1),
                      field.ground.sizes().y() / static_cast<double>(field.ny() - 1));
  const double step = cell.minCoeff() / 3;
  const Point<2> direction = toward_.head<2>() / across;
  const double rise = toward_.z() / across;
  const double longest = field.ground.sizes().norm();
  for (double walked = step; walked <= longest; walked += step) {
    const Point<2> at = scene.head<2>() + walked * direction;
    if (!field.ground.contains(at)) break;
    if (field.height_at(at) * exaggeration_ > scene.z() * exaggeration_ + walked * rise + slack) return false;
  }
  return true;
}

}  // namespace seesaw
