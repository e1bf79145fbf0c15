#include "sandbox2d/profile_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/image/chart_frame.h"
#include "core/image/colormap.h"
#include "core/image/symbols.h"

namespace seesaw {

double ProfileData::at(double distance) const {
  if (empty() || !(distance >= 0 && distance <= length)) return std::numeric_limits<double>::quiet_NaN();
  const Index last = along.size() - 1;
  const double place = distance / length * static_cast<double>(last);
  const Index i = std::min(static_cast<Index>(place), last - 1);
  const double t = place - static_cast<double>(i);
  return t == 0 ? values[i] : (1 - t) * values[i] + t * values[i + 1];
}

ProfileData profile_of(const Field<2>& field, const ProfileLine& line, const Document<2>& document,
                       const Field<2>* other, double near, Index samples) {
  ProfileData profile;
  const Point<2> run = line.to - line.from;
  const double length = run.norm();
  if (!(length > 0) || !std::isfinite(length) || samples < 2) return profile;
  const Point<2> direction = run / length;
  profile.length = length;
  profile.along = Values::LinSpaced(samples, 0, length);
  Points<2> points(2, samples);
  for (Index i = 0; i < samples; ++i) points.col(i) = line.from + profile.along[i] * direction;
  profile.values = field.values(points);
  if (other) profile.other = other->values(points);

  const auto mark = [&](const Point<2>& at, double value, ConstraintKind kind, bool normal, bool highlight) {
    const Point<2> from = at - line.from;
    const double along = from.dot(direction);
    const double beyond = std::max({0.0, -along, along - length});
    if (!(std::hypot(cross(direction, from), beyond) <= near)) return;
    profile.marks.push_back({std::clamp(along, 0.0, length), value, kind, normal, highlight});
  };
  for (const SceneConstraint<2>& each : document.constraints) {
    const Constraint<2>& c = each.constraint;
    if (c.normal)
      mark(c.at - c.normal->offset * c.normal->direction.normalized(), c.normal->value, c.kind, true,
           each.highlight || each.highlight_normal);
    mark(c.at, c.value, c.kind, false, each.highlight);
  }
  return profile;
}

void ProfileRange::include(const ProfileData& profile) {
  double low = 0, high = 0;
  const auto see = [&](double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const double value : profile.values) see(value);
  for (const double value : profile.other) see(value);
  for (const ProfileMark& mark : profile.marks) see(mark.value);
  const bool fresh = low_ == high_;
  if (!fresh && low >= low_ && high <= high_) return;
  // Room at an end that has moved; a fresh range has some at both, so that zero is no edge of the chart.
  const double span = std::max(high, fresh ? high : high_) - std::min(low, fresh ? low : low_);
  if (!(span > 0)) return;
  if (fresh || high > high_) high_ = std::max(high + 0.12 * span, fresh ? 0.0 : high_);
  if (fresh || low < low_) low_ = std::min(low - 0.12 * span, fresh ? 0.0 : low_);
}

void ProfileRange::settle(const ProfileData& profile) {
  ProfileRange needed;
  needed.include(profile);
  if (3 * (needed.high() - needed.low()) < high_ - low_) reset();
  include(profile);
}

namespace {

class ProfilePainter {
 public:
  ProfilePainter(Canvas& canvas, const Rect& region, const ProfileData& profile, const ProfileRange& range,
                 const ProfileLook& look)
      : canvas_(canvas), profile_(profile), look_(look), unit_(look.text_size / 10) {
    const double low = range.low() < range.high() ? range.low() : -1,
                 high = range.low() < range.high() ? range.high() : 1;
    frame_.x = Scale(0, profile.empty() ? 1 : profile.length, false);
    frame_.y = Scale(low, high, false);
    frame_.y_ticks =
        linear_ticks(low, high, std::max(2, static_cast<int>(region.height / (2.2 * look.text_size))));
    double widest = 0;
    for (const Tick& tick : frame_.y_ticks)
      widest = std::max(widest, measure_text(tick.label, words()).width);
    frame_.plot = region.inset(widest + 1.6 * look.text_size + 6 * unit_, 0.8 * look.text_size,
                               1.2 * look.text_size, 3.15 * look.text_size);
    frame_.x_ticks = linear_ticks(frame_.x.low(), frame_.x.high(),
                                  std::max(2, static_cast<int>(frame_.plot.width / (5.5 * look.text_size))));
  }

  bool has_room() const {
    return frame_.plot.width > 2 * look_.text_size && frame_.plot.height > 2 * look_.text_size;
  }

