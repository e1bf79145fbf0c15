// The four steps of dense linear algebra that a fit needs, by LAPACK where it is installed, by Eigen where it
// is not. LAPACK's library picks the processor's instructions at run time; what we compile ourselves may not.
//
// Matrices are column-major with their lower triangle stored, n x n inside a larger one of `stride` rows.
#pragma once

#include "core/base/types.h"

namespace seesaw::dense {

/// The largest absolute column sum of the symmetric matrix.
double norm1(const double* lower, Index n, Index stride);

/// Overwrites the lower triangle of A with L, A = L L'. False where A is not positive definite (to rounding).
/// About n^3 / 3 multiplications.
bool cholesky(double* lower, Index n, Index stride);

/// x := A^-1 x, given L. 2 n^2 multiplications.
void solve(const double* cholesky, Index n, Index stride, double* x);

/// An estimate of 1 / (|A|_1 |A^-1|_1), given L and |A|_1 (Higham 1988); about ten solves. 1 for n = 0.
double reciprocal_condition(const double* cholesky, Index n, Index stride, double norm1);

/// "LAPACK" or "Eigen".
const char* name();

}  // namespace seesaw::dense
