// The ground floor: numbers as text, whole files, seeded random numbers, loops over blocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <thread>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(Text, NumbersComeBackToTheSameBits) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-300, 300));
    EXPECT_EQ(parse_number(to_text(value, 17)), value);
  }
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(1.0 / 3, 3), "0.333");
  EXPECT_EQ(to_text(1e100), "1e+100");
}

TEST(Text, OnlyWholeNumbersAreNumbers) {
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("-2e3"), -2000);
  for (const char* text : {"", "+", "-", "1,5", "1.5 ", " 1", "1.5x", "0x10", "--1", "+-1", "one"})
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
  EXPECT_EQ(parse_number("1e-400"), 0.0);
  EXPECT_EQ(parse_number("-1e400"), -infinity);
}

class File : public testing::Test {
 protected:
  ScratchFolder scratch;
  fs::path folder = scratch.path();
};

TEST_F(File, WhatWasWrittenIsRead) {
  std::string bytes(100000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7);
  write_file(folder / "a", bytes);
  EXPECT_EQ(read_file(folder / "a"), bytes);
  write_file(folder / "a", "short");
  EXPECT_EQ(read_file(folder / "a"), "short");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);  // no temporary file is left
}

TEST_F(File, ErrorsNameTheFile) {
  const auto message = [](const auto& work) {
    try {
      work();
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message([&] { read_file(folder / "none"); }), HasSubstr("none: no such file"));
  EXPECT_THAT(message([&] { read_file(folder); }), HasSubstr("is a folder"));
  EXPECT_THAT(message([&] { write_file(folder / "no" / "where", "x"); }),
              HasSubstr("where: cannot be written"));
  write_file(folder / "a", "12345");
  EXPECT_THAT(message([&] { read_file(folder / "a", 4); }), HasSubstr("larger than the 4 bytes"));
  EXPECT_EQ(FileError("a.json", 12, "bad").what(), std::string("a.json:12: bad"));
}

TEST_F(File, SavingKeepsPermissionsAndLinks) {
  write_file(folder / "a", "1");
  fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("a", folder / "link");
  write_file(folder / "link", "2");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "a"), "2");
  EXPECT_EQ(fs::status(folder / "a").permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST_F(File, ANewFileGetsThePermissionsOfTheUsersMask) {
  const ::mode_t before = ::umask(027);
  write_file(folder / "a", "1");
  ::umask(before);
  EXPECT_EQ(static_cast<int>(fs::status(folder / "a").permissions()), 0640);
}

TEST(Random, SameSeedSameNumbersOnEveryMachine) {
  Random random(42);
  // The first output of std::mt19937_64 seeded with 42, as the C++ standard fixes it, shifted to 53 bits.
  EXPECT_EQ(random.uniform(), static_cast<double>(13930160852258120406ull >> 11) * 0x1p-53);
  Random a(7), b(7), c(8);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.normal(), b.normal());
  EXPECT_NE(a.uniform(), c.uniform());
}

TEST(Random, DistributionsHaveTheirMoments) {
  Random random(3);
  const int n = 100000;
  double mean = 0, square = 0, normal = 0, normal_square = 0;
  Point<3> directions = Point<3>::Zero();
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform(), g = random.normal();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    mean += u / n;
    square += u * u / n;
    normal += g / n;
    normal_square += g * g / n;
    const Point<3> d = random.direction<3>();
    ASSERT_NEAR(d.norm(), 1, 1e-15);
    directions += d / n;
    ASSERT_LT(random.index(5), 5);
  }
  // Six standard errors.
  EXPECT_NEAR(mean, 0.5, 0.006);
  EXPECT_NEAR(square, 1.0 / 3, 0.006);
  EXPECT_NEAR(normal, 0, 0.02);
  EXPECT_NEAR(normal_square, 1, 0.03);
  EXPECT_LT(directions.norm(), 0.02);
}

TEST(Parallel, BlocksCoverEverythingOnce) {
  for (const Index count : {0, 1, 7, 64, 65, 1000}) {
    std::vector<std::atomic<int>> touched(static_cast<std::size_t>(count));
    parallel_blocks(count, 8, [&](Index begin, Index end) {
      EXPECT_EQ(begin % 8, 0);
      for (Index i = begin; i < end; ++i) ++touched[static_cast<std::size_t>(i)];
    });
    for (const auto& each : touched) EXPECT_EQ(each, 1);
  }
}

TEST(Parallel, ErrorsReachTheCaller) {
  EXPECT_THROW(parallel_blocks(1000, 1,
                               [](Index begin, Index) {
                                 if (begin > 500) throw Error("no");
                               }),
               Error);
}

TEST(Parallel, ACoreIsLeft) {
  const auto caller = std::this_thread::get_id();
  std::mutex mutex;
  std::set<std::thread::id> threads;
  leaving_a_core([&] {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    parallel_blocks(400, 1, [&](Index, Index) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      const std::scoped_lock lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
  });
  EXPECT_LE(threads.size(), std::max(1u, std::thread::hardware_concurrency() - 1));
  EXPECT_THROW(leaving_a_core([] { throw Error("no"); }), Error);
}

TEST(Progress, StopsWhenTold) {
  EXPECT_NO_THROW(report({}, 0.5));
  EXPECT_NO_THROW(report([](double) { return true; }, 0.5));
  EXPECT_THROW(report([](double) { return false; }, 0.5), Cancelled);
}

TEST(CheckDeathTest, PrintsBothValues) {
  EXPECT_DEATH(SEESAW_CHECK_EQ(1 + 1, 3), "1 \\+ 1 == 3.*left  = 2.*right = 3");
}

TEST(Types, BoxesGrow) {
  const Box<2> box = grown<2>(Box<2>(Point<2>(0, 0), Point<2>(4, 2)), 0.25);
  EXPECT_EQ(box.min(), Point<2>(-1, -1));
  EXPECT_EQ(box.max(), Point<2>(5, 3));
  EXPECT_TRUE(bounding_box_of<3>(Points<3>(3, 0)).isEmpty());
}

TEST(Text, DigitsTellAPlaceFromItsNeighborAPixelAway) {
  for (const auto& [value, step] :
       {std::pair(1.2345, 0.004), {1e7, 0.5}, {-3e-9, 1e-11}, {0.0, 0.01}, {0.02, 0.01}}) {
    const int digits = digits_for(value, step);
    EXPECT_GE(digits, 3);
    if (value != 0) {
      EXPECT_NE(to_text(value, digits), to_text(value + step, digits)) << value;
    }
  }
  EXPECT_EQ(digits_for(1, 0), 17);
  EXPECT_EQ(digits_for(1e300, 1e-300), 17);
  EXPECT_EQ(capitalized("undo"), "Undo");
  EXPECT_EQ(capitalized("\u00e9t\u00e9"), "\u00e9t\u00e9");
  EXPECT_EQ(capitalized(""), "");
}

}  // namespace
}  // namespace seesaw
