#include "sandbox2d/plate_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/contour/lattice.h"
#include "core/contour/roots.h"
#include "core/image/colormap.h"
#include "core/image/theme.h"
#include "core/scene/field_layer.h"

namespace seesaw {

namespace {

constexpr int plate_levels = 3;  // -limit, 0, limit
constexpr int plate_bands = 4;   // below, between and above them

// The grid, the places where its edges pass a level, and the mesh that becomes of both.
class PlateMaker {
 public:
  PlateMaker(const Field<2>& field, const Box<2>& box, const PlateOptions& options)
      : field_(field), options_(options), lattice_(make_lattice(box, options.cells)) {
    PlateSpace& space = plate_.space;
    space.center = box.center();
    space.scale = 2 / lattice_.extent;
    space.z_scale = options.relief / options.height;
    space.limit = options.headroom * options.height;
    level_ = {-space.limit, 0, space.limit};
  }

  PlateMesh make() {
    evaluate_corners();
    choose_diagonals();
    find_crossings();
    for (int j = 0; j < lattice_.ny; ++j)
      for (int i = 0; i < lattice_.nx; ++i) cell(i, j);
    lines();
    finish();
    return std::move(plate_);
  }

 private:
  // Edges of cell (i, j): along x and along y from its lower left corner, and its diagonal. Those of the last
  // row and column belong to cells beyond the box.
  enum EdgeKind { along_x, along_y, diagonal };
  Index edge_index(int i, int j, EdgeKind kind) const { return 3 * lattice_.corner(i, j) + kind; }

  struct Edge {
    Index from, to;  // corners
    Index index;
  };
  Edge edge(int i, int j, EdgeKind kind) const {
    const Index here = lattice_.corner(i, j), right = here + 1, above = here + lattice_.nx + 1;
    switch (kind) {
      case along_x:
        return {here, right, edge_index(i, j, kind)};
      case along_y:
        return {here, above, edge_index(i, j, kind)};
      default:
        break;
    }
    if (falling_[slot(here)]) return {right, above, edge_index(i, j, kind)};
    return {here, above + 1, edge_index(i, j, kind)};
  }

  void evaluate_corners() {
    points_.resize(2, lattice_.corners());
    for (int j = 0; j <= lattice_.ny; ++j)
      for (int i = 0; i <= lattice_.nx; ++i)
        points_.col(lattice_.corner(i, j)) = lattice_.position(Point<2>(i, j));
    values_.resize(points_.cols());
    gradients_.resize(2, points_.cols());
    field_.evaluate(points_, values_, gradients_);
    for (const double f : values_) plate_.nonfinite += !std::isfinite(f);
    corner_vertex_.assign(slot(plate_bands * points_.cols()), -1);
  }

  // The diagonal whose ends differ less lies better on a bent plate.
  void choose_diagonals() {
    falling_.assign(slot(points_.cols()), false);
    for (int j = 0; j < lattice_.ny; ++j)
      for (int i = 0; i < lattice_.nx; ++i) {
        const Index here = lattice_.corner(i, j), above = here + lattice_.nx + 1;
        falling_[slot(here)] =
            std::abs(values_[here + 1] - values_[above]) < std::abs(values_[here] - values_[above + 1]);
      }
  }

  // All edges at once for each level, zero first: where an edge passes zero and a limit, the zero bounds the
  // search for the limit, so that the two come in order.
  void find_crossings() {
    crossing_of_.assign(slot(plate_levels * 3 * points_.cols()), -1);
    std::vector<Edge> edges;
    for (int j = 0; j <= lattice_.ny; ++j)
      for (int i = 0; i <= lattice_.nx; ++i) {
        if (i < lattice_.nx) edges.push_back(edge(i, j, along_x));
        if (j < lattice_.ny) edges.push_back(edge(i, j, along_y));
        if (i < lattice_.nx && j < lattice_.ny) edges.push_back(edge(i, j, diagonal));
      }
    for (const int level : {1, 0, 2}) find_crossings_of(level, edges);
  }

