// How steep can the function be in a box? A number that |grad f| provably does not exceed.
//
// Before it: weights, and a box that someone wants to skip or step through.
// After it: Field::gradient_bound; f has no zero within |f(m)| / bound of the box's center m.
//
// Expand grad f about the center m of the ball of radius R around the box. Centers farther than 2R from m are
// smooth in the ball: their gradient, Hessian and third derivatives at m are summed *exactly*, so that the
// huge weights of close pairs (a boundary constraint and its normal) cancel as they do in f, and only the
// fourth derivatives are bounded one by one:
//     |grad f(x)| <= |g(m)| + R |H(m)| + R^2 / 2 |T(m)| + R^3 / 6 sum |w_j| M4(d_j - R)  +  near centers.
// Unit vectors u give the extremes of D^k phi[u, ..., u], with c the cosine between u and the radius:
//                 third derivatives          fourth derivatives M4(r)
//   r^3           (9 c - 3 c^3)      <= 6     9 (1 - c^2)^2 / r           <= 9 / r
//   r^2 log r     (6 c - 4 c^3) / r           (6 - 24 c^2 + 16 c^4) / r^2 <= 6 / r^2
//   r             (3 c^3 - 3 c) / r^2         (-3 + 18 c^2 - 15 c^4) / r^3 <= 3 / r^3
// Near centers, d_j <= 2R, can lie inside the ball, where higher derivatives do not exist:
//   r^3           gradient and Hessian at m count exactly; third derivatives by 6: R^2 / 2 * 6 |w_j|
//   r^2 log r     the gradient at m counts exactly; it changes by at most |w_j| R K on the way to x. The side
//                 conditions leave the unit of log r free, if it is one for all centers: take R. Then the
//                 Hessian's norm is at most 2 |log r| + 3 with r in [0, 3], its integral along a unit path at
//                 most K = 2 (1 + log 2) + 3 < 6.4
//   r             its gradient is a unit vector: |w_j|
// As the box shrinks near centers vanish, or their part falls with R, and the bound closes in on |grad f(m)|.
#pragma once

#include "core/base/types.h"
#include "core/rbf/kernel.h"

namespace seesaw {

/// Everything in one system of coordinates; `weights` must meet eq. 8's side conditions; `slope` is the
/// linear part of the polynomial. Rigorous up to rounding, for which a relative 1e-9 is added. O(N).
template <int Dim>
double kernel_gradient_bound(Kernel kernel, const PointsRef<Dim>& centers,
                             const Eigen::Ref<const Values>& weights, const Point<Dim>& slope,
                             const Box<Dim>& box);

}  // namespace seesaw
