#include "core/image/height_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/image/colormap.h"

namespace seesaw {
namespace {

constexpr double facet_overlap = 0.5;  // points; see Canvas::facet

struct Range {
  double low = 0, high = 0;
};

Range height_range(const HeightPlot& plot) {
  Range range{infinity, -infinity};
  const auto see = [&](double z) {
    if (!std::isfinite(z)) return;
    range.low = std::min(range.low, z);
    range.high = std::max(range.high, z);
  };
  for (const double z : plot.field.heights.reshaped()) see(z);
  if (range.low > range.high) throw Error("a height plot needs at least one height that is a number");
  for (const Pole& pole : plot.poles) see(pole.top.z());
  return range;
}

// A surface color in the light: soft and two-sided, so that shape shows but the color can still be read as
// a value.
Color lit(const Color& color, const Point<3>& normal, const HeightProjection& view) {
  const Point<3> light = (-0.55 * view.right() + 0.75 * view.up() + 0.65 * view.toward()).normalized();
  const bool underside = normal.dot(view.toward()) < 0;
  const Point<3> n = underside ? Point<3>(-normal) : normal;
  const double diffuse = std::max(0.0, n.dot(light));
  const double shine = std::pow(std::max(0.0, n.dot((light + view.toward()).normalized())), 40);
  const double bright = (underside ? 0.62 : 0.70) + 0.34 * diffuse;
  const Color shaded{color.r * bright, color.g * bright, color.b * bright};
  return mix(shaded, theme::paper, 0.16 * shine);
}

// What is left of a polygon on one side of z = 0: sign +1 keeps z >= 0, -1 keeps z <= 0.
std::vector<Point<3>> cut_at_zero(const std::vector<Point<3>>& polygon, double sign) {
  std::vector<Point<3>> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<3>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (sign * a.z() >= 0) kept.push_back(a);
    if (a.z() * b.z() < 0) {
      const double t = a.z() / (a.z() - b.z());
      Point<3> cut = a + t * (b - a);
      cut.z() = 0;
      kept.push_back(cut);
    }
  }
  return kept;
}

class Painter {
 public:
  Painter(Canvas& canvas, const HeightPlot& plot, const HeightProjection& view)
      : canvas_(canvas), plot_(plot), field_(plot.field), view_(view) {
    const double largest =
        field_.heights.unaryExpr([](double z) { return std::isfinite(z) ? std::abs(z) : 0.0; }).maxCoeff();
    color_range_ = plot.color_range.value_or(largest);
    if (!(color_range_ > 0)) color_range_ = 1;
    cell_ = Point<2>(field_.ground.sizes().x() / static_cast<double>(field_.nx() - 1),
                     field_.ground.sizes().y() / static_cast<double>(field_.ny() - 1));
  }

  /// The surface on one side of the sheet, from the back to the front.
  void surface(double sign) {
    const Index nx = field_.nx() - 1, ny = field_.ny() - 1;
    const bool up_x = view_.toward().x() >= 0, up_y = view_.toward().y() >= 0;
    for (Index a = 0; a < nx; ++a)
      for (Index b = 0; b < ny; ++b) cell(up_x ? a : nx - 1 - a, up_y ? b : ny - 1 - b, up_x, up_y, sign);
  }

  void sheet() {
    Points<2> corners(2, 4);
    Index k = 0;
    for (const auto corner : {Box<2>::BottomLeft, Box<2>::BottomRight, Box<2>::TopRight, Box<2>::TopLeft})
      corners.col(k++) = on_sheet(field_.ground.corner(corner));
    canvas_.fill_polygon(corners, hex("#F4F6F9").with_alpha(0.55));
    canvas_.polygon(corners, {.color = theme::soft_ink, .width = 0.8});
  }

  /// The shore. Before the land above is painted: all of it. After: only what is in sight, whole in its
  /// width.
  void curves(bool only_in_sight) {
    const Stroke stroke{.color = theme::curve, .width = plot_.curve_width};
    for (const Points<2>& curve : plot_.zero_curves) {
      const Points<2> fine = subdivided(curve);
      Points<2> page(2, fine.cols());
      for (Index i = 0; i < fine.cols(); ++i) {
        const Point<2> p = fine.col(i);
        const bool seen = !only_in_sight || view_.sees({p.x(), p.y(), 0}, field_, 0.1 * cell_.maxCoeff());
        page.col(i) = seen ? on_sheet(p) : Point<2>::Constant(std::numeric_limits<double>::quiet_NaN());
      }
      canvas_.polyline(page, stroke);
    }
  }

