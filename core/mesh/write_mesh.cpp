// Meshes and point clouds as bytes of a file.
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

using Column = Eigen::Ref<const Point<3>>;

void append_number(std::string& text, double value) {
  // A NaN has a sign, which no reader cares for.
  if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 17).ptr;
  text.append(buffer.data(), end);
}

void append_numbers(std::string& text, const Column& p, char between = ' ') {
  for (int d = 0; d < 3; ++d) {
    if (d > 0) text += between;
    append_number(text, p[d]);
  }
}

void append_line(std::string& text, const char* word, const Column& p) {
  append_numbers(text += word, p);
  text += '\n';
}

template <class Unsigned>
void append_little_endian(std::string& bytes, Unsigned value) {
  for (std::size_t k = 0; k < sizeof(value); ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFF);
}
void append_double(std::string& bytes, double value) {
  append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
}
void append_float(std::string& bytes, double value) {
  append_little_endian(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}
void append_index(std::string& bytes, int value) {
  append_little_endian(bytes, static_cast<std::uint32_t>(value));
}

std::string obj_of(const TriangleMesh& mesh) {
  std::string text =
      "# " + counted(mesh.vertices.cols(), "vertex") + ", " + counted(mesh.faces.cols(), "face") + "\n";
  for (Index v = 0; v < mesh.vertices.cols(); ++v) append_line(text, "v ", mesh.vertices.col(v));
  for (Index v = 0; v < mesh.normals.cols(); ++v) append_line(text, "vn ", mesh.normals.col(v));
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    text += 'f';
    for (int k = 0; k < 3; ++k) {
      const std::string number = std::to_string(mesh.faces(k, f) + 1);
      (text += ' ') += number;
      if (mesh.has_normals()) (text += "//") += number;
    }
    text += '\n';
  }
  return text;
}

std::string off_of(const TriangleMesh& mesh) {
  std::string text = mesh.has_normals() ? "NOFF\n" : "OFF\n";
  text += std::to_string(mesh.vertices.cols()) + " " + std::to_string(mesh.faces.cols()) + " 0\n";
  for (Index v = 0; v < mesh.vertices.cols(); ++v) {
    append_numbers(text, mesh.vertices.col(v));
    if (mesh.has_normals()) append_numbers(text += ' ', mesh.normals.col(v));
    text += '\n';
  }
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    text += '3';
    for (int k = 0; k < 3; ++k) (text += ' ') += std::to_string(mesh.faces(k, f));
    text += '\n';
  }
  return text;
}

std::string ply_of(const Points<3>& points, const Points<3>& normals, const Faces& faces, bool text) {
  const bool has_normals = normals.cols() > 0;
  std::string bytes = std::string("ply\nformat ") + (text ? "ascii" : "binary_little_endian") +
                      " 1.0\nelement vertex " + std::to_string(points.cols()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    if (name[0] != 'n' || has_normals) bytes += std::string("property double ") + name + "\n";
  if (faces.cols() > 0)
    bytes += "element face " + std::to_string(faces.cols()) + "\nproperty list uchar int vertex_indices\n";
  bytes += "end_header\n";
  for (Index v = 0; v < points.cols(); ++v) {
    if (text) {
      append_numbers(bytes, points.col(v));
      if (has_normals) append_numbers(bytes += ' ', normals.col(v));
      bytes += '\n';
    } else {
      for (int d = 0; d < 3; ++d) append_double(bytes, points(d, v));
      for (int d = 0; d < 3 && has_normals; ++d) append_double(bytes, normals(d, v));
    }
  }
  for (Index f = 0; f < faces.cols(); ++f) {
    bytes += text ? '3' : '\3';
    for (int k = 0; k < 3; ++k) {
      if (text)
        (bytes += ' ') += std::to_string(faces(k, f));
      else
        append_index(bytes, faces(k, f));
    }
    if (text) bytes += '\n';
  }
  return bytes;
}

std::string stl_of(const TriangleMesh& mesh, bool text) {
  if (!text && mesh.vertices.size() > 0 &&
      mesh.vertices.cwiseAbs().maxCoeff() > double{std::numeric_limits<float>::max()})
    throw Error("a binary STL has floats, and a coordinate of this mesh is beyond 3.4e38");
  std::string bytes = text ? "solid seesaw\n" : std::string(80, ' ');
  if (!text) append_index(bytes, static_cast<int>(mesh.faces.cols()));
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    const auto corner = [&](int k) -> Point<3> { return mesh.vertices.col(mesh.faces(k, f)); };
    const Point<3> normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized();
    if (text) {
      append_numbers(bytes += "facet normal ", normal);
      bytes += "\n outer loop\n";
      for (int k = 0; k < 3; ++k) append_line(bytes, "  vertex ", corner(k));
      bytes += " endloop\nendfacet\n";
    } else {
      for (int d = 0; d < 3; ++d) append_float(bytes, normal[d]);
      for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d) append_float(bytes, corner(k)[d]);
      bytes.append(2, '\0');
    }
  }
  return text ? bytes + "endsolid seesaw\n" : bytes;
}

