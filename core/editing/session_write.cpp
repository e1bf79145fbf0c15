// to_json_text and write_session.

#include <cmath>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/editing/session.h"
#include "core/scene/document_json.h"
#include "core/scene/document_parts.h"
#include "core/scene/document_rules.h"
#include "core/scene/json_text.h"

namespace seesaw {

namespace {

/// `text`, its lines behind the first one `columns` further in.
std::string indented(const std::string& text, std::size_t columns) {
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result.append(columns, ' ');
  }
  return result;
}

template <int Dim>
std::string document_text(const Document<Dim>& document, std::size_t columns) {
  std::string text = to_json_text(document);
  text.pop_back();  // The newline at the end.
  return indented(text, columns);
}

/// The members behind "do", of one command.
template <int Dim>
class Writer {
 public:
  std::string text() const { return text_ + "}"; }
  void add(std::string_view key, const std::string& json) {
    text_ += (text_.size() > 1 ? ", " : "") + json_string(key) + ": " + json;
  }

  void operator()(const Action<Dim>& action) { std::visit(*this, action); }
  void operator()(const Add<Dim>& a) {
    if (a.constraints.empty()) throw Error("constraints: expected at least one constraint");
    std::string list;
    for (std::size_t i = 0; i < a.constraints.size(); ++i) {
      if (const auto fault = fault_of(a.constraints[i]))
        throw Error("constraints[" + std::to_string(i) + "]." + fault->key + ": " + fault->message);
      list += (i ? ",\n      " : "") + json_line(a.constraints[i]);
    }
    add("constraints", a.constraints.size() == 1 ? "[" + list + "]" : "[\n      " + list + "\n    ]");
  }
  void operator()(const AddOnSurface<Dim>& a) {
    point("from", a.from);
    if (Dim == 3) direction("direction", a.direction);
  }
  void operator()(const Move<Dim>& a) { which(a.which), point("by", a.by); }
  void operator()(const MoveTo<Dim>& a) { which(a.which), point("to", a.to); }
  void operator()(const Delete& a) { which(a.which); }
  void operator()(const SetValue& a) { which(a.which), number("value", a.value); }
  void operator()(const SetKind& a) {
    which(a.which);
    add("kind", json_string(name_of(a.kind)));
    if (a.value) number("value", *a.value);
  }
  void operator()(const AddNormal& a) {
    which(a.which);
    if (a.offset) number("offset", *a.offset);
  }
  void operator()(const SetNormal<Dim>& a) {
    which(a.which);
    point("normal", a.normal.direction);
    number("offset", a.normal.offset);
    number("value", a.normal.value);
  }
  void operator()(const TurnNormal<Dim>& a) {
    which(a.which);
    point("direction", a.direction);
    if (a.value) number("value", *a.value);
  }
  void operator()(const RemoveNormal& a) { which(a.which); }
  void operator()(const SetKernel& a) { add("kernel", json_string(name_of(a.kernel))); }
  void operator()(const SetSmoothing& a) { number("smoothing", a.smoothing); }
  void operator()(const Restore<Dim>& a) { add("document", document_text(a.document, 4)); }
  void operator()(const Undo&) {}
  void operator()(const Redo&) {}
  void operator()(const BeginGesture&) {}
  void operator()(const EndGesture&) {}
  void operator()(const CancelGesture&) {}
  void operator()(const Label& a) { add("text", json_string(a.text)); }

 private:
  void which(Index index) {
    if (index < 0) throw Error("which: expected the index of a constraint, found " + std::to_string(index));
    add("which", std::to_string(index));
  }
  void which(const std::vector<Index>& indices) {
    std::string list;
    for (const Index index : indices) {
      if (index < 0) throw Error("which: expected the index of a constraint, found " + std::to_string(index));
      list += (list.empty() ? "" : ", ") + std::to_string(index);
    }
    add("which", "[" + list + "]");
  }
  void point(const char* key, const Point<Dim>& value) {
    if (!value.allFinite()) throw Error(std::string(key) + ": expected finite numbers");
    add(key, json_point<Dim>(value));
  }
  void direction(const char* key, const Point<Dim>& value) {
    if (value.isZero(0)) throw Error(std::string(key) + ": the zero vector has no direction");
    point(key, value);
  }
  void number(const char* key, double value) {
    if (!std::isfinite(value)) throw Error(std::string(key) + ": expected a finite number");
    add(key, json_number(value));
  }

  std::string text_ = "{";
};

template <int Dim>
std::string text_of(const RecordedCommand<Dim>& each) {
  Writer<Dim> writer;
  writer.add("do", json_string(name_of<Dim>(each.command)));
  std::visit(writer, each.command);
  if (!each.comment.empty()) writer.add("comment", json_string(each.comment));
  return writer.text();
}

/// Runs `write`; an Error gets `path` in front.
template <class Write>
std::string named(const std::string& path, const Write& write) {
  try {
    return write();
  } catch (const Error& error) {
    throw Error(path + error.what());
  }
}

}  // namespace

template <int Dim>
std::string to_json_text(const Session<Dim>& session) {
  std::string text = "{\n  \"seesaw_session\": " + std::to_string(session_version) +
                     ",\n  \"dimension\": " + std::to_string(Dim);
  if (!session.title.empty()) text += ",\n  \"title\": " + json_string(session.title);
  if (!session.comment.empty()) text += ",\n  \"comment\": " + json_string(session.comment);
  text += ",\n  \"start\": " + named("start.", [&] { return document_text(session.start, 2); });
  text += ",\n  \"actions\": [";
  for (std::size_t i = 0; i < session.commands.size(); ++i)
    text += (i ? ",\n    " : "\n    ") +
            named("actions[" + std::to_string(i) + "].", [&] { return text_of(session.commands[i]); });
  return text + (session.commands.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::string to_json_text(const AnySession& session) {
  return std::visit([](const auto& each) { return to_json_text(each); }, session);
}

template <int Dim>
void write_session(const std::filesystem::path& path, const Session<Dim>& session) {
  write_file(path, to_json_text(session));
}

template std::string to_json_text(const Session<2>&);
template std::string to_json_text(const Session<3>&);
template void write_session(const std::filesystem::path&, const Session<2>&);
template void write_session(const std::filesystem::path&, const Session<3>&);

}  // namespace seesaw
