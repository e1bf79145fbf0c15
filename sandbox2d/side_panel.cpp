#include "sandbox2d/side_panel.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/scene/document_rules.h"
#include "core/window/ui.h"
#include "sandbox2d/overlay.h"

namespace seesaw {

namespace {

constexpr double degree = M_PI / 180;

const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> names = {"boundary", "interior", "exterior"};
  return names;
}

// A widget's answer, told to the desk: while it is dragged one step to undo.
void tell(Desk& desk, const ui::Edit& edit, const Action<2>& action) {
  if (edit.changed) desk.slide(action);
  if (edit.ended) desk.let_go();
}

// How fast a number is dragged: a pixel of the picture for a pixel of the hand.
double pixel_of(const Desk& desk) { return desk.view().pixel(); }

// A digit more than tells a pixel from the next, as far as there is room.
const char* place_format(double value, double pixel) {
  static const char* const formats[] = {"%.4g", "%.5g",  "%.6g",  "%.7g", "%.8g",
                                        "%.9g", "%.10g", "%.11g", "%.12g"};
  return formats[std::clamp(digits_for(value, pixel) + 1 - 4, 0, 8)];
}

}  // namespace

void SidePanel::draw(const Rect& place, Desk& desk, Shown& shown, const LiveNumbers& numbers,
                     const std::function<void(DeskCommand)>& act) {
  const auto panel = ui::panel("Side", place, {.title = false});
  if (!panel) return;
  const auto width = ui::item_width(0.52 * ui::width_left());
  if (const auto open = ui::section("Lever and selection")) selection(desk, act);
  if (const auto open = ui::section("Function")) function(desk, act);
  if (const auto open = ui::section("Numbers")) draw_numbers(desk, numbers);
  if (const auto open = ui::section("Show")) draw_switches(desk, shown, act);
}

void SidePanel::function(Desk& desk, const std::function<void(DeskCommand)>& act) {
  const Document<2>& document = desk.document();
  std::vector<std::string> names;
  int chosen = 0;
  for (const Kernel each : all_kernels) {
    if (each == document.kernel) chosen = static_cast<int>(names.size());
    names.push_back(formula_of(each));
  }
  if (ui::choice("kernel", chosen, names))
    desk.apply(SetKernel{all_kernels[static_cast<std::size_t>(chosen)]});
  double smoothing = document.smoothing;
  const ui::Edit smoothed =
      ui::slider("smoothing", smoothing, 0, 10, {.format = "%.3g", .logarithmic = true});
  tell(desk, smoothed, SetSmoothing{std::max(0.0, smoothing)});
  if (ui::last_hovered())
    ui::tooltip("0 passes through every constraint exactly; more lets the curve miss them to be smoother");
  // With large letters the panel is narrow, and the last button stands below the others.
  const bool in_a_row = ui::buttons_width({"Remember", "Compare", "Kernels"}) <= ui::width_left();
  if (ui::button("Remember##before")) act(DeskCommand::remember);
  ui::same_line();
  bool before = desk.other_name() == "before";
  if (ui::tool_button("Compare", before)) act(DeskCommand::compare);
  if (in_a_row) ui::same_line();
  if (ui::tool_button("Kernels", !desk.other_name().empty() && !before)) act(DeskCommand::compare_kernels);
}

// The see-saw's lever: values of what is selected, or of all interior constraints.
void SidePanel::lever(Desk& desk, ConstraintKind kind) {
  std::vector<Index> which = desk.selection().indices();
  std::erase_if(which, [&](Index i) { return desk.constraint(i).kind != kind; });
  const bool of_selection = !which.empty(), inner = kind == ConstraintKind::interior;
  if (which.empty() && inner) which = all_of(desk.document(), kind);
  if (which.empty()) return;
  const double sign = inner ? 1 : -1;
  const double size = sign * desk.constraint(which.front()).value;
  double& reach = reach_[inner ? 0 : 1];
  if (!desk.sliding() && desk.gesture() == Gesture::none && (size > reach || size < reach / 12))
    reach = std::max(3.0, std::pow(10.0, std::ceil(std::log10(1.2 * size))));
  double value = sign * size;
  const double near = sign * 0.01, far = sign * reach;
  const ui::Edit edit = ui::slider(inner ? "interior value" : "exterior value", value, std::min(near, far),
                                   std::max(near, far), {.format = "%.3f", .typed_beyond = true});
  if (edit.changed && sign * value > 0) desk.slide(SetValue{which, value});
  if (edit.ended) desk.let_go();
  if (ui::last_hovered() && !desk.sliding())
    ui::tooltip(std::string(of_selection ? "f at what is selected" : "f at every interior constraint") +
                ": pull it, and the plate tips about the boundary constraints");
}

