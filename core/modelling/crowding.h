// Keeps rows of the system apart that a solver could not tell from each other.
//
// Before it: model_constraints.h, vertex by vertex.  After it: constraints whose matrix has an inverse.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

/// Points, found again by a grid of cells as large as the distance that is asked about.
class Crowding {
 public:
  /// `distance` > 0; positions should be of size 1 or so.
  explicit Crowding(double distance) : distance_(distance) {}

  /// The first point within the distance of `at`, but not at the very same position (to 1e-11); false if
  /// there is none. `same` says whether one is there exactly.
  bool near(const Point<3>& at, bool* same = nullptr) const {
    constexpr double coincident = 1e-11;
    bool found = false;
    if (same) *same = false;
    const Cell middle = cell(at);
    for (int i = 0; i < 27; ++i) {
      const Cell each{middle.x + i % 3 - 1, middle.y + i / 3 % 3 - 1, middle.z + i / 9 - 1};
      const auto range = grid_.equal_range(key(each));
      for (auto entry = range.first; entry != range.second; ++entry) {
        const double d = (entry->second - at).norm();
        if (d <= coincident && same) *same = true;
        if (d > coincident && d < distance_) found = true;
      }
    }
    return found;
  }
  void add(const Point<3>& at) { grid_.emplace(key(cell(at)), at); }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  Cell cell(const Point<3>& at) const {
    const auto whole = [&](double x) { return static_cast<std::int64_t>(std::floor(x / distance_)); };
    return {whole(at.x()), whole(at.y()), whole(at.z())};
  }
  // Cells that share a key are told apart by the distance.
  static std::uint64_t key(const Cell& c) {
    return static_cast<std::uint64_t>(c.x) * 0x9E3779B97F4A7C15u ^
           static_cast<std::uint64_t>(c.y) * 0xC2B2AE3D27D4EB4Fu ^
           static_cast<std::uint64_t>(c.z) * 0x165667B19E3779F9u;
  }

  double distance_;
  std::unordered_multimap<std::uint64_t, Point<3>> grid_;
};

}  // namespace seesaw
