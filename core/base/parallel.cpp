#include "core/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace seesaw {

void parallel_blocks(Index count, Index block, const std::function<void(Index, Index)>& work) {
  if (count <= 0) return;
  if (count <= block) return work(0, count);
  const Index blocks = (count + block - 1) / block;
  tbb::parallel_for(tbb::blocked_range<Index>(0, blocks), [&](const tbb::blocked_range<Index>& range) {
    work(range.begin() * block, std::min(count, range.end() * block));
  });
}

void leaving_a_core(const std::function<void()>& work) {
  tbb::task_arena arena(std::max(1, tbb::this_task_arena::max_concurrency() - 1));
  arena.execute(work);
}

}  // namespace seesaw
