#include "core/editing/view_2d.h"

#include <algorithm>
#include <cmath>

namespace seesaw {

namespace {

// Beyond these nothing that is squared on the way to a picture would stay finite and normal.
constexpr double largest_coordinate = 1e120, smallest_pixel = 1e-120, largest_pixel = 1e117;
// Relative to the coordinates: a thousand pixels then have some 5e5 doubles to tell them apart.
constexpr double finest = 1e-13;

Point<2> clamped(const Point<2>& p) { return p.cwiseMax(-largest_coordinate).cwiseMin(largest_coordinate); }

}  // namespace

View2D::View2D(double width, double height) { resize(width, height); }

Box<2> View2D::scene() const {
  const Point<2> half = 0.5 * pixel_ * Point<2>(width_, height_);
  return {center_ - half, center_ + half};
}

PlanView View2D::plan() const { return {Rect{0, 0, width_, height_}, scene(), 1 / pixel_}; }

void View2D::resize(double width, double height) {
  width_ = std::max(1.0, width);
  height_ = std::max(1.0, height);
}

// No farther out than is allowed, or than it is.
void View2D::move_center(const Point<2>& to) {
  if (!to.allFinite()) return;
  const Point<2> reach = Point<2>::Constant(10 * extent_) + 0.5 * pixel_ * Point<2>(width_, height_);
  const Point<2> low = (home_ - reach).cwiseMin(center_), high = (home_ + reach).cwiseMax(center_);
  center_ = clamped(to.cwiseMax(low).cwiseMin(high));
}

void View2D::pan(const Point<2>& by) { move_center(center_ + by); }

void View2D::zoom(double factor, const Point<2>& about) {
  if (!(factor > 0) || !std::isfinite(factor) || !about.allFinite()) return;
  const double coordinate = std::max(center_.cwiseAbs().maxCoeff(), home_.cwiseAbs().maxCoeff());
  const double least = std::max({smallest_pixel, 1e-12 * extent_, finest * coordinate});
  const double most = std::max(std::min(largest_pixel, extent_ / 8), 8 * least);
  const double pixel = std::clamp(pixel_ / factor, std::min(least, pixel_), std::max(most, pixel_));
  const Point<2> to = about + (pixel / pixel_) * (center_ - about);
  pixel_ = pixel;
  move_center(to);
}

void View2D::center_on(const Point<2>& at) { move_center(at); }

void View2D::show(const Box<2>& box) {
  Box<2> shown(Point<2>(-2, -2), Point<2>(2, 2));
  if (!box.isEmpty() && box.min().allFinite() && box.max().allFinite())
    shown = Box<2>(clamped(box.min()), clamped(box.max()));
  center_ = shown.center();
  const Point<2> size = shown.sizes();
  pixel_ = std::max(size.x() / width_, size.y() / height_);
  if (!(pixel_ > 0)) pixel_ = 1 / std::min(width_, height_);
  pixel_ =
      std::clamp(std::max(pixel_, finest * center_.cwiseAbs().maxCoeff()), smallest_pixel, largest_pixel);
}

void View2D::set_home(const Box<2>& home) {
  home_ = Point<2>::Zero();
  extent_ = 4;
  if (home.isEmpty() || !home.min().allFinite() || !home.max().allFinite()) return;
  const Box<2> box(clamped(home.min()), clamped(home.max()));
  home_ = box.center();
  extent_ = box.sizes().maxCoeff();
  if (!(extent_ > 0)) extent_ = 1;
}

}  // namespace seesaw
