// What a document must keep to, whoever made it: one list of rules for the reader and the writer, so that
// what was saved can always be opened.
//
// Before it: a part of a document, read from a file or about to be written.
// After it: core/scene/document_json.h turns a fault into an error with its line and path.
#pragma once

#include <optional>
#include <string>

#include "core/scene/document.h"

namespace seesaw {

struct Fault {
  /// The key whose value is at fault: "at", "normal", "value", "view", ...
  std::string key;
  /// What is wrong with it and what was expected.
  std::string message;
};

/// The first fault of a part, or nothing. The parts of a part are the caller's to ask about: the rules of a
/// document are those of its own numbers. For Dim 2 and 3.
template <int Dim>
std::optional<Fault> fault_of(const SceneConstraint<Dim>& each);
template <int Dim>
std::optional<Fault> fault_of(const Display<Dim>& display);
template <int Dim>
std::optional<Fault> fault_of(const Document<Dim>& document);
std::optional<Fault> fault_of(const Camera& camera);

/// "boundary", "interior" or "exterior".
const char* name_of(ConstraintKind kind);
/// phi(r) as people write it, in UTF-8: "r\u00b2 log r", "r\u00b3" or "r".
const char* formula_of(Kernel kernel);

}  // namespace seesaw
