// The header of a PLY file: what is in it, in which order, and of which type.
//
// Before it: the bytes of a file.  After it: read_ply.cpp, which reads the numbers that the header announces.
//
//     ply
//     format ascii 1.0
//     element vertex 8
//     property float x
//     ...
//     element face 6
//     property list uchar int vertex_indices
//     end_header
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t size_of(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  Index count = 0;
  std::vector<PlyProperty> properties;

  /// Which property has this name, or -1.
  int find(std::string_view property) const;
  /// The fewest bytes that one element takes in a binary file.
  std::size_t least_size() const;
};

struct PlyHeader {
  enum class Format { ascii, little_endian, big_endian };
  Format format = Format::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes, with the line end_header
  int lines = 0;
};

/// Throws FileError with the line. The counts are not yet checked against the length of the file.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace seesaw
