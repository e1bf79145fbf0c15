#include "core/mesh/compact.h"

#include <vector>

namespace seesaw {

TriangleMesh with_faces(const TriangleMesh& mesh, const Faces& faces) {
  std::vector<int> number(static_cast<std::size_t>(mesh.vertices.cols()), -1);
  for (Index i = 0; i < faces.size(); ++i) number[static_cast<std::size_t>(faces.data()[i])] = 0;
  TriangleMesh result;
  result.vertices.resize(3, mesh.vertices.cols());
  if (mesh.has_normals()) result.normals.resize(3, mesh.vertices.cols());
  int used = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    result.vertices.col(used) = mesh.vertices.col(static_cast<Index>(v));
    if (mesh.has_normals()) result.normals.col(used) = mesh.normals.col(static_cast<Index>(v));
    number[v] = used++;
  }
  result.vertices.conservativeResize(3, used);
  if (mesh.has_normals()) result.normals.conservativeResize(3, used);
  result.faces = faces.unaryExpr([&](int v) { return number[static_cast<std::size_t>(v)]; });
  return result;
}

}  // namespace seesaw
