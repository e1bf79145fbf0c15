// One loop over blocks, run on all cores. The result never depends on how many there are: a block's work
// reads shared data and writes only what belongs to the block.
#pragma once

#include <functional>

#include "core/base/types.h"

namespace seesaw {

/// Calls `work(begin, end)` for consecutive runs that together cover 0 .. count - 1, each but the last a
/// multiple of `block` long, in any order and from several threads. Work of one block or less runs in the
/// calling thread.
void parallel_blocks(Index count, Index block, const std::function<void(Index begin, Index end)>& work);

/// Calls `work` in the calling thread, where its loops run on all cores but one: for work on a thread of its
/// own, beside one that a person is waiting for.
void leaving_a_core(const std::function<void()>& work);

}  // namespace seesaw
