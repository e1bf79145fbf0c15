#include "sandbox2d/folder_listing.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>

#include "core/base/error.h"
#include "tests/sandbox2d/random_place.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<FileKind> scene_kinds = {{".json", "Scene"}};
const std::vector<FileKind> picture_kinds = {{".png", "Picture"}, {".svg", "Drawing"}, {".pdf", "Page"}};

std::vector<std::string> names_of(const FolderListing& listing) {
  std::vector<std::string> names;
  for (const FolderEntry& each : listing.entries) names.push_back(each.name + (each.folder ? "/" : ""));
  return names;
}

template <class Call>
std::string trouble_with(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(FolderListing, FoldersComeFirstAndNumbersCount) {
  ScratchFolder folder;
  for (const char* name : {"fig10.json", "Fig2.json", "fig1.JSON", "notes.txt", ".hidden.json", "zeta/x.json",
                           "Alpha/x.json", ".git/x.json"})
    folder.with(name);
  const FolderListing listing = list_folder(folder.path(), scene_kinds);
  EXPECT_THAT(names_of(listing), ElementsAre("Alpha/", "zeta/", "fig1.JSON", "Fig2.json", "fig10.json"));
  EXPECT_EQ(listing.others, 1u);
  EXPECT_EQ(listing.entries.back().size, 5u);
  EXPECT_EQ(list_folder(folder.path(), {}).entries.size(), 6u);
}

TEST(FolderListing, LinksAreFollowedAndLinksToNothingLeftOut) {
  ScratchFolder folder;
  folder.with("real/a.json");
  std::filesystem::create_symlink(folder / "real", folder / "link");
  std::filesystem::create_symlink(folder / "real/a.json", folder / "b.json");
  std::filesystem::create_symlink(folder / "gone", folder / "c.json");
  EXPECT_THAT(names_of(list_folder(folder.path(), scene_kinds)), ElementsAre("link/", "real/", "b.json"));
}

TEST(FolderListing, WhatCannotBeReadIsSaid) {
  ScratchFolder folder;
  EXPECT_THAT(trouble_with([&] { list_folder(folder / "none", {}); }), HasSubstr("none: cannot be read"));
  const auto file = folder.with("file");
  EXPECT_THAT(trouble_with([&] { list_folder(file, {}); }), HasSubstr("file: cannot be read"));
  if (::geteuid() == 0) return;  // who may read everything
  std::filesystem::create_directory(folder / "shut");
  std::filesystem::permissions(folder / "shut", std::filesystem::perms::none);
  EXPECT_THAT(trouble_with([&] { list_folder(folder / "shut", {}); }), HasSubstr("ermission denied"));
  EXPECT_EQ(nearest_folder(folder / "shut"), folder.path());
}

TEST(FolderListing, NamesAreInNaturalOrder) {
  const std::vector<std::string> ordered = {"",   "a",    "A1",    "a02",    "a2",   "a2b",   "a10",  "a10.",
                                            "ab", "fig9", "Fig10", "figure", "über", "Übung", "übung"};
  std::vector<std::string> mixed = ordered;
  Random random(7);
  for (int run = 0; run < 20; ++run) {
    for (std::size_t i = mixed.size(); i > 1; --i) std::swap(mixed[i - 1], mixed[below(random, i)]);
    std::sort(mixed.begin(), mixed.end(), natural_less);
    EXPECT_EQ(mixed, ordered);
  }
  EXPECT_TRUE(natural_less("x99999999999999999999", "x100000000000000000000")) << "larger than any integer";
}

// What std::sort asks of an order, or it may run out of its array.
TEST(FolderListing, TheOrderIsStrict) {
  Random random(11);
  const std::string letters = "aAbB019.- ";
  std::vector<std::string> names(120);
  for (std::string& name : names)
    for (std::size_t i = below(random, 5); i > 0; --i) name += letters[below(random, letters.size())];
  for (const std::string& a : names)
    for (const std::string& b : names) {
      EXPECT_EQ(natural_less(a, b) || natural_less(b, a), a != b) << a << " and " << b;
      EXPECT_FALSE(natural_less(a, b) && natural_less(b, a)) << a << " and " << b;
      for (const std::string& c : names)
        if (natural_less(a, b) && natural_less(b, c)) {
          ASSERT_TRUE(natural_less(a, c)) << a << ", " << b << ", " << c;
        }
    }
}

TEST(FolderListing, ATypedPathIsMeantAsItIsWritten) {
  EXPECT_EQ(full_path("a.json", "/data", "/home/ada"), "/data/a.json");
  EXPECT_EQ(full_path("  a b.json ", "/data", "/home/ada"), "/data/a b.json");
  EXPECT_EQ(full_path("~", "/data", "/home/ada"), "/home/ada");
  EXPECT_EQ(full_path("~/x//y/", "/data", "/home/ada"), "/home/ada/x/y");
  EXPECT_EQ(full_path("~x", "/data", "/home/ada"), "/data/~x");
  EXPECT_EQ(full_path("~/x", "/data", ""), "/data/~/x");
  EXPECT_EQ(full_path("/etc/../tmp", "/data", ""), "/tmp");
  EXPECT_EQ(full_path("..", "/data/scenes", ""), "/data");
  EXPECT_EQ(full_path("/", "/data", ""), "/");
}

TEST(FolderListing, AFileIsFoundWithoutItsEnding) {
  ScratchFolder folder;
  folder.with("torus.json");
  folder.with("sub/x.json");
  const auto open = [&](const char* typed) {
    return place_to_open(typed, folder.path(), folder.path(), scene_kinds);
  };
  EXPECT_EQ(open("torus").path, folder / "torus.json");
  EXPECT_EQ(open("~/torus.json").path, folder / "torus.json");
  EXPECT_FALSE(open("torus").folder);
  EXPECT_TRUE(open("sub").folder);
  EXPECT_TRUE(open("..").folder);
  EXPECT_THAT(trouble_with([&] { open(" "); }), HasSubstr("choose a file"));
  EXPECT_THAT(trouble_with([&] { open("tori"); }), HasSubstr("there is no file tori in "));
  EXPECT_THAT(trouble_with([&] { open("none/x"); }), HasSubstr("there is no folder "));
}

TEST(FolderListing, AFileToSaveGetsItsEnding) {
  ScratchFolder folder;
  folder.with("old.svg");
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_directory(folder / "taken.png");
  const auto save = [&](const char* typed) {
    return place_to_save(typed, folder.path(), folder.path(), picture_kinds, 0);
  };
  EXPECT_EQ(save("curve").path, folder / "curve.png");
  EXPECT_EQ(save("curve.v2").path, folder / "curve.v2.png");
  EXPECT_EQ(save("curve.PDF").path, folder / "curve.PDF");
  EXPECT_EQ(save("sub/curve").path, folder / "sub/curve.png");
  EXPECT_FALSE(save("curve").exists);
  EXPECT_TRUE(save("old.svg").exists);
  EXPECT_TRUE(save("sub").folder);
  EXPECT_THAT(trouble_with([&] { save(""); }), HasSubstr("type a name"));
  EXPECT_THAT(trouble_with([&] { save(".png"); }), HasSubstr("type a name before .png"));
  EXPECT_THAT(trouble_with([&] { save("none/"); }), HasSubstr("there is no folder"));
  EXPECT_THAT(trouble_with([&] { save("none/x"); }), HasSubstr("there is no folder"));
  EXPECT_THAT(trouble_with([&] { save("old.svg/x"); }), HasSubstr("there is no folder"));
  EXPECT_THAT(trouble_with([&] { save("taken"); }), HasSubstr("is a folder"));
}

TEST(FolderListing, TheKindIsPartOfTheName) {
  EXPECT_EQ(kind_of("a.SVG", picture_kinds), 1);
  EXPECT_EQ(kind_of("a.svg.gz", picture_kinds), -1);
  EXPECT_EQ(with_kind("a.svg", picture_kinds, 2), "a.pdf");
  EXPECT_EQ(with_kind("a.b", picture_kinds, 0), "a.b.png");
  EXPECT_EQ(with_kind("", picture_kinds, 0), "");
}

TEST(FolderListing, FoldersAreMadeAndWalked) {
  ScratchFolder folder;
  EXPECT_EQ(make_folder(folder.path(), " new "), folder / "new");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "new"));
  EXPECT_THAT(trouble_with([&] { make_folder(folder.path(), "new"); }), HasSubstr("exists already"));
  EXPECT_THAT(trouble_with([&] { make_folder(folder.path(), "a/b"); }), HasSubstr("no /"));
  EXPECT_THAT(trouble_with([&] { make_folder(folder.path(), ""); }), HasSubstr("type a name"));
  EXPECT_THAT(trouble_with([&] { make_folder(folder / "none", "x"); }), HasSubstr("cannot be made"));
  EXPECT_EQ(nearest_folder(folder / "new/not/there"), folder / "new");
  EXPECT_THAT(way_to("/a/b"), ElementsAre("/", "/a", "/a/b"));
  EXPECT_THAT(way_to("/"), ElementsAre("/"));
}

