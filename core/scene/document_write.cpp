// to_json_text and write_document, and the parts of a document as text.

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/document_json.h"
#include "core/scene/document_parts.h"
#include "core/scene/document_rules.h"
#include "core/scene/json_text.h"

namespace seesaw {

template <int Dim>
std::string json_point(const Point<Dim>& point) {
  std::string text = "[";
  for (int d = 0; d < Dim; ++d) text += (d ? ", " : "") + json_number(point[d]);
  return text + "]";
}

namespace {

/// An object on one line, member by member.
class OneLine {
 public:
  void add(std::string_view key, const std::string& json) {
    text_ += (text_.size() > 1 ? ", " : "") + json_string(key) + ": " + json;
  }
  void add(const Extras& extras) {
    for (const Extra& extra : extras) add(extra.key, extra.json);
  }
  bool empty() const { return text_.size() == 1; }
  std::string text() const { return text_ + "}"; }

 private:
  std::string text_ = "{";
};

const char* boolean(bool value) { return value ? "true" : "false"; }

void check(const std::optional<Fault>& fault, const std::string& path) {
  if (fault) throw Error(path + fault->key + ": " + fault->message);
}

}  // namespace

template <int Dim>
std::string json_line(const SceneConstraint<Dim>& each) {
  const Constraint<Dim>& c = each.constraint;
  OneLine line;
  line.add("kind", json_string(name_of(c.kind)));
  line.add("at", json_point<Dim>(c.at));
  if (c.normal) {
    // The defaults too: a shape does not change when a later version chooses others.
    line.add("normal", json_point<Dim>(c.normal->direction));
    line.add("offset", json_number(c.normal->offset));
    line.add("value", json_number(c.normal->value));
  }
  if (c.kind != ConstraintKind::boundary) line.add("value", json_number(c.value));
  if (each.highlight) line.add("highlight", boolean(true));
  if (each.highlight_normal) line.add("highlight_normal", boolean(true));
  if (!each.label.empty()) line.add("label", json_string(each.label));
  line.add(each.extras);
  return line.text();
}

namespace {

/// Empty where there is nothing to say.
template <int Dim>
std::string text_of(const Display<Dim>& display) {
  OneLine line;
  if (display.view) {
    OneLine box;
    box.add("min", json_point<Dim>(display.view->min()));
    box.add("max", json_point<Dim>(display.view->max()));
    box.add(display.view_extras);
    line.add("view", box.text());
  }
  const Display<Dim> usual;
  std::uint32_t bit = 1;
  for (const DisplaySwitch<Dim>& each : display_switches<Dim>) {
    const bool value = display.*each.member;
    if (value != usual.*each.member || (display.spelled_out & bit)) line.add(each.key, boolean(value));
    bit <<= 1;
  }
  line.add(display.extras);
  return line.empty() ? std::string() : line.text();
}

std::string text_of(const Camera& camera) {
  OneLine line;
  line.add("position", json_point<3>(camera.position));
  line.add("target", json_point<3>(camera.target));
  line.add("up", json_point<3>(camera.up));
  line.add("field_of_view", json_number(camera.field_of_view));
  line.add(camera.extras);
  return line.text();
}

}  // namespace

template <int Dim>
std::string to_json_text(const Document<Dim>& document) {
  check(fault_of(document), "");
  check(fault_of(document.display), "display.");
  std::string text = "{";
  const auto add = [&](std::string_view key, const std::string& json) {
    const std::string start = "  " + json_string(key) + ": ";
    text += (text.size() > 1 ? ",\n" : "\n") + start + json_layout(json, 2, start.size());
  };
  const auto add_words = [&](std::string_view key, const std::string& words) {
    if (!words.empty()) add(key, json_string(words));
  };
  add("seesaw", std::to_string(document_version));
  add("dimension", std::to_string(Dim));
  add_words("title", document.title);
  add_words("figure", document.figure);
  add_words("description", document.description);
  add("kernel", json_string(name_of(document.kernel)));
  add("smoothing", json_number(document.smoothing));
  if (const std::string display = text_of(document.display); !display.empty()) add("display", display);
  if constexpr (Dim == 3) {
    if (document.camera) {
      check(fault_of(*document.camera), "camera.");
      add("camera", text_of(*document.camera));
    }
  }
  for (const Extra& extra : document.extras) add(extra.key, extra.json);
  // Last, for they are many, and each on one line whatever it holds.
  text += ",\n  \"constraints\": [";
  for (std::size_t i = 0; i < document.constraints.size(); ++i) {
    check(fault_of(document.constraints[i]), "constraints[" + std::to_string(i) + "].");
    text += (i ? ",\n    " : "\n    ") + json_line(document.constraints[i]);
  }
  text += document.constraints.empty() ? "]\n}\n" : "\n  ]\n}\n";
  return text;
}

std::string to_json_text(const AnyDocument& document) {
  return std::visit([](const auto& each) { return to_json_text(each); }, document);
}

template <int Dim>
void write_document(const std::filesystem::path& path, const Document<Dim>& document) {
  write_file(path, to_json_text(document));
}

void write_document(const std::filesystem::path& path, const AnyDocument& document) {
  write_file(path, to_json_text(document));
}

template std::string json_point(const Point<2>&);
template std::string json_point(const Point<3>&);
template std::string json_line(const SceneConstraint<2>&);
template std::string json_line(const SceneConstraint<3>&);
template std::string to_json_text(const Document<2>&);
template std::string to_json_text(const Document<3>&);
template void write_document(const std::filesystem::path&, const Document<2>&);
template void write_document(const std::filesystem::path&, const Document<3>&);

}  // namespace seesaw
