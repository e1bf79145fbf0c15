// The parts of a document as JSON values, for files that hold documents or pieces of them: a recorded session
// (core/editing/session.h) starts with one and adds constraints.
//
// Before it: core/scene/json_tape.h.  After it: the same data as core/scene/document_json.h has them, under
// the same rules and with the same errors: the line, and the path from the top of the whole file.
#pragma once

#include <string>

#include "core/scene/document.h"
#include "core/scene/json_tape.h"

namespace seesaw {

// Each throws FileError for a value that is something else. For Dim 2 and 3.

/// An array of Dim numbers.
template <int Dim>
Point<Dim> point_of(JsonValue value);
/// "boundary", "interior" or "exterior".
ConstraintKind kind_of(JsonValue value);
/// The name of a kernel.
Kernel kernel_of(JsonValue value);
/// 2 or 3.
int dimension_of(JsonValue value);
/// {"kind": ..., "at": ..., ...}, checked.
template <int Dim>
SceneConstraint<Dim> scene_constraint_of(JsonValue value);
/// A whole document of that dimension, checked.
template <int Dim>
Document<Dim> document_of(JsonValue value);

/// A constraint as the one line that a document has for it; fault_of it is the caller's to ask.
template <int Dim>
std::string json_line(const SceneConstraint<Dim>& each);
/// "[0, 1]", each number the shortest that reads back to the same bits.
template <int Dim>
std::string json_point(const Point<Dim>& point);

}  // namespace seesaw
