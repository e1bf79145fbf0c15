// Sessions: recorded, written, read and replayed to the same bits; and files that are none.
#include "core/editing/session.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "core/base/file.h"
#include "core/editing/replay.h"
#include "tests/core/editing/documents.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Every command once, and numbers that decimal fractions round.
template <int Dim>
Session<Dim> recorded(std::string& end) {
  Session<Dim> session;
  Editor<Dim> editor(start_document<Dim>());
  record(editor, session);
  Random random(5);
  AddOnSurface<Dim> pick{.from = 4 * random.direction<Dim>(), .direction = Point<Dim>::Zero()};
  if (Dim == 3) pick.direction = -pick.from;
  editor.apply(pick);
  editor.label("a \"label\" \xC3\xBC\n");
  editor.begin_gesture();
  for (int i = 0; i < 5; ++i) editor.apply(Move<Dim>{{12, 0}, random.direction<Dim>() / 30});
  editor.end_gesture();
  editor.apply(AddNormal{1});
  editor.apply(TurnNormal<Dim>{1, random.direction<Dim>()});
  editor.apply(TurnNormal<Dim>{1, random.direction<Dim>(), 2.0 / 3});
  editor.apply(MoveTo<Dim>{2, random.direction<Dim>() / 3});
  editor.apply(SetKind{{3, 1}, ConstraintKind::interior, 1.0 / 3});
  editor.apply(SetKind{{3}, ConstraintKind::exterior});
  editor.apply(SetValue{{4, 6}, -1.0 / 7});
  editor.apply(Add<Dim>{
      {{interior<Dim>(random.direction<Dim>() / 5)}, {boundary<Dim>(-0.0 * pick.from), true, false, "L"}}});
  editor.apply(SetKernel{Kernel::linear});
  editor.apply(SetSmoothing{1e-3 / 3});
  editor.undo();
  editor.undo();
  editor.redo();
  editor.begin_gesture();
  editor.apply(Delete{{0, 1}});
  editor.cancel_gesture();
  editor.apply(SetNormal<Dim>{0, {random.direction<Dim>(), -0.1, -1.0 / 9}});
  editor.apply(RemoveNormal{{0}});
  Document<Dim> other = editor.document();
  other.title = "other";
  editor.apply(Restore<Dim>{other});
  editor.apply(Delete{{5}});
  end = bits_of(editor.document());
  return session;
}

template <int Dim>
void record_write_read_replay() {
  std::string end;
  Session<Dim> session = recorded<Dim>(end);
  session.title = "every command";
  session.commands[2].comment = "why";
  const std::string text = to_json_text(session);
  const ScratchFolder folder;
  const auto path = folder / "session.json";
  write_session(path, session);
  EXPECT_EQ(read_file(path), text);
  const Session<Dim> again = read_session<Dim>(path);
  EXPECT_EQ(to_json_text(again), text);
  EXPECT_EQ(again.title, "every command");
  EXPECT_EQ(again.commands[2].comment, "why");
  // Command for command, for the restore near the end would hide what went wrong before it.
  const auto documents = [](const Session<Dim>& replayed) {
    std::vector<std::string> all;
    ReplayOptions<Dim> collect;
    collect.after_each = [&](Index, Editor<Dim>& editor) { all.push_back(bits_of(editor.document())); };
    replay(replayed, collect);
    return all;
  };
  EXPECT_EQ(documents(again), documents(session));
  std::vector<std::string> labels;
  Index performed = 0;
  double done = 0;
  ReplayOptions<Dim> options;
  options.at_label = [&](const std::string& label, Editor<Dim>& editor) {
    labels.push_back(label);
    EXPECT_EQ(editor.size(), 13);
    EXPECT_TRUE(editor.shape().current());
  };
  options.after_each = [&](Index index, Editor<Dim>&) { EXPECT_EQ(index, performed++); };
  Editor<Dim> editor = replay(again, options, [&](double fraction) {
    EXPECT_GE(fraction, done);
    done = fraction;
    return true;
  });
  EXPECT_EQ(bits_of(editor.document()), end);
  EXPECT_EQ(performed, static_cast<Index>(again.commands.size()));
  EXPECT_EQ(done, 1.0);
  EXPECT_THAT(labels, ElementsAre("a \"label\" \xC3\xBC\n"));
  while (editor.undo().changed) {
  }
  EXPECT_EQ(bits_of(editor.document()), bits_of(start_document<Dim>()));
  EXPECT_THROW(replay<Dim>(again, {}, [](double fraction) { return fraction < 0.5; }), Cancelled);
}

TEST(Session, Recorded2DIsReplayedToTheBit) { record_write_read_replay<2>(); }
TEST(Session, Recorded3DIsReplayedToTheBit) { record_write_read_replay<3>(); }

