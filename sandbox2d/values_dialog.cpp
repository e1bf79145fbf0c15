#include "sandbox2d/values_dialog.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/window/ui.h"

namespace seesaw {

namespace {

constexpr const char* values_title = "Numbers of a constraint";
constexpr double radians_a_degree = M_PI / 180;

// The fewest digits that are this very number: 1.15, not 1.1499999999999999.
const char* exact_format(double value) {
  static const char* const formats[] = {"%.6g", "%.8g", "%.10g", "%.12g", "%.14g", "%.15g", "%.16g", "%.17g"};
  constexpr int digits[] = {6, 8, 10, 12, 14, 15, 16, 17};
  for (std::size_t i = 0; i < std::size(digits); ++i)
    if (std::stod(to_text(value, digits[i])) == value) return formats[i];
  return "%.17g";
}

}  // namespace

void ValuesDialog::ask(Desk& desk) {
  if (desk.selection().empty()) return desk.say("select a constraint to type its numbers");
  desk.let_go();
  which_ = desk.selection().indices().front();
  read(desk);
  fresh_ = asked_ = true;
}

void ValuesDialog::read(const Desk& desk) {
  c_ = desk.constraint(which_);
  has_normal_ = c_.normal.has_value();
  normal_ = c_.normal.value_or(NormalConstraint<2>{});
  degrees_ = std::atan2(normal_.direction.y(), normal_.direction.x()) / radians_a_degree;
  trouble_.clear();
}

// As one step to undo; where a part is refused nothing is done, and the words stay.
bool ValuesDialog::write(Desk& desk) {
  const Constraint<2> before = desk.constraint(which_);
  const auto number = desk.message().number;
  bool good = desk.slide(MoveTo<2>{which_, c_.at});
  if (good && c_.kind != before.kind)
    good = desk.slide(SetKind{
        {which_}, c_.kind, c_.kind == ConstraintKind::boundary ? std::nullopt : std::optional(c_.value)});
  else if (good && c_.kind != ConstraintKind::boundary)
    good = desk.slide(SetValue{{which_}, c_.value});
  if (good && c_.kind == ConstraintKind::boundary) {
    if (has_normal_) {
      normal_.direction = {std::cos(degrees_ * radians_a_degree), std::sin(degrees_ * radians_a_degree)};
      // The direction that was there, to the bit, where its angle was not typed anew.
      if (before.normal) {
        const Point<2>& old = before.normal->direction;
        if (std::atan2(old.y(), old.x()) / radians_a_degree == degrees_) normal_.direction = old;
      }
      good = desk.slide(SetNormal<2>{which_, normal_});
    } else if (before.normal) {
      good = desk.slide(RemoveNormal{{which_}});
    }
  }
  if (good)
    desk.let_go();
  else
    desk.cancel();
  if (!good) trouble_ = desk.message().number != number ? desk.message().text : "that is not possible";
  return good;
}

void ValuesDialog::frame(Desk& desk) {
  const double s = ui::scale();
  const auto dialog = ui::dialog(values_title, 420 * s, false);
  // In the next frame: the Enter that asked for it would press its main button.
  if (std::exchange(asked_, false)) ui::open_dialog(values_title);
  if (!dialog) return;
  // At once, also out of a field: what is typed is not to be kept.
  if (ui::foremost() && ui::key_pressed(Key::escape)) return ui::close_dialog();
  if (which_ < 0 || which_ >= desk.editor().size()) return ui::close_dialog();
  const auto width = ui::item_width(200 * s);
  const Index selected = desk.selection().size();
  ui::soft_text("constraint " + std::to_string(which_) +
                (selected > 1 ? ", the first of " + std::to_string(selected) + " that are selected" : ""));
  if (fresh_) ui::focus_next();
  fresh_ = false;
  ui::number("x", c_.at.x(), 0, exact_format(c_.at.x()));
  ui::number("y", c_.at.y(), 0, exact_format(c_.at.y()));
  int kind = static_cast<int>(c_.kind);
  if (ui::choice("kind##typed", kind, {"boundary", "interior", "exterior"})) {
    c_.kind = static_cast<ConstraintKind>(kind);
    c_.value = kind == 0   ? 0
               : kind == 1 ? std::abs(c_.value == 0 ? 1 : c_.value)
                           : -std::abs(c_.value == 0 ? 1 : c_.value);
  }
  if (c_.kind != ConstraintKind::boundary) {
    ui::number("value", c_.value, 0, exact_format(c_.value));
  } else {
    ui::checkbox("has a normal", has_normal_);
    if (has_normal_) {
      ui::number("direction, degrees", degrees_, 0, "%.10g");
      ui::number("offset", normal_.offset, 0, exact_format(normal_.offset));
      ui::number("value there", normal_.value, 0, exact_format(normal_.value));
    }
  }
  if (!trouble_.empty()) ui::colored_text(trouble_, ui::colors().warning);
  ui::gap(4 * s);
  if (ui::main_button("Apply") && write(desk)) ui::close_dialog();
  ui::same_line();
  if (ui::button("Cancel")) ui::close_dialog();
}

}  // namespace seesaw
