#include "core/polygonize/continuation.h"

#include <algorithm>

#include "core/polygonize/cube_table.h"

namespace seesaw {

namespace {

// What a crossed cube costs on its way to a mesh: some 1.2 vertices and 2.4 triangles, each with its place in
// the nets that assemble.h and improve.h build. Measured at 500 to 600 bytes.
constexpr std::size_t bytes_per_cube = 640;

// Added to a cube's key, the keys of its corners in the order of cube_table.h.
constexpr std::array<Key, 8> corner_steps = [] {
  std::array<Key, 8> steps{};
  for (Key c = 0; c < 8; ++c) steps[c] = (c & 1) | (c >> 1 & 1) << key_bits | (c >> 2) << (2 * key_bits);
  return steps;
}();

constexpr std::array<int, 8> unknown = {-1, -1, -1, -1, -1, -1, -1, -1};

}  // namespace

std::size_t MemoryBound::total(std::size_t bytes, std::size_t cubes) {
  return bytes + cubes * bytes_per_cube;
}

void MemoryBound::check(std::size_t bytes, std::size_t cubes) const {
  if (allows(bytes, cubes)) return;
  const auto megabytes = [](std::size_t n) { return std::to_string((n + 999'999) / 1'000'000); };
  throw TooMuchMemory("the surface crosses " + std::to_string(cubes) +
                      " cubes or more, and its mesh would take over " + megabytes(total(bytes, cubes)) +
                      " MB where " + megabytes(limit_) +
                      " MB are allowed: use fewer cells or allow more memory");
}

void CrossedCubes::sort() {
  std::sort(cubes.begin(), cubes.end(),
            [](const CrossedCube& a, const CrossedCube& b) { return a.key < b.key; });
}

std::size_t Continuation::bytes() const {
  return numbers_.bytes() + looked_at_.bytes() + found_.corners.capacity() * sizeof(Key) +
         found_.values.capacity() * sizeof(double) + found_.cubes.capacity() * sizeof(CrossedCube) +
         wave_.capacity() * sizeof(Visit) + blocked_.capacity() * sizeof(Key);
}

bool Continuation::look_at(const Corner& cube) {
  const Key key = key_of(cube);
  if (!lattice_.range.contains(cube)) {
    blocked_.push_back(key);
    return false;
  }
  const int known = looked_at_.size();
  if (looked_at_.insert(key) != known) return false;
  wave_.push_back({key, known, unknown, -1});
  crossed_.push_back(false);
  return true;
}

void Continuation::unblock() {
  std::vector<Key> blocked;
  blocked.swap(blocked_);
  for (const Key key : blocked) look_at(corner_of(key));
}

void Continuation::keep_range() {
  std::erase_if(found_.cubes,
                [&](const CrossedCube& cube) { return !lattice_.range.contains(corner_of(cube.key)); });
}

// Gives every corner of the wave's cubes a number and a value.
void Continuation::evaluate_corners() {
  const std::size_t known = found_.corners.size();
  for (Visit& visit : wave_)
    for (std::size_t c = 0; c < 8; ++c) {
      if (visit.corner[c] >= 0) continue;
      const Key corner = visit.key + corner_steps[c];
      visit.corner[c] = numbers_.insert(corner);
      if (visit.corner[c] == static_cast<int>(found_.corners.size())) found_.corners.push_back(corner);
    }
  Points<3> points(3, static_cast<Index>(found_.corners.size() - known));
  for (Index i = 0; i < points.cols(); ++i)
    points.col(i) = lattice_.position(corner_of(found_.corners[known + static_cast<std::size_t>(i)]));
  const Values values = sampler_.values(points);
  found_.values.insert(found_.values.end(), values.data(), values.data() + values.size());
}

bool Continuation::run(std::size_t most_cubes) {
  while (!wave_.empty()) {
    memory_.check(bytes(), found_.cubes.size());
    if (found_.cubes.size() > most_cubes) return false;
    evaluate_corners();
    std::vector<Visit> wave;
    wave.swap(wave_);
    for (const Visit& visit : wave) {
      CrossedCube crossed{visit.key, visit.corner, 0};
      for (int c = 0; c < 8; ++c)
        if (is_inside(found_.values[static_cast<std::size_t>(visit.corner[static_cast<std::size_t>(c)])]))
          crossed.inside |= 1u << c;
      if (crossed.inside == 0 || crossed.inside == 255) continue;
      crossed_[static_cast<std::size_t>(visit.number)] = true;
      found_.cubes.push_back(crossed);
      const unsigned faces = crossed_faces(crossed.inside);
      for (int face = 0; face < 6; ++face) {
        if (!(faces >> face & 1u) || face == visit.back) continue;
        const unsigned axis = static_cast<unsigned>(face) / 2, side = static_cast<unsigned>(face) % 2;
        Corner next = corner_of(visit.key);
        next[axis] += side == 1 ? 1 : -1;
        if (!look_at(next)) continue;
        // It shares the face's corners, which have their numbers.
        Visit& seen = wave_.back();
        seen.back = face ^ 1;
        for (unsigned c = 0; c < 8; ++c)
          if ((c >> axis & 1u) == side) seen.corner[c ^ 1u << axis] = visit.corner[c];
      }
    }
  }
  return true;
}

}  // namespace seesaw
