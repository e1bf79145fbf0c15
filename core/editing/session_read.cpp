// parse_session and read_session.

#include <map>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/editing/session.h"
#include "core/scene/document_parts.h"
#include "core/scene/json_members.h"

namespace seesaw {

namespace {

/// The members of an object of which every one is known.
class Strict {
 public:
  explicit Strict(JsonValue object) : object_(object), members_(object) { members_.find("comment"); }

  JsonValue need(std::string_view key, const char* expected) { return members_.need(key, expected); }
  std::optional<JsonValue> find(std::string_view key) { return members_.find(key); }

  std::string comment() {
    std::string text;
    members_.read("comment", text);
    return text;
  }
  /// To be asked at the end.
  void refuse_the_rest() const {
    for (const Extra& extra : members_.extras()) object_.refuse(extra.key, "is not known here");
  }

  template <int Dim>
  Point<Dim> point(std::string_view key) {
    return point_of<Dim>(need(key, Dim == 2 ? "2 numbers" : "3 numbers"));
  }
  double number(std::string_view key) { return need(key, "a number").number(); }

  Index index(std::string_view key = "which") { return index_of(need(key, "the index of a constraint")); }
  std::vector<Index> indices() {
    const JsonValue value = need("which", "the index of a constraint, or an array of them");
    if (value.type() != JsonType::array) return {index_of(value)};
    std::vector<Index> result;
    result.reserve(value.size());
    value.each_item([&](JsonValue item) { result.push_back(index_of(item)); });
    return result;
  }

 private:
  static Index index_of(JsonValue value) {
    const double number = value.number();
    // Beyond are no exact integers, and no constraints.
    if (value.type() != JsonType::natural || number > 1e15)
      value.refuse("expected the index of a constraint (0, 1, ...), found " + to_text(number));
    return static_cast<Index>(number);
  }

