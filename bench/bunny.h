// The paper's bunny: 800 vertices, each with a boundary and a normal constraint (T&O 2002, section 8.2).
#pragma once

#include "core/mesh/mesh_file.h"
#include "core/mesh/simplify.h"
#include "core/modelling/model_constraints.h"

namespace seesaw::bench {

inline constexpr const char* bunny_file = "/usr/share/glmark2/models/bunny.obj";

/// In the unit cube, normal constraints 0.01 inside.
inline Constraints<3> constraints_of_bunny() {
  return constraints_from(simplify(read_mesh(bunny_file).mesh, 800), {.to_unit_cube = true}).constraints;
}

}  // namespace seesaw::bench
