#include "sandbox2d/overlay.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/editing/curve_foot.h"
#include "core/image/colormap.h"
#include "core/image/symbols.h"
#include "core/scene/constraint_layer.h"
#include "core/scene/document_rules.h"

namespace seesaw {

namespace {

const Color selected = theme::series[0];

// With more than so many of a kind a mark for each would cost a frame, and say no more.
constexpr std::size_t crowd = 200;

class Overlay {
 public:
  Overlay(Canvas& canvas, Desk& desk, const OverlayOptions& options)
      : canvas_(canvas), desk_(desk), options_(options), s_(options.scale), view_(desk.view().plan()) {}

  void draw() {
    draw_snap_grid();
    if (options_.weights) draw_weights();
    draw_profile_line();
    draw_selection();
    draw_pointed();
    draw_culprits();
    if (options_.pointer_here || desk_.gesture() != Gesture::none) draw_hover();
    draw_preview();
    draw_band();
    draw_reading();
    draw_legend();
  }

 private:
  Point<2> page(const Point<2>& p) const { return view_.page_from_scene(p); }
  Point<2> place(Index i) const { return page(desk_.constraint(i).at); }
  bool in_sight(const Point<2>& p) const { return canvas_.bounds().inset(-40 * s_).contains(p); }

  void ring(const Point<2>& at, double radius, const Color& color, double width) {
    canvas_.circle(at, radius * s_, {.color = theme::paper.with_alpha(0.85), .width = (width + 1.6) * s_});
    canvas_.circle(at, radius * s_, {.color = color, .width = width * s_});
  }

  void tag(const Point<2>& at, const std::string& words, const Color& color = theme::ink) {
    const double size = 11 * s_;
    const TextStyle style{.size = size, .color = color};
    const TextSize room = measure_text(words, style);
    const double width = room.width + size, height = 1.9 * size;
    Rect box{at.x() + 12 * s_, at.y() - height - 9 * s_, width, height};
    box.x = std::min(box.x, canvas_.width() - width - 4);
    if (box.y < 4) box.y = at.y() + 14 * s_;
    canvas_.fill_rectangle(box, theme::paper.with_alpha(0.9), 3 * s_);
    canvas_.text({box.x + size / 2, box.y + height / 2 + room.ascent / 2}, words, style);
  }