  JsonValue object_;
  Members members_;
};

template <int Dim>
Add<Dim> add_of(Strict& s) {
  const JsonValue list = s.need("constraints", "an array of constraints");
  if (list.type() != JsonType::array)
    list.refuse(std::string("expected an array of constraints, found ") + list.description());
  if (list.size() == 0) list.refuse("expected at least one constraint");
  Add<Dim> add;
  list.each_item([&](JsonValue each) { add.constraints.push_back(scene_constraint_of<Dim>(each)); });
  return add;
}

template <int Dim>
AddOnSurface<Dim> add_on_surface_of(Strict& s) {
  AddOnSurface<Dim> add;
  add.from = s.point<Dim>("from");
  if constexpr (Dim == 3) {
    const JsonValue direction = s.need("direction", "3 numbers");
    add.direction = point_of<3>(direction);
    if (add.direction.isZero(0)) direction.refuse("the zero vector has no direction");
  }
  return add;
}

template <int Dim>
Move<Dim> move_of(Strict& s) {
  Move<Dim> move;
  move.which = s.indices();
  move.by = s.point<Dim>("by");
  return move;
}

SetValue set_value_of(Strict& s) {
  SetValue set;
  set.which = s.indices();
  set.value = s.number("value");
  return set;
}

SetKind set_kind_of(Strict& s) {
  SetKind set;
  set.which = s.indices();
  set.kind = kind_of(s.need("kind", "\"boundary\", \"interior\" or \"exterior\""));
  if (const auto value = s.find("value")) set.value = value->number();
  return set;
}

template <int Dim>
TurnNormal<Dim> turn_normal_of(Strict& s) {
  TurnNormal<Dim> turn{s.index(), s.point<Dim>("direction"), std::nullopt};
  if (const auto value = s.find("value")) turn.value = value->number();
  return turn;
}

AddNormal add_normal_of(Strict& s) {
  AddNormal add{s.index(), std::nullopt};
  if (const auto offset = s.find("offset")) add.offset = offset->number();
  return add;
}

// One line a command: what stands in a file under "do", and what is read from the rest.
template <int Dim>
const auto& readers() {
  using A = Action<Dim>;
  using Reader = Command<Dim> (*)(Strict&);
  static const std::map<std::string_view, Reader> all = {
      {"add", [](Strict& s) -> Command<Dim> { return A(add_of<Dim>(s)); }},
      {"add_on_surface", [](Strict& s) -> Command<Dim> { return A(add_on_surface_of<Dim>(s)); }},
      {"move", [](Strict& s) -> Command<Dim> { return A(move_of<Dim>(s)); }},
      {"move_to",
       [](Strict& s) -> Command<Dim> {
         return A(MoveTo<Dim>{s.index(), s.point<Dim>("to")});
       }},
      {"delete", [](Strict& s) -> Command<Dim> { return A(Delete{s.indices()}); }},
      {"set_value", [](Strict& s) -> Command<Dim> { return A(set_value_of(s)); }},
      {"set_kind", [](Strict& s) -> Command<Dim> { return A(set_kind_of(s)); }},
      {"add_normal", [](Strict& s) -> Command<Dim> { return A(add_normal_of(s)); }},
      {"set_normal",
       [](Strict& s) -> Command<Dim> {
         return A(SetNormal<Dim>{s.index(), {s.point<Dim>("normal"), s.number("offset"), s.number("value")}});
       }},
      {"turn_normal", [](Strict& s) -> Command<Dim> { return A(turn_normal_of<Dim>(s)); }},
      {"remove_normal", [](Strict& s) -> Command<Dim> { return A(RemoveNormal{s.indices()}); }},
      {"set_kernel",
       [](Strict& s) -> Command<Dim> {
         return A(SetKernel{kernel_of(s.need("kernel", "a kernel's name"))});
       }},
      {"set_smoothing", [](Strict& s) -> Command<Dim> { return A(SetSmoothing{s.number("smoothing")}); }},
      {"restore",
       [](Strict& s) -> Command<Dim> {
         return A(Restore<Dim>{document_of<Dim>(s.need("document", "a document"))});
       }},
      {"undo", [](Strict&) -> Command<Dim> { return Undo{}; }},
      {"redo", [](Strict&) -> Command<Dim> { return Redo{}; }},
      {"begin", [](Strict&) -> Command<Dim> { return BeginGesture{}; }},
      {"end", [](Strict&) -> Command<Dim> { return EndGesture{}; }},
      {"cancel", [](Strict&) -> Command<Dim> { return CancelGesture{}; }},
      {"label",
       [](Strict& s) -> Command<Dim> { return Label{std::string(s.need("text", "a string").text())}; }},
  };
  return all;
}

template <int Dim>
RecordedCommand<Dim> command_of(JsonValue value) {
  Strict members(value);
  const JsonValue what = members.need("do", "the name of an action");
  const auto found = readers<Dim>().find(what.text());
  if (found == readers<Dim>().end()) {
    std::string known;
    for (const auto& [name, reader] : readers<Dim>())
      known += (known.empty() ? "" : ", ") + std::string(name);
    what.refuse("expected one of " + known);
  }
  RecordedCommand<Dim> result{found->second(members), members.comment(), value.line()};
  members.refuse_the_rest();
  return result;
}

template <int Dim>
Session<Dim> session_of(Strict& members, const std::string& name) {
  Session<Dim> session;
  session.name = name;
  session.comment = members.comment();
  if (const auto title = members.find("title")) session.title = title->text();
  session.start = document_of<Dim>(members.need("start", "the document that it begins with"));
  const JsonValue actions = members.need("actions", "an array of actions");
  if (actions.type() != JsonType::array)
    actions.refuse(std::string("expected an array of actions, found ") + actions.description());
  session.commands.reserve(actions.size());
  actions.each_item([&](JsonValue each) { session.commands.push_back(command_of<Dim>(each)); });
  members.refuse_the_rest();
  return session;
}

/// `wanted` is 2, 3, or 0 for either.
AnySession parse(std::string_view text, const std::string& name, int wanted) {
  const JsonTape tape = parse_json(text, name);
  const JsonValue top(tape);
  const auto version = top.find("seesaw_session");
  if (!version)
    top.refuse(std::string("is not a recorded session: one is an object with \"seesaw_session\": 1") +
               (top.find("seesaw") ? "; this is a document" : ""));
  const double number = version->number();
  if (number > session_version)
    version->refuse("was made by a newer Seesaw (version " + to_text(number) + "; this one reads up to " +
                    std::to_string(session_version) + ")");
  if (number != session_version) version->refuse("expected the version, 1, found " + to_text(number));
  Strict members(top);
  members.find("seesaw_session");
  const JsonValue value = members.need("dimension", "2 or 3");
  const int dimension = dimension_of(value);
  if (wanted != 0 && dimension != wanted)
    value.refuse("this is a " + std::to_string(dimension) + "D session, expected a " +
                 std::to_string(wanted) + "D one");
  if (dimension == 2) return session_of<2>(members, name);
  return session_of<3>(members, name);
}

AnySession read(const std::filesystem::path& path, int wanted) {
  return parse(read_file(path, JsonLimits().bytes), path.string(), wanted);
}

}  // namespace

AnySession parse_session(std::string_view text, const std::string& name) { return parse(text, name, 0); }

AnySession read_session(const std::filesystem::path& path) { return read(path, 0); }

template <int Dim>
Session<Dim> read_session(const std::filesystem::path& path) {
  return std::get<Session<Dim>>(read(path, Dim));
}

template Session<2> read_session(const std::filesystem::path&);
template Session<3> read_session(const std::filesystem::path&);

}  // namespace seesaw
