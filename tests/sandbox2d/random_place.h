// A random place in a text or a list.
#pragma once

#include "core/base/random.h"

namespace seesaw {

/// Uniform in 0 .. n - 1.
inline std::size_t below(Random& random, std::size_t n) {
  return static_cast<std::size_t>(random.index(static_cast<Index>(n)));
}

}  // namespace seesaw
