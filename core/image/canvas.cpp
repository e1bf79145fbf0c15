#include "core/image/canvas.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/sheet.h"

namespace seesaw {
namespace {

void set_color(cairo_t* cr, const Color& color) {
  const Color c = safe(color);
  cairo_set_source_rgba(cr, c.r, c.g, c.b, c.a);
}

void add_path(cairo_t* cr, const Points<2>& points, bool closed) {
  for (Index i = 0; i < points.cols(); ++i)
    i == 0 ? cairo_move_to(cr, points(0, i), points(1, i)) : cairo_line_to(cr, points(0, i), points(1, i));
  if (closed && points.cols() > 0) cairo_close_path(cr);
}

// Cairo refuses for good (the whole picture is lost) a dash with a negative or with no positive length.
bool usable(const std::vector<double>& dash) {
  double sum = 0;
  for (const double length : dash) {
    if (!(length >= 0) || !std::isfinite(length)) return false;
    sum += length;
  }
  return sum > 0;
}

void stroke_path(cairo_t* cr, const Stroke& stroke) {
  set_color(cr, stroke.color);
  cairo_set_line_width(cr, stroke.width);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cr, stroke.cap == Cap::round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  const bool dashed = usable(stroke.dash);
  cairo_set_dash(cr, dashed ? stroke.dash.data() : nullptr, dashed ? static_cast<int>(stroke.dash.size()) : 0,
                 0);
  cairo_stroke(cr);
}

bool drawable(const Stroke& stroke) { return stroke.width > 0 && std::isfinite(stroke.width); }

Points<2> corners_of(const Rect& r) {
  Points<2> p(2, 4);
  p << r.left(), r.right(), r.right(), r.left(), r.top(), r.top(), r.bottom(), r.bottom();
  return p;
}

// A polygon close enough to a circle for the sheet, for the circles that Cairo's own numbers cannot hold.
Points<2> circle_points(const Point<2>& center, double radius) {
  const Index n = 8192;
  Points<2> points(2, n);
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.col(i) = center + radius * Point<2>(std::cos(angle), std::sin(angle));
  }
  return points;
}

}  // namespace

Canvas::Canvas(double width, double height, const Color& background) {
  if (!(width > 0 && height > 0 && std::isfinite(width) && std::isfinite(height)))
    throw Error("a canvas needs a size above zero, not " + to_text(width) + " x " + to_text(height) +
                " points");
  marks_ = std::make_unique<Marks>(Marks{width, height, background, {}, {}, {}});
}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

double Canvas::width() const { return marks_->width; }
double Canvas::height() const { return marks_->height; }

void Canvas::line(const Point<2>& from, const Point<2>& to, const Stroke& stroke) {
  Points<2> points(2, 2);
  points << from, to;
  polyline(points, stroke);
}

void Canvas::polyline(const PointsRef<2>& points, const Stroke& stroke) {
  if (!drawable(stroke)) return;
  std::vector<Points<2>> pieces = pieces_within(points, marks_->reach(stroke.width));
  if (pieces.empty()) return;
  marks_->list.push_back([pieces = std::move(pieces), stroke](const Brush& brush) {
    for (const Points<2>& piece : pieces) add_path(brush.cairo, piece, false);
    stroke_path(brush.cairo, stroke);
  });
}

void Canvas::polygon(const PointsRef<2>& points, const Stroke& stroke) { rings({Points<2>(points)}, stroke); }

void Canvas::rings(const std::vector<Points<2>>& all, const Stroke& stroke) {
  if (!drawable(stroke)) return;
  std::vector<Points<2>> cut;
  for (const Points<2>& ring : all) cut.push_back(ring_within(ring, marks_->reach(stroke.width)));
  marks_->list.push_back([cut = std::move(cut), stroke](const Brush& brush) {
    for (const Points<2>& ring : cut) add_path(brush.cairo, ring, true);
    stroke_path(brush.cairo, stroke);
  });
}

void Canvas::circle(const Point<2>& center, double radius, const Stroke& stroke) {
  if (!drawable(stroke) || !center.allFinite() || !(radius > 0) || !std::isfinite(radius)) return;
  const Box<2> box(center.array() - radius, center.array() + radius);
  if (!marks_->reach(stroke.width).contains(box)) return polygon(circle_points(center, radius), stroke);
  marks_->list.push_back([center, radius, stroke](const Brush& brush) {
    cairo_new_sub_path(brush.cairo);
    cairo_arc(brush.cairo, center.x(), center.y(), radius, 0, 2 * std::numbers::pi);
    cairo_close_path(brush.cairo);
    stroke_path(brush.cairo, stroke);
  });
}

void Canvas::rectangle(const Rect& rect, const Stroke& stroke) { polygon(corners_of(rect), stroke); }

