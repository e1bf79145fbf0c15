// Which part of the plane a window shows: a center, and how large a pixel is. Panned, zoomed and fitted.
//
// Before it: the size of the window's drawing area, the wheel, a document's box.
// After it: core/scene/plan_view.h, with which the document is drawn; and every click, as a scene point.
//
//     scene = center + pixel (x - width / 2, height / 2 - y)          pixels: y down, origin at the top left
//
// One can always go on. Zooming out ends where the document is a few pixels wide, zooming in where
// neighboring pixels would share their doubles, panning some ten documents away; and from everywhere the
// way back is open, also where the document has changed so that the view is beyond what it may reach.
#pragma once

#include "core/scene/plan_view.h"

namespace seesaw {

class View2D {
 public:
  /// In pixels, at least 1 each.
  explicit View2D(double width = 800, double height = 600);

  const Point<2>& center() const { return center_; }
  /// Scene units per pixel, > 0.
  double pixel() const { return pixel_; }
  double width() const { return width_; }
  double height() const { return height_; }
  Point<2> scene_from_pixel(const Point<2>& p) const {
    return center_ + pixel_ * Point<2>(p.x() - width_ / 2, height_ / 2 - p.y());
  }
  Point<2> pixel_from_scene(const Point<2>& p) const {
    return {width_ / 2 + (p.x() - center_.x()) / pixel_, height_ / 2 - (p.y() - center_.y()) / pixel_};
  }
  /// What is seen.
  Box<2> scene() const;
  /// For core/scene/picture.h: the same part of the scene on a page of the window's size, one point a pixel.
  PlanView plan() const;

  /// The center and the size of a pixel stay.
  void resize(double width, double height);
  /// Moves what is looked at by `by`, scene units.
  void pan(const Point<2>& by);
  /// Makes everything `factor` > 0 times as large on the screen; what is at `about` stays where it is.
  void zoom(double factor, const Point<2>& about);
  void center_on(const Point<2>& at);
  /// All of `box` as large as it can be, centered. A box of one point, or none, gets a view of about its
  /// size.
  void show(const Box<2>& box);

  /// What pan and zoom are not to lose: the document's box. Empty for no document.
  void set_home(const Box<2>& home);

  bool operator==(const View2D&) const = default;

 private:
  void move_center(const Point<2>& to);

  double width_ = 800, height_ = 600;
  Point<2> center_ = Point<2>::Zero();
  double pixel_ = 0.01;
  Point<2> home_ = Point<2>::Zero();  // center and longest side of the document's box
  double extent_ = 4;
};

}  // namespace seesaw
