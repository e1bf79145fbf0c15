// The radial basis functions phi(r) that an interpolant is a sum of, and what is special about each.
//
// Before it: nothing but a distance.  After it: core/rbf/system.h fills eq. 8 with phi(|c_i - c_j|).
//
// Turk & O'Brien 2002, section 3. Each of the three is conditionally definite of order 2: together with a
// linear polynomial the system of eq. 8 has exactly one solution, for any distinct centers that are not all
// on one line (2D) or plane (3D). The sign s says which way: s v' Phi v > 0 for v orthogonal to linear
// functions.
//
//   kernel              phi(r)      s   in 2D                          in 3D
//   thin_plate_spline   r^2 log r   +   eq. 4: minimizes eq. 3         rougher than |x|^3
//   cubic               r^3         +   smoother than the thin plate   the papers' choice (section 3)
//   linear              r           -   cones at the centers           minimizes eq. 3's form in 3D
//
// Every kernel works in every dimension.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace seesaw {

enum class Kernel { thin_plate_spline, cubic, linear };

inline constexpr Kernel all_kernels[] = {Kernel::thin_plate_spline, Kernel::cubic, Kernel::linear};

/// The name used in documents and on command lines: "thin_plate_spline", "cubic" or "linear".
std::string_view name_of(Kernel kernel);
/// The kernel of that name, or nothing.
std::optional<Kernel> kernel_named(std::string_view name);
/// The kernel the papers use in that dimension: thin_plate_spline in 2D, cubic in 3D and above.
constexpr Kernel papers_kernel(int dimension) {
  return dimension <= 2 ? Kernel::thin_plate_spline : Kernel::cubic;
}

}  // namespace seesaw
