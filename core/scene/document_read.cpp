// parse_document and read_document, and the parts of a document: from the tape to checked data.

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/scene/document_json.h"
#include "core/scene/document_parts.h"
#include "core/scene/json_members.h"

namespace seesaw {

namespace {

template <int Dim>
std::string example_point() {
  return Dim == 2 ? "2 numbers such as [0, 1]" : "3 numbers such as [0, 1, 0]";
}

}  // namespace

template <int Dim>
Point<Dim> point_of(JsonValue value) {
  if (value.type() != JsonType::array)
    value.refuse("expected " + example_point<Dim>() + ", found " + value.description());
  if (value.size() != Dim)
    value.refuse("expected " + std::to_string(Dim) + " numbers, found " + std::to_string(value.size()));
  Point<Dim> point;
  int d = 0;
  value.each_item([&](JsonValue item) { point[d++] = item.number(); });
  return point;
}

ConstraintKind kind_of(JsonValue value) {
  const std::string_view word = value.text();
  for (const ConstraintKind kind :
       {ConstraintKind::boundary, ConstraintKind::interior, ConstraintKind::exterior})
    if (word == name_of(kind)) return kind;
  value.refuse("expected \"boundary\", \"interior\" or \"exterior\"");
}

template <int Dim>
SceneConstraint<Dim> scene_constraint_of(JsonValue value) {
  Members members(value);
  SceneConstraint<Dim> result;
  Constraint<Dim>& c = result.constraint;
  c.kind = kind_of(members.need("kind", "\"boundary\", \"interior\" or \"exterior\""));
  c.at = point_of<Dim>(members.need("at", example_point<Dim>()));
  const auto normal = members.find("normal"), offset = members.find("offset"), number = members.find("value");
  const std::string owner = std::string("belongs to a boundary constraint, this one is ") + name_of(c.kind);
  switch (c.kind) {
    case ConstraintKind::boundary:
      if (normal) {
        c.normal.emplace();
        c.normal->direction = point_of<Dim>(*normal);
        if (offset) c.normal->offset = offset->number();
        if (number) c.normal->value = number->number();
      } else {
        if (offset) offset->refuse("belongs to a normal: add a \"normal\" or take the \"offset\" away");
        if (number && number->number() != 0)
          number->refuse(
              "a boundary constraint is 0 by definition: add the \"normal\" that this value belongs to, or "
              "make the kind "
              "\"interior\" or \"exterior\"");
      }
      break;
    case ConstraintKind::interior:
    case ConstraintKind::exterior:
      if (normal) normal->refuse(owner);
      if (offset) offset->refuse(owner);
      c.value = number ? number->number() : c.kind == ConstraintKind::interior ? 1.0 : -1.0;
      break;
  }
  members.read("highlight", result.highlight);
  members.read("highlight_normal", result.highlight_normal);
  members.read("label", result.label);
  result.extras = members.extras();
  members.check(fault_of(result));
  return result;
}

namespace {

template <int Dim>
void read_view(JsonValue value, Display<Dim>& into) {
  Members members(value);
  const Point<Dim> min = point_of<Dim>(members.need("min", example_point<Dim>()));
  const Point<Dim> max = point_of<Dim>(members.need("max", example_point<Dim>()));
  into.view = Box<Dim>(min, max);
  into.view_extras = members.extras();
}

template <int Dim>
Display<Dim> display_of(JsonValue value) {
  Members members(value);
  Display<Dim> result;
  if (const auto view = members.find("view")) read_view(*view, result);
  std::uint32_t bit = 1;
  for (const DisplaySwitch<Dim>& each : display_switches<Dim>) {
    const bool usual = result.*each.member;
    members.read(each.key, result.*each.member);
    if (value.find(each.key) && result.*each.member == usual) result.spelled_out |= bit;
    bit <<= 1;
  }
  result.extras = members.extras();
  members.check(fault_of(result));
  return result;
}

Camera camera_of(JsonValue value) {
  Members members(value);
  Camera result;
  result.position = point_of<3>(members.need("position", example_point<3>()));
  result.target = point_of<3>(members.need("target", example_point<3>()));
  if (const auto up = members.find("up")) result.up = point_of<3>(*up);
  members.read("field_of_view", result.field_of_view);
  result.extras = members.extras();
  members.check(fault_of(result));
  return result;
}

}  // namespace

Kernel kernel_of(JsonValue value) {
  if (const auto kernel = kernel_named(value.text())) return *kernel;
  std::string known;
  for (const Kernel kernel : all_kernels)
    known += (known.empty() ? "\"" : ", \"") + std::string(name_of(kernel)) + "\"";
  value.refuse("expected one of " + known);
}

namespace {

template <int Dim>
Document<Dim> body_of(Members& members) {
  Document<Dim> result;
  members.read("title", result.title);
  members.read("figure", result.figure);
  members.read("description", result.description);
  if (const auto kernel = members.find("kernel")) result.kernel = kernel_of(*kernel);
  members.read("smoothing", result.smoothing);
  if (const auto display = members.find("display")) result.display = display_of<Dim>(*display);
  if constexpr (Dim == 3) {
    if (const auto camera = members.find("camera")) result.camera = camera_of(*camera);
  }
  const JsonValue constraints = members.need("constraints", "an array of constraints");
  if (constraints.type() != JsonType::array)
    constraints.refuse(std::string("expected an array of constraints, found ") + constraints.description());
  result.constraints.reserve(constraints.size());
  constraints.each_item(
      [&](JsonValue each) { result.constraints.push_back(scene_constraint_of<Dim>(each)); });
  result.extras = members.extras();
  members.check(fault_of(result));
  return result;
}

/// Is this a document, of a version that can be read?
void check_version(JsonValue top) {
  if (!top.find("seesaw"))
    top.refuse("is not a Seesaw document: one is an object with \"seesaw\": " +
               std::to_string(document_version));
  const JsonValue version = *top.find("seesaw");
  const double number = version.number();
  if (number > document_version)
    version.refuse("was made by a newer Seesaw (version " + to_text(number) + "; this one reads up to " +
                   std::to_string(document_version) + ")");
  if (number != document_version)
    version.refuse("expected the version, " + std::to_string(document_version) + ", found " +
                   to_text(number));
}

}  // namespace

int dimension_of(JsonValue value) {
  const double dimension = value.number();
  if (dimension != 2 && dimension != 3) value.refuse("expected 2 or 3, found " + to_text(dimension));
  return static_cast<int>(dimension);
}

namespace {

/// `wanted` is 2, 3, or 0 for either.
AnyDocument any_document_of(JsonValue top, int wanted) {
  check_version(top);
  Members members(top);
  members.find("seesaw");
  const JsonValue value = members.need("dimension", "2 or 3");
  const int dimension = dimension_of(value);
  if (wanted != 0 && dimension != wanted)
    value.refuse("this is a " + std::to_string(dimension) + "D document, expected a " +
                 std::to_string(wanted) + "D one");
  if (dimension == 2) return body_of<2>(members);
  return body_of<3>(members);
}

AnyDocument parse(std::string_view text, const std::string& name, int wanted) {
  const JsonTape tape = parse_json(text, name);
  return any_document_of(JsonValue(tape), wanted);
}

std::string file_text(const std::filesystem::path& path) { return read_file(path, JsonLimits().bytes); }

}  // namespace

template <int Dim>
Document<Dim> document_of(JsonValue value) {
  return std::get<Document<Dim>>(any_document_of(value, Dim));
}

AnyDocument parse_document(std::string_view text, const std::string& name) { return parse(text, name, 0); }

template <int Dim>
Document<Dim> parse_document(std::string_view text, const std::string& name) {
  return std::get<Document<Dim>>(parse(text, name, Dim));
}

AnyDocument read_document(const std::filesystem::path& path) {
  return parse_document(file_text(path), path.string());
}

template <int Dim>
Document<Dim> read_document(const std::filesystem::path& path) {
  return parse_document<Dim>(file_text(path), path.string());
}

template Point<2> point_of(JsonValue);
template Point<3> point_of(JsonValue);
template SceneConstraint<2> scene_constraint_of(JsonValue);
template SceneConstraint<3> scene_constraint_of(JsonValue);
template Document<2> document_of(JsonValue);
template Document<3> document_of(JsonValue);
template Document<2> parse_document(std::string_view, const std::string&);
template Document<3> parse_document(std::string_view, const std::string&);
template Document<2> read_document(const std::filesystem::path&);
template Document<3> read_document(const std::filesystem::path&);

}  // namespace seesaw
