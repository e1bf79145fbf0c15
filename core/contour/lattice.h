// The box cut into nx x ny equal cells, and the field at all their corners.
//
// Before it: a box and how many cells.  After it: triangulation.h, which bisects where that is too coarse.
//
// Lattice coordinates (u, v) count cells: (0, 0) is the box's lower left corner, (nx, ny) its upper right
// one. All vertices ever made are dyadic fractions of a cell, which doubles hold exactly: midpoints are
// exact, and "is this point left of that edge" is never a matter of rounding between vertices.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/progress.h"
#include "core/contour/sampler.h"

namespace seesaw {

struct Lattice {
  Box<2> box;
  int nx = 0, ny = 0;  ///< cells
  double extent = 0;   ///< longest side of the box, in scene units
  double cell = 0;     ///< longer side of a cell, in scene units
  double grain = 0;    ///< how finely doubles resolve coordinates in this box, in scene units
  Values values;       ///< at corner (i, j): values[j * (nx + 1) + i]

  Index corners() const { return Index{nx + 1} * (ny + 1); }
  Index corner(int i, int j) const { return Index{j} * (nx + 1) + i; }

  /// Scene coordinates of a lattice point; the box's own sides exactly on the box.
  Point<2> position(const Point<2>& uv) const {
    return {coordinate(uv.x(), nx, box.min().x(), box.max().x()),
            coordinate(uv.y(), ny, box.min().y(), box.max().y())};
  }
  /// The reverse, up to rounding.
  Point<2> lattice_from_scene(const Point<2>& p) const {
    return {(p.x() - box.min().x()) / box.sizes().x() * nx, (p.y() - box.min().y()) / box.sizes().y() * ny};
  }

  static double coordinate(double u, int n, double low, double high) {
    // Multiplied before divided: round numbers (u = 3 of 10 cells over a length of 2) stay round.
    return u == n ? high : std::min(high, low + u * (high - low) / n);
  }
};

/// Cells as square as the box allows, `cells` of them along its longest side. The box has width and height.
inline Lattice make_lattice(const Box<2>& box, int cells) {
  Lattice lattice;
  lattice.box = box;
  lattice.extent = box.sizes().maxCoeff();
  const auto count = [&](double side) {
    return std::clamp(static_cast<int>(std::ceil(side / lattice.extent * cells - 1e-9)), 1, cells);
  };
  lattice.nx = count(box.sizes().x());
  lattice.ny = count(box.sizes().y());
  lattice.cell = std::max(box.sizes().x() / lattice.nx, box.sizes().y() / lattice.ny);
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  lattice.grain = std::numeric_limits<double>::epsilon() * largest;
  return lattice;
}

/// Fills lattice.values, some rows a batch, reporting `from` to `to` on the way.
inline void evaluate(Lattice& lattice, Sampler& sampler, const Progress& progress, double from, double to) {
  const int width = lattice.nx + 1;
  lattice.values.resize(lattice.corners());
  std::vector<double> xs(static_cast<std::size_t>(width));
  for (int i = 0; i < width; ++i)
    xs[static_cast<std::size_t>(i)] =
        Lattice::coordinate(i, lattice.nx, lattice.box.min().x(), lattice.box.max().x());
  // Large enough to fill all cores, small enough to be told to stop in time.
  const int rows = std::max(1, 65536 / width);
  Points<2> points;
  Values values;
  for (int first = 0; first <= lattice.ny; first += rows) {
    const int last = std::min(lattice.ny, first + rows - 1);
    points.resize(2, Index{last - first + 1} * width);
    Index at = 0;
    for (int j = first; j <= last; ++j) {
      const double y = Lattice::coordinate(j, lattice.ny, lattice.box.min().y(), lattice.box.max().y());
      for (int i = 0; i < width; ++i) points.col(at++) << xs[static_cast<std::size_t>(i)], y;
    }
    sampler.evaluate(points, values);
    lattice.values.segment(lattice.corner(0, first), values.size()) = values;
    report(progress, from + (to - from) * (last + 1) / (lattice.ny + 1));
  }
}

}  // namespace seesaw