  void find_crossings_of(int level, const std::vector<Edge>& edges) {
    const double at = level_[slot(level)];
    std::vector<Edge> passing;
    for (const Edge& e : edges) {
      const double a = values_[e.from] - at, b = values_[e.to] - at;
      if (std::isfinite(a) && std::isfinite(b) && ((a < 0 && b > 0) || (a > 0 && b < 0)))
        passing.push_back(e);
    }
    const auto n = static_cast<Index>(passing.size());
    Points<2> inside(2, n), outside(2, n);
    Values inside_values(n), outside_values(n);
    for (Index k = 0; k < n; ++k) {
      const Edge& e = passing[slot(k)];
      const bool up = values_[e.to] > values_[e.from];
      const Index high = up ? e.to : e.from, low = up ? e.from : e.to;
      inside.col(k) = points_.col(high);
      inside_values[k] = values_[high] - at;
      outside.col(k) = points_.col(low);
      outside_values[k] = values_[low] - at;
      const int zero = level == 1 ? -1 : crossing(e.index, 1);
      if (zero < 0) continue;
      if (level == 2) {
        outside.col(k) = crossings_[slot(zero)].at;
        outside_values[k] = -at;
      } else {
        inside.col(k) = crossings_[slot(zero)].at;
        inside_values[k] = -at;
      }
    }
    Sampler sampler(field_, at);
    const Roots roots =
        find_roots(sampler, inside, outside, inside_values, outside_values, 1e-9 * lattice_.cell);
    for (Index k = 0; k < n; ++k) {
      crossing_of_[slot(plate_levels * passing[slot(k)].index + level)] = static_cast<int>(crossings_.size());
      crossings_.push_back({roots.positions.col(k), roots.gradients.col(k), level, {-1, -1}});
    }
  }

  int crossing(Index edge, int level) const { return crossing_of_[slot(plate_levels * edge + level)]; }

  // Vertices, made when first asked for.

  int vertex(const Point<2>& p, double value, const Point<2>& gradient, int band) {
    const PlateSpace& space = plate_.space;
    const int side = band >= 2 ? 1 : -1;
    const bool flat = band == 0 || band == 3;
    vertices_.push_back(space.at(p, value));
    const double steepness = flat ? 0 : space.z_scale / space.scale;
    normals_.push_back(Point<3>(-steepness * gradient.x(), -steepness * gradient.y(), 1).normalized());
    if (!normals_.back().allFinite()) normals_.back() = Point<3>::UnitZ();
    plate_.colors.push_back(plate_color(value, space.limit, side));
    return static_cast<int>(vertices_.size()) - 1;
  }
  int corner_vertex(Index corner, int band) {
    int& known = corner_vertex_[slot(plate_bands * corner + band)];
    if (known < 0) known = vertex(points_.col(corner), values_[corner], gradients_.col(corner), band);
    return known;
  }
  int crossing_vertex(int which, int band) {
    Crossing& c = crossings_[slot(which)];
    int& known = c.vertex[slot(band - c.level)];
    if (known < 0) {
      const double value = level_[slot(c.level)];
      const Point<2> at = c.at, gradient = c.gradient;
      known = vertex(at, value, gradient, band);
    }
    return known;
  }

  void cell(int i, int j) {
    const Index here = lattice_.corner(i, j), right = here + 1, above = here + lattice_.nx + 1,
                across = above + 1;
    const Edge bottom = edge(i, j, along_x), left = edge(i, j, along_y), top = edge(i, j + 1, along_x),
               far = edge(i + 1, j, along_y), slant = edge(i, j, diagonal);
    if (falling_[slot(here)]) {
      triangle({here, right, above}, {bottom.index, slant.index, left.index});
      triangle({right, across, above}, {far.index, top.index, slant.index});
    } else {
      triangle({here, right, across}, {bottom.index, far.index, slant.index});
      triangle({here, across, above}, {slant.index, top.index, left.index});
    }
  }

