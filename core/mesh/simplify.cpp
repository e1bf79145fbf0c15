#include "core/mesh/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/base/check.h"
#include "core/mesh/compact.h"
#include "core/mesh/edge_collapse.h"
#include "core/mesh/mesh_check.h"

namespace seesaw {

namespace {

// Positions in floats around the middle: scans stand at offsets where floats would have no digits left.
std::vector<float> positions_of(const TriangleMesh& mesh) {
  const Box<3> box = bounding_box_of<3>(mesh.vertices);
  const Point<3> middle = box.center();
  const double size = box.sizes().maxCoeff() > 0 ? box.sizes().maxCoeff() : 1.0;
  std::vector<float> positions(static_cast<std::size_t>(mesh.vertices.size()));
  for (Index v = 0; v < mesh.vertices.cols(); ++v)
    for (int d = 0; d < 3; ++d)
      positions[static_cast<std::size_t>(3 * v + d)] =
          static_cast<float>((mesh.vertices(d, v) - middle[d]) / size);
  return positions;
}

class Bulk {
 public:
  explicit Bulk(const TriangleMesh& mesh)
      : mesh_(mesh),
        positions_(positions_of(mesh)),
        indices_(mesh.faces.data(), mesh.faces.data() + mesh.faces.size()) {}

  TriangleMesh with_faces_about(Index faces) const {
    std::vector<unsigned> result(indices_.size());
    const auto target = static_cast<std::size_t>(std::clamp<Index>(faces, 0, mesh_.faces.cols())) * 3;
    const std::size_t n = meshopt_simplify(result.data(), indices_.data(), indices_.size(), positions_.data(),
                                           positions_.size() / 3, 3 * sizeof(float), target,
                                           std::numeric_limits<float>::max(), 0, nullptr);
    Faces kept(3, static_cast<Index>(n / 3));
    std::copy(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(n), kept.data());
    return with_faces(mesh_, kept);
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<float> positions_;
  std::vector<unsigned> indices_;
};

bool same_topology(const MeshReport& a, const MeshReport& b) {
  return a.closed == b.closed && a.manifold == b.manifold && a.oriented == b.oriented &&
         a.components == b.components && a.euler_characteristic == b.euler_characteristic &&
         a.boundary_loops == b.boundary_loops;
}

// Of a mesh that is not manifold: the most vertices up to `vertices`, by halving the range of face counts.
TriangleMesh nearest_below(const TriangleMesh& mesh, Index vertices, const Progress& progress) {
  const Bulk bulk(mesh);
  Index low = 0, high = mesh.faces.cols();
  TriangleMesh best;
  while (low < high) {
    report(progress, 1 - static_cast<double>(high - low) / static_cast<double>(mesh.faces.cols()));
    const Index middle = low + (high - low) / 2;
    TriangleMesh tried = bulk.with_faces_about(middle);
    const Index reached = tried.vertices.cols();
    if (reached <= vertices && reached > best.vertices.cols()) best = std::move(tried);
    if (reached == vertices) break;
    if (reached > vertices)
      high = middle;
    else
      low = middle + 1;
  }
  if (best.faces.cols() == 0)
    throw Error("this mesh is not manifold and cannot be simplified to " + std::to_string(vertices) +
                " vertices");
  return best;
}

}  // namespace

TriangleMesh simplify(const TriangleMesh& mesh, Index vertices, const Progress& progress) {
  if (vertices < 4)
    throw Error("a mesh cannot be simplified to " + std::to_string(vertices) + " vertices; the fewest are 4");
  const TriangleMesh original = with_faces(mesh, mesh.faces);
  if (original.vertices.cols() <= vertices) return original;
  const MeshReport wanted = check_mesh(original);
  if (!wanted.manifold) return nearest_below(original, vertices, progress);

  const Bulk bulk(original);
  const Index all_faces = original.faces.cols();
  const double share = static_cast<double>(vertices) / static_cast<double>(original.vertices.cols());
  Index faces = wanted.closed ? 2 * (vertices - wanted.euler_characteristic)
                              : static_cast<Index>(share * static_cast<double>(all_faces));
  Index reached = original.vertices.cols();
  // What is asked for in addition after a result that is damaged or too small grows, in the end to all faces.
  Index more = 8 + vertices / 50;
  for (int attempt = 0;; ++attempt, more *= 4) {
    report(progress, attempt / 12.0);
    const bool whole = faces >= all_faces;
    TriangleMesh tried = whole ? original : bulk.with_faces_about(faces);
    const Index short_of = vertices - tried.vertices.cols();
    if (short_of <= 0 && (whole || same_topology(check_mesh(tried), wanted))) {
      if (short_of < 0) tried = collapse_edges(tried, vertices, progress);
      reached = std::min(reached, tried.vertices.cols());
      if (reached == vertices && same_topology(check_mesh(tried), wanted)) return tried;
    }
    if (whole) break;
    faces += 2 * std::max<Index>(0, short_of) + more;
  }
  throw Error("this mesh cannot be simplified to " + std::to_string(vertices) + " vertices without damage; " +
              std::to_string(reached) + " were reached");
}

}  // namespace seesaw
