// Why a document has no function, and which of its constraints stand in the way, in words.
//
// Before it: a ConstraintError of core/rbf/fit.h. After it: the command lines' errors.
#pragma once

#include <string>

#include "core/rbf/system.h"

namespace seesaw {

/// What the error says, then a line for each of the first ten culprits with its index, kind, place and value.
/// `constraints` are those that the error is about.
template <int Dim>
std::string in_words(const ConstraintError& error, const Constraints<Dim>& constraints);

}  // namespace seesaw
