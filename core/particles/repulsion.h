// Floaters push each other away, and learn from how much they push how dense it is.
//
// Before it: neighbors.h says who is near, same_sheet.h who counts.
// After it: desired velocities go to adhesion.h, energies to radii.h.
//
// The energy of floater i due to j is a Gaussian of their distance whose width is i's own repulsion radius
// (Witkin & Heckbert 1994, section 4.3), with r = p_i - p_j:
//
//     E_ij = alpha exp(-|r|^2 / (2 sigma_i^2)),      E_i = sum_j (E_ij + E_ji)
//
// and the desired velocity is P_i = -sigma_i^2 grad E_i. The paper prints it (eq. 9) as
// sigma_i^2 sum_j (r_ij E_ij / sigma_i^2 - r_ji E_ji / sigma_j^2), with r_ji = p_j - p_i = -r. So
//
//     P_i = sum_j r (E_ij + (sigma_i / sigma_j)^2 E_ji)
//
// Both terms push i away from j. Then
//
//     D_i = sum_j E_ij,      dD_i/dsigma_i = sigma_i^-3 sum_j |r|^2 E_ij                      (eq. 13)
//
// Where density is to differ from place to place (t_i: how wide the spacing shall be at i), all of this
// happens in lengths stretched by 1 / t: r is divided by the mean of t_i and t_j, sigma_i by t_i, and P_i
// comes back multiplied by t_i. And each term of P_i is weighted by sqrt(t_j / t_i). Without that there is no
// rest: a floater has more neighbors on the dense side, drifts to the sparse one and dies there, while others
// are born behind it. Why the root: let t grow by g per length in direction u. At the stretched distance s
// in a direction at angle a from u, neighbors stand |r| = t_i s (1 + g t_i s cos(a) / 2) away; their density
// goes as t_j^-2, the area element |r| d|r| da as 1 + (3/2) g t_i s cos(a). With the weight t_j^p what is one
// sided in the sum is p - 2 + 3/2 times g t_i s cos(a): nothing for p = 1/2.
//
// The sums run over j != i: the paper's E-hat, six neighbors two radii away, counts no self-energy. Each term
// is weighted by same_sheet(), which is held fixed in the gradient, and left out beyond 4.5 radii, where it
// is alpha exp(-10.1) = 4e-5 alpha; in a hexagonal packing two radii apart all terms left out together are
// 1.1e-5 alpha.
#pragma once

#include "core/base/types.h"

namespace seesaw {

/// Beyond so many radii nothing is felt.
inline constexpr double repulsion_reach = 4.5;

/// N floaters as the pair sums see them.
struct Crowd {
  Points<3> positions = Points<3>(3, 0);  ///< 3 x N, scene units
  Points<3> normals = Points<3>(3, 0);    ///< 3 x N, outward, of unit length
  Values radii;                           ///< sigma_i > 0, N, scene units
  /// t_i, N, in (0, 1]: desired spacings relative to each other; empty for the same everywhere.
  Values scales = {};
};

struct PairSums {
  Points<3> push;    ///< P_i, 3 x N, scene units per unit of time
  Values energy;     ///< E_i, N, without unit
  Values own;        ///< D_i, N: the part of E_i that i's own radius decides
  Values own_slope;  ///< dD_i / dsigma_i, N, per scene unit
  /// sqrt(kappa_1^2 + kappa_2^2), N, per scene unit: the curvature as neighbors' normals tell it,
  /// sqrt(2 <|n_i - n_j|^2 / |r|^2>), averaged by E_ij + E_ji. 0 without neighbors.
  Values curvature;
  /// min_j (t_j + grading |r|), N: the scale that neighbors allow; 1 at most, also without neighbors.
  Values allowed;
};

/// Only the first term of P_i counts for `mutual` = false, the simple repulsion of section 4.1, where all
/// radii are equal and E_i = D_i.
struct RepulsionOptions {
  double amplitude = 6;  ///< alpha
  bool mutual = true;
  double grading = 0;  ///< how fast scales may grow from floater to floater, per scene unit
};

/// In about linear time; the same to the bit on any number of threads.
PairSums repulsion(const Crowd& crowd, const RepulsionOptions& options = {});

/// The same by asking every pair, the paper's O(r^2) way: an oracle for tests, and bench's peer. It adds in
/// another order, so the last digits differ.
PairSums repulsion_of_all_pairs(const Crowd& crowd, const RepulsionOptions& options = {});

}  // namespace seesaw
