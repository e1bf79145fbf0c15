// Actions that ask the shape a question, answered: what is left is plain data.
//
// Before it: an action as a person means it ("here on the surface", "with the normal that it has").
// After it: core/editing/plan.h, and the record: replayed answers are the same bits whatever the solver.
//
// A boundary constraint where f = 0 asks for what is so already, and so does a normal constraint
//     direction n = -grad f(c) / |grad f(c)|,   value f(c - offset n)             (T&O 2002, section 5),
// so f, which is the least bent function that obeys, remains the least bent one: it changes nowhere. With
// smoothing too: a term that is zero is added to what f minimizes already.
#pragma once

#include "core/editing/action.h"
#include "core/editing/shape.h"

namespace seesaw {

/// `action` with its question answered by `shape`: AddOnSurface becomes Add, AddNormal becomes SetNormal, the
/// others stay. The shape is the one that a person sees, also where the document has moved on and has none.
/// Throws Refused: nothing is met there; f is flat there; there is no shape yet.
template <int Dim>
Action<Dim> resolve(const Action<Dim>& action, const Document<Dim>& document, const Shape<Dim>& shape);

}  // namespace seesaw