void SidePanel::selection(Desk& desk, const std::function<void(DeskCommand)>& act) {
  lever(desk, ConstraintKind::interior);
  lever(desk, ConstraintKind::exterior);
  const Selection& chosen = desk.selection();
  if (chosen.empty())
    ui::soft_text(desk.editor().size() == 0 ? "Place constraints: B, I, E and a click."
                                            : "Nothing is selected.");
  else if (chosen.size() == 1)
    one_constraint(desk, chosen.indices().front(), act);
  else
    several(desk, act);
}

void SidePanel::one_constraint(Desk& desk, Index which, const std::function<void(DeskCommand)>& act) {
  const auto scope = ui::id(static_cast<long>(which));
  const Constraint<2> c = desk.constraint(which);
  int kind = static_cast<int>(c.kind);
  ui::bold_text("constraint " + std::to_string(which));
  if (ui::choice("kind", kind, kind_names())) desk.apply(SetKind{{which}, static_cast<ConstraintKind>(kind)});
  for (int axis = 0; axis < 2; ++axis) {
    Point<2> to = c.at;
    const ui::Edit edit = ui::drag_number(axis == 0 ? "x" : "y", to[axis], pixel_of(desk),
                                          place_format(to[axis], pixel_of(desk)));
    tell(desk, edit, MoveTo<2>{which, to});
  }
  const std::vector<double> weights = constraint_weights(desk).own;
  if (static_cast<std::size_t>(which) < weights.size())
    ui::fact("weight", to_text(weights[static_cast<std::size_t>(which)], 4));
  if (c.kind == ConstraintKind::boundary) normal(desk, which);
  if (ui::button("Delete")) act(DeskCommand::delete_selection);
  if (c.kind == ConstraintKind::boundary) {
    ui::same_line();
    if (!c.normal && ui::button("Add normal")) act(DeskCommand::add_normals);
    if (c.normal && ui::button("Remove normal")) act(DeskCommand::remove_normals);
  }
}

void SidePanel::normal(Desk& desk, Index which) {
  const Constraint<2> c = desk.constraint(which);
  if (!c.normal) return;
  const NormalConstraint<2> n = *c.normal;
  double degrees = std::atan2(n.direction.y(), n.direction.x()) / degree;
  const ui::Edit turned = ui::drag_number("normal, degrees", degrees, 0.5, "%.1f");
  NormalConstraint<2> next = n;
  next.direction = Point<2>(std::cos(degrees * degree), std::sin(degrees * degree));
  tell(desk, turned, SetNormal<2>{which, next});
  double offset = n.offset;
  const ui::Edit moved = ui::drag_number("offset", offset, std::max(1e-12, 0.01 * n.offset), "%.4g");
  next = n;
  next.offset = offset;
  if (offset > 0) tell(desk, moved, SetNormal<2>{which, next});
  double value = n.value;
  const ui::Edit raised =
      ui::drag_number("value there", value, std::max(1e-12, 0.01 * std::abs(n.value)), "%.4g");
  next = n;
  next.value = value;
  tell(desk, raised, SetNormal<2>{which, next});
}

void SidePanel::several(Desk& desk, const std::function<void(DeskCommand)>& act) {
  Index by_kind[3] = {};
  for (const Index i : desk.selection().indices()) ++by_kind[static_cast<int>(desk.constraint(i).kind)];
  std::string words;
  for (int k = 0; k < 3; ++k)
    if (by_kind[k] > 0)
      words += (words.empty() ? " selected: " : ", ") + std::to_string(by_kind[k]) + " " +
               kind_names()[static_cast<std::size_t>(k)];
  ui::paragraph(std::to_string(desk.selection().size()) + words);
  Point<2> middle = Point<2>::Zero();
  for (const Index i : desk.selection().indices())
    middle += desk.constraint(i).at / static_cast<double>(desk.selection().size());
  for (int axis = 0; axis < 2; ++axis) {
    Point<2> to = middle;
    if (std::abs(to[axis]) < 1e-6 * pixel_of(desk)) to[axis] = 0;  // a sum's rounding
    const ui::Edit edit = ui::drag_number(axis == 0 ? "middle x" : "middle y", to[axis], pixel_of(desk),
                                          place_format(to[axis], pixel_of(desk)));
    tell(desk, edit, Move<2>{desk.selection().indices(), to - middle});
  }
  their_normals(desk);
  const bool in_a_row = ui::buttons_width({"Delete", "Duplicate", "Add normals"}) <= ui::width_left();
  if (ui::button("Delete")) act(DeskCommand::delete_selection);
  ui::same_line();
  if (ui::button("Duplicate")) act(DeskCommand::duplicate);
  if (by_kind[0] > 0) {
    if (in_a_row) ui::same_line();
    if (ui::button("Add normals")) act(DeskCommand::add_normals);
  }
}

