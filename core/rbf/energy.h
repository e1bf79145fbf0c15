// What a fitted function minimizes, and how large it is, from the weights alone.
//
// Before it: weights and kernel.  After it: the number that the editor shows and the figure `energy` checks.
//
// Among all functions that meet the constraints, f = sum w phi + p has the least
//     E(f) = (2 pi)^-n  integral of  |xi|^(n + b) |F(xi)|^2 d xi,      phi ~ r^b
// (Duchon 1977), F the Fourier transform of f. F = W(xi) phi^(xi) with phi^(xi) = s c |xi|^-(n + b) away from
// 0, s = +-1, c > 0, so
//     E(f) = s c  w' Phi w = s c  w' h                                   (h the values; no smoothing).
// For whole even n + b this is an integral of squared derivatives:
//     r^2 log r in 2D   n + b = 4   all second derivatives: eq. 3 of Turk & O'Brien 2002, exactly; c = 8 pi
//     r in 3D           n + b = 4   eq. 3 in three dimensions; c = 8 pi
//     r^3 in 3D         n + b = 6   all *third* derivatives squared; c = 96 pi. The papers say
//                                   "similar to" eq. 3; exactly, Duchon's semi-norm with m = 2, s = 1
// For the rest it is a fractional derivative, still the energy that is minimized.
#pragma once

#include "core/rbf/kernel.h"

namespace seesaw {

/// b of phi(r) ~ r^b: 2, 3 or 1. Weights scale by length^-b, the energy too.
double growth_of(Kernel kernel);

/// c above, for `dimension` n >= 1:  r^b: 2^(b + n) pi^(n/2) Gamma((b + n) / 2) / |Gamma(-b / 2)|;
/// r^2 log r: the derivative of that in b at 2, 2^(n + 1) pi^(n/2) Gamma((n + 2) / 2).
double energy_factor(Kernel kernel, int dimension);

}  // namespace seesaw
