#include "figures/bunny.h"

#include "core/mesh/mesh_file.h"
#include "core/mesh/simplify.h"
#include "figures/figure.h"

namespace seesaw {

TriangleMesh bunny_of(Index vertices) {
  const std::filesystem::path path = "/usr/share/glmark2/models/bunny.obj";
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw MissingPackage("glmark2-data", path);
  static const TriangleMesh full = read_mesh(path).mesh;
  return simplify(full, vertices);
}

}  // namespace seesaw