  /// The stems of the poles below the sheet (sign -1) or above it.
  void stems(double sign) {
    constexpr int pieces = 48;
    for (const Pole& pole : plot_.poles) {
      if (!(sign * pole.top.z() > 0) || !pole.top.allFinite()) continue;
      Points<2> seen(2, pieces + 1), whole(2, 2);
      for (int k = 0; k <= pieces; ++k) {
        const Point<3> p(pole.top.x(), pole.top.y(), pole.top.z() * k / pieces);
        seen.col(k) = view_.sees(p, field_, 0.02 * cell_.minCoeff())
                          ? view_.pixel_from_scene(p)
                          : Point<2>::Constant(std::numeric_limits<double>::quiet_NaN());
      }
      whole << on_sheet(pole.top.head<2>()), view_.pixel_from_scene(pole.top);
      canvas_.polyline(
          whole, {.color = pole.color.with_alpha(0.55), .width = 1, .dash = {2, 2.2}, .cap = Cap::butt});
      canvas_.polyline(seen, {.color = pole.color, .width = 1.4});
      canvas_.fill_circle(whole.col(0), 1.7, pole.color);
    }
  }

  void heads() {
    // Far heads first, so that near ones overlap them.
    std::vector<const Pole*> order;
    for (const Pole& pole : plot_.poles)
      if (pole.top.allFinite()) order.push_back(&pole);
    const auto nearness = [&](const Pole* p) { return view_.toward().head<2>().dot(p->top.head<2>()); };
    std::stable_sort(order.begin(), order.end(),
                     [&](const Pole* a, const Pole* b) { return nearness(a) < nearness(b); });
    for (const Pole* pole : order) {
      // A head is wider than its point: it is in sight while the point is not far under the surface.
      const bool seen = view_.sees(pole->top, field_, 0.4 * pole->size / view_.scale());
      const auto faint = canvas_.layer(seen ? 1 : 0.45);
      draw_symbol(canvas_, pole->head, view_.pixel_from_scene(pole->top), pole->size, pole->color);
    }
  }

 private:
  Point<2> on_sheet(const Point<2>& p) const { return view_.pixel_from_scene({p.x(), p.y(), 0}); }

  Point<3> corner(Index i, Index j) const {
    const Point<2> g = field_.ground_point(static_cast<double>(i), static_cast<double>(j));
    return {g.x(), g.y(), field_.heights(i, j)};
  }

  void cell(Index i, Index j, bool up_x, bool up_y, double sign) {
    const Point<3> p00 = corner(i, j), p10 = corner(i + 1, j), p11 = corner(i + 1, j + 1),
                   p01 = corner(i, j + 1);
    if (!(p00.allFinite() && p10.allFinite() && p11.allFinite() && p01.allFinite())) return;
    if (sign * p00.z() <= 0 && sign * p10.z() <= 0 && sign * p11.z() <= 0 && sign * p01.z() <= 0) {
      // Nothing on this side. Land that is level with the sheet belongs to the part above it.
      if (sign < 0 || p00.z() != 0 || p10.z() != 0 || p11.z() != 0 || p01.z() != 0) return;
    }
    const double ex = view_.exaggeration();
    const Point<3> normal = Point<3>(-0.5 * ex * (p10.z() + p11.z() - p00.z() - p01.z()) / cell_.x(),
                                     -0.5 * ex * (p01.z() + p11.z() - p00.z() - p10.z()) / cell_.y(), 1)
                                .normalized();
    // A facet with four corners of one sign is painted whole; one that the sheet cuts, as two triangles,
    // whose cuts are straight.
    const bool crosses = std::min({p00.z(), p10.z(), p11.z(), p01.z()}) < 0 &&
                         std::max({p00.z(), p10.z(), p11.z(), p01.z()}) > 0;
    Color line;
    if (crosses) {
      facet({p00, p10, p11}, normal, sign, line);
      facet({p00, p11, p01}, normal, sign, line);
    } else {
      facet({p00, p10, p11, p01}, normal, sign, line);
    }

    // Mesh lines on the far edges: the neighbors behind are painted already and cannot cover them.
    const auto on_mesh = [&](Index k, Index last) {
      return k == 0 || k == last || (plot_.mesh_every > 0 && k % plot_.mesh_every == 0);
    };
    const Index last_x = field_.nx() - 1, last_y = field_.ny() - 1;
    const bool far_x = on_mesh(up_x ? i : i + 1, last_x), near_x = up_x ? i + 1 == last_x : i == 0;
    const bool far_y = on_mesh(up_y ? j : j + 1, last_y), near_y = up_y ? j + 1 == last_y : j == 0;
    if (up_x ? far_x : near_x) edge(p00, p01, sign, line);
    if (up_x ? near_x : far_x) edge(p10, p11, sign, line);
    if (up_y ? far_y : near_y) edge(p00, p10, sign, line);
    if (up_y ? near_y : far_y) edge(p01, p11, sign, line);
  }