// One point a line; the normal behind it.
std::string rows_of(const PointCloud& cloud, char between) {
  std::string text;
  for (Index i = 0; i < cloud.points.cols(); ++i) {
    append_numbers(text, cloud.points.col(i), between);
    if (cloud.has_normals()) append_numbers(text += between, cloud.normals.col(i), between);
    text += '\n';
  }
  return text;
}

std::string pwn_of(const PointCloud& cloud) {
  std::string text = std::to_string(cloud.points.cols()) + "\n" + rows_of({cloud.points, {}}, ' ');
  return cloud.has_normals() ? text + rows_of({cloud.normals, {}}, ' ') : text;
}

}  // namespace

std::string mesh_bytes(const TriangleMesh& mesh, const std::string& ending, const WriteOptions& options) {
  SEESAW_CHECK_EQ(mesh.vertices.allFinite(), true);
  if (mesh.normals.cols() > 0) SEESAW_CHECK_EQ(mesh.normals.cols(), mesh.vertices.cols());
  if (ending == ".obj") return obj_of(mesh);
  if (ending == ".off") return off_of(mesh);
  if (ending == ".ply") return ply_of(mesh.vertices, mesh.normals, mesh.faces, options.text);
  if (ending == ".stl") return stl_of(mesh, options.text);
  throw Error("expected a name that ends in .obj, .ply, .stl or .off");
}

std::string point_cloud_bytes(const PointCloud& cloud, const std::string& ending,
                              const WriteOptions& options) {
  SEESAW_CHECK_EQ(cloud.points.allFinite(), true);
  if (cloud.normals.cols() > 0) SEESAW_CHECK_EQ(cloud.normals.cols(), cloud.points.cols());
  if (ending == ".xyz") return rows_of(cloud, ' ');
  if (ending == ".pwn") return pwn_of(cloud);
  if (ending == ".csv") return (cloud.has_normals() ? "x,y,z,nx,ny,nz\n" : "x,y,z\n") + rows_of(cloud, ',');
  if (ending == ".ply") return ply_of(cloud.points, cloud.normals, Faces(3, 0), options.text);
  throw Error("expected a name that ends in .xyz, .pwn, .csv or .ply");
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, const WriteOptions& options) {
  std::string bytes;
  try {
    bytes = mesh_bytes(mesh, ending_of(path), options);
  } catch (const Error& error) {
    throw FileError(path.string(), error.what());
  }
  write_file(path, bytes);
}

void write_point_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                       const WriteOptions& options) {
  std::string bytes;
  try {
    bytes = point_cloud_bytes(cloud, ending_of(path), options);
  } catch (const Error& error) {
    throw FileError(path.string(), error.what());
  }
  write_file(path, bytes);
}

}  // namespace seesaw
