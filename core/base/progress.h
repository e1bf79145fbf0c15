// How long work says where it stands, and how it is told to stop.
#pragma once

#include <functional>

#include "core/base/error.h"

namespace seesaw {

/// Called now and then from the thread that does the work with the fraction done, 0 to 1; return false to
/// stop the work, which then ends with `Cancelled` and leaves nothing half made. An empty function never
/// stops it.
using Progress = std::function<bool(double fraction)>;

/// Reports `fraction` and throws Cancelled when the listener says stop.
inline void report(const Progress& progress, double fraction) {
  if (progress && !progress(fraction)) throw Cancelled();
}

/// For a part of some work, from `begin` to `end` of the whole. For as long as `progress` lives.
inline Progress share_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [&progress, begin, end](double fraction) { return progress(begin + fraction * (end - begin)); };
}

}  // namespace seesaw
