// Makes neighbors agree on which side is out, and turns what is inside out.
//
// Before it: faces in any direction, equal vertices welded.  After it: mesh_repair.h reports what was done.
//
// A patch is a set of faces joined across edges of two faces. Within a patch the direction of one face fixes
// all others; the majority of the file's own faces decides. Around a closed patch there is an outside: if its
// signed volume is negative and no other closed patch contains it, it is inside out and is turned. A closed
// patch within another is a shell, most often the wall of a cavity, whose faces rightly look inward: it is
// left as it is, and turned only together with the patch around it, and only if it then would not alternate
// with it.
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

struct OrientationReport {
  Index turned_faces = 0;  ///< turned to agree with their patch
  Index one_sided = 0;  ///< patches that no turning makes consistent, like a Moebius band: left as they are
  Index turned_patches = 0;  ///< closed patches that were inside out, shells turned with them included
};

/// Turns faces of `mesh` in place; the vertices and the order of the faces stay. O(F log F).
OrientationReport orient_faces(TriangleMesh& mesh);

}  // namespace seesaw
