// The proof that a passage leads through a seed (seeds.h says what is proved, and why).
//
// Before it: a passage near the seed.  After it: seeds.cpp, which asks for smaller triangles where the proof
// fails.
#pragma once

#include <vector>

#include "core/contour/seeds.h"

namespace seesaw {

/// A seed s with its two chords, A-s and s-B.
struct Trial {
  Seed* seed;
  int triangle;       ///< whose passage it is
  int before, after;  ///< crossings A and B, -1 where the box cuts the curve off
};

/// For each trial, does it prove its seed? All trials share their batches. Sets the seeds' `corner`.
std::vector<bool> prove(Crossings& curve, const std::vector<Trial>& trials);

}  // namespace seesaw