TEST(FolderListing, SizesAndTimesAreForPeople) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(999), "999 B");
  EXPECT_EQ(size_text(1000), "1 kB");
  EXPECT_EQ(size_text(4096), "4.1 kB");
  EXPECT_EQ(size_text(12'345'678), "12 MB");
  EXPECT_EQ(size_text(999'999), "1 MB");
  EXPECT_EQ(size_text(123'456), "123 kB");
  const auto now = std::filesystem::file_time_type::clock::now();
  const std::string text = time_text(now);
  ASSERT_EQ(text.size(), 16u) << text;
  const std::time_t seconds = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&seconds, &local);
  EXPECT_EQ(text.substr(0, 4), std::to_string(1900 + local.tm_year));
}

// Ten thousand files are read and sorted in a moment, once.
TEST(FolderListing, AFolderWithManyFilesIsListed) {
  ScratchFolder folder;
  for (int i = 0; i < 2000; ++i) std::ofstream(folder / ("s" + std::to_string(i) + ".json")) << i;
  const FolderListing listing = list_folder(folder.path(), scene_kinds);
  ASSERT_EQ(listing.entries.size(), 2000u);
  for (std::size_t i = 0; i < 2000; ++i)
    EXPECT_EQ(listing.entries[i].name, "s" + std::to_string(i) + ".json");
}

}  // namespace
}  // namespace seesaw
