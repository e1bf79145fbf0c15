// Files of a desk: the unsaved mark, broken files, killed in mid-save and in mid-drag, failing disks,
// autosave, recent files.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <thread>

#include "core/base/file.h"
#include "core/editing/autosave.h"
#include "core/editing/recent_files.h"
#include "tests/core/editing/documents.h"
#include "tests/core/editing/hand.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class DeskFiles : public ::testing::Test {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& each : fs::directory_iterator(folder)) result.push_back(each.path().filename().string());
    std::ranges::sort(result);
    return result;
  }

  ScratchFolder scratch;
  fs::path folder = scratch.path();
};

/// Runs `work` in a process of its own. It must end by _exit or be killed.
template <class Work>
pid_t in_child(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  return child;
}

/// "exit 3" or "signal 9".
std::string end_of(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? "exit " + std::to_string(WEXITSTATUS(status))
                           : "signal " + std::to_string(WTERMSIG(status));
}

/// Lets a child work for 3 to 15 ms before its `kill`-th kill; for twice as long after every 20 that were not
/// enough, as on some disks a single file takes that long.
void let_it_write(int kill, Random& random) {
  const int doubled = std::min(kill / 20, 5);
  std::this_thread::sleep_for(std::chrono::microseconds(3000 + (random.index(12'000) << doubled)));
}

Document<2> many(int count, double y) {
  Document<2> document;
  for (int i = 0; i < count; ++i) document.constraints.push_back({boundary<2>({i / 3.0, y})});
  document.title = "row at " + std::to_string(y);
  return document;
}

TEST_F(DeskFiles, TheUnsavedMark) {
  Desk desk(start_document<2>());
  EXPECT_EQ(desk.name(), "untitled");
  EXPECT_FALSE(desk.unsaved());
  desk.apply(MoveTo<2>{0, {2, 2}});
  EXPECT_EQ(desk.name(), "untitled*");
  desk.perform(DeskCommand::undo);
  EXPECT_FALSE(desk.unsaved());
  desk.perform(DeskCommand::redo);
  ASSERT_TRUE(desk.save(folder / "a.json"));
  EXPECT_EQ(desk.name(), "a.json");
  EXPECT_EQ(bits_of(read_document<2>(folder / "a.json")), bits_of(desk.document()));
  desk.perform(DeskCommand::undo);
  EXPECT_EQ(desk.name(), "a.json*") << "before what was saved";
  desk.perform(DeskCommand::redo);
  EXPECT_FALSE(desk.unsaved());
  desk.display().isolines = true;
  EXPECT_TRUE(desk.unsaved());
  ASSERT_TRUE(desk.save(desk.path()));
  EXPECT_FALSE(desk.unsaved());
  EXPECT_TRUE(read_document<2>(folder / "a.json").display.isolines);
  EXPECT_THAT(names(), ElementsAre("a.json"));
  // Saved in the middle of a drag, which then goes on.
  TestHand hand{desk};
  hand.down({2, 2});
  hand.to({1, 2});
  ASSERT_TRUE(desk.save(desk.path()));
  EXPECT_FALSE(desk.unsaved());
  hand.to({0, 2});
  hand.up({0, 2});
  EXPECT_TRUE(desk.unsaved());
}

TEST_F(DeskFiles, AnotherDocumentStartsAnew) {
  write_document<2>(folder / "b.json", many(5, 1));
  Desk desk(start_document<2>());
  const auto revision = desk.revision();
  desk.perform(DeskCommand::select_all);
  TestHand hand{desk};
  hand.down(desk.constraint(0).at);
  hand.to({3, 3});
  ASSERT_TRUE(desk.open(folder / "b.json"));
  EXPECT_EQ(bits_of(desk.document()), bits_of(many(5, 1)));
  EXPECT_TRUE(desk.selection().empty());
  EXPECT_EQ(desk.gesture(), Gesture::none);
  EXPECT_FALSE(desk.unsaved());
  EXPECT_GT(desk.revision(), revision) << "a picture of the old one is not taken for the new one's";
  EXPECT_EQ(desk.editor().undo_size(), 0u);
  for (Index i = 0; i < 5; ++i) EXPECT_TRUE(desk.view().scene().contains(desk.constraint(i).at));
  hand.up({3, 3});
  EXPECT_FALSE(desk.unsaved());
  desk.start();
  EXPECT_EQ(desk.editor().size(), 0);
  EXPECT_EQ(desk.name(), "untitled");
  desk.recover(many(3, 0), folder / "b.json");
  EXPECT_EQ(desk.name(), "b.json*");
}

TEST_F(DeskFiles, ASessionIsDoneAgain) {
  Desk desk(start_document<2>());
  desk.start_recording();
  desk.apply(MoveTo<2>{0, {2, 2}});
  desk.perform(DeskCommand::cage);
  write_session(folder / "session.json", *desk.stop_recording());
  Desk other;
  ASSERT_TRUE(other.open(folder / "session.json")) << other.message().text;
  EXPECT_EQ(bits_of(other.document()), bits_of(desk.document()));
  EXPECT_EQ(other.editor().undo_size(), desk.editor().undo_size());
  EXPECT_TRUE(other.unsaved());
  EXPECT_TRUE(other.path().empty()) << "a save is not to write over the session";
  EXPECT_FALSE(other.recording());
}

TEST_F(DeskFiles, BrokenHugeAndForeignFilesLeaveTheOpenDocument) {
  const std::string good = to_json_text(many(3, 0));
  write_file(folder / "empty.json", "");
  write_file(folder / "cut.json", good.substr(0, good.size() / 2));
  write_file(folder / "picture.png", "\x89PNG\r\n\x1a\n with some bytes");
  write_file(folder / "space.json", R"({"seesaw": 1, "dimension": 3, "constraints": []})");
  write_file(folder / "newer.json", R"({"seesaw": 99, "dimension": 2, "constraints": []})");
  write_file(folder / "deep.json", std::string(100'000, '['));
  write_file(folder / "session.json", R"({"seesaw_session": 1, "dimension": 2, "start": )" + good +
                                          R"(, "actions": [{"do": "delete", "which": 7}]})");
  write_file(folder / "huge.json", to_json_text(many(5001, 0)));
  fs::create_directory(folder / "folder.json");
  { std::ofstream(folder / "sparse.json").seekp((std::streamoff{1} << 28) + 10).put('x'); }
  Desk desk(start_document<2>());
  ASSERT_TRUE(desk.save(folder / "mine.json"));
  desk.apply(MoveTo<2>{0, {2, 2}});
  desk.select({1, 2});
  const std::string before = bits_of(desk.document());
  const View2D view = desk.view();
  for (const auto& each : fs::directory_iterator(folder)) {
    if (each.path().filename() == "mine.json") continue;
    const auto number = desk.message().number;
    EXPECT_FALSE(desk.open(each.path())) << each.path();
    EXPECT_EQ(desk.message().number, number + 1);
    EXPECT_TRUE(desk.message().trouble);
    EXPECT_THAT(desk.message().text, HasSubstr(each.path().filename().string()));
  }
  EXPECT_FALSE(desk.open(folder / "missing.json"));
  EXPECT_EQ(bits_of(desk.document()), before);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(1, 2));
  EXPECT_EQ(desk.name(), "mine.json*");
  EXPECT_EQ(desk.editor().undo_size(), 1u);
  EXPECT_EQ(desk.view(), view);
}

TEST_F(DeskFiles, KilledInMidSaveTheFileIsWhole) {
  const fs::path file = folder / "kept.json";
  const Document<2> a = many(400, 1), b = many(900, 2);
  const std::string texts[] = {to_json_text(a), to_json_text(b)};
  write_document(file, a);
  Random random(4);
  int of_a = 0, of_b = 0, unfinished = 0;
  // More on a machine that is too busy to be caught in the middle.
  for (int kill = 0; kill < 20 || (kill < 250 && (unfinished == 0 || of_b == 0)); ++kill) {
    const pid_t child = in_child([&] {
      for (int i = 0;; ++i) write_document(file, i % 2 ? a : b);
    });
    let_it_write(kill, random);
    ::kill(child, SIGKILL);
    EXPECT_EQ(end_of(child), "signal 9");
    const std::string found = read_file(file);
    ASSERT_TRUE(found == texts[0] || found == texts[1]) << found.size() << " bytes";
    of_a += found == texts[0];
    of_b += found == texts[1];
    for (const std::string& name : names())
      if (name != "kept.json") {
        ++unfinished;
        fs::remove(folder / name);
      }
  }
  // Else the child never came to write: nothing would have been tested.
  EXPECT_GT(of_b, 0);
  EXPECT_GT(unfinished, 0) << "never killed in the middle";
  RecordProperty("unfinished", unfinished);
}

TEST_F(DeskFiles, AFailingDiskLeavesTheOldFile) {
  const fs::path file = folder / "kept.json";
  Desk desk(start_document<2>());
  ASSERT_TRUE(desk.save(file));
  const std::string whole = read_file(file);
  const pid_t child = in_child([&] {
    // No file may grow beyond 300 bytes: as on a full disk, writing stops in the middle.
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{300, 300};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    desk.apply(MoveTo<2>{0, {2, 2}});
    if (desk.save(file)) ::_exit(1);
    if (!desk.message().trouble || desk.message().text.find("cannot be written") == std::string::npos)
      ::_exit(2);
    if (!desk.unsaved()) ::_exit(3);
    ::_exit(0);
  });
  EXPECT_EQ(end_of(child), "exit 0");
  EXPECT_EQ(read_file(file), whole);
  EXPECT_THAT(names(), ElementsAre("kept.json"));
  EXPECT_FALSE(desk.save(folder / "no such folder" / "x.json"));
  EXPECT_TRUE(desk.message().trouble);
  EXPECT_EQ(desk.path(), file) << "what it was saved to before";
}

Keepsake keepsake_of(const Desk& desk) { return {desk.to_save(), desk.path()}; }

TEST_F(DeskFiles, AutosaveKeepsWhatIsNotSaved) {
  Desk desk(start_document<2>());
  Autosave autosave(folder / "state", 5);
  int asked = 0;
  const auto tick = [&](double now) {
    autosave.tick(desk.unsaved(), desk.revision(), now, [&] {
      ++asked;
      return keepsake_of(desk);
    });
    autosave.wait();
  };
  tick(0);
  EXPECT_EQ(asked, 0) << "nothing is unsaved";
  EXPECT_FALSE(fs::exists(folder / "state"));
  desk.apply(MoveTo<2>{0, {2, 2}});
  tick(1);
  EXPECT_EQ(asked, 1);
  ASSERT_TRUE(fs::exists(autosave.file()));
  desk.apply(MoveTo<2>{0, {2, 3}});
  tick(5.9);
  EXPECT_EQ(asked, 1) << "not so soon";
  tick(6.1);
  EXPECT_EQ(asked, 2);
  tick(20);
  EXPECT_EQ(asked, 2) << "nothing has changed";
  EXPECT_EQ(read_document<2>(autosave.file()).constraints, desk.document().constraints)
      << "a document like any other";
  EXPECT_TRUE(find_recovered(folder / "state").empty()) << "its program is still running";
  desk.save(folder / "a \"b\"\\\n.json");
  tick(21);
  EXPECT_FALSE(fs::exists(autosave.file()));
  desk.apply(MoveTo<2>{0, {2, 4}});
  tick(22);
  EXPECT_TRUE(fs::exists(autosave.file()));
  EXPECT_EQ(autosave.trouble(), "");
  autosave.clear();
  EXPECT_FALSE(fs::exists(autosave.file()));
}

TEST_F(DeskFiles, KilledInMidDragTheAutosaveRecovers) {
  const fs::path state = folder / "state", file = folder / "odd \"name\"\\.json";
  write_document(file, start_document<2>());
  const std::string on_disk = read_file(file);
  const pid_t child = in_child([&] {
    Desk desk;
    Autosave autosave(state, 0);
    if (!desk.open(file)) ::_exit(1);
    TestHand hand{desk};
    hand.down(desk.constraint(0).at);
    for (int i = 0;; ++i) {
      hand.to({3, 0.001 * i});
      autosave.tick(desk.unsaved(), desk.revision(), i, [&] { return keepsake_of(desk); });
      if (i == 20) {
        autosave.wait();
        ::raise(SIGKILL);
      }
    }
  });
  EXPECT_EQ(end_of(child), "signal 9");
  EXPECT_EQ(read_file(file), on_disk);
  const std::vector<Recovered> found = find_recovered(state);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kept.of, file);
  Desk desk;
  desk.recover(std::get<Document<2>>(found[0].kept.document), found[0].kept.of);
  EXPECT_TRUE(desk.unsaved());
  EXPECT_EQ(desk.constraint(0).at.x(), 3) << "in the middle of the drag";
  Document<2> back = desk.document();
  back.constraints[0].constraint.at = start_document<2>().constraints[0].constraint.at;
  EXPECT_EQ(bits_of(back), bits_of(start_document<2>())) << "and the rest to the bit";
  ASSERT_TRUE(desk.save(file));
  discard(found[0]);
  EXPECT_TRUE(find_recovered(state).empty());
  EXPECT_TRUE(fs::is_empty(state));
}

TEST_F(DeskFiles, KilledInMidAutosaveACopyIsWholeOrThatOfBefore) {
  const fs::path state = folder / "state";
  Random random(6);
  int found_some = 0;
  for (int kill = 0; kill < 10 || (kill < 250 && found_some == 0); ++kill) {
    const pid_t child = in_child([&] {
      Autosave autosave(state, 0);
      for (int i = 0;; ++i) {
        autosave.tick(true, static_cast<std::uint64_t>(i), i, [&] { return Keepsake{many(500, i), {}}; });
        autosave.wait();
      }
    });
    let_it_write(kill, random);
    ::kill(child, SIGKILL);
    EXPECT_EQ(end_of(child), "signal 9");
    for (const Recovered& each : find_recovered(state)) {
      ++found_some;
      EXPECT_EQ(std::get<Document<2>>(each.kept.document).constraints.size(), 500u);
      EXPECT_TRUE(each.kept.of.empty());
      discard(each);
    }
    if (!fs::exists(state)) continue;  // it was killed before it came to that
    // Broken pieces are swept away.
    for (const auto& left : fs::directory_iterator(state))
      EXPECT_EQ(left.path().extension(), ".lock") << left.path();
  }
  EXPECT_GT(found_some, 0);
}

TEST_F(DeskFiles, AnAutosaveThatCannotBeWrittenSaysSoOnce) {
  write_file(folder / "file", "not a folder");
  Autosave autosave(folder / "file" / "state", 0);
  for (int i = 0; i < 3; ++i) {
    autosave.tick(true, static_cast<std::uint64_t>(i), i, [] { return Keepsake{many(3, 0), {}}; });
    const std::string trouble = autosave.trouble();
    if (i == 0) {
      EXPECT_THAT(trouble, HasSubstr("no autosave"));
    } else {
      EXPECT_EQ(trouble, "");
    }
  }
}

TEST_F(DeskFiles, RecentFiles) {
  const fs::path list = folder / "state" / "recent.txt";
  {
    RecentFiles recent(list, 3);
    EXPECT_TRUE(recent.list().empty());
    for (const char* name : {"a.json", "b c.json", "./a.json", "d.json", "e.json"})
      EXPECT_TRUE(recent.add(folder / name));
    EXPECT_THAT(recent.list(), ElementsAre(folder / "e.json", folder / "d.json", folder / "a.json"));
    EXPECT_FALSE(recent.add(folder / "two\nlines"));
  }
  RecentFiles again(list, 3);
  EXPECT_THAT(again.list(), ElementsAre(folder / "e.json", folder / "d.json", folder / "a.json"));
  again.remove(folder / "d.json");
  EXPECT_EQ(RecentFiles(list).list().size(), 2u);
  write_file(list, std::string("\0\n\n/x\n", 6));
  EXPECT_THAT(RecentFiles(list).list(), ElementsAre("/x"));
  EXPECT_TRUE(RecentFiles(folder).list().empty()) << "a folder is no list";
  RecentFiles nowhere(folder / "state" / "recent.txt" / "x");
  EXPECT_FALSE(nowhere.add("/y"));
  EXPECT_THAT(nowhere.list(), ElementsAre("/y"));
}

TEST(StateFolder, IsThatOfTheDesktop) {
  EXPECT_EQ(state_folder("/s", "/home/x"), "/s/seesaw");
  EXPECT_EQ(state_folder("relative", "/home/x"), "/home/x/.local/state/seesaw");
  EXPECT_EQ(state_folder("", "/home/x"), "/home/x/.local/state/seesaw");
  EXPECT_EQ(state_folder(nullptr, nullptr), "");
}

}  // namespace
}  // namespace seesaw
