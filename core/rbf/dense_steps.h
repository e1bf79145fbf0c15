// The steps that dense.cpp's algorithms consist of: one call of BLAS or LAPACK each, or one line of Eigen.
// Those libraries pick the processor's instructions at run time; what we compile ourselves may not.
//
// Before it: blocks of column-major matrices, as pointers with the distance between columns.  After it:
// dense.cpp.
#pragma once

#include "core/base/types.h"

namespace seesaw::dense {

/// A block of a matrix: its columns are `stride` numbers apart.
struct ConstBlock {
  const double* data;
  Index rows, columns, stride;
};
struct Block {
  double* data;
  Index rows, columns, stride;
  operator ConstBlock() const { return {data, rows, columns, stride}; }
};

/// While one lives, BLAS works in the calling thread alone. How it cuts work for several threads decides the
/// last digits of its results, and ours are to be the same whatever the number of threads; so the cutting is
/// ours.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
};

// Of the square block a, its lower triangle. x and y are columns of as many numbers as fit.

bool factor(const Block& a);                             ///< a := L, a = L L'; false: not definite
void divide_right(const Block& x, const ConstBlock& l);  ///< x := x L'^-1
void divide(const ConstBlock& l, double* x);             ///< x := L^-1 x
void divide_transposed(const ConstBlock& l, double* x);  ///< x := L'^-1 x
void add_symmetric(const ConstBlock& a, const double* x, double* y);  ///< y := y + a x, of a symmetric
void subtract_square(const Block& a, const ConstBlock& u);            ///< a := a - u u', lower triangle
/// a := a - u v' - v u', lower triangle
void subtract_both(const Block& a, const ConstBlock& u, const ConstBlock& v);

void divide(const ConstBlock& l, const Block& x);             ///< x := L^-1 x
void divide_transposed(const ConstBlock& l, const Block& x);  ///< x := L'^-1 x

// Of any block a.

void subtract_product(const Block& a, const ConstBlock& u, const ConstBlock& v);  ///< a := a - u v'
/// y := y + sign a x and y := y + sign a' x.
void add_product(double sign, const ConstBlock& a, const double* x, double* y);
void add_transposed(double sign, const ConstBlock& a, const double* x, double* y);
void subtract_times(const Block& y, const ConstBlock& a, const ConstBlock& x);             ///< y := y - a x
void subtract_transposed_times(const Block& y, const ConstBlock& a, const ConstBlock& x);  ///< y := y - a' x

const char* name();

}  // namespace seesaw::dense
