#include "core/polygonize/working_mesh.h"

#include "core/base/parallel.h"
#include "core/polygonize/triangle_quality.h"

namespace seesaw {

WorkingMesh::WorkingMesh(LatticeMesh& its_mesh, double its_cell)
    : mesh(its_mesh),
      net(its_mesh.faces, its_mesh.vertices()),
      cell(its_cell),
      quality(static_cast<std::size_t>(its_mesh.faces.cols())) {
  renew_all();
}

double WorkingMesh::worst_around(int v) const {
  double worst = 1;
  net.for_each_leaving(v, [&](int h) { worst = std::min(worst, quality_at(h)); });
  return worst;
}

void WorkingMesh::renew(int face) {
  const int h = 3 * face;
  quality[static_cast<std::size_t>(face)] =
      net.is_alive(h) ? quality_of(at(net.origin(h)), at(net.origin(h + 1)), at(net.origin(h + 2))) : 1;
}

void WorkingMesh::renew_all() {
  parallel_blocks(static_cast<Index>(quality.size()), 1024, [&](Index begin, Index end) {
    for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f) renew(f);
  });
}

void WorkingMesh::finish() {
  mesh.faces = net.faces();
  mesh.cube_start.clear();
  keep_faces(mesh, std::vector<bool>(static_cast<std::size_t>(mesh.faces.cols()), true));
}

}  // namespace seesaw
