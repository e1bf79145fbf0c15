#include "core/mesh/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

using Reader = PolygonSoup (*)(std::string_view, const std::string&);

// From here on products of three coordinates may overflow, and every sign with them.
constexpr double largest_coordinate = 1e100;

std::string_view first_word(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return text.substr(begin, text.find_first_of(" \t\r\n", begin) - begin);
}

// What the content says beyond doubt.
Reader reader_by_content(std::string_view bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  const std::string_view word = first_word(text);
  if (text.starts_with("ply") && word == "ply") return read_ply;
  if (word.size() <= 8 && word.ends_with("OFF")) return read_off;
  if (is_binary_stl(bytes)) return read_stl;
  return nullptr;
}

Reader reader_by_ending(const std::string& ending) {
  if (ending == ".obj") return read_obj;
  if (ending == ".ply") return read_ply;
  if (ending == ".off") return read_off;
  if (ending == ".stl") return read_stl;
  for (const char* points : {".xyz", ".pwn", ".csv", ".txt", ".pts", ".asc", ".xyzn", ".npts"})
    if (ending == points) return read_points;
  return nullptr;
}

// A last guess at a file without a name that says anything.
Reader reader_by_first_line(std::string_view bytes) {
  TextLines lines(without_byte_order_mark(bytes).substr(0, 4096), {}, {.comment = "#", .separators = ",;"});
  if (!lines.next()) return nullptr;
  const std::string_view word = lines[0];
  if (word == "solid") return read_stl;
  for (const char* statement : {"v", "vn", "vt", "mtllib", "usemtl", "o", "g"})
    if (word == statement) return read_obj;
  return parse_number(word) ? read_points : nullptr;
}

void refuse_empty(std::string_view bytes, const std::string& name) {
  if (bytes.find_first_not_of(std::string_view(" \t\r\n\0", 5)) == std::string_view::npos)
    throw FileError(name, "is empty");
}

void refuse_utf16(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw FileError(name, "is text in UTF-16; save it as UTF-8");
}

void refuse_too_large(const PolygonSoup& soup, const std::string& name) {
  for (std::size_t i = 0; i < soup.coordinates.size(); ++i)
    if (!(std::abs(soup.coordinates[i]) <= largest_coordinate))
      throw FileError(name, "vertex " + std::to_string(i / 3) + " has the coordinate " +
                                to_text(soup.coordinates[i]) + "; beyond 1e100 nothing can be computed");
}

PointCloud cloud_of(const PolygonSoup& soup) {
  PointCloud cloud;
  cloud.points = soup.points();
  if (soup.normals.empty()) return cloud;
  cloud.normals = Eigen::Map<const Points<3>>(soup.normals.data(), 3, soup.vertices());
  for (Index i = 0; i < cloud.normals.cols(); ++i)
    if (!cloud.normals.col(i).allFinite())
      cloud.normals.col(i).setConstant(std::numeric_limits<double>::quiet_NaN());
  return cloud;
}

Model model_of(const PolygonSoup& soup, const std::string& name, const RepairOptions& options) {
  if (soup.vertices() == 0) throw FileError(name, "holds neither faces nor points");
  refuse_too_large(soup, name);
  if (soup.polygons() == 0) {
    if (soup.lines_and_points > 0) throw FileError(name, "holds lines or single points, but no faces");
    return cloud_of(soup);
  }
  LoadedMesh loaded;
  try {
    loaded = repair(soup, options);
  } catch (const Error& error) {
    throw FileError(name, error.what());
  }
  if (loaded.mesh.faces.cols() == 0) throw FileError(name, "has no face with an area");
  return loaded;
}

}  // namespace

Model parse_model(std::string_view bytes, const std::string& name, const RepairOptions& options) {
  refuse_empty(bytes, name);
  refuse_utf16(bytes, name);
  Reader reader = reader_by_content(bytes);
  if (!reader) reader = reader_by_ending(ending_of(name));
  if (!reader) reader = reader_by_first_line(bytes);
  if (!reader)
    throw FileError(name, "is of a kind that is not known here: neither OBJ, PLY, OFF, STL nor points");
  return model_of(reader(bytes, name), name, options);
}

Model read_model(const std::filesystem::path& path, const RepairOptions& options) {
  const std::string name = path.string();
  const std::string bytes = read_file(path);
  refuse_empty(bytes, name);
  const std::string ending = ending_of(name);
  const bool ours = reader_by_content(bytes) || reader_by_ending(ending);
  if (ours || ending.empty() || !assimp_reads(ending)) return parse_model(bytes, name, options);
  return model_of(read_by_assimp(path), name, options);
}

LoadedMesh read_mesh(const std::filesystem::path& path, const RepairOptions& options) {
  Model model = read_model(path, options);
  if (LoadedMesh* mesh = std::get_if<LoadedMesh>(&model)) return std::move(*mesh);
  throw FileError(path.string(), "holds points without faces, where a mesh is needed");
}

PointCloud read_point_cloud(const std::filesystem::path& path) {
  Model model = read_model(path);
  if (PointCloud* cloud = std::get_if<PointCloud>(&model)) return std::move(*cloud);
  throw FileError(path.string(), "holds faces, where a cloud of points is needed");
}

}  // namespace seesaw
