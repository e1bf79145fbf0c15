#include "core/polygonize/scan.h"

#include "core/polygonize/cube_table.h"

namespace seesaw {

namespace {

// The corners of one height z, x fastest.
struct Layer {
  Values values;
  std::vector<int> numbers;  // among the corners of the result; -1 for one that no crossed cube has
};

}  // namespace

CrossedCubes scan(const Lattice& lattice, Sampler& sampler, const MemoryBound& memory) {
  const CubeRange& range = lattice.range;
  const int nx = range.high[0] - range.low[0], ny = range.high[1] - range.low[1];
  const std::size_t row = static_cast<std::size_t>(nx) + 1,
                    corners = row * (static_cast<std::size_t>(ny) + 1);
  // Two layers of values and numbers, one of points.
  const std::size_t layer_bytes = corners * (2 * (sizeof(double) + sizeof(int)) + 3 * sizeof(double));
  memory.check(layer_bytes, 0);

  CrossedCubes found;
  Points<3> points(3, static_cast<Index>(corners));
  const auto layer_at = [&](int z) {
    Index i = 0;
    for (int y = range.low[1]; y <= range.high[1]; ++y)
      for (int x = range.low[0]; x <= range.high[0]; ++x) points.col(i++) = lattice.position({x, y, z});
    return Layer{sampler.values(points), std::vector<int>(corners, -1)};
  };
  Layer below = layer_at(range.low[2]);
  for (int z = range.low[2]; z < range.high[2]; ++z) {
    Layer above = layer_at(z + 1);
    for (int y = range.low[1]; y < range.high[1]; ++y)
      for (int x = range.low[0]; x < range.high[0]; ++x) {
        const std::size_t first =
            static_cast<std::size_t>(y - range.low[1]) * row + static_cast<std::size_t>(x - range.low[0]);
        const auto place = [&](int c) {
          return first + static_cast<std::size_t>(c & 1) + (c >> 1 & 1 ? row : std::size_t{0});
        };
        CrossedCube cube{key_of({x, y, z}), {}, 0};
        for (int c = 0; c < 8; ++c)
          if (is_inside((c >> 2 ? above : below).values[static_cast<Index>(place(c))]))
            cube.inside |= 1u << c;
        if (cube.inside == 0 || cube.inside == 255) continue;
        for (int c = 0; c < 8; ++c) {
          Layer& layer = c >> 2 ? above : below;
          int& number = layer.numbers[place(c)];
          if (number < 0) {
            number = static_cast<int>(found.corners.size());
            found.corners.push_back(key_of({x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)}));
            found.values.push_back(layer.values[static_cast<Index>(place(c))]);
          }
          cube.corner[static_cast<std::size_t>(c)] = number;
        }
        found.cubes.push_back(cube);
      }
    memory.check(layer_bytes + found.corners.capacity() * (sizeof(Key) + sizeof(double)) +
                     found.cubes.capacity() * sizeof(CrossedCube),
                 found.cubes.size());
    below = std::move(above);
  }
  return found;
}

bool crosses_range(const Lattice& lattice, const CrossedCubes& found) {
  for (const CrossedCube& cube : found.cubes) {
    const Corner at = corner_of(cube.key);
    const unsigned faces = crossed_faces(cube.inside);
    for (std::size_t d = 0; d < 3; ++d)
      if ((at[d] == lattice.range.low[d] && (faces >> (2 * d) & 1u)) ||
          (at[d] + 1 == lattice.range.high[d] && (faces >> (2 * d + 1) & 1u)))
        return true;
  }
  return false;
}

}  // namespace seesaw
