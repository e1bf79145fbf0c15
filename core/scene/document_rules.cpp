#include "core/scene/document_rules.h"

#include <cmath>
#include <limits>

#include "core/base/text.h"

namespace seesaw {

namespace {

const char* const not_finite = "expected a finite number";

/// What keeps `v` from having a direction, or nothing. Lengths whose square leaves the range of doubles are
/// refused: v / |v| would not be a unit vector.
template <int Dim>
std::optional<std::string> direction_fault(const Point<Dim>& v) {
  if (!v.allFinite()) return not_finite;
  if (v.isZero(0)) return "the zero vector has no direction: give a vector of any other length";
  const double square = v.squaredNorm();
  if (square < std::numeric_limits<double>::min() || !std::isfinite(square))
    return "a vector this short or long has no usable direction: give one of length about 1";
  return std::nullopt;
}

}  // namespace

template <int Dim>
std::optional<Fault> fault_of(const SceneConstraint<Dim>& each) {
  const Constraint<Dim>& c = each.constraint;
  if (!c.at.allFinite()) return Fault{"at", not_finite};
  if (!std::isfinite(c.value)) return Fault{"value", not_finite};
  if (c.kind != ConstraintKind::boundary && c.normal)
    return Fault{"normal",
                 std::string("only a boundary constraint has a normal, this one is ") + name_of(c.kind)};
  switch (c.kind) {
    case ConstraintKind::boundary:
      // Where a boundary constraint's own value comes from a program, not from a file.
      if (c.value != 0) return Fault{"value", "a boundary constraint is 0 by definition"};
      break;
    case ConstraintKind::interior:
      if (!(c.value > 0))
        return Fault{"value", "expected a number above 0 inside, found " + to_text(c.value)};
      break;
    case ConstraintKind::exterior:
      if (!(c.value < 0))
        return Fault{"value", "expected a number below 0 outside, found " + to_text(c.value)};
      break;
  }
  if (c.normal) {
    if (auto fault = direction_fault<Dim>(c.normal->direction)) return Fault{"normal", *fault};
    if (!std::isfinite(c.normal->offset)) return Fault{"offset", not_finite};
    if (!std::isfinite(c.normal->value)) return Fault{"value", not_finite};
  }
  return std::nullopt;
}

template <int Dim>
std::optional<Fault> fault_of(const Display<Dim>& display) {
  if (!display.view) return std::nullopt;
  const Box<Dim>& view = *display.view;
  if (!view.min().allFinite() || !view.max().allFinite()) return Fault{"view", not_finite};
  if (!(view.min().array() < view.max().array()).all())
    return Fault{"view", "expected \"min\" below \"max\" in every coordinate"};
  return std::nullopt;
}

template <int Dim>
std::optional<Fault> fault_of(const Document<Dim>& document) {
  if (!std::isfinite(document.smoothing) || document.smoothing < 0)
    return Fault{"smoothing", "expected 0 or a positive number, found " + to_text(document.smoothing)};
  return std::nullopt;
}

std::optional<Fault> fault_of(const Camera& camera) {
  if (!camera.position.allFinite()) return Fault{"position", not_finite};
  if (!camera.target.allFinite()) return Fault{"target", not_finite};
  if (camera.position == camera.target)
    return Fault{"target", "expected another point than the camera's position"};
  if (auto fault = direction_fault<3>(camera.up)) return Fault{"up", *fault};
  if (!(camera.field_of_view > 0 && camera.field_of_view < 180))
    return Fault{"field_of_view",
                 "expected degrees above 0 and below 180, found " + to_text(camera.field_of_view)};
  return std::nullopt;
}

const char* name_of(ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::boundary:
      return "boundary";
    case ConstraintKind::interior:
      return "interior";
    case ConstraintKind::exterior:
      return "exterior";
  }
  return "?";
}

const char* formula_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::thin_plate_spline:
      return "r\u00b2 log r";
    case Kernel::cubic:
      return "r\u00b3";
    case Kernel::linear:
      return "r";
  }
  return "?";
}

template std::optional<Fault> fault_of(const SceneConstraint<2>&);
template std::optional<Fault> fault_of(const SceneConstraint<3>&);
template std::optional<Fault> fault_of(const Display<2>&);
template std::optional<Fault> fault_of(const Display<3>&);
template std::optional<Fault> fault_of(const Document<2>&);
template std::optional<Fault> fault_of(const Document<3>&);

}  // namespace seesaw
