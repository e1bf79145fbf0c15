#include "core/contour/trace.h"

namespace seesaw {
namespace {}  // namespace

// Green's theorem: half the integral of x dy - y dx around the inside region, counter-clockwise.
double inside_area(const Crossings& curve, const std::vector<Polyline>& polylines) {
  const Triangulation& mesh = curve.mesh();
  const Lattice& lattice = mesh.lattice();
  const Point<2> origin = lattice.box.center();
  double twice = 0;
  const auto add = [&](const Point<2>& a, const Point<2>& b) { twice += cross(a - origin, b - origin); };

  for (const Polyline& polyline : polylines)
    for (Index i = 0; i < polyline.segments(); ++i)
      add(polyline.vertices.col(i), polyline.vertices.col((i + 1) % polyline.vertices.cols()));

  const auto add_side = [&](int i, int j, int side, Index from, Index to) {
    if (mesh.first_triangle(i, j) < 0) {
      // A cell that was not made has one sign.
      if (mesh.inside(static_cast<int>(from)))
        add(mesh.position(static_cast<int>(from)), mesh.position(static_cast<int>(to)));
      return;
    }
    mesh.for_each_edge_on_side(i, j, side, [&](int t, int k) {
      const auto [a, b] = mesh.edge(t, k);
      Point<2> start = mesh.position(a), end = mesh.position(b);
      if (!mesh.inside(a) && !mesh.inside(b)) return;
      if (mesh.inside(a) != mesh.inside(b))
        (mesh.inside(a) ? end : start) =
            curve[mesh.triangle(t).crossing[static_cast<std::size_t>(k)]].position;
      add(start, end);
    });
  };
  const int nx = lattice.nx, ny = lattice.ny;
  for (int i = 0; i < nx; ++i) {
    add_side(i, 0, 0, lattice.corner(i, 0), lattice.corner(i + 1, 0));
    add_side(i, ny - 1, 2, lattice.corner(i + 1, ny), lattice.corner(i, ny));
  }
  for (int j = 0; j < ny; ++j) {
    add_side(nx - 1, j, 1, lattice.corner(nx, j), lattice.corner(nx, j + 1));
    add_side(0, j, 3, lattice.corner(0, j + 1), lattice.corner(0, j));
  }
  return 0.5 * twice;
}

}  // namespace seesaw