// Recording may begin in the middle of a life, and undo may lead out of what was recorded.
TEST(Session, UndoBeyondTheBeginningOfARecordIsReplayed) {
  Editor<2> editor(start_document<2>());
  editor.apply(SetSmoothing{0.1});
  editor.apply(Move<2>{{0}, {0.1, 0.2}});
  editor.apply(Move<2>{{1}, {0.3, 0.1}});
  editor.undo();
  Session<2> session;
  record(editor, session);
  const auto same = [&] { return bits_of(replay(session).document()) == bits_of(editor.document()); };
  editor.redo();  // Of what was undone before.
  EXPECT_TRUE(same());
  editor.undo();
  EXPECT_TRUE(same());
  record(editor, session);
  editor.apply(Delete{{2}});
  editor.undo();
  EXPECT_TRUE(std::holds_alternative<Undo>(session.commands.back().command)) << "within the record";
  editor.redo();
  editor.undo();
  editor.undo();
  EXPECT_TRUE(std::holds_alternative<Action<2>>(session.commands.back().command)) << "beyond";
  EXPECT_TRUE(same());
  editor.undo();
  EXPECT_TRUE(same());
  EXPECT_EQ(bits_of(editor.document()), bits_of(start_document<2>()));
  for (int i = 0; i < 4; ++i) {
    editor.redo();
    EXPECT_TRUE(same()) << i;
  }
  editor.begin_gesture();
  EXPECT_THROW(record(editor, session), Refused);
}

// The header's example, by hand: questions in a file are answered by the replay.
TEST(Session, WrittenByAPersonAsksTheSurface) {
  std::string start = to_json_text(start_document<3>());
  const Session<3> session = std::get<Session<3>>(parse_session(R"({"seesaw_session": 1, "dimension": 3,
    "comment": "two constraints, one with a normal", "start": )" +
                                                                start + R"(,
    "actions": [
      {"do": "add_on_surface", "from": [0, 0, 5], "direction": [0, 0, -1], "comment": "from the front"},
      {"do": "add_normal", "which": 12},
      {"do": "add_normal", "which": 0, "offset": 0.05},
      {"do": "label", "text": "done"}
    ]})"));
  Editor<3> editor = replay(session);
  ASSERT_EQ(editor.size(), 13);
  const Constraint<3>& added = editor.document().constraints[12].constraint;
  EXPECT_EQ(added.at.head<2>(), Point<2>(0, 0));
  EXPECT_GT(added.at.z(), 0.3);
  EXPECT_LT(added.at.z(), 1.0);
  ASSERT_TRUE(added.normal);
  EXPECT_GT(added.normal->direction.z(), 0.5);
  EXPECT_EQ(editor.document().constraints[0].constraint.normal->offset, 0.05);
}