  // Where points snap to, as dots, unless grid lines or too many of them say it already.
  void draw_snap_grid() {
    if (!desk_.grid().on) return;
    const double step = desk_.grid_step();
    const Box<2> seen = view_.scene;
    if (seen.sizes().x() / step * (seen.sizes().y() / step) > 12'000) return;
    for (double x = std::ceil(seen.min().x() / step); x * step <= seen.max().x(); ++x)
      for (double y = std::ceil(seen.min().y() / step); y * step <= seen.max().y(); ++y)
        canvas_.fill_circle(page({x * step, y * step}), 0.9 * s_, theme::soft_ink.with_alpha(0.45));
  }

  // The area of a disc is the size of the weight: orange pulls f up, blue pulls it down. A normal constraint
  // stands so near its boundary constraint that its disc is drawn apart, inside.
  void draw_weights() {
    const ConstraintWeights weights = constraint_weights(desk_);
    double largest = 0;
    for (const auto* each : {&weights.own, &weights.normal})
      for (const double w : *each) largest = std::max(largest, std::abs(w));
    if (!(largest > 0) || flat()) return;
    const double full = std::max(6.0, 24 * desk_.symbol_share()) * s_;
    std::vector<std::pair<double, Point<2>>> found;
    for (std::size_t i = 0; i < weights.own.size(); ++i) {
      const Point<2> at = place(static_cast<Index>(i));
      if (!in_sight(at)) continue;
      const auto& normal = desk_.constraint(static_cast<Index>(i)).normal;
      Point<2> inward = Point<2>::Zero();
      if (normal) inward = Point<2>(-normal->direction.x(), normal->direction.y()).normalized();
      found.push_back({weights.own[i], at});
      if (normal) found.push_back({weights.normal[i], at + 1.6 * full * inward});
    }
    std::ranges::stable_sort(found, std::greater{}, [](const auto& each) { return std::abs(each.first); });
    if (found.size() > crowd)
      draw_many_weights(found, largest, full);
    else
      for (const auto& [weight, at] : found) draw_weight(at, weight, largest, full);
    label_weights(found);
  }

  // Whether f is a plane but for rounding, whose weights say nothing.
  bool flat() const {
    const auto& function = desk_.shape().function;
    double value = 0;
    for (const auto& each : desk_.document().constraints)
      value = std::max(value, std::abs(each.constraint.value));
    return !function || function->normalized_weights().size() == 0 ||
           function->normalized_weights().cwiseAbs().maxCoeff() < 1e-12 * value;
  }

  // The largest first, and as many as have room.
  void label_weights(const std::vector<std::pair<double, Point<2>>>& weights) {
    std::vector<Point<2>> taken;
    const Point<2> room(34 * s_, 15 * s_);
    for (const auto& [weight, at] : weights) {
      if (taken.size() >= 40) return;
      const bool free = std::ranges::none_of(taken, [&](const Point<2>& other) {
        return std::abs(other.x() - at.x()) < room.x() && std::abs(other.y() - at.y()) < room.y();
      });
      if (!free) continue;
      taken.push_back(at);
      weight_label(at, weight);
    }
  }

  void draw_weight(const Point<2>& at, double weight, double largest, double full) {
    const double radius = full * std::sqrt(std::abs(weight) / largest);
    const Color color = diverging_color(weight > 0 ? 0.8 : -0.8);
    canvas_.fill_circle(at, radius, color.with_alpha(0.35));
    canvas_.circle(at, radius, {.color = color, .width = 1.4 * s_});
  }

  // A mark for those that pull up and one for those that pull down.
  void draw_many_weights(const std::vector<std::pair<double, Point<2>>>& weights, double largest,
                         double full) {
    for (const double sign : {1.0, -1.0}) {
      std::vector<Points<2>> discs;
      for (const auto& [weight, at] : weights)
        if (weight * sign > 0) discs.push_back(disc(at, full * std::sqrt(std::abs(weight) / largest)));
      if (!discs.empty())
        canvas_.fill_rings(discs, diverging_color(0.8 * sign).with_alpha(0.7), FillRule::winding);
    }
  }

  static Points<2> disc(const Point<2>& at, double radius) {
    Points<2> ring(2, 12);
    for (Index k = 0; k < 12; ++k) {
      const double turn = M_PI / 6 * static_cast<double>(k);
      ring.col(k) = at + radius * Point<2>(std::cos(turn), std::sin(turn));
    }
    return ring;
  }

  void weight_label(const Point<2>& at, double weight) {
    const std::string size = to_text(std::abs(weight), 3);
    canvas_.text(
        at + Point<2>(0, 14 * s_), weight < 0 ? "\u2212" + size : size,
        {.size = 9 * s_, .align = Align::center, .vertical = VerticalAlign::middle, .halo = 2.5 * s_});
  }

  void draw_profile_line() {
    if (!desk_.profile()) return;
    const Point<2> from = page(desk_.profile()->from), to = page(desk_.profile()->to);
    canvas_.line(from, to, {.color = theme::paper.with_alpha(0.8), .width = 3.4 * s_});
    canvas_.line(from, to, {.color = theme::moved, .width = 1.6 * s_});
    // Constraints stand on the line, not under it.
    const Point<2> along = (to - from).normalized();
    const double share = desk_.symbol_share(), symbol = 11 * share * s_;
    if (share < 0.7) return draw_profile_ends(from, to);  // a crowd's would cut line and curve to pieces
    for (const auto& each : desk_.document().constraints) {
      const Point<2> at = page(each.constraint.at), way = at - from;
      const double across = std::abs(way.x() * along.y() - way.y() * along.x());
      if (!desk_.display().constraints || !(across < 0.7 * symbol) || !in_sight(at)) continue;
      draw_symbol(canvas_, symbol_of(each.constraint.kind), at, symbol,
                  each.highlight ? theme::moved : theme::constraint);
    }
    draw_profile_ends(from, to);
  }

  void draw_profile_ends(const Point<2>& from, const Point<2>& to) {
    for (const Point<2>& end : {from, to}) {
      canvas_.fill_circle(end, 4.6 * s_, theme::paper);
      canvas_.fill_circle(end, 3.4 * s_, theme::moved);
    }
    canvas_.text(from + Point<2>(0, -9 * s_), "0",
                 {.size = 8.5 * s_, .color = theme::moved, .align = Align::center, .halo = 2.5});
  }

  void draw_selection() {
    std::vector<Point<2>> places;
    for (const Index i : desk_.selection().indices())
      if (const Point<2> at = place(i); in_sight(at)) places.push_back(at);
    if (places.size() > crowd) return mark_crowd(places);
    for (const Point<2>& at : places) ring(at, 8.5, selected, 2);
  }

  // A marker's stroke over all of them, as one mark.
  void mark_crowd(const std::vector<Point<2>>& places) {
    std::vector<Points<2>> discs;
    discs.reserve(places.size());
    for (const Point<2>& at : places) discs.push_back(disc(at, 7 * s_));
    canvas_.fill_rings(discs, selected.with_alpha(0.45), FillRule::winding);
  }

  void draw_pointed() {
    for (const Index i : options_.pointed)
      if (i >= 0 && i < desk_.editor().size()) ring(place(i), 13, theme::series[1], 2.4);
  }

  void draw_culprits() {
    const auto impossible = desk_.shape().impossible;
    if (!impossible) return;
    std::size_t marked = 0, culprits = 0;
    std::optional<Point<2>> seen, unseen;
    for (const Index i : impossible->culprits) {
      if (i < 0 || i >= desk_.editor().size()) continue;
      ++culprits;
      const Point<2> at = place(i);
      if (!in_sight(at)) {
        if (!unseen) unseen = at;
        continue;
      }
      if (!seen) seen = at;
      if (marked++ >= 2 * crowd) continue;
      ring(at, 11, theme::moved, 2.4);
      const double reach = 15.5 * s_;
      for (const double sign : {1.0, -1.0}) {
        const Point<2> along = Point<2>(1, sign).normalized();
        for (const double way : {1.0, -1.0})
          canvas_.line(at + way * 11 * s_ * along, at + way * reach * along,
                       {.color = theme::moved, .width = 2.4 * s_});
      }
    }
    const std::string words = culprits == 1 ? "no function obeys this" : "no function obeys these";
    if (seen)
      tag(*seen, words, theme::moved);
    else if (unseen)
      point_out(*unseen, words);
  }

  // An arrow at the rim, to what is beyond it.
  void point_out(const Point<2>& beyond, const std::string& words) {
    const Rect rim = canvas_.bounds().inset(18 * s_);
    const Point<2> tip(std::clamp(beyond.x(), rim.left(), rim.right()),
                       std::clamp(beyond.y(), rim.top(), rim.bottom()));
    const Point<2> way = (beyond - tip).stableNormalized(), across(-way.y(), way.x());
    if (!way.allFinite()) return;
    const Point<2> tail = tip - 22 * s_ * way;
    canvas_.line(tail, tip, {.color = theme::moved, .width = 2.4 * s_});
    for (const double side : {1.0, -1.0})
      canvas_.line(tip, tip + 9 * s_ * (0.8 * side * across - way),
                   {.color = theme::moved, .width = 2.4 * s_});
    tag(tail, words, theme::moved);
  }

  void draw_hover() {
    const Hit hit = desk_.hover();
    switch (hit.over) {
      case Over::constraint:
        if (!desk_.selection().contains(hit.which)) ring(page(hit.at), 8.5, theme::soft_ink, 1.4);
        break;
      case Over::spike:
        ring(page(hit.at), 5.5, selected, 1.8);
        break;
      case Over::profile_start:
      case Over::profile_end:
        ring(page(hit.at), 6.5, theme::moved, 1.6);
        break;
      case Over::curve:
        // Where a boundary constraint would change nothing.
        if (desk_.gesture() == Gesture::none && takes_curve())
          draw_symbol(canvas_, Symbol::circle, page(hit.at), 11 * s_, selected);
        break;
      default:
        break;
    }
  }

  bool takes_curve() const {
    return desk_.tool() == Tool::select || desk_.tool() == Tool::boundary || desk_.tool() == Tool::normal;
  }

  void draw_preview() {
    const Points<2> points = desk_.preview();
    const Symbol symbol = symbol_of(desk_.kind());
    for (Index i = 0; i < points.cols(); ++i)
      draw_symbol(canvas_, symbol, page(points.col(i)), 11 * s_, selected);
    if (points.cols() > 0 && desk_.cursor())
      tag(page(*desk_.cursor()), std::to_string(points.cols()) + " constraints; the wheel changes how many");
  }

  void draw_band() {
    const auto band = desk_.band();
    if (!band) return;
    const Point<2> a = page(band->min()), b = page(band->max());
    const Rect rect{a.x(), b.y(), b.x() - a.x(), a.y() - b.y()};
    canvas_.fill_rectangle(rect, selected.with_alpha(0.1));
    canvas_.rectangle(rect, {.color = selected, .width = 1.2 * s_, .dash = {4 * s_, 3 * s_}});
  }

  // Where the constraint in hand is, and which value it has.
  void draw_reading() {
    const Gesture gesture = desk_.gesture();
    if (gesture != Gesture::grab && gesture != Gesture::place && gesture != Gesture::toggle &&
        gesture != Gesture::beneath && gesture != Gesture::turn && gesture != Gesture::give_normal &&
        gesture != Gesture::place_normal)
      return;
    const Hit hit = desk_.hover();
    if (hit.which < 0 || hit.which >= desk_.editor().size()) return;
    const Constraint<2>& c = desk_.constraint(hit.which);
    const double pixel = desk_.view().pixel();
    std::string words = "(" + to_text(c.at.x(), digits_for(c.at.x(), pixel)) + ", " +
                        to_text(c.at.y(), digits_for(c.at.y(), pixel)) + ")";
    if (hit.over == Over::spike && c.normal)
      words = "normal (" + to_text(c.normal->direction.x(), 3) + ", " + to_text(c.normal->direction.y(), 3) +
              "), value " + to_text(c.normal->value, 3);
    else if (c.kind != ConstraintKind::boundary)
      words += ", f = " + to_text(c.value, 3);
    tag(page(hit.at), words);
  }

  void draw_legend() {
    const std::string name = desk_.other_name();
    if (name.empty()) return;
    const double size = 11.5 * s_;
    const std::optional<Kernel> kernel = kernel_named(name);
    const std::string words = "dashed: " + (kernel ? std::string("kernel ") + formula_of(*kernel) : name);
    const TextSize room = measure_text(words, {.size = size});
    const Rect box{canvas_.width() - room.width - 52 * s_, 12 * s_, room.width + 40 * s_, 2.1 * size};
    canvas_.fill_rectangle(box, theme::paper.with_alpha(0.88), 3 * s_);
    const double y = box.y + box.height / 2;
    canvas_.line({box.x + 8 * s_, y}, {box.x + 28 * s_, y},
                 {.color = theme::soft_ink, .width = 1.4 * s_, .dash = {5 * s_, 4 * s_}, .cap = Cap::butt});
    canvas_.text({box.x + 34 * s_, y + room.ascent / 2}, words, {.size = size});
  }

  Canvas& canvas_;
  Desk& desk_;
  const OverlayOptions& options_;
  double s_;
  PlanView view_;
};

}  // namespace

void draw_overlay(Canvas& canvas, Desk& desk, const OverlayOptions& options) {
  Overlay(canvas, desk, options).draw();
}

ConstraintWeights constraint_weights(Desk& desk) {
  const Shape<2>& shape = desk.shape();
  if (!shape.current()) return {};
  const Points<2>& centers = shape.function->centers();
  const Values weights = shape.function->weights();
  std::map<std::pair<double, double>, double> at;
  for (Index i = 0; i < centers.cols(); ++i) at.emplace(std::pair(centers(0, i), centers(1, i)), weights[i]);
  const auto take = [&](const Point<2>& center) {
    const auto found = at.find({center.x(), center.y()});
    return found == at.end() ? 0.0 : std::exchange(found->second, 0.0);
  };
  ConstraintWeights result;
  for (Index i = 0; i < desk.editor().size(); ++i) {
    const Constraint<2>& c = desk.constraint(i);
    result.own.push_back(take(c.at));
    result.normal.push_back(c.normal ? take(normal_center<2>(c.at, *c.normal)) : 0.0);
  }
  return result;
}

}  // namespace seesaw
