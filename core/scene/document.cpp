#include "core/scene/document.h"

namespace seesaw {

namespace {

template <int Dim>
bool same(const std::optional<NormalConstraint<Dim>>& a, const std::optional<NormalConstraint<Dim>>& b) {
  if (!a || !b) return !a && !b;
  return a->direction == b->direction && a->offset == b->offset && a->value == b->value;
}

template <int Dim>
bool same(const std::optional<Box<Dim>>& a, const std::optional<Box<Dim>>& b) {
  if (!a || !b) return !a && !b;
  return a->min() == b->min() && a->max() == b->max();
}

}  // namespace

template <int Dim>
bool operator==(const SceneConstraint<Dim>& a, const SceneConstraint<Dim>& b) {
  return a.constraint.kind == b.constraint.kind && a.constraint.at == b.constraint.at &&
         a.constraint.value == b.constraint.value && same<Dim>(a.constraint.normal, b.constraint.normal) &&
         a.highlight == b.highlight && a.highlight_normal == b.highlight_normal && a.label == b.label &&
         a.extras == b.extras;
}

template <int Dim>
bool operator==(const Display<Dim>& a, const Display<Dim>& b) {
  for (const DisplaySwitch<Dim>& each : display_switches<Dim>)
    if (a.*each.member != b.*each.member) return false;
  return same<Dim>(a.view, b.view) && a.view_extras == b.view_extras && a.spelled_out == b.spelled_out &&
         a.extras == b.extras;
}

bool operator==(const Camera& a, const Camera& b) {
  return a.position == b.position && a.target == b.target && a.up == b.up &&
         a.field_of_view == b.field_of_view && a.extras == b.extras;
}

template <int Dim>
bool operator==(const Document<Dim>& a, const Document<Dim>& b) {
  return a.kernel == b.kernel && a.smoothing == b.smoothing && a.constraints == b.constraints &&
         a.title == b.title && a.description == b.description && a.figure == b.figure &&
         a.display == b.display && a.camera == b.camera && a.extras == b.extras;
}

template bool operator==(const SceneConstraint<2>&, const SceneConstraint<2>&);
template bool operator==(const SceneConstraint<3>&, const SceneConstraint<3>&);
template bool operator==(const Display<2>&, const Display<2>&);
template bool operator==(const Display<3>&, const Display<3>&);
template bool operator==(const Document<2>&, const Document<2>&);
template bool operator==(const Document<3>&, const Document<3>&);

}  // namespace seesaw
