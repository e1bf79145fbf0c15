#include "core/scene/inside_rings.h"

#include <algorithm>
#include <cmath>

namespace seesaw {

namespace {

// How far along the border of the box, counterclockwise from its lower left corner.
class Border {
 public:
  explicit Border(const Box<2>& box) : box_(box), size_(box.sizes()) {}

  double length() const { return 2 * (size_.x() + size_.y()); }

  double place_of(const Point<2>& p) const {
    const Point<2> low = p - box_.min(), high = box_.max() - p;
    const double off[] = {std::abs(low.y()), std::abs(high.x()), std::abs(high.y()), std::abs(low.x())};
    switch (std::min_element(off, off + 4) - off) {
      case 0:
        return low.x();
      case 1:
        return size_.x() + low.y();
      case 2:
        return size_.x() + size_.y() + high.x();
      default:
        return 2 * size_.x() + size_.y() + high.y();
    }
  }

  /// The corners passed on the way counterclockwise.
  void add_corners(double from, double way, std::vector<Point<2>>& ring) const {
    const double at[] = {size_.x(), size_.x() + size_.y(), 2 * size_.x() + size_.y(), length()};
    const Point<2> corner[] = {
        {box_.max().x(), box_.min().y()}, box_.max(), {box_.min().x(), box_.max().y()}, box_.min()};
    for (int turn = 0; turn < 2; ++turn)
      for (int k = 0; k < 4; ++k) {
        const double there = at[k] + turn * length() - from;
        if (there > 0 && there < way) ring.push_back(corner[k]);
      }
  }

  double way(double from, double to) const { return to >= from ? to - from : to - from + length(); }

 private:
  Box<2> box_;
  Point<2> size_;
};

Points<2> ring_of(const std::vector<Point<2>>& points) {
  Points<2> result(2, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) result.col(static_cast<Index>(i)) = points[i];
  return result;
}

}  // namespace

std::vector<Points<2>> inside_rings(const std::vector<Polyline>& polylines, const Box<2>& box) {
  std::vector<Points<2>> rings;
  struct Open {
    const Polyline* line;
    double start, end;
    bool used = false;
  };
  std::vector<Open> open;
  const Border border(box);
  for (const Polyline& line : polylines) {
    if (line.vertices.cols() < 2) continue;
    if (line.closed)
      rings.push_back(line.vertices);
    else
      open.push_back({&line, border.place_of(line.vertices.col(0)),
                      border.place_of(line.vertices.col(line.vertices.cols() - 1))});
  }
  for (Open& first : open) {
    if (first.used) continue;
    std::vector<Point<2>> ring;
    for (Open* here = &first; !here->used;) {
      here->used = true;
      for (Index i = 0; i < here->line->vertices.cols(); ++i) ring.push_back(here->line->vertices.col(i));
      const auto next = std::ranges::min_element(
          open, {}, [&](const Open& each) { return border.way(here->end, each.start); });
      border.add_corners(here->end, border.way(here->end, next->start), ring);
      here = &*next;
    }
    rings.push_back(ring_of(ring));
  }
  return rings;
}

}  // namespace seesaw
