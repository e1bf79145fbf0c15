// What one cube contributes: for each of the 256 patterns of signs at its corners, the triangles that
// separate inside from outside.
//
// Before it: signs at the corners of a cube (continuation.h).  After it: assemble.h puts the cubes together.
//
// The table is not typed in but made, once, as Bloomenthal 1994 does (`makecubetable`): by walking around the
// faces. On a face, going around its four corners, the sign changes two or four times. Two changes are joined
// by a segment. Four make the face ambiguous, and one fixed rule decides: each inside corner is cut off by
// itself. The rule knows nothing but the face's four signs, so the two cubes at a face agree on its segments.
// An edge of the cube that changes sign lies on two faces and has one segment on each: the segments chain
// into loops, each of which is cut into triangles.
//
// Why that gives a manifold, whatever the signs. (1) A segment lies on one face, so in exactly two triangles,
// one of each cube there. (2) A loop is cut by diagonals that run through the cube's inside, never between
// two edges of one face; so no diagonal meets a segment or a diagonal of the neighbor, and it too lies in
// exactly two triangles. (That such a cut exists for every loop was checked by trying: the table's maker
// would stop.) (3) Around a lattice edge that changes sign stand four cubes and four faces, each face with
// one segment ending there: the triangles at that vertex form one ring.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace seesaw {

/// Edge e of a cube: from corner `low`, in direction `axis`. Corner c has coordinates c & 1, c >> 1 & 1, c >>
/// 2.
struct CubeEdge {
  int low, axis;
  int high() const { return low | 1 << axis; }
};
extern const std::array<CubeEdge, 12> cube_edges;

/// Vertices lie on edges: three edge numbers a triangle, counter-clockwise as seen from outside the solid.
using CubeTriangles = std::vector<std::array<std::uint8_t, 3>>;

/// By the bits of the corners that are inside: bit c for corner c.
const CubeTriangles& cube_triangles(unsigned inside);

/// Bit f for face f (2 axis + side, side 1 the upper) when the face's corners are of both signs.
unsigned crossed_faces(unsigned inside);

}  // namespace seesaw