void Canvas::arrow(const Point<2>& from, const Point<2>& to, const Stroke& stroke, double head) {
  const double length = (to - from).norm();
  if (!std::isfinite(length) || length == 0 || !drawable(stroke)) return;
  const Point<2> along = (to - from) / length, across(-along.y(), along.x());
  const double size = std::clamp(head, 0.0, length);
  Stroke shaft = stroke;
  shaft.cap = Cap::butt;  // a round end would show beside the point
  line(from, to - 0.8 * size * along, shaft);
  Points<2> tip(2, 4);
  tip << to, to - size * along + 0.38 * size * across, to - 0.78 * size * along,
      to - size * along - 0.38 * size * across;
  fill_polygon(tip, stroke.color);
}

void Canvas::fill_polygon(const PointsRef<2>& points, const Color& color) {
  fill_rings({Points<2>(points)}, color, FillRule::winding);
}

void Canvas::fill_rings(const std::vector<Points<2>>& all, const Color& color, FillRule rule) {
  std::vector<Points<2>> cut;
  for (const Points<2>& ring : all) cut.push_back(ring_within(ring, marks_->reach()));
  marks_->list.push_back([cut = std::move(cut), color, rule](const Brush& brush) {
    for (const Points<2>& ring : cut) add_path(brush.cairo, ring, true);
    set_color(brush.cairo, color);
    cairo_set_fill_rule(brush.cairo,
                        rule == FillRule::even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_fill(brush.cairo);
  });
}

void Canvas::fill_circle(const Point<2>& center, double radius, const Color& color) {
  if (!center.allFinite() || !(radius > 0) || !std::isfinite(radius)) return;
  const Box<2> box(center.array() - radius, center.array() + radius);
  if (!marks_->reach().contains(box)) return fill_polygon(circle_points(center, radius), color);
  marks_->list.push_back([center, radius, color](const Brush& brush) {
    cairo_new_sub_path(brush.cairo);
    cairo_arc(brush.cairo, center.x(), center.y(), radius, 0, 2 * std::numbers::pi);
    set_color(brush.cairo, color);
    cairo_fill(brush.cairo);
  });
}

void Canvas::fill_rectangle(const Rect& rect, const Color& color, double corner) {
  const double r = std::min({corner, rect.width / 2, rect.height / 2});
  const Box<2> box(Point<2>(rect.left(), rect.top()), Point<2>(rect.right(), rect.bottom()));
  if (!corners_of(rect).allFinite()) return;
  if (!(r > 0) || !marks_->reach().contains(box)) return fill_polygon(corners_of(rect), color);
  marks_->list.push_back([rect, color, r](const Brush& brush) {
    const double quarter = std::numbers::pi / 2;
    cairo_new_sub_path(brush.cairo);
    cairo_arc(brush.cairo, rect.right() - r, rect.top() + r, r, -quarter, 0);
    cairo_arc(brush.cairo, rect.right() - r, rect.bottom() - r, r, 0, quarter);
    cairo_arc(brush.cairo, rect.left() + r, rect.bottom() - r, r, quarter, 2 * quarter);
    cairo_arc(brush.cairo, rect.left() + r, rect.top() + r, r, 2 * quarter, 3 * quarter);
    cairo_close_path(brush.cairo);
    set_color(brush.cairo, color);
    cairo_fill(brush.cairo);
  });
}

void Canvas::facet(const PointsRef<2>& points, const Color& color, double overlap) {
  Points<2> ring = ring_within(points, marks_->reach());
  marks_->list.push_back([ring = std::move(ring), color, overlap](const Brush& brush) {
    add_path(brush.cairo, ring, true);
    set_color(brush.cairo, color);
    cairo_set_fill_rule(brush.cairo, CAIRO_FILL_RULE_WINDING);
    if (!(overlap > 0)) return cairo_fill(brush.cairo);
    cairo_fill_preserve(brush.cairo);
    stroke_path(brush.cairo, {.color = color, .width = overlap});
  });
}

Canvas::Scope Canvas::clip(const Rect& rect) {
  const Points<2> ring = ring_within(corners_of(rect), marks_->reach());
  marks_->list.push_back([ring](const Brush& brush) {
    cairo_save(brush.cairo);
    add_path(brush.cairo, ring, true);
    cairo_clip(brush.cairo);
  });
  marks_->open.push_back([](const Brush& brush) { cairo_restore(brush.cairo); });
  return Scope(marks_.get());
}

Canvas::Scope Canvas::layer(double opacity) {
  const double alpha = safe({0, 0, 0, opacity}).a;
  if (alpha == 1) {  // an opaque layer changes nothing, and vector files stay simpler
    marks_->open.push_back([](const Brush&) {});
    return Scope(marks_.get());
  }
  marks_->list.push_back([](const Brush& brush) { cairo_push_group(brush.cairo); });
  marks_->open.push_back([alpha](const Brush& brush) {
    cairo_pop_group_to_source(brush.cairo);
    cairo_paint_with_alpha(brush.cairo, alpha);
  });
  return Scope(marks_.get());
}

void Canvas::Scope::close() {
  if (!marks_) return;
  marks_->list.push_back(std::move(marks_->open.back()));
  marks_->open.pop_back();
  marks_ = nullptr;
}

}  // namespace seesaw
