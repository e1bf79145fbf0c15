#include "core/polygonize/improve.h"

#include "core/polygonize/collapse.h"
#include "core/polygonize/flip.h"
#include "core/polygonize/slide.h"

namespace seesaw {

namespace {

// An edge shorter than this many cubes collapses. Lattice edges' crossings are half a cube to 1.4 cubes apart
// where the lattice is at its best.
constexpr double short_edge = 0.45;
constexpr int rounds = 3;

}  // namespace

void collapse_empty_edges(LatticeMesh& mesh, double cell) {
  WorkingMesh work(mesh, cell);
  collapse_short_edges(work, 0);
  work.finish();
}

void improve(LatticeMesh& mesh, Sampler& sampler, double cell) {
  WorkingMesh work(mesh, cell);
  collapse_short_edges(work, 0);
  collapse_short_edges(work, short_edge * cell);
  for (int round = 0; round < rounds; ++round) {
    flip_edges(work);
    slide_vertices(work, sampler);
  }
  flip_edges(work);
  collapse_needles(work);
  flip_edges(work);
  work.finish();
}

}  // namespace seesaw
