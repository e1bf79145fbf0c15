// Models from files, and into files.
//
// Before it: whatever somebody scanned, modeled or polygonized.
// After it: a TriangleMesh or a PointCloud; mesh_check.h says what it is worth.
//
// Reading: OBJ, PLY (text and both binary orders), OFF, STL (text and binary), and by Assimp what else it
// knows (glTF, Collada, 3DS, FBX ...); oriented points as .xyz, .pwn, .csv, or as PLY (or OBJ, OFF) without
// faces. What the first bytes say counts more than the name. A mesh is repaired (mesh_repair.h) and the
// repairs are reported. What is wrong in a way that no repair can know about ends with a FileError that names
// the line or the element: numbers that are not numbers, infinite or beyond 1e100, indices out of range,
// headers that promise more than follows.
//
// Writing is all or nothing (core/base/file.h). A locale changes nothing, neither way.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "core/mesh/mesh_repair.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

using Model = std::variant<LoadedMesh, PointCloud>;

/// A mesh if the file has faces, else a point cloud. Throws FileError.
Model read_model(const std::filesystem::path& path, const RepairOptions& options = {});

/// The same from memory, without Assimp; `name` is what errors call it, and its ending helps where the
/// content does not say what it is.
Model parse_model(std::string_view bytes, const std::string& name, const RepairOptions& options = {});

/// As read_model; refuses points without faces.
LoadedMesh read_mesh(const std::filesystem::path& path, const RepairOptions& options = {});

/// As read_model; refuses a file with faces. Points in one place are all kept, with the normals of each.
PointCloud read_point_cloud(const std::filesystem::path& path);

struct WriteOptions {
  /// PLY and STL as text. In binary, PLY has doubles and loses nothing; STL has floats.
  bool text = false;
};

/// By the ending of `path`: .obj, .ply, .stl or .off. Normals are written where the mesh has them (STL has
/// one a face, which is worked out). Text has 17 digits, so that reading gives back the same numbers. Throws
/// FileError, also for coordinates that a binary STL has no room for.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const WriteOptions& options = {});

/// By the ending of `path`: .xyz, .pwn, .csv or .ply. Normals that are not known are written as "nan".
void write_point_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                       const WriteOptions& options = {});

/// What write_mesh would write: `ending` with its dot, in lower case. Throws Error for any other.
std::string mesh_bytes(const TriangleMesh& mesh, const std::string& ending, const WriteOptions& options = {});
std::string point_cloud_bytes(const PointCloud& cloud, const std::string& ending,
                              const WriteOptions& options = {});

}  // namespace seesaw
