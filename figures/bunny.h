// The Stanford bunny, read from the Debian package glmark2-data: nothing of it is shipped (its terms are its
// own).
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// The bunny simplified to `vertices` vertices, closed. Throws MissingPackage.
TriangleMesh bunny_of(Index vertices);

}  // namespace seesaw
