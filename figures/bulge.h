// How far does a blend bulge? And the summed blobbies that do: the comparison of T&O 2002, section 6.
//
// Before it: objects to be blended.  After it: Figure 9 and the companion figure `blend-bulge`.
#pragma once

#include <vector>

#include "core/implicit/field.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// The greatest distance from a vertex of `blend` that lies outside `hard_union` to the mesh of that union,
/// in scene units: how far the blend stands outside what it blends. 0 if it does so nowhere.
double farthest_outside(const TriangleMesh& blend, const TriangleMesh& union_mesh,
                        const Field<3>& hard_union);

/// Blobby spheres side by side along a path: a limb of one radius.
struct BlobbyChain {
  Points<3> centers;
  Values deviations;
};

/// Centers on `path` (3 x N), each with the deviation `radius`.
BlobbyChain blobby_chain(const Points<3>& path, double radius);
/// The threshold at which a chain alone has its surface at `radius` from its path, beside the path's middle.
double chain_threshold(const BlobbyChain& chain, double radius);

struct SummedBlobbies {
  TriangleMesh mesh;            ///< of the sum of all chains
  double farthest_outside = 0;  ///< of that mesh, outside the union of the chains, each alone; scene units
};
/// The sum of all chains at one threshold, against their union.
SummedBlobbies sum_of(const std::vector<BlobbyChain>& chains, double threshold, int cells = 90);

}  // namespace seesaw