  // Corners counterclockwise; edge k leads from corner k to the next. What of it lies in one band is a convex
  // polygon: corners in that band, and crossings with the band's two levels, in the order of a walk around
  // it.
  void triangle(const std::array<Index, 3>& corners, const std::array<Index, 3>& edges) {
    double low = infinity, high = -infinity;
    for (const Index c : corners) {
      if (!std::isfinite(values_[c])) return;
      low = std::min(low, values_[c]);
      high = std::max(high, values_[c]);
    }
    for (int band = 0; band < plate_bands; ++band) {
      const double floor = band == 0 ? -infinity : level_[slot(band - 1)],
                   ceiling = band == plate_levels ? infinity : level_[slot(band)];
      // Land level with a boundary belongs to the band above it.
      const bool here = low == high ? floor <= low && low < ceiling : low < ceiling && high > floor;
      if (!here) continue;
      std::array<int, 6> ring{};
      std::size_t n = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = corners[k], b = corners[(k + 1) % 3];
        if (floor <= values_[a] && values_[a] <= ceiling) ring[n++] = corner_vertex(a, band);
        const bool rising = values_[b] > values_[a];
        for (const int level : {rising ? band - 1 : band, rising ? band : band - 1}) {
          if (level < 0 || level >= plate_levels) continue;
          if (const int c = crossing(edges[k], level); c >= 0) ring[n++] = crossing_vertex(c, band);
        }
      }
      for (std::size_t k = 2; k < n; ++k) faces_.push_back({ring[0], ring[k - 1], ring[k]});
    }
    zero_segment(corners, edges);
  }

  // Where zero runs along an edge of the grid it is drawn by the triangle above it, if there is one.
  void zero_segment(const std::array<Index, 3>& corners, const std::array<Index, 3>& edges) {
    std::array<Point<2>, 3> ends;
    std::size_t n = 0;
    bool above = false, below = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const double f = values_[corners[k]];
      above = above || f > 0;
      below = below || f < 0;
      if (f == 0) ends[n++] = points_.col(corners[k]);
      if (const int c = crossing(edges[k], 1); c >= 0 && n < 3) ends[n++] = crossings_[slot(c)].at;
    }
    if (n != 2 || !above) return;
    zero_.push_back(plate_.space.at(ends[0], 0));
    zero_.push_back(plate_.space.at(ends[1], 0));
  }

  // Every few cells, along edges of the mesh and over their crossings.
  void lines() {
    const int every = options_.lines_every;
    if (every <= 0) return;
    const auto drawn = [every](int k, int last) { return k == 0 || k == last || k % every == 0; };
    for (int j = 0; j <= lattice_.ny; ++j)
      for (int i = 0; i <= lattice_.nx; ++i) {
        if (i < lattice_.nx && drawn(j, lattice_.ny)) line(edge(i, j, along_x));
        if (j < lattice_.ny && drawn(i, lattice_.nx)) line(edge(i, j, along_y));
      }
  }

  void line(const Edge& e) {
    const double a = values_[e.from], b = values_[e.to];
    if (!std::isfinite(a) || !std::isfinite(b)) return;
    Point<3> last = plate_.space.at(points_.col(e.from), a);
    double value = a;
    const auto go_on = [&](const Point<2>& p, double f) {
      const Point<3> next = plate_.space.at(p, f);
      // Of one side each, so that a line does not turn gray on its way through the shore.
      const int side = value + f >= 0 ? 1 : -1;
      for (const auto& [end, z] : {std::pair(last, value), std::pair(next, f)}) {
        grid_.push_back(end);
        plate_.grid_colors.push_back(mix(plate_color(z, plate_.space.limit, side), theme::ink, 0.30));
      }
      last = next;
      value = f;
    };
    for (const int level : {b > a ? 0 : 2, 1, b > a ? 2 : 0})
      if (const int c = crossing(e.index, level); c >= 0) go_on(crossings_[slot(c)].at, level_[slot(level)]);
    go_on(points_.col(e.to), b);
  }