  void facet(const std::vector<Point<3>>& corners, const Point<3>& normal, double sign, Color& line) {
    const std::vector<Point<3>> kept = cut_at_zero(corners, sign);
    if (kept.size() < 3) return;
    Points<2> page(2, static_cast<Index>(kept.size()));
    double height = 0;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      page.col(static_cast<Index>(k)) = view_.pixel_from_scene(kept[k]);
      height += kept[k].z();
    }
    height /= static_cast<double>(kept.size());
    // A touch past zero, so that land near the shore shows its side and does not fade into the sheet.
    const double value = std::clamp(height / color_range_, -1.0, 1.0);
    const Color color = lit(diverging_color(sign * (0.10 + 0.90 * std::abs(value))), normal, view_);
    line = mix(color, theme::ink, 0.34);
    canvas_.facet(page, color, facet_overlap);
  }

  void edge(const Point<3>& a, const Point<3>& b, double sign, const Color& color) {
    const double za = sign * a.z(), zb = sign * b.z();
    if (za < 0 && zb < 0) return;
    Point<3> from = a, to = b;
    if (za < 0) from = a + za / (za - zb) * (b - a);
    if (zb < 0) to = b + zb / (zb - za) * (a - b);
    // A little longer than the edge, over what the overlap of the next facets takes off its ends.
    const Point<2> p = view_.pixel_from_scene(from), q = view_.pixel_from_scene(to);
    const double length = (q - p).norm();
    if (!(length > 0)) return;
    const Point<2> more = 0.5 * facet_overlap / length * (q - p);
    canvas_.line(p - more, q + more, {.color = color, .width = 0.6, .cap = Cap::butt});
  }

  // With pieces no longer than half a cell, so that what is hidden can end between two points.
  Points<2> subdivided(const Points<2>& curve) const {
    std::vector<Point<2>> fine;
    for (Index i = 0; i < curve.cols(); ++i) {
      if (i > 0) {
        const Point<2> a = curve.col(i - 1), run = curve.col(i) - a;
        const double length = run.norm() / (0.5 * cell_.minCoeff());
        const int pieces = std::isfinite(length) ? static_cast<int>(std::min(length, 1000.0)) + 1 : 1;
        for (int k = 1; k < pieces; ++k) fine.push_back(a + run * (static_cast<double>(k) / pieces));
      }
      fine.push_back(curve.col(i));
    }
    Points<2> points(2, static_cast<Index>(fine.size()));
    for (std::size_t i = 0; i < fine.size(); ++i) points.col(static_cast<Index>(i)) = fine[i];
    return points;
  }

  Canvas& canvas_;
  const HeightPlot& plot_;
  const HeightField& field_;
  const HeightProjection& view_;
  double color_range_ = 1;
  Point<2> cell_;
};

}  // namespace

HeightProjection project(const HeightPlot& plot, const Rect& region) {
  if (plot.field.nx() < 2 || plot.field.ny() < 2)
    throw Error("a height plot needs a grid of at least 2 x 2 heights");
  const Point<2> sizes = plot.field.ground.sizes();
  if (!sizes.allFinite() || !(sizes.minCoeff() > 0)) throw Error("a height plot needs a ground of some size");
  const Range range = height_range(plot);
  const double low = std::min(range.low, 0.0), high = std::max(range.high, 0.0);
  const double fitting = high > low ? plot.relief * sizes.maxCoeff() / (high - low) : 1;

  // What must fit: the land, the sheet, the poles.
  const HeightField& field = plot.field;
  Points<3> scene(3, field.nx() * field.ny() + 4 + static_cast<Index>(plot.poles.size()));
  Index n = 0;
  for (Index i = 0; i < field.nx(); ++i)
    for (Index j = 0; j < field.ny(); ++j) {
      const Point<2> g = field.ground_point(static_cast<double>(i), static_cast<double>(j));
      scene.col(n++) << g, field.heights(i, j);
    }
  for (const auto corner : {Box<2>::BottomLeft, Box<2>::BottomRight, Box<2>::TopRight, Box<2>::TopLeft})
    scene.col(n++) << field.ground.corner(corner), 0.0;
  for (const Pole& pole : plot.poles) scene.col(n++) = pole.top;
  return HeightProjection(region, scene, plot.azimuth, plot.elevation, plot.exaggeration.value_or(fitting));
}

HeightProjection draw_height_plot(Canvas& canvas, const Rect& region, const HeightPlot& plot) {
  const HeightProjection view = project(plot, region);
  Painter painter(canvas, plot, view);
  painter.surface(-1);
  painter.stems(-1);
  if (plot.zero_plane) painter.sheet();
  painter.curves(false);
  painter.surface(1);
  painter.curves(true);
  painter.stems(1);
  painter.heads();
  return view;
}

}  // namespace seesaw
