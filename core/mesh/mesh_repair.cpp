#include "core/mesh/mesh_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/flat_faces.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/orientation.h"
#include "core/mesh/polygon_triangles.h"
#include "core/mesh/text_lines.h"
#include "core/mesh/vertex_normals.h"
#include "core/mesh/weld.h"

namespace seesaw {

namespace {

using Face = std::array<int, 3>;

// The soup's polygons as triangles over `name_of[v]` in place of v.
std::vector<Face> triangles_of(const PolygonSoup& soup, const std::vector<int>& name_of,
                               MeshRepairs& repairs) {
  std::vector<Face> faces;
  faces.reserve(soup.corners.size() - 2 * std::min(soup.corners.size() / 2, soup.ends.size()));
  std::vector<int> polygon;
  for (Index p = 0; p < soup.polygons(); ++p) {
    polygon.clear();
    for (const int v : soup.polygon(p))
      if (polygon.empty() || polygon.back() != name_of[slot(v)]) polygon.push_back(name_of[slot(v)]);
    while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    if (polygon.size() < 3) {
      ++repairs.degenerate_faces;
      continue;
    }
    repairs.crossing_polygons += !cut_polygon(soup.points(), polygon, faces);
  }
  if (faces.size() > std::size_t{std::numeric_limits<int>::max()} / 3)
    throw Error("a mesh of more than 715 million triangles is more than Seesaw can count");
  repairs.degenerate_faces += static_cast<Index>(
      std::erase_if(faces, [](const Face& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }));
  return faces;
}

void drop_duplicates(std::vector<Face>& faces, MeshRepairs& repairs) {
  std::vector<std::pair<Face, int>> sorted(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    sorted[f] = {faces[f], static_cast<int>(f)};
    std::sort(sorted[f].first.begin(), sorted[f].first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> twice(faces.size(), 0);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first) twice[slot(sorted[i].second)] = 1;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (!twice[f]) faces[kept++] = faces[f];
  repairs.duplicate_faces += static_cast<Index>(faces.size() - kept);
  faces.resize(kept);
}

// A mesh of all the soup's vertices and the faces that are left.
LoadedMesh build(const PolygonSoup& soup, const std::vector<int>& name_of, const RepairOptions& options) {
  LoadedMesh result;
  MeshRepairs& repairs = result.repairs;
  repairs.lines_and_points = soup.lines_and_points;
  for (std::size_t v = 0; v < name_of.size(); ++v)
    repairs.welded_vertices += name_of[v] != static_cast<int>(v);
  std::vector<Face> faces = triangles_of(soup, name_of, repairs);
  drop_duplicates(faces, repairs);
  if (const Index flat = remove_flat_faces(soup.points(), faces); flat > 0) {
    repairs.degenerate_faces += flat;
    // What is joined may lie on what was there.
    drop_duplicates(faces, repairs);
  }
  result.mesh.vertices = soup.points();
  result.mesh.faces.resize(3, static_cast<Index>(faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) result.mesh.faces(k, static_cast<Index>(f)) = faces[f][slot(k)];
  if (options.orient) {
    const OrientationReport turned = orient_faces(result.mesh);
    repairs.turned_faces = turned.turned_faces;
    repairs.turned_shells = turned.turned_patches;
    repairs.one_sided = turned.one_sided;
  }
  return result;
}

// Drops the vertices in no face, and takes the soup's normals along where they are fit to be kept.
void keep_used_vertices(const PolygonSoup& soup, const std::vector<int>& name_of, LoadedMesh& result) {
  TriangleMesh& mesh = result.mesh;
  std::vector<int> number(name_of.size(), -1);
  for (Index f = 0; f < mesh.faces.cols(); ++f)
    for (int k = 0; k < 3; ++k) number[slot(mesh.faces(k, f))] = 0;
  int used = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) {
      mesh.vertices.col(used) = Point<3>(mesh.vertices.col(static_cast<Index>(v)));
      number[v] = used++;
    } else if (name_of[v] == static_cast<int>(v)) {
      ++result.repairs.unused_vertices;
    }
  }
  mesh.vertices.conservativeResize(3, used);
  mesh.faces = mesh.faces.unaryExpr([&](int v) { return number[slot(v)]; });

  if (soup.normals.empty() || result.repairs.turned_faces + result.repairs.turned_shells > 0) return;
  const Eigen::Map<const Points<3>> given(soup.normals.data(), 3, soup.vertices());
  Points<3> normals = Points<3>::Zero(3, used);
  for (std::size_t v = 0; v < number.size(); ++v) {
    const int n = number[slot(name_of[v])];
    if (n < 0) continue;
    const Point<3> normal = Point<3>(given.col(static_cast<Index>(v))).stableNormalized();
    if (!(normal.squaredNorm() > 0.5)) return;                                 // zero, or not a number
    if (normals.col(n).squaredNorm() > 0 && normals.col(n) != normal) return;  // a crease was welded
    normals.col(n) = normal;
  }
  if (normals.cwiseProduct(vertex_normals(mesh)).sum() > 0) mesh.normals = normals;
}

}  // namespace

LoadedMesh repair(const PolygonSoup& soup, const RepairOptions& options) {
  std::vector<int> itself(slot(soup.vertices()));
  std::iota(itself.begin(), itself.end(), 0);
  std::vector<int> name_of = options.weld ? first_of_equals(soup.points()) : itself;
  LoadedMesh result = build(soup, name_of, options);
  if (result.repairs.welded_vertices > 0 && !check_mesh(result.mesh).manifold) {
    LoadedMesh unwelded = build(soup, itself, options);
    const MeshReport report = check_mesh(unwelded.mesh);
    if (report.closed && report.manifold) {
      result = std::move(unwelded);
      name_of = itself;
    }
  }
  keep_used_vertices(soup, name_of, result);
  return result;
}

LoadedMesh repair(const TriangleMesh& mesh, const RepairOptions& options) {
  PolygonSoup soup;
  soup.coordinates.assign(mesh.vertices.data(), mesh.vertices.data() + mesh.vertices.size());
  if (mesh.has_normals()) soup.normals.assign(mesh.normals.data(), mesh.normals.data() + mesh.normals.size());
  soup.corners.assign(mesh.faces.data(), mesh.faces.data() + mesh.faces.size());
  for (Index f = 1; f <= mesh.faces.cols(); ++f) soup.ends.push_back(slot(3 * f));
  return repair(soup, options);
}

bool MeshRepairs::any() const {
  const auto all = named();
  return std::any_of(all.begin(), all.end(), [](const auto& item) { return item.second != 0; });
}

std::vector<std::pair<std::string, Index>> MeshRepairs::named() const {
  return {{"welded_vertices", welded_vertices},
          {"unused_vertices", unused_vertices},
          {"degenerate_faces", degenerate_faces},
          {"duplicate_faces", duplicate_faces},
          {"crossing_polygons", crossing_polygons},
          {"lines_and_points", lines_and_points},
          {"turned_faces", turned_faces},
          {"turned_shells", turned_shells},
          {"one_sided", one_sided}};
}

std::vector<std::string> MeshRepairs::in_words() const {
  std::vector<std::string> words;
  const auto say = [&](Index n, const std::string& noun, const std::string& what) {
    if (n != 0) words.push_back(counted(n, noun) + " " + what);
  };
  say(welded_vertices, "vertex", "welded to others with equal coordinates");
  say(unused_vertices, "vertex", "dropped that no face uses");
  say(degenerate_faces, "face", "of no area removed");
  say(duplicate_faces, "face", "dropped that an earlier one repeats");
  say(crossing_polygons, "polygon", "cut somehow: the outline crosses itself");
  say(lines_and_points, "element", "dropped: a line or a point, not a face");
  say(turned_faces, "face", "turned to agree with the neighbors");
  say(turned_shells, "closed piece", "turned that was inside out");
  say(one_sided, "one-sided piece", "left as found: no turning makes it consistent");
  return words;
}

}  // namespace seesaw
