// What an action does to a document: from the action to a change that has not been laid on yet.
//
// Before it: core/editing/resolve.h, an action that asks the shape nothing.
// After it: core/editing/editor.h lays the change on.
//
// Planning does all the checking, so an action happens as a whole or not at all. What it leads to keeps the
// rules of core/scene/document_rules.h: whatever is edited can be saved.
#pragma once

#include "core/editing/action.h"
#include "core/editing/change.h"

namespace seesaw {

/// The change that `action` makes of `document`; empty where everything is so already. Throws Refused, naming
/// the action, the constraint and what is wrong: "move: constraint 7 does not exist, there are 5 (0 to 4)".
/// Neither AddOnSurface nor AddNormal. Linear in the number of constraints named.
template <int Dim>
Change<Dim> plan(const Action<Dim>& action, const Document<Dim>& document);

/// Throws Refused as above unless `index` is that of a boundary constraint of `document`. `action` is its
/// name.
template <int Dim>
const Constraint<Dim>& boundary_at(const Document<Dim>& document, Index index, const char* action);

}  // namespace seesaw
