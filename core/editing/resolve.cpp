#include "core/editing/resolve.h"

#include <cmath>

#include "core/base/text.h"
#include "core/editing/pick.h"
#include "core/editing/plan.h"

namespace seesaw {

namespace {

[[noreturn]] void refuse(const char* action, const std::string& why) {
  throw Refused(std::string(action) + ": " + why);
}

template <int Dim>
const Interpolant<Dim>& function_of(const Shape<Dim>& shape, const char* action) {
  if (!shape.function)
    refuse(action, std::string("there is no shape yet") + (shape.impossible ? ": " + shape.impossible->message
                                                           : shape.pending  ? ": it is still being solved"
                                                                            : ""));
  return *shape.function;
}

Point<3> place(const AddOnSurface<3>& add, const Document<3>&, const Shape<3>& shape, const char* action) {
  if (!add.from.allFinite() || !add.direction.allFinite()) refuse(action, "the ray is not of finite numbers");
  if (!(add.direction.stableNorm() > 0)) refuse(action, "the ray has no direction");
  function_of(shape, action);
  const auto hit = first_on_surface(shape.function, add.from, add.direction);
  if (!hit) refuse(action, "the ray does not meet the surface");
  return *hit;
}

Point<2> place(const AddOnSurface<2>& add, const Document<2>& document, const Shape<2>& shape,
               const char* action) {
  if (!add.from.allFinite()) refuse(action, "the point is not of finite numbers");
  if (!add.direction.isZero(0))
    refuse(action, "in the plane the nearest point of the curve is meant: leave the direction away");
  const auto foot = nearest_on_curve(function_of(shape, action), add.from, boundary_points(document));
  if (!foot) refuse(action, "there is no curve");
  return *foot;
}

template <int Dim>
SetNormal<Dim> normal(const AddNormal& add, const Document<Dim>& document, const Shape<Dim>& shape,
                      const char* action) {
  const Point<Dim> at = boundary_at(document, add.which, action).at;
  const Interpolant<Dim>& f = function_of(shape, action);
  const Point<Dim> gradient = f.gradient(at);
  const double slope = gradient.stableNorm();
  if (!(slope > 0) || !std::isfinite(slope))
    refuse(action, "constraint " + std::to_string(add.which) +
                       ": the function is flat there and has no normal; set one by hand");
  double offset = 0.01;
  if (add.offset) {
    offset = *add.offset;
    if (!std::isfinite(offset) || offset == 0)
      refuse(action, "offset: expected a number other than 0, found " + to_text(offset));
  } else {
    const double longest = bounding_box_of<Dim>(boundary_points(document)).sizes().maxCoeff();
    // Of two digits: a person reads it.
    if (longest > 0 && std::isfinite(longest)) offset = std::stod(to_text(offset * longest, 2));
  }
  NormalConstraint<Dim> result;
  result.direction = -gradient / slope;
  result.offset = offset;
  // At the very place where core/rbf/system.h will put it.
  result.value = f.value(normal_center<Dim>(at, result));
  return {add.which, result};
}

}  // namespace

template <int Dim>
Action<Dim> resolve(const Action<Dim>& action, const Document<Dim>& document, const Shape<Dim>& shape) {
  const char* const name = name_of<Dim>(action);
  if (const auto* add = std::get_if<AddOnSurface<Dim>>(&action))
    return Add<Dim>{{{.constraint = boundary<Dim>(place(*add, document, shape, name))}}};
  if (const auto* add = std::get_if<AddNormal>(&action)) return normal(*add, document, shape, name);
  return action;
}

template Action<2> resolve<2>(const Action<2>&, const Document<2>&, const Shape<2>&);
template Action<3> resolve<3>(const Action<3>&, const Document<3>&, const Shape<3>&);

}  // namespace seesaw