// One offset and one value for all normals of the selection; the first's are shown.
void SidePanel::their_normals(Desk& desk) {
  std::vector<Index> which = desk.selection().indices();
  std::erase_if(which, [&](Index i) { return !desk.constraint(i).normal; });
  if (which.empty()) return;
  const auto number = [&](const char* label, double NormalConstraint<2>::*part, bool positive) {
    double least = infinity, largest = -infinity;
    for (const Index i : which) {
      least = std::min(least, (*desk.constraint(i).normal).*part);
      largest = std::max(largest, (*desk.constraint(i).normal).*part);
    }
    double next = (*desk.constraint(which.front()).normal).*part;
    const ui::Edit edit = ui::drag_number(label, next, std::max(1e-12, 0.01 * std::abs(next)), "%.4g");
    if (ui::last_hovered())
      ui::tooltip("of all " + std::to_string(which.size()) + " normals" +
                  (least < largest ? ", now from " + to_text(least, 3) + " to " + to_text(largest, 3) : ""));
    if (edit.changed && (next > 0 || !positive))
      for (const Index i : which) {
        NormalConstraint<2> normal = *desk.constraint(i).normal;
        normal.*part = next;
        if (!desk.slide(SetNormal<2>{i, normal})) break;
      }
    if (edit.ended) desk.let_go();
  };
  number("offset", &NormalConstraint<2>::offset, true);
  number("value there", &NormalConstraint<2>::value, false);
}

void draw_numbers(Desk& desk, const LiveNumbers& numbers) {
  const auto count = [&](ConstraintKind kind) {
    return static_cast<Index>(all_of(desk.document(), kind).size());
  };
  Index normals = 0;
  for (const auto& each : desk.document().constraints) normals += each.constraint.normal.has_value();
  ui::fact("boundary, normals",
           std::to_string(count(ConstraintKind::boundary)) + ", " + std::to_string(normals));
  ui::fact("interior, exterior", std::to_string(count(ConstraintKind::interior)) + ", " +
                                     std::to_string(count(ConstraintKind::exterior)));
  const Shape<2>& shape = desk.shape();
  const Contour& curve = numbers.curve;
  if (shape.function) {
    std::string pieces = std::to_string(curve.components);
    if (curve.closed < curve.components)
      pieces += " (" + std::to_string(curve.components - curve.closed) + " cut)";
    ui::fact("components in view", pieces);
    // Where f is zero everywhere, or all that is seen is inside, there is no curve around an area.
    ui::fact("area inside, in view", curve.components > 0 ? to_text(curve.area, 4) : "\u2013");
    ui::fact("length of the curve", to_text(curve.length, 4));
    ui::fact("bending energy", to_text(shape.report.energy, 5));
    ui::fact("condition", shape.report.reciprocal_condition > 0
                              ? to_text(1 / shape.report.reciprocal_condition, 2)
                              : "infinite");
    ui::fact("largest residual", to_text(shape.report.max_residual, 2));
    if (numbers.refit_difference) ui::fact("off a fresh fit", to_text(*numbers.refit_difference, 2));
  }
  const auto took = [](const std::optional<double>& seconds) {
    return seconds ? to_text(1e3 * *seconds, *seconds < 0.1 ? 2 : 3) + " ms" : std::string("\u2013");
  };
  ui::fact("solve", numbers.solving ? "at work" : took(numbers.solve_seconds));
  ui::fact("draw", took(numbers.draw_seconds));
}

void draw_switches(Desk& desk, Shown& shown, const std::function<void(DeskCommand)>& act) {
  using C = DeskCommand;
  const Display<2>& display = desk.display();
  const struct {
    const char* label;
    bool on;
    C command;
  } rows[] = {{"field", display.field, C::toggle_field},
              {"isolines", display.isolines, C::toggle_isolines},
              {"gradient", display.gradient, C::toggle_gradient},
              {"constraints", display.constraints, C::toggle_constraints},
              {"normals", display.normals, C::toggle_normals},
              {"weights", shown.weights, C::toggle_weights},
              {"see-saw plate", shown.plate, C::toggle_plate},
              {"profile line", desk.profile().has_value(), C::toggle_profile},
              {"grid lines", display.grid, C::toggle_grid},
              {"snap to grid", desk.grid().on, C::toggle_snap},
              {"scale bar", display.scale_bar, C::toggle_scale_bar}};
  // Side by side where there is room for the longest name twice.
  const double wide = ui::text_width("see-saw plate") + 36 * ui::scale();
  const std::size_t columns = 2 * wide <= ui::width_left() ? 2 : 1;
  const auto table = ui::table("switches", std::vector<std::string>(columns), false, {1, 1});
  if (!table) return;
  for (const auto& row : rows) {
    ui::next_cell();
    bool on = row.on;
    if (ui::checkbox(row.label, on)) act(row.command);
    if (ui::last_hovered() && !keys_of(row.command).empty()) ui::tooltip("key " + keys_of(row.command));
  }
}

}  // namespace seesaw
