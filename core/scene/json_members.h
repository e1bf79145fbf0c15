// An object of a JSON file, read member by member; what nobody asked for is kept or refused.
//
// Before it: core/scene/json_tape.h.  After it: core/scene/document_read.cpp, core/editing/session_read.cpp.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/document.h"
#include "core/scene/document_rules.h"
#include "core/scene/json_tape.h"

namespace seesaw {

/// An object whose members are asked for by name; what nobody asked for are its extras.
class Members {
 public:
  explicit Members(JsonValue object) : object_(object) {
    if (object.type() != JsonType::object)
      object.refuse(std::string("expected an object, found ") + object.description());
  }

  std::optional<JsonValue> find(std::string_view key) {
    asked_.push_back(key);
    return object_.find(key);
  }
  JsonValue need(std::string_view key, const std::string& expected) {
    if (const auto value = find(key)) return *value;
    object_.refuse(key, "is missing: expected " + expected);
  }
  void read(std::string_view key, std::string& into) {
    if (const auto value = find(key)) into = value->text();
  }
  void read(std::string_view key, double& into) {
    if (const auto value = find(key)) into = value->number();
  }
  void read(std::string_view key, bool& into) {
    if (const auto value = find(key)) into = value->boolean();
  }

  Extras extras() const {
    Extras result;
    object_.each_member([&](std::string_view key, JsonValue value) {
      if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        result.push_back({std::string(key), value.json()});
    });
    return result;
  }

  /// Throws the fault, if there is one, with the line and path of its key.
  void check(const std::optional<Fault>& fault) const {
    if (fault) object_.refuse(fault->key, fault->message);
  }

 private:
  JsonValue object_;
  std::vector<std::string_view> asked_;
};

}  // namespace seesaw
