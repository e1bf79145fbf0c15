// How fast can the sum be at all? Loops written by hand for one kernel, one dimension and one instruction
// set.
//
// They are what core/rbf's loops are measured against (aim: 80 %): intrinsics, no templates, no compensated
// sums, no guard against a center on the point itself, and no points or centers to spare: `points.count` must
// be a multiple of `ceiling_points` and `centers.count` even. Digits are those of double.
#pragma once

#include "core/rbf/kernel_sums.h"

namespace seesaw::bench {

inline constexpr std::int64_t ceiling_points = 96;

/// The arguments of KernelSums::values, without kernel and dimension.
using CeilingLoop = void (*)(const CenterArrays&, const PointArrays&, double* values);

/// The loop for "avx2" or "avx512"; nullptr where there is none or the processor lacks it. There are two for
/// each: cubic in 3D and thin_plate_spline in 2D, the papers' kernels.
CeilingLoop ceiling_loop(const char* instruction_set, Kernel kernel, int dimension);

#if defined(__x86_64__)
void cubic_3d_avx2(const CenterArrays&, const PointArrays&, double* values);
void thin_plate_2d_avx2(const CenterArrays&, const PointArrays&, double* values);
void cubic_3d_avx512(const CenterArrays&, const PointArrays&, double* values);
void thin_plate_2d_avx512(const CenterArrays&, const PointArrays&, double* values);
#endif

}  // namespace seesaw::bench
