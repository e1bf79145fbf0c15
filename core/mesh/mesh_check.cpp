#include "core/mesh/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/check.h"
#include "core/mesh/edge_table.h"

namespace seesaw {

namespace {

void count_edges(const Faces& faces, const EdgeTable& table, MeshReport& report) {
  report.edges = table.edges();
  report.closed = table.edges() > 0;
  for (Index e = 0; e < table.edges(); ++e) {
    const auto halves = table.halves(e);
    const auto n = static_cast<Index>(halves.size());
    Index forward = 0;
    for (const int h : halves) forward += start_of(faces, h) == table.ends(e).a;
    report.boundary_edges += n == 1;
    report.nonmanifold_edges += n > 2;
    report.misoriented_edges += std::abs(2 * forward - n) > n % 2;
    if (n % 2 != 0) report.closed = false;
  }
  report.oriented = report.misoriented_edges == 0;
}

// Corner 3 f + k is face f at its vertex k. Corners at one vertex that are joined across edges make a fan.
DisjointSets fans_of(const Faces& faces, const EdgeTable& table) {
  DisjointSets fans(3 * faces.cols());
  for (Index e = 0; e < table.edges(); ++e) {
    const auto halves = table.halves(e);
    const auto corner = [&](int h, int vertex) {
      return start_of(faces, h) == vertex ? h : h - h % 3 + (h + 1) % 3;
    };
    for (const int h : halves)
      for (const int vertex : {table.ends(e).a, table.ends(e).b})
        fans.unite(corner(halves[0], vertex), corner(h, vertex));
  }
  return fans;
}

void count_vertices(const Faces& faces, const EdgeTable& table, DisjointSets& fans, MeshReport& report) {
  std::vector<int> fans_at(slot(report.vertices), 0);
  for (Index c = 0; c < 3 * faces.cols(); ++c)
    if (!table.skipped(c / 3) && fans.find(c) == c) ++fans_at[slot(faces(c % 3, c / 3))];
  for (const int n : fans_at) report.nonmanifold_vertices += n > 1;
  report.manifold = report.nonmanifold_edges == 0 && report.nonmanifold_vertices == 0;
}

// The two boundary edges at either end of a fan are neighbors in one chain.
void count_boundary_loops(const EdgeTable& table, DisjointSets& fans, MeshReport& report) {
  std::vector<int> edge_at(3 * slot(report.faces), -1);  // by the fan
  DisjointSets chains(table.edges());
  for (Index e = 0; e < table.edges(); ++e) {
    const auto halves = table.halves(e);
    if (halves.size() != 1) continue;
    const int h = halves[0];
    for (const int corner : {h, h - h % 3 + (h + 1) % 3}) {
      int& other = edge_at[slot(fans.find(corner))];
      if (other >= 0) chains.unite(e, other);
      other = static_cast<int>(e);
    }
  }
  for (Index e = 0; e < table.edges(); ++e)
    report.boundary_loops += table.halves(e).size() == 1 && chains.find(e) == e;
}

// V - E + F, and the pieces.
void count_components(const Faces& faces, const EdgeTable& table, MeshReport& report) {
  DisjointSets pieces(report.vertices);
  std::vector<char> in_use(slot(report.vertices), 0), in_face(slot(report.vertices), 0);
  Index proper_faces = 0;
  for (Index f = 0; f < faces.cols(); ++f) {
    for (int k = 0; k < 3; ++k) in_face[slot(faces(k, f))] = 1;
    if (table.skipped(f)) continue;
    ++proper_faces;
    for (int k = 0; k < 3; ++k) in_use[slot(faces(k, f))] = 1;
    pieces.unite(faces(0, f), faces(1, f));
    pieces.unite(faces(0, f), faces(2, f));
  }
  Index used = 0;
  for (Index v = 0; v < report.vertices; ++v) {
    used += in_use[slot(v)];
    report.unused_vertices += !in_face[slot(v)];
    report.components += in_use[slot(v)] && pieces.find(v) == v;
  }
  report.euler_characteristic = used - report.edges + proper_faces;
  if (report.closed && report.manifold && report.oriented)
    report.genus = report.components - report.euler_characteristic / 2;
}

double angle_between(const Point<3>& u, const Point<3>& v) {
  return std::atan2(u.cross(v).norm(), u.dot(v)) * (180 / 3.141592653589793);
}

void measure(const TriangleMesh& mesh, const EdgeTable& table, MeshReport& report) {
  for (Index f = 0; f < mesh.faces.cols(); ++f)
    for (int k = 0; k < 3; ++k) report.box.extend(Point<3>(mesh.vertices.col(mesh.faces(k, f))));
  // The common point in the middle: far from the origin the terms would otherwise cancel and leave rounding.
  const Point<3> middle =
      report.box.isEmpty() ? Point<3>::Zero() : Point<3>(report.box.min() / 2 + report.box.max() / 2);
  double six_volumes = 0;
  double smallest = 180, largest = 0;
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    const Point<3> a = mesh.vertices.col(mesh.faces(0, f)) - middle;
    const Point<3> b = mesh.vertices.col(mesh.faces(1, f)) - middle;
    const Point<3> c = mesh.vertices.col(mesh.faces(2, f)) - middle;
    const double twice_area = (b - a).cross(c - a).norm();
    if (table.skipped(f) || twice_area == 0) ++report.degenerate_faces;
    if (table.skipped(f)) continue;
    report.area += twice_area / 2;
    six_volumes += a.dot(b.cross(c));
    for (const double angle :
         {angle_between(b - a, c - a), angle_between(c - b, a - b), angle_between(a - c, b - c)}) {
      smallest = std::min(smallest, angle);
      largest = std::max(largest, angle);
    }
  }
  const bool solid = report.closed && report.oriented;
  report.volume = solid ? six_volumes / 6 : std::numeric_limits<double>::quiet_NaN();
  report.smallest_angle = largest > 0 ? smallest : 0;
  report.largest_angle = largest;
}

}  // namespace

MeshReport check_mesh(const TriangleMesh& mesh) {
  SEESAW_CHECK_EQ(mesh.vertices.allFinite(), true);
  MeshReport report;
  report.vertices = mesh.vertices.cols();
  report.faces = mesh.faces.cols();
  const EdgeTable table(mesh.faces, report.vertices);
  count_edges(mesh.faces, table, report);
  DisjointSets fans = fans_of(mesh.faces, table);
  count_vertices(mesh.faces, table, fans, report);
  count_boundary_loops(table, fans, report);
  count_components(mesh.faces, table, report);
  measure(mesh, table, report);
  return report;
}

}  // namespace seesaw
