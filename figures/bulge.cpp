#include "figures/bulge.h"

#include "core/implicit/blobby.h"
#include "core/implicit/booleans.h"
#include "core/modelling/triangle_tree.h"
#include "core/polygonize/polygonize.h"

namespace seesaw {

double farthest_outside(const TriangleMesh& blend, const TriangleMesh& union_mesh,
                        const Field<3>& hard_union) {
  const Values values = hard_union.values(blend.vertices);
  const TriangleTree tree(union_mesh.vertices, union_mesh.faces);
  double farthest = 0;
  for (Index i = 0; i < values.size(); ++i)
    if (values[i] < 0) farthest = std::max(farthest, tree.nearest(blend.vertices.col(i)).distance);
  return farthest;
}

BlobbyChain blobby_chain(const Points<3>& path, double radius) {
  return {path, Values::Constant(path.cols(), radius)};
}

double chain_threshold(const BlobbyChain& chain, double radius) {
  const Index middle = chain.centers.cols() / 2;
  const Point<3> along = chain.centers.col(middle) - chain.centers.col(middle - 1);
  const Point<3> across = along.unitOrthogonal();
  // f = -t + sum: with t = 0 the value is the sum, and level there once both sides of the path are averaged.
  const BlobbySpheres<3> sum(0.0, chain.centers, chain.deviations);
  const Point<3> at = chain.centers.col(middle);
  return 0.5 * (sum.value(at + radius * across) + sum.value(at - radius * across));
}

SummedBlobbies sum_of(const std::vector<BlobbyChain>& chains, double threshold, int cells) {
  std::vector<FieldPointer<3>> alone;
  Index count = 0;
  for (const BlobbyChain& chain : chains) count += chain.centers.cols();
  Points<3> centers(3, count);
  Values deviations(count);
  count = 0;
  for (const BlobbyChain& chain : chains) {
    alone.push_back(share(BlobbySpheres<3>(threshold, chain.centers, chain.deviations)));
    centers.middleCols(count, chain.centers.cols()) = chain.centers;
    deviations.segment(count, chain.centers.cols()) = chain.deviations;
    count += chain.centers.cols();
  }
  const BlobbySpheres<3> sum(threshold, centers, deviations);
  const Union<3> hard(alone);
  const PolygonizeOptions options{.cells = cells, .exhaustive = true};
  SummedBlobbies result;
  result.mesh = polygonize(sum, Points<3>(3, 0), options).mesh;
  result.farthest_outside =
      farthest_outside(result.mesh, polygonize(hard, Points<3>(3, 0), options).mesh, hard);
  return result;
}

}  // namespace seesaw