std::string fault_of_text(const std::string& text) {
  try {
    parse_session(text, "s.json");
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

/// A 2D session with this command on line 4.
std::string with(const std::string& command) {
  return "{\"seesaw_session\": 1, \"dimension\": 2,\n \"start\": {\"seesaw\": 1, \"dimension\": 2, "
         "\"constraints\": "
         "[]},\n \"actions\": [\n" +
         command + "\n]}";
}

TEST(Session, ErrorsNameLineAndPath) {
  EXPECT_EQ(fault_of_text(with(R"({"do": "undo"})")), "accepted");
  const auto expect = [](const std::string& command, const std::string& message) {
    EXPECT_THAT(fault_of_text(with(command)), HasSubstr("s.json:4: actions[0]" + message)) << command;
  };
  expect(R"({"do": "mvoe", "which": 1})", ".do: expected one of add, add_normal, add_on_surface, ");
  expect(R"({"which": 1})", ".do: is missing");
  expect(R"({"do": 3})", ".do: expected a string, found a number");
  expect(R"(7)", ": expected an object, found a number");
  expect(R"({"do": "move", "which": [0], "by": [1]})", ".by: expected 2 numbers, found 1");
  expect(R"({"do": "move", "which": [0], "by": [1, "x"]})", ".by[1]: expected a number, found a string");
  expect(R"({"do": "move", "which": [0]})", ".by: is missing");
  expect(R"({"do": "move", "by": [0, 1]})", ".which: is missing");
  expect(R"({"do": "move", "which": [0, 1.5], "by": [0, 1]})",
         ".which[1]: expected the index of a constraint");
  expect(R"({"do": "delete", "which": -1})",
         ".which: expected the index of a constraint (0, 1, ...), found -1");
  expect(R"({"do": "delete", "which": 1e300})", ".which: expected the index");
  expect(R"({"do": "move_to", "which": [1], "to": [0, 1]})", ".which: expected a number, found an array");
  expect(R"({"do": "undo", "which": 1})", ".which: is not known here");
  expect(R"({"do": "set_value", "which": 1, "vlaue": 2, "value": 1})", ".vlaue: is not known here");
  expect(R"({"do": "set_kind", "which": 1, "kind": "inside"})", ".kind: expected \"boundary\", \"interior\"");
  expect(R"({"do": "set_kernel", "kernel": "gauss"})", ".kernel: expected one of \"thin_plate_spline\"");
  expect(R"({"do": "add", "constraints": []})", ".constraints: expected at least one constraint");
  expect(R"({"do": "add", "constraints": [{"kind": "interior", "at": [0, 0], "value": -1}]})",
         ".constraints[0].value: expected a number above 0");
  expect(R"({"do": "restore", "document": {"seesaw": 1, "dimension": 3, "constraints": []}})",
         ".document.dimension: this is a 3D document, expected a 2D one");
  expect(R"({"do": "label"})", ".text: is missing");

  EXPECT_EQ(fault_of_text(""), "s.json: is empty");
  EXPECT_THAT(fault_of_text("[]"), HasSubstr("s.json:1: is not a recorded session"));
  EXPECT_THAT(fault_of_text(to_json_text(start_document<2>())), HasSubstr("this is a document"));
  EXPECT_THAT(fault_of_text(R"({"seesaw_session": 2})"),
              HasSubstr("seesaw_session: was made by a newer Seesaw"));
  EXPECT_THAT(fault_of_text(R"({"seesaw_session": 1})"), HasSubstr("dimension: is missing"));
  EXPECT_THAT(fault_of_text(R"({"seesaw_session": 1, "dimension": 3, "actions": []})"),
              HasSubstr("start: is missing"));
  EXPECT_THAT(
      fault_of_text("{\"seesaw_session\": 1, \"dimension\": 2,\n\"start\": {\"seesaw\": 1, \"dimension\": "
                    "2,\n\"constraints\": [{\"kind\": \"boundary\", \"at\": [1]}]}, \"actions\": []}"),
      HasSubstr("s.json:3: start.constraints[0].at: expected 2 numbers, found 1"));
  // Cut short anywhere, it is refused.
  const std::string whole = with(R"({"do": "move", "which": [0, 1], "by": [0.5, 1]})");
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THAT(fault_of_text(whole.substr(0, n)),
                AnyOf(HasSubstr("s.json:1: "), HasSubstr("s.json:2: "), HasSubstr("s.json:3: "),
                      HasSubstr("s.json:4: "), HasSubstr("s.json:5: "), HasSubstr("is empty")))
        << n;
}

TEST(Session, AFileThatIsNotThereOrOfAnotherDimensionIsNamed) {
  try {
    read_session<3>("/no/such/session.json");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), "/no/such/session.json");
  }
  const ScratchFolder folder;
  const auto path = folder / "flat.json";
  write_session(path, Session<2>{});
  try {
    read_session<3>(path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("dimension: this is a 2D session, expected a 3D one"));
  }
}

TEST(Session, ARefusedCommandEndsTheReplayAndIsNamed) {
  const Session<2> session = std::get<Session<2>>(parse_session(
      with("{\"do\": \"label\", \"text\": \"x\"},\n\n{\"do\": \"delete\", \"which\": [3]}"), "s.json"));
  try {
    replay(session);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "s.json:6: actions[1]: delete: constraint 3 does not exist, there are none");
    EXPECT_EQ(error.line(), 6);
  }
  Session<2> made;
  made.commands.push_back({EndGesture{}});
  EXPECT_THROW(replay(made), Error);
}

TEST(Session, WhatCannotBeReadIsNotWritten) {
  const auto fault = [](const Command<3>& command) -> std::string {
    Session<3> session;
    session.commands.push_back({command});
    try {
      to_json_text(session);
    } catch (const Error& error) {
      return error.what();
    }
    return "written";
  };
  const Point<3> bad(0, std::nan(""), 0);
  EXPECT_EQ(fault(Action<3>(Move<3>{{0}, bad})), "actions[0].by: expected finite numbers");
  EXPECT_EQ(fault(Action<3>(Delete{{-1}})), "actions[0].which: expected the index of a constraint, found -1");
  EXPECT_EQ(fault(Action<3>(SetSmoothing{INFINITY})), "actions[0].smoothing: expected a finite number");
  EXPECT_THAT(fault(Action<3>(Add<3>{})), HasSubstr("actions[0].constraints: "));
  EXPECT_THAT(fault(Action<3>(Add<3>{{{interior<3>({0, 0, 0}, -1)}}})),
              HasSubstr("actions[0].constraints[0].value: "));
  EXPECT_THAT(fault(Action<3>(AddOnSurface<3>{})), HasSubstr("actions[0].direction: "));
  Session<3> session;
  session.start.smoothing = -1;
  EXPECT_THROW(to_json_text(session), Error);
}

}  // namespace
}  // namespace seesaw
