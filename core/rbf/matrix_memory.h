// Memory for matrices, of which one piece is kept from one matrix to the next.
//
// A matrix of 6000 rows is 150 MB that nobody has touched: the system clears every page of it, and a computer
// that is shared must find them first. (Measured on two such: 0.02 and 0.35 s, where the whole fit takes 1.2
// s.) Whoever fits again and again, as an editor does, shall pay once.
//
// Before it: nothing.  After it: core/rbf/dense.h, whose matrices live here.
#pragma once

#include <cstddef>
#include <memory>

#include "core/base/types.h"

namespace seesaw::dense {

/// Gives a piece of `bytes` back. The last that came back is the one that is kept, if it is not larger than
/// 256 MB: it is what the program works with at present.
struct GiveBack {
  std::size_t bytes = 0;
  void operator()(double* memory) const;
};

using MatrixMemory = std::unique_ptr<double[], GiveBack>;

/// At least `count` numbers, not initialized: the piece that was kept, if it has as many and not more than
/// twice as many, or new ones, in large pages where the system has them. New ones have some room to spare,
/// which costs nothing until it is used: a document grows constraint by constraint. Throws std::bad_alloc.
/// From any thread.
MatrixMemory matrix_memory(Index count);

}  // namespace seesaw::dense
