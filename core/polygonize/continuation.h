// Crawling over the surface: from the cubes of the seeds to all crossed cubes that hang together with them.
//
// Before it: a lattice, and cubes to start in.  After it: assemble.h turns crossed cubes into triangles.
//
// Bloomenthal keeps a stack of cubes; we keep a wave. All cubes of a wave are looked at together: their new
// corners make one batch for the field, evaluated in parallel, and each corner of the lattice is evaluated
// once. Crossed cubes send the next wave through their crossed faces. The result is a set of cubes, sorted:
// it depends neither on the order of the waves nor on the number of threads.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/error.h"
#include "core/polygonize/lattice.h"
#include "core/polygonize/sampler.h"

namespace seesaw {

struct CrossedCube {
  Key key;
  std::array<int, 8> corner;  ///< numbers of its corners, in the order of cube_table.h
  unsigned inside;            ///< bit c: corner c is inside
};

/// What is known of the lattice: values at corners, and the cubes that the surface crosses.
struct CrossedCubes {
  std::vector<Key> corners;
  std::vector<double> values;  ///< f at the corners; never NaN
  std::vector<CrossedCube> cubes;

  /// Puts the cubes in the order of their keys.
  void sort();
};

/// What `MemoryBound` throws.
class TooMuchMemory : public Error {
 public:
  using Error::Error;
};

/// Refuses work that would take more than its limit; the message says what to do.
class MemoryBound {
 public:
  explicit MemoryBound(std::size_t limit) : limit_(limit) {}
  /// Throws TooMuchMemory where so many bytes, with what comes later for so many crossed cubes, are beyond
  /// the limit.
  void check(std::size_t bytes, std::size_t cubes) const;
  /// Whether `check` would let it pass.
  bool allows(std::size_t bytes, std::size_t cubes) const { return total(bytes, cubes) <= limit_; }

 private:
  static std::size_t total(std::size_t bytes, std::size_t cubes);
  std::size_t limit_;
};

class Continuation {
 public:
  /// Keeps references to all three.
  Continuation(const Lattice& lattice, Sampler& sampler, const MemoryBound& memory)
      : lattice_(lattice), sampler_(sampler), memory_(memory) {}

  /// A cube to look at when `run` is called next; one outside the lattice's range is only remembered.
  /// Whether it will be: false for a cube that was looked at before, too.
  bool look_at(const Corner& cube);
  /// Follows the surface from the cubes given until nothing is left, or until more than `most_cubes` are
  /// crossed: then returns false.
  bool run(std::size_t most_cubes = ~std::size_t{0});
  /// Whether the surface wanted to leave the range.
  bool clipped() const { return !blocked_.empty(); }
  /// To call after the lattice's range has grown: what was blocked is looked at by the next `run`.
  void unblock();

  bool was_looked_at(const Corner& cube) const { return looked_at_.find(key_of(cube)) >= 0; }
  /// Whether the cube was looked at and is crossed.
  bool is_crossed(const Corner& cube) const {
    const int number = looked_at_.find(key_of(cube));
    return number >= 0 && crossed_[static_cast<std::size_t>(number)];
  }
  CrossedCubes& found() { return found_; }
  const CrossedCubes& found() const { return found_; }
  std::size_t bytes() const;
  /// Forgets crossed cubes outside of the lattice's range, which has shrunk.
  void keep_range();

 private:
  // A cube of the wave, its place among all that were looked at, its corners as far as they are known, and
  // the face that leads back to where it was seen from, -1 for a seed's.
  struct Visit {
    Key key;
    int number;
    std::array<int, 8> corner;
    int back;
  };
  void evaluate_corners();

  const Lattice& lattice_;
  Sampler& sampler_;
  const MemoryBound& memory_;
  KeyMap numbers_, looked_at_;
  std::vector<bool> crossed_;
  std::vector<Visit> wave_;
  std::vector<Key> blocked_;
  CrossedCubes found_;
};

}  // namespace seesaw
