// Checks of what a programmer promised: they print both values and stop.
//
// Only mistakes of the calling code end here (a batch of 5 points and room for 4 values). What a user can
// cause is an exception: core/base/error.h.
#pragma once

#include <cstdlib>
#include <iostream>

namespace seesaw::detail {

template <class A, class B>
[[noreturn]] void check_failed(const char* file, int line, const char* expression, const A& a, const B& b) {
  std::cerr << file << ':' << line << ": check failed: " << expression << "\n  left  = " << a
            << "\n  right = " << b << std::endl;
  std::abort();
}

}  // namespace seesaw::detail

// Kept in release builds: each is one comparison a batch, never one a point.
#define SEESAW_CHECK_OP(op, a, b)                                                                       \
  do {                                                                                                  \
    const auto& seesaw_left = (a);                                                                      \
    const auto& seesaw_right = (b);                                                                     \
    if (!(seesaw_left op seesaw_right))                                                                 \
      ::seesaw::detail::check_failed(__FILE__, __LINE__, #a " " #op " " #b, seesaw_left, seesaw_right); \
  } while (false)

#define SEESAW_CHECK_EQ(a, b) SEESAW_CHECK_OP(==, a, b)
#define SEESAW_CHECK_LT(a, b) SEESAW_CHECK_OP(<, a, b)
#define SEESAW_CHECK_LE(a, b) SEESAW_CHECK_OP(<=, a, b)
#define SEESAW_CHECK_GE(a, b) SEESAW_CHECK_OP(>=, a, b)