  static Points<3> columns(const std::vector<Point<3>>& points) {
    Points<3> result(3, static_cast<Index>(points.size()));
    for (std::size_t k = 0; k < points.size(); ++k) result.col(static_cast<Index>(k)) = points[k];
    return result;
  }

  void finish() {
    plate_.mesh.vertices = columns(vertices_);
    plate_.mesh.normals = columns(normals_);
    plate_.mesh.faces.resize(3, static_cast<Index>(faces_.size()));
    for (std::size_t k = 0; k < faces_.size(); ++k)
      plate_.mesh.faces.col(static_cast<Index>(k)) << faces_[k][0], faces_[k][1], faces_[k][2];
    plate_.grid = columns(grid_);
    plate_.zero = columns(zero_);
    if (vertices_.empty()) return;
    plate_.lowest = plate_.mesh.vertices.row(2).minCoeff();
    plate_.highest = plate_.mesh.vertices.row(2).maxCoeff();
  }

  struct Crossing {
    Point<2> at, gradient;
    int level;
    std::array<int, 2> vertex;  // of the band below the level and of the one above
  };

  const Field<2>& field_;
  const PlateOptions& options_;
  Lattice lattice_;
  std::array<double, plate_levels> level_{};
  PlateMesh plate_;
  Points<2> points_, gradients_;  // at corners of the grid
  Values values_;
  std::vector<bool> falling_;     // a cell's diagonal: from its lower right corner to its upper left one
  std::vector<int> crossing_of_;  // three levels an edge; -1 for none
  std::vector<Crossing> crossings_;
  std::vector<int> corner_vertex_;  // four bands a corner
  std::vector<Point<3>> vertices_, normals_, grid_, zero_;
  std::vector<std::array<int, 3>> faces_;
};

}  // namespace

Color plate_color(double value, double limit, int side) {
  constexpr double shore = 0.14, full = 0.9, full_at = 0.6;
  const double depth = std::min(1.0, std::abs(color_depth(value, full_at * limit)));
  return diverging_color(side * (shore + (full - shore) * depth));
}

double typical_height(const Field<2>& field, const Document<2>& document, const Box<2>& seen) {
  double height = 0;
  Box<2> among;
  for (const SceneConstraint<2>& each : document.constraints) {
    const Constraint<2>& c = each.constraint;
    if (!seen.contains(c.at)) continue;
    among.extend(c.at);
    if (c.kind != ConstraintKind::boundary && std::isfinite(c.value))
      height = std::max(height, std::abs(c.value));
  }
  if (among.isEmpty() || !(among.sizes().minCoeff() > 0)) among = seen;
  constexpr Index n = 24;
  Points<2> points(2, n * n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      points.col(j * n + i) =
          among.min() + among.sizes().cwiseProduct(
                            Point<2>((static_cast<double>(i) + 0.5) / n, (static_cast<double>(j) + 0.5) / n));
  std::vector<double> sizes;
  for (const double f : field.values(points))
    if (std::isfinite(f)) sizes.push_back(std::abs(f));
  if (!sizes.empty()) {
    const auto tenth = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::nth_element(sizes.begin(), tenth, sizes.end());
    height = std::max(height, *tenth);
  }
  return height > 0 ? height : 1;
}

PlateMesh make_plate(const Field<2>& field, const Box<2>& box, const PlateOptions& options) {
  if (box.isEmpty() || !box.sizes().allFinite() || !(box.sizes().minCoeff() > 0))
    throw Error("a plate needs a box with width and height");
  if (options.cells < 1 || !(options.height > 0) || !(options.relief > 0) || !(options.headroom > 0))
    throw Error("a plate needs at least one cell, and a height, relief and headroom above zero");
  return PlateMaker(field, box, options).make();
}

}  // namespace seesaw
