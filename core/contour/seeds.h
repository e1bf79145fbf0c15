// Points that are known to lie on the curve, and the proof that the curve seen is the curve through them.
//
// Before it: the boundary constraints of a document; hidden.h's finds. The proof itself is in trial.h.
// After it: refine.h bisects around every seed without that proof; trace.h makes seeds vertices.
//
// A lattice sees a curve only by the signs at its corners. A loop between corners is not seen; of two sheets
// between the same corners neither is; of three, one is, and it may be the wrong one. So a seed s is
// *satisfied* only when a passage nearby leads from A to B such that, with inside on the left of both chords
// A-s and s-B,
//   - the gradients at A and B are square to their chords, to 12 degrees: the curve really sets out for s;
//   - the gradients at points between, ever nearer to s, point to the left of the chords (to 30 degrees) and
//     are of the size of the one at s (to a factor 3): between two sheets, or beside a small loop, they do
//     not.
//   - f is positive to the left of the chords and negative to the right, at points off them by 17 degrees as
//     seen from s, down to a millionth of the chord: it is not where a loop touches them, or two curves
//     cross.
// The kernel |x| makes a corner of the curve at every seed, where the one gradient given is that of neither
// side. So a seed that fails by the size alone gets a second trial, of points so near to s that no loop fits
// between, and their sizes are compared with each other. A seed without a gradient (a node) cannot be proved
// and is refined to the end; what is not satisfied even then is settled last, when the curve around it is
// known. It may be the tip of a spike (a cusp; a sharp corner) that grows thinner than any triangle on its
// way to the seed.
#pragma once

#include <vector>

#include "core/contour/crossings.h"

namespace seesaw {

struct Seed {
  enum class State {
    pending,      ///< no proof yet
    satisfied,    ///< a passage leads through it
    exhausted,    ///< no proof, and its triangles are too small to bisect
    off_curve,    ///< f is not zero here, or its zero is a mere point
    outside_box,  ///< not looked for
    lost,         ///< on a curve that was not found
  };
  Point<2> at;        ///< scene coordinates, on the zero set
  Point<2> gradient;  ///< grad f there
  Point<2> uv;        ///< lattice coordinates
  State state = State::pending;
  bool given = true;     ///< false: found by ourselves
  bool scouted = false;  ///< points of the curve beside it have been made seeds
  bool corner = false;   ///< the proof met gradients that leave room for a corner of the curve here
  int triangle = -1;     ///< of a satisfied seed: the leaf whose passage leads through it
};

/// Seeds out of points (2 x N) on or near the zero set. One that is off by more than 1e-9 of the extent is
/// moved along its gradient onto the zero set, by no more than two cells.
std::vector<Seed> make_seeds(Crossings& curve, const PointsRef<2>& points);

/// Looks for the proof of every pending seed, and again where the proof's leaf has been bisected. Fills
/// `leaves` with what to bisect for those still pending.
void check_seeds(Crossings& curve, std::vector<Seed>& seeds, std::vector<int>& leaves);

/// Settles exhausted seeds, when nothing else is left to bisect. Where a curve must pass but none is seen,
/// two points of it are added to `seeds`, pending; true when that was done.
bool settle_seeds(Crossings& curve, std::vector<Seed>& seeds);

/// When no more will be bisected: finds the passage also for seeds that were not satisfied when refinement
/// was stopped.
void attach_seeds(Crossings& curve, std::vector<Seed>& seeds);

/// The length below which no triangle is bisected, in scene units.
double smallest_triangle(const Lattice& lattice);

}  // namespace seesaw
