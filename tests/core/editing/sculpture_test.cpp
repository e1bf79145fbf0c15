// Sculptures: files, and what a drag promises.
#include "core/editing/sculpture.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace seesaw {
namespace {

const char* const ball_text = R"({
  "seesaw_sculpture": 1,
  "cylinders": [
    {"from": [-0.5, 0, 0], "to": [0.5, 0, 0], "deviation": 0.3},
    {"from": [-0.5, 0.05, 0], "to": [0.5, -0.05, 0], "deviation": 0.3, "comment": "turned a little"}
  ],
  "frozen": ["bias", "s0", "s1"],
  "desired_radius": 0.12,
  "drags": [{"grab": [0.7, 0, 0], "to": [0.9, 0.3, 0]}, {"grab": [-0.7, 0, 0], "to": [-0.9, 0.2, 0.1]}]
})";

TEST(Sculpture, DraggedPointsMeetTheirCursorsAndOthersStay) {
  const Sculpture sculpture = parse_sculpture(ball_text);
  ASSERT_EQ(sculpture.drags.size(), 2U);
  Sculptor sculptor(sculpture);
  EXPECT_GT(sculptor.floaters().size(), 50);
  const Values before = sculptor.surface().shape().deviations();
  const DragReport first = sculptor.drag(sculpture.drags[0]);
  EXPECT_TRUE(first.is_new);
  EXPECT_LE(first.miss, 1e-3 * sculpture.desired_radius);
  const Point<3> held = sculptor.points().positions.col(0);
  EXPECT_LE((held - sculpture.drags[0].to).norm(), 1e-3 * sculpture.desired_radius);
  const DragReport second = sculptor.drag(sculpture.drags[1]);
  EXPECT_EQ(second.point, 1);
  EXPECT_LE(second.miss, 1e-3 * sculpture.desired_radius);
  // Control points move only when they are dragged; the surface stays on all of them, and what is frozen is
  // what it was to the bit.
  EXPECT_EQ(Point<3>(sculptor.points().positions.col(0)), held);
  EXPECT_LE(std::max(first.most_off, second.most_off), 0.05 * sculpture.desired_radius);
  EXPECT_EQ(sculptor.surface().shape().deviations(), before);
  EXPECT_EQ(sculptor.surface().shape().threshold(), sculpture.threshold);
  EXPECT_EQ(sculptor.floaters().counts().lost, 0);
  // Taking hold of the same place again takes the same point.
  const DragReport again = sculptor.drag({held, held});
  EXPECT_FALSE(again.is_new);
  EXPECT_EQ(again.point, 0);
}

std::string message_of(const std::string& broken) {
  try {
    parse_sculpture(broken, "s.json");
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing was refused";
}
std::string with(const std::string& from, const std::string& to) {
  std::string changed = ball_text;
  changed.replace(changed.find(from), from.size(), to);
  return changed;
}

TEST(Sculpture, FaultsAreNamedWithTheirLine) {
  EXPECT_NE(message_of("").find("s.json"), std::string::npos);
  EXPECT_NE(message_of(with("\"seesaw_sculpture\": 1", "\"seesaw_sculpture\": 2")).find("s.json:2"),
            std::string::npos);
  EXPECT_NE(message_of(with("\"deviation\": 0.3}", "\"deviation\": -1}")).find("s.json:4"),
            std::string::npos);
  EXPECT_NE(message_of(with("[0.5, 0, 0]", "[0.5, 0]")).find("cylinders[0].to"), std::string::npos);
  EXPECT_NE(message_of(with("\"s1\"", "\"radius\"")).find("s.json:7"), std::string::npos);
  EXPECT_NE(message_of(with("\"grab\"", "\"grap\"")).find("drags[0]"), std::string::npos);
  EXPECT_NE(message_of(with("\"drags\"", "\"draws\"")).find("drags"), std::string::npos);
  EXPECT_EQ(message_of(ball_text), "nothing was refused");
}

TEST(Sculpture, DamagedFilesAreRefusedOrRead) {
  Random random(6);
  const std::string whole = ball_text;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = whole;
    for (Index k = 1 + random.index(3); k > 0; --k) {
      const auto at = static_cast<std::size_t>(random.index(static_cast<Index>(damaged.size())));
      if (random.index(2) == 0)
        damaged.erase(at, static_cast<std::size_t>(1 + random.index(20)));
      else
        damaged[at] = static_cast<char>(32 + random.index(95));
      if (damaged.empty()) damaged = "{";
    }
    try {
      const Sculpture read = parse_sculpture(damaged);
      EXPECT_TRUE(read.starts.allFinite() && read.ends.allFinite());
    } catch (const FileError&) {
    }
  }
}

}  // namespace
}  // namespace seesaw
