#include "core/image/svg_text.h"

#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "core/base/text.h"

namespace seesaw {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string xml_text(std::string_view words) {
  std::string escaped;
  for (const char c : words) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else
      escaped += c;
  }
  return escaped;
}

// Only names that some id="..." declares are touched, in the three places where they can stand.
std::string renumbered(const std::string& svg) {
  std::map<std::string, std::string, std::less<>> names;
  // First all declarations, in order, since a use may stand before its declaration.
  for (std::size_t at = svg.find(" id=\""); at != std::string::npos; at = svg.find(" id=\"", at + 1)) {
    const std::size_t from = at + 5, to = svg.find('"', from);
    names.emplace(svg.substr(from, to - from), "part" + std::to_string(names.size()));
  }
  std::string result = svg;
  for (const std::string_view opening : {" id=\"", "url(#", "href=\"#"}) {
    const std::string text = std::move(result);
    result.clear();
    std::size_t done = 0;
    for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at + 1)) {
      const std::size_t from = at + opening.size(), to = text.find_first_of("\")", from);
      const auto name = names.find(std::string_view(text).substr(from, to - from));
      if (name == names.end()) continue;
      result.append(text, done, from - done).append(name->second);
      done = to;
    }
    result.append(text, done);
  }
  return result;
}

// The length of a setting that says no more than SVG's default, at the beginning of `text`; 0 for none. All
// joins are round, so that the miter's limit never counts.
std::size_t usual_setting(std::string_view text) {
  for (const std::string_view usual : {"stroke-miterlimit:10;", "fill-opacity:1;", "stroke-opacity:1;"})
    if (text.substr(0, usual.size()) == usual) return usual.size();
  return 0;
}

// Base64 has no '.', so an embedded image cannot be mistaken for a number.
std::string shortened(const std::string& svg) {
  std::string result;
  result.reserve(svg.size());
  for (std::size_t at = 0; at < svg.size();) {
    const std::size_t usual = usual_setting(std::string_view(svg).substr(at));
    if (usual > 0) {
      at += usual;
      continue;
    }
    if (!is_digit(svg[at])) {
      result += svg[at++];
      continue;
    }
    std::size_t end = at;
    while (end < svg.size() && is_digit(svg[end])) ++end;
    const std::size_t point = end;
    if (end + 1 < svg.size() && svg[end] == '.' && is_digit(svg[end + 1]))
      for (++end; end < svg.size() && is_digit(svg[end]);) ++end;
    const std::string_view number = std::string_view(svg).substr(at, end - at);
    if (end - point > 4)
      result += to_text(std::round(*parse_number(number) * 1000) / 1000, 12);
    else
      result += number;
    at = end;
  }
  return result;
}

}  // namespace

std::string tidied_svg(const std::string& svg, const std::vector<std::string>& words) {
  std::string tidy = shortened(renumbered(svg));
  const std::size_t root = tidy.find("<svg");
  if (words.empty() || root == std::string::npos) return tidy;
  std::string description = "\n<desc>";
  for (const std::string& line : words) description.append(xml_text(line)).append("\n");
  description.replace(description.size() - 1, 1, "</desc>");
  return tidy.insert(tidy.find('>', root) + 1, description);
}

}  // namespace seesaw
