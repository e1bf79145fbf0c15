#include "core/polygonize/working_mesh.h"

#include "core/base/parallel.h"
#include "core/polygonize/triangle_quality.h"

namespace seesaw {

std::vector<char> WorkingMesh::faces_below(double quality) const {
  const Index count = net.size() / 3;
  std::vector<char> below(static_cast<std::size_t>(count), 0);
  parallel_blocks(count, 1024, [&](Index begin, Index end) {
    for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f)
      if (net.is_alive(3 * f))
        below[static_cast<std::size_t>(f)] =
            quality_of(at(net.origin(3 * f)), at(net.origin(3 * f + 1)), at(net.origin(3 * f + 2))) < quality;
  });
  return below;
}

void WorkingMesh::finish() {
  mesh.faces = net.faces();
  mesh.cube_start.clear();
  keep_faces(mesh, std::vector<bool>(static_cast<std::size_t>(mesh.faces.cols()), true));
}

}  // namespace seesaw
