// One reader a format: bytes in, a PolygonSoup out, or a FileError that names the line or the element.
//
// Before it: mesh_file.h has read the bytes and knows the format.  After it: mesh_repair.h, or a PointCloud.
//
// What all of them promise: coordinates are finite, indices in range, and no memory is asked for that the
// file does not fill: a header that promises more than follows it is refused first. Polygons keep their
// corners and faces their order. What no surface needs (colors, textures, materials) is read over.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh/polygon_soup.h"

namespace seesaw {

/// Wavefront: v (with w or a color behind it), vn, f in all forms (v, v/vt, v//vn, v/vt/vn, negative
/// indices), lines continued by a backslash. l and p are counted as lines_and_points; g, o, s, usemtl and the
/// like are read over; anything else is refused. Corner normals become vertex normals where all corners of a
/// vertex agree.
PolygonSoup read_obj(std::string_view text, const std::string& name);

/// Stanford: ascii, binary_little_endian, binary_big_endian, with any elements and properties in any order.
/// Triangle strips are refused.
PolygonSoup read_ply(std::string_view bytes, const std::string& name);

/// Geomview: OFF, COFF, NOFF, STOFF and their combinations, in text, with or without the first word. 4OFF,
/// nOFF and binary files are refused.
PolygonSoup read_off(std::string_view text, const std::string& name);

/// Stereolithography, text or binary; each face has three vertices of its own. The normals in the file are
/// read over: the order of the vertices says where out is.
PolygonSoup read_stl(std::string_view bytes, const std::string& name);
/// Is this a binary STL, whatever the first word? Its length says so.
bool is_binary_stl(std::string_view bytes);

/// Points as text, one a line: x y z or x y z nx ny nz, separated by blanks, commas or semicolons. A first
/// line of names (csv) may put columns in another order and among others; a first line with one whole number
/// is the number of points, and normals may then follow in a second block (pwn).
/// Columns without names that can only be colors (whole numbers from 0 to 255, some of them 16 or more) are
/// read over.
PolygonSoup read_points(std::string_view text, const std::string& name);

/// Everything else, by Assimp: all meshes of the file's scene in one, each where its node puts it.
PolygonSoup read_by_assimp(const std::filesystem::path& path);
/// Does Assimp know this ending (".glb")?
bool assimp_reads(const std::string& ending);

}  // namespace seesaw
