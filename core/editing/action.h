// What a user can do to a document, as plain data.
//
// Before it: a mouse, a key, a script, a line of a session file (core/editing/session.h).
// After it: core/editing/editor.h applies it; core/editing/plan.h knows what it does to the document.
//
// Turk & O'Brien 2002, section 5: constraints are created on the surface by a ray through the cursor, moved,
// and given normals whose "initial direction ... is given by the gradient of the current implicit function"
// and whose value "is given by the implicit function's value at the constraint location". Created so, a
// constraint asks for nothing that f does not do already, and f does not change. Then one is dragged.
//
// Two of these ask the present shape a question (where does the ray meet it, which way does it face). They
// are answered once, when they are applied: what is undone, recorded and replayed is the answer, as one of
// the others (core/editing/resolve.h). So a replay needs no solver, and has the same bits on every machine.
//
// Constraints are named by their index in the document at the time. A gesture on several is one action where
// all do the same (Move), or several actions between Editor::begin_gesture and end_gesture.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/rbf/kernel.h"
#include "core/scene/document.h"

namespace seesaw {

/// An action that makes no sense for the document as it is. Nothing has changed; `what()` says why.
class Refused : public Error {
 public:
  using Error::Error;
};

/// Appends constraints, one or many: a click, a cage, a duplicate, points along a line.
template <int Dim>
struct Add {
  std::vector<SceneConstraint<Dim>> constraints = {};
};

/// Appends a boundary constraint where the shape is met. In 3D by the ray from `from` along `direction` (of
/// any length but zero), at the first place from there on; in 2D at the point of the curve nearest to `from`,
/// and `direction` is zero. Refused where there is nothing to meet. Becomes an Add.
template <int Dim>
struct AddOnSurface {
  Point<Dim> from = Point<Dim>::Zero();
  Point<Dim> direction = Point<Dim>::Zero();
};

/// Moves constraints by a vector, scene units. Their normals go with them.
template <int Dim>
struct Move {
  std::vector<Index> which = {};
  Point<Dim> by = Point<Dim>::Zero();
};

/// Places one constraint exactly.
template <int Dim>
struct MoveTo {
  Index which = 0;
  Point<Dim> to = Point<Dim>::Zero();
};

struct Delete {
  std::vector<Index> which = {};
};

/// Sets f at interior or exterior constraints: the see-saw's lever. The sign must be that of their kind.
struct SetValue {
  std::vector<Index> which = {};
  double value = 1.0;
};

/// Makes constraints boundary, interior or exterior. `value` is f there: 0 for boundary; 1 and -1 where
/// nothing is said. A normal goes where its constraint is no longer boundary.
struct SetKind {
  std::vector<Index> which = {};
  ConstraintKind kind = ConstraintKind::boundary;
  std::optional<double> value = std::nullopt;
};

/// Gives a boundary constraint a normal constraint that changes f nowhere: direction -grad f / |grad f| here,
/// value f(at - offset * direction). Refused where f is flat. Becomes a SetNormal.
struct AddNormal {
  Index which = 0;
  /// Scene units; none means 0.01 of the longest side of the box around the boundary constraints, the papers'
  /// 0.01 for objects within a unit cube.
  std::optional<double> offset = std::nullopt;
};

/// Gives a boundary constraint this normal constraint, in place of any that it had.
template <int Dim>
struct SetNormal {
  Index which = 0;
  NormalConstraint<Dim> normal = {};
};

/// Turns a normal, as by dragging the free end of its spike: `direction` is outward, of any length but zero.
/// The offset stays, and the value where none is given.
///
/// The surface follows, but how far? One value beside the surface asks for the slope of f along the spike,
/// not for the direction of grad f. Turned by an angle t from a normal that changed nothing, it asks grad f =
/// g for only |g| (1 - cos t) more along the new direction, and f obliges by as little as that: on the torus
/// of the papers' Fig. 7 a spike turned by 30 degrees turns the surface by 4. With ten times the value grad f
/// is mostly the constraint's own doing, and the surface turns by 26 (by less where no other constraints hold
/// it nearby). So an editor may let the length of the spike be the value, and let it grow as it is dragged.
template <int Dim>
struct TurnNormal {
  Index which = 0;
  Point<Dim> direction = Point<Dim>::UnitX();
  std::optional<double> value = std::nullopt;
};

struct RemoveNormal {
  std::vector<Index> which = {};
};

struct SetKernel {
  Kernel kernel = Kernel::cubic;
};

/// As in core/rbf/fit.h, >= 0.
struct SetSmoothing {
  double smoothing = 0.0;
};

/// Makes the whole document another: pasted, or gone back to.
template <int Dim>
struct Restore {
  Document<Dim> document = {};
};

template <int Dim>
using Action =
    std::variant<Add<Dim>, AddOnSurface<Dim>, Move<Dim>, MoveTo<Dim>, Delete, SetValue, SetKind, AddNormal,
                 SetNormal<Dim>, TurnNormal<Dim>, RemoveNormal, SetKernel, SetSmoothing, Restore<Dim>>;

/// The action's name in session files and messages: "add", "add_on_surface", "move", ... For Dim 2 and 3.
template <int Dim>
const char* name_of(const Action<Dim>& action);
/// An action's name in a person's words: "moving" for "move_to". Other names are their own words.
std::string_view in_words(std::string_view name);

}  // namespace seesaw
