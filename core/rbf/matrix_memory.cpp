#include "core/rbf/matrix_memory.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace seesaw::dense {

namespace {

constexpr std::size_t page = std::size_t{1} << 21;
constexpr std::size_t largest_kept = std::size_t{256} << 20;

struct Kept {
  std::mutex mutex;
  double* memory = nullptr;
  std::size_t bytes = 0;
};

// Never destroyed: matrices may outlive any other static object.
Kept& kept() {
  static Kept& kept = *new Kept;
  return kept;
}

// In pages of 2 MB a matrix of 100 MB costs 50 page faults instead of 25,000, a tenth of its factorization.
double* allocated(std::size_t bytes) {
  void* memory = std::aligned_alloc(page, bytes);
  if (!memory) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
  ::madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: where it is refused, small pages do
#endif
  return static_cast<double*>(memory);
}

}  // namespace

void GiveBack::operator()(double* memory) const {
  if (bytes >= page && bytes <= largest_kept) {
    Kept& k = kept();
    const std::scoped_lock lock(k.mutex);
    k.bytes = bytes;
    std::swap(k.memory, memory);
  }
  std::free(memory);
}

MatrixMemory matrix_memory(Index count) {
  const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(std::max<Index>(count, 1));
  if (bytes < page) {
    auto* memory = static_cast<double*>(std::malloc(bytes));
    if (!memory) throw std::bad_alloc();
    return {memory, GiveBack{bytes}};
  }
  {
    Kept& k = kept();
    const std::scoped_lock lock(k.mutex);
    if (k.memory && k.bytes >= bytes && k.bytes / 2 <= bytes)
      return {std::exchange(k.memory, nullptr), GiveBack{k.bytes}};
  }
  const std::size_t roomy = (bytes + bytes / 8 + page - 1) / page * page;
  return {allocated(roomy), GiveBack{roomy}};
}

}  // namespace seesaw::dense
