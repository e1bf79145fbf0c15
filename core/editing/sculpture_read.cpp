// parse_sculpture and read_sculpture.

#include <algorithm>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/editing/sculpture.h"
#include "core/scene/document_parts.h"
#include "core/scene/json_members.h"

namespace seesaw {

namespace {

/// Every member is known, or a comment.
void refuse_the_rest(JsonValue object, Members& members) {
  members.find("comment");
  for (const Extra& extra : members.extras()) object.refuse(extra.key, "is not known here");
}

double positive(JsonValue value) {
  const double number = value.number();
  if (!(number > 0)) value.refuse("expected a number above 0, found " + to_text(number));
  return number;
}

template <class Take>
void each(Members& members, std::string_view key, const Take& take) {
  const JsonValue list = members.need(key, "an array of objects");
  if (list.type() != JsonType::array)
    list.refuse(std::string("expected an array, found ") + list.description());
  list.each_item(take);
}

}  // namespace

Sculpture parse_sculpture(std::string_view text, const std::string& name) {
  const JsonTape tape = parse_json(text, name);
  const JsonValue root(tape);
  Members members(root);
  const JsonValue version = members.need("seesaw_sculpture", "its version, 1");
  if (version.number() != 1) version.refuse("is a version that this program does not know; it knows 1");
  Sculpture result;
  members.read("title", result.title);
  if (const auto threshold = members.find("threshold")) result.threshold = positive(*threshold);
  if (const auto radius = members.find("desired_radius")) result.desired_radius = positive(*radius);
  std::vector<Point<3>> ends[2];
  std::vector<double> deviations;
  each(members, "cylinders", [&](JsonValue each_value) {
    Members cylinder(each_value);
    ends[0].push_back(point_of<3>(cylinder.need("from", "3 numbers")));
    ends[1].push_back(point_of<3>(cylinder.need("to", "3 numbers")));
    deviations.push_back(positive(cylinder.need("deviation", "a number above 0")));
    refuse_the_rest(each_value, cylinder);
  });
  if (deviations.empty()) root.refuse("cylinders", "is empty: expected at least one cylinder");
  result.starts.resize(3, static_cast<Index>(deviations.size()));
  result.ends.resize(3, static_cast<Index>(deviations.size()));
  result.deviations = Eigen::Map<const Values>(deviations.data(), static_cast<Index>(deviations.size()));
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    result.starts.col(static_cast<Index>(i)) = ends[0][i];
    result.ends.col(static_cast<Index>(i)) = ends[1][i];
  }
  const std::vector<std::string> names =
      ParametricBlobbyCylinders<3>(BlobbyCylinders<3>(0.5, result.starts, result.ends, result.deviations))
          .names();
  if (const auto frozen = members.find("frozen")) {
    if (frozen->type() != JsonType::array)
      frozen->refuse(std::string("expected an array of names, found ") + frozen->description());
    frozen->each_item([&](JsonValue each_value) {
      const std::string its(each_value.text());
      if (std::find(names.begin(), names.end(), its) == names.end())
        each_value.refuse("no parameter has this name; there are " + names.front() + ", " + names[1] +
                          " .. " + names.back());
      result.frozen.push_back(its);
    });
  }
  each(members, "drags", [&](JsonValue each_value) {
    Members drag(each_value);
    result.drags.push_back(
        {point_of<3>(drag.need("grab", "3 numbers")), point_of<3>(drag.need("to", "3 numbers"))});
    refuse_the_rest(each_value, drag);
  });
  refuse_the_rest(root, members);
  return result;
}

Sculpture read_sculpture(const std::filesystem::path& path) {
  return parse_sculpture(read_file(path, JsonLimits().bytes), path.string());
}

}  // namespace seesaw
