#include "core/mesh/ply_header.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

std::optional<PlyType> type_named(std::string_view name) {
  constexpr std::pair<std::string_view, PlyType> types[] = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  for (const auto& [word, type] : types)
    if (word == name) return type;
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view lines, const std::string& name)
      : lines_(lines, name, {.comment = {}, .separators = {}}) {}

  PlyHeader read() {
    lines_.next();  // "ply"
    bool format = false;
    while (lines_.next()) {
      const std::string_view word = lines_[0];
      if (word == "comment" || word == "obj_info") continue;
      if (word == "end_header") {
        if (!format) lines_.fail("the header has no line \"format ...\"");
        header_.lines = lines_.line();
        return std::move(header_);
      }
      if (word == "format") {
        read_format();
        format = true;
      } else if (word == "element") {
        read_element();
      } else if (word == "property") {
        read_property();
      } else {
        lines_.fail("expected element, property, comment or end_header, found " + in_quotes(word));
      }
    }
    lines_.fail("the file ends before end_header");
  }

 private:
  void read_format() {
    const std::string_view word = lines_.size() > 1 ? lines_[1] : std::string_view();
    if (word == "ascii")
      header_.format = PlyHeader::Format::ascii;
    else if (word == "binary_little_endian")
      header_.format = PlyHeader::Format::little_endian;
    else if (word == "binary_big_endian")
      header_.format = PlyHeader::Format::big_endian;
    else
      lines_.fail("expected format ascii, binary_little_endian or binary_big_endian, found " + in_quotes(word));
  }

  void read_element() {
    if (lines_.size() != 3) lines_.fail("expected element, a name and a number");
    PlyElement element;
    element.name = lines_[1];
    const long long count = lines_.integer(2, "the number of elements");
    if (count < 0) lines_.fail("the number of elements is negative");
    element.count = count;
    for (const PlyElement& other : header_.elements)
      if (other.name == element.name) lines_.fail("the element " + in_quotes(element.name) + " is there twice");
    header_.elements.push_back(std::move(element));
  }

  PlyType type(std::size_t word) const {
    const auto found = type_named(lines_[word]);
    if (!found)
      lines_.fail("unknown type " + in_quotes(lines_[word]) + "; expected char, uchar, short ... double");
    return *found;
  }

  void read_property() {
    if (header_.elements.empty()) lines_.fail("a property before the first element");
    PlyProperty property;
    property.list = lines_.size() > 1 && lines_[1] == "list";
    if (lines_.size() != (property.list ? 5u : 3u))
      lines_.fail("expected property, a type and a name, or property list, two types and a name");
    if (property.list) {
      property.count_type = type(2);
      if (!is_integer(property.count_type)) lines_.fail("the length of a list must be a whole number");
    }
    property.type = type(property.list ? 3 : 1);
    property.name = lines_[property.list ? 4 : 2];
    if (header_.elements.back().find(property.name) >= 0)
      lines_.fail("the property " + in_quotes(property.name) + " is there twice");
    header_.elements.back().properties.push_back(std::move(property));
  }

  TextLines lines_;
  PlyHeader header_;
};

// Where the bytes after the line end_header begin, or npos. The header's own first line says how its lines
// end: what looks like one more line feed behind a lone CR may be the first byte of the data.
std::size_t end_of_header(std::string_view bytes) {
  const std::size_t first = bytes.find_first_of("\r\n");
  if (first == std::string_view::npos) return first;
  const std::string_view ending = bytes.substr(first).starts_with("\r\n") ? "\r\n" : bytes.substr(first, 1);
  std::size_t begin = 0;
  while (begin < bytes.size()) {
    const std::size_t end = std::min(bytes.find(ending, begin), bytes.size());
    std::string_view line = bytes.substr(begin, end - begin);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\t' || line.back() == '\r'))
      line.remove_suffix(1);
    begin = std::min(end + ending.size(), bytes.size());
    if (line == "end_header") return begin;
  }
  return std::string_view::npos;
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool is_integer(PlyType type) { return type < PlyType::float32; }

int PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return static_cast<int>(i);
  return -1;
}

std::size_t PlyElement::least_size() const {
  std::size_t size = 0;
  for (const PlyProperty& property : properties)
    size += size_of(property.list ? property.count_type : property.type);
  return size;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with("ply") || bytes.size() < 4 ||
      std::string_view(" \t\r\n").find(bytes[3]) == std::string_view::npos)
    throw FileError(name, 1, "is no PLY file: its first line is not \"ply\"");
  const std::size_t end = end_of_header(bytes);
  PlyHeader header = HeaderReader(bytes.substr(0, std::min(end, bytes.size())), name).read();
  header.size = std::min(end, bytes.size());
  return header;
}

}  // namespace seesaw
