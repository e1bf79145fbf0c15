// How large symbols are among thousands of neighbors, and that an editor finds the spikes where they are
// drawn.
#include "core/scene/crowding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/picture.h"
#include "tests/support/shapes.h"

namespace seesaw {
namespace {

Document<2> ring_of(int count, bool normals = false) {
  Document<2> document;
  for (int i = 0; i < count; ++i) {
    const Point<2> out(std::cos(2 * M_PI * i / count), std::sin(2 * M_PI * i / count));
    document.constraints.push_back({.constraint = boundary<2>(out)});
    if (normals) document.constraints.back().constraint = boundary<2>(out, out, 0.01);
  }
  return document;
}

TEST(Crowding, SpacingIsTheUsualDistanceOfNeighbors) {
  EXPECT_EQ(usual_spacing(ring_of(99)), infinity) << "few have room";
  const double chord = 2 * std::sin(M_PI / 1500);
  Document<2> crowd = ring_of(1500);
  EXPECT_NEAR(usual_spacing(crowd), chord, 1e-12);
  crowd.constraints.push_back({.constraint = interior<2>({0, 0})});
  crowd.constraints.push_back({.constraint = exterior<2>({1e7, 0})});
  EXPECT_NEAR(usual_spacing(crowd), chord, 1e-12) << "whatever lies elsewhere";
}

TEST(Crowding, SymbolsShrinkWithTheirRoomAndStayVisible) {
  EXPECT_EQ(symbol_share(infinity, 100, 11), 1);
  EXPECT_EQ(symbol_share(1, 100, 11), 1);
  EXPECT_NEAR(symbol_share(0.1, 100, 11), 7.0 / 11, 1e-15) << "seven tenths of the ten points between them";
  EXPECT_EQ(symbol_share(0.001, 100, 11), 0.3);
  EXPECT_EQ(symbol_share(0, 100, 11), 0.3);
}

// Drawn as one mark or as many, a spike covers the same points.
TEST(Crowding, SpikesOfACrowdAreDrawnWhereThoseOfFewAre) {
  const auto ink_along_first_spike = [&](int count) {
    Document<2> document = ring_of(count, true);
    Canvas canvas(600, 600);
    document.display.view = Box<2>(Point<2>(-1.5, -1.5), Point<2>(1.5, 1.5));
    const PlanView view =
        draw_plain_document(canvas, {0, 0, 600, 600}, document, {.symbol_size = 4, .spike_length = 26});
    const Image image = canvas.image(1);
    std::vector<bool> dark;
    for (int x = -4; x < 40; ++x) {
      const Point<2> at = view.page_from_scene(Point<2>(1, 0)) + Point<2>(x, 0);
      dark.push_back(image.at(static_cast<int>(at.x()), static_cast<int>(at.y() - 0.5)).r < 0.5);
    }
    return dark;
  };
  const auto few = ink_along_first_spike(180), many = ink_along_first_spike(210);
  int differ = 0, inked = 0;
  for (std::size_t i = 0; i < few.size(); ++i) differ += few[i] != many[i], inked += many[i];
  EXPECT_GE(inked, 20);
  EXPECT_LE(differ, 3) << "but for the edge of a pixel at either end";
}

}  // namespace
}  // namespace seesaw