  void axes() {
    const UiColors& c = look_.colors;
    const Rect& plot = frame_.plot;
    for (const Tick& tick : frame_.y_ticks) {
      const double y = at(0, tick.value).y();
      canvas_.line({plot.left(), y}, {plot.right(), y},
                   {.color = c.line, .width = 0.8 * unit_, .cap = Cap::butt});
      TextStyle style = words();
      style.align = Align::right;
      style.vertical = VerticalAlign::middle;
      canvas_.text({plot.left() - 5 * unit_, y}, tick.label, style);
    }
    for (const Tick& tick : frame_.x_ticks) {
      const double x = at(tick.value, 0).x();
      canvas_.line({x, plot.bottom()}, {x, plot.bottom() + 3.5 * unit_},
                   {.color = c.soft_ink, .width = 0.9 * unit_, .cap = Cap::butt});
      TextStyle style = words();
      style.align = Align::center;
      style.vertical = VerticalAlign::top;
      canvas_.text({x, plot.bottom() + 5.5 * unit_}, tick.label, style);
    }
    canvas_.line({plot.left(), plot.bottom()}, {plot.right(), plot.bottom()},
                 {.color = c.soft_ink, .width = 0.9 * unit_, .cap = Cap::butt});
    TextStyle name = words();
    name.color = c.ink;
    name.align = Align::center;
    const double room = 2 * (canvas_.width() - plot.center().x());
    const char* words = "distance along the line";
    if (measure_text(words, name).width > room) words = "distance";
    canvas_.text({plot.center().x(), plot.bottom() + 2.65 * look_.text_size}, words, name);
    name.italic = true;
    name.vertical = VerticalAlign::middle;
    canvas_.text({plot.left() - 5 * unit_ - widest_label() - 0.8 * look_.text_size, plot.center().y()}, "f",
                 name);
  }

  // The land between f and zero, cut where f passes zero.
  void areas() {
    std::vector<Point<2>> area;  // data
    int side = 0;
    const auto close = [&] {
      if (side != 0 && area.size() > 1) {
        Points<2> page(2, static_cast<Index>(area.size()) + 2);
        Index k = 0;
        for (const Point<2>& p : area) page.col(k++) = at(p.x(), p.y());
        page.col(k++) = at(area.back().x(), 0);
        page.col(k) = at(area.front().x(), 0);
        canvas_.fill_polygon(page, diverging_color(side * 0.5).with_alpha(0.75));
      }
      area.clear();
      side = 0;
    };
    for (Index i = 0; i < profile_.along.size(); ++i) {
      const double x = profile_.along[i], f = profile_.values[i];
      if (!std::isfinite(f)) {
        close();
        continue;
      }
      const int here = f > 0 ? 1 : f < 0 ? -1 : 0;
      if (here * side < 0) {
        const Point<2>& before = area.back();
        const double t = before.y() / (before.y() - f);
        const Point<2> shore(before.x() + t * (x - before.x()), 0);
        area.push_back(shore);
        close();
        area.push_back(shore);
      }
      area.emplace_back(x, f);
      if (here != 0) side = here;
    }
    close();
  }

  void zero_line() {
    const double y = at(0, 0).y();
    canvas_.line({frame_.plot.left(), y}, {frame_.plot.right(), y},
                 {.color = look_.colors.soft_ink, .width = 1.1 * unit_, .cap = Cap::butt});
  }

  void curve(const Values& values, const Stroke& stroke) {
    if (values.size() != profile_.along.size()) return;
    Points<2> page(2, values.size());
    for (Index i = 0; i < values.size(); ++i) page.col(i) = at(profile_.along[i], values[i]);
    canvas_.polyline(page, stroke);
  }

  void curves() {
    const auto inside = canvas_.clip(frame_.plot.inset(-2 * unit_));
    areas();
    zero_line();
    curve(profile_.other, {.color = look_.colors.soft_ink,
                           .width = 1.2 * unit_,
                           .dash = {4 * unit_, 3 * unit_},
                           .cap = Cap::butt});
    curve(profile_.values, {.color = theme::moved, .width = 2 * unit_});
  }

  void marks() {
    std::vector<Point<2>> drawn;
    for (const ProfileMark& mark : profile_.marks) {
      const Point<2> p = at(mark.along, mark.value);
      // A rope of symbols, each on the next, would hide the curve.
      const auto hides = [&](const Point<2>& other) { return (p - other).norm() < 5 * unit_; };
      if (std::ranges::any_of(drawn, hides)) continue;
      drawn.push_back(p);
      const Color color = mark.highlight ? theme::moved : theme::constraint;
      if (mark.normal) {
        canvas_.fill_circle(p, 3.4 * unit_, theme::paper);
        canvas_.fill_circle(p, 2.4 * unit_, color);
        continue;
      }
      const Symbol symbol = mark.kind == ConstraintKind::interior   ? Symbol::plus
                            : mark.kind == ConstraintKind::exterior ? Symbol::minus
                                                                    : Symbol::circle;
      draw_symbol(canvas_, symbol, p, 8 * unit_, color);
    }
  }

 private:
  TextStyle words() const { return {.size = look_.text_size, .color = look_.colors.soft_ink}; }
  double widest_label() const {
    double widest = 0;
    for (const Tick& tick : frame_.y_ticks)
      widest = std::max(widest, measure_text(tick.label, words()).width);
    return widest;
  }
  Point<2> at(double along, double value) const { return frame_.pixel_from_data({along, value}); }

  Canvas& canvas_;
  const ProfileData& profile_;
  const ProfileLook& look_;
  double unit_;  // what lines and symbols are multiplied by
  ChartFrame frame_;
};

}  // namespace

void draw_profile(Canvas& canvas, const Rect& region, const ProfileData& profile, const ProfileRange& range,
                  const ProfileLook& look) {
  ProfilePainter painter(canvas, region, profile, range, look);
  if (!painter.has_room()) return;
  painter.axes();
  if (profile.empty()) return;
  painter.curves();
  painter.marks();
}

}  // namespace seesaw
