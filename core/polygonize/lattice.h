// The lattice of cubes: where its corners are, and one number for each corner and cube.
//
// Before it: a box and a number of cells.  After it: continuation.h walks on it.
//
// Corners have integer coordinates 0 .. n in each of three directions; a cube is named by its lowest corner.
// Nothing is stored: of a lattice with billions of corners only those near the surface ever get a value
// (KeyMap). Cubes are cubes up to the rounding of the box's sides to whole numbers of cells.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

/// Integer coordinates of a corner or a cube.
using Corner = std::array<int, 3>;

/// 21 bits a coordinate: sorted keys run through x fastest, then y, then z.
using Key = std::uint64_t;
inline constexpr int key_bits = 21;
inline Key key_of(const Corner& c) {
  return static_cast<Key>(c[0]) | static_cast<Key>(c[1]) << key_bits |
         static_cast<Key>(c[2]) << (2 * key_bits);
}
inline Corner corner_of(Key key) {
  constexpr Key mask = (Key{1} << key_bits) - 1;
  return {static_cast<int>(key & mask), static_cast<int>(key >> key_bits & mask),
          static_cast<int>(key >> (2 * key_bits))};
}

/// A run of cubes: those with low <= coordinate < high.
struct CubeRange {
  Corner low{0, 0, 0}, high{0, 0, 0};
  bool contains(const Corner& c) const {
    for (std::size_t d = 0; d < 3; ++d)
      if (c[d] < low[d] || c[d] >= high[d]) return false;
    return true;
  }
};

struct Lattice {
  Box<3> box;              ///< the lattice ends on its faces, exactly
  Corner n{0, 0, 0};       ///< cubes in each direction
  Point<3> step{1, 1, 1};  ///< sides of a cube, scene units
  CubeRange range;         ///< the cubes that the surface may use; all of them unless something narrows it

  double cell() const { return step.maxCoeff(); }
  double coordinate(std::size_t d, int i) const {
    const Index e = static_cast<Index>(d);
    return i == n[d] ? box.max()[e] : box.min()[e] + i * step[e];
  }
  Point<3> position(const Corner& c) const {
    return {coordinate(0, c[0]), coordinate(1, c[1]), coordinate(2, c[2])};
  }
  /// The cube that holds `point`, or the nearest one.
  Corner cube_at(const Point<3>& point) const {
    Corner c{};
    for (std::size_t d = 0; d < 3; ++d) {
      const Index e = static_cast<Index>(d);
      const double at = std::floor((point[e] - box.min()[e]) / step[e]);
      c[d] = at >= n[d] ? n[d] - 1 : at > 0 ? static_cast<int>(at) : 0;
    }
    return c;
  }
};

/// From keys to numbers 0, 1, 2 ... in the order in which the keys came. An open table with linear probing.
class KeyMap {
 public:
  explicit KeyMap(std::size_t expected = 1024) {
    std::size_t size = 1024;
    while (size < 2 * expected) size *= 2;
    slots_.assign(size, {none, -1});
  }
  int size() const { return size_; }
  std::size_t bytes() const { return slots_.size() * sizeof(Slot); }
  /// The key's number, or -1.
  int find(Key key) const {
    for (std::size_t s = start(key);; s = (s + 1) & (slots_.size() - 1)) {
      if (slots_[s].key == key) return slots_[s].number;
      if (slots_[s].key == none) return -1;
    }
  }
  /// The key's number; a new one when it had none, which is then `size() - 1`.
  int insert(Key key) {
    std::size_t s = start(key);
    for (; slots_[s].key != none; s = (s + 1) & (slots_.size() - 1))
      if (slots_[s].key == key) return slots_[s].number;
    slots_[s] = {key, size_++};
    if (static_cast<std::size_t>(size_) * 5 > slots_.size() * 3) grow();
    return size_ - 1;
  }

 private:
  struct Slot {
    Key key;
    int number;
  };
  static constexpr Key none = ~Key{0};
  std::size_t start(Key key) const {
    key *= 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio: neighbors in space land far apart
    return static_cast<std::size_t>(key ^ key >> 32) & (slots_.size() - 1);
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size(), {none, -1});
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.key != none) {
        std::size_t s = start(slot.key);
        while (slots_[s].key != none) s = (s + 1) & (slots_.size() - 1);
        slots_[s] = slot;
      }
  }

  std::vector<Slot> slots_;
  int size_ = 0;
};

}  // namespace seesaw
