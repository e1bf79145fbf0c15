// What a command has to say, as two columns for people.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace seesaw {

/// Names and what there is to say about them.
using Table = std::vector<std::pair<std::string, std::string>>;

/// A line each, the second column aligned.
inline std::string aligned_text(const Table& table) {
  std::size_t width = 0;
  for (const auto& row : table) width = std::max(width, row.first.size());
  std::string text;
  for (const auto& [name, value] : table)
    text += name + std::string(width + 2 - name.size(), ' ') + value + "\n";
  return text;
}

/// "1 vertex", "2 vertices".
inline std::string counted(std::ptrdiff_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace seesaw
