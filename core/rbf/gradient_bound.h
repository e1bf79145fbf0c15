// How steep can the function be in a box? A number that |grad f| provably does not exceed.
//
// Before it: weights, and a box that someone wants to skip or step through.
// After it: Field::gradient_bound; f has no zero within |f(m)| / bound of the box's center m.
//
// Expand grad f about the center m of the ball of radius R around the box. Centers that are not near m are
// smooth in the ball: their derivatives at m up to the fifth are summed *exactly*, so that the huge weights
// of close pairs (a boundary constraint and its normal) cancel as they do in f, and only the sixth are
// bounded one by one:
//     |grad f(x)| <= sum_{k = 1..5} R^{k-1} / (k-1)! |D^k(m)|  +  R^5 / 120 sum |w_j| M6(d_j - R)  +  near.
// With s = r^2 and a_q the q-fold (1/r d/dr) of phi, a derivative is a sum over the ways to pair its
// directions, here for a unit vector u and c the cosine between u and the radius:
//     D^k phi[u, ..., u] = sum_p k! / (p! 2^p (k - 2p)!) a_{k-p}(r) (r c)^{k-2p}.
// The largest |D^6 phi[u, ..., u]| over all c is also the largest over any six unit vectors (Banach 1938):
//     r^3           |315 c^6 - 675 c^4 + 405 c^2 - 45| / r^3       <= 45 / r^3     at c = 0
//     r^2 log r     |768 c^6 - 1440 c^4 + 720 c^2 - 60| / r^4      <= 60 / r^4     at c = 0
//     r             |945 c^6 - 1575 c^4 + 675 c^2 - 45| / r^5      <= 45 / r^5     at c = 0
// Near centers can lie inside the ball, where higher derivatives do not exist:
//   r^3           gradient and Hessian at m count exactly; third derivatives are 6 at most: R^2 / 2 * 6 |w_j|
//   r^2 log r     the gradient at m counts exactly; it changes by at most |w_j| R K on the way to x. The side
//                 conditions leave the unit of log r free, if it is one for all centers: take R. Then the
//                 Hessian's norm is at most 2 |log r| + 3 with r in [0, 3], its integral along a unit path at
//                 most K = 2 (1 + log 2) + 3 < 6.4
//   r             its gradient is a unit vector: |w_j|
// Near is d_j <= 1.5 R (1.8 R for r), where the two ways of bounding a center cost about the same. As the box
// shrinks near centers vanish, or their part falls with R, and the bound closes in on |grad f(m)|.
#pragma once

#include "core/base/types.h"
#include "core/rbf/kernel_sums.h"

namespace seesaw {

/// Everything in one system of coordinates; the centers' weights must meet eq. 8's side conditions; `slope`
/// is the linear part of the polynomial. Rigorous up to rounding, for which a relative 1e-9 and 1e-13 of all
/// that was added up are added. Infinite for a box without end. O(N), some ten times a value of f.
template <int Dim>
double kernel_gradient_bound(Kernel kernel, const CenterArrays& centers, const Point<Dim>& slope,
                             const Box<Dim>& box);

}  // namespace seesaw
