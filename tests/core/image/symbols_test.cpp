#include "core/image/symbols.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/image/colormap.h"

namespace seesaw {
namespace {

double lightness(const Image& image, double x, double y, double scale) {
  return lab_of(image.at(static_cast<int>(x * scale), static_cast<int>(y * scale))).L;
}

TEST(Symbols, AreTheirShapesInTheirSizes) {
  Canvas canvas(60, 20, theme::grid);
  draw_symbol(canvas, Symbol::circle, {10, 10}, 10);
  draw_symbol(canvas, Symbol::plus, {30, 10}, 10);
  draw_symbol(canvas, Symbol::minus, {50, 10}, 10);
  const double scale = 8;
  const Image image = canvas.image(scale);
  const auto L = [&](double x, double y) { return lightness(image, x, y, scale); };
  EXPECT_GT(L(10, 10), 99) << "open";
  EXPECT_LT(L(10, 5.6), 20);
  EXPECT_LT(L(14.4, 10), 20);
  EXPECT_GT(L(10, 4.5), 99) << "rim of paper";
  EXPECT_LT(L(30, 10), 20);
  EXPECT_LT(L(30, 5.8), 20);
  EXPECT_LT(L(34.2, 10), 20);
  EXPECT_NEAR(L(26.5, 6.5), lab_of(theme::grid).L, 1);
  EXPECT_LT(L(45.8, 10), 20);
  EXPECT_GT(L(50, 8.4), 99);
  EXPECT_NEAR(L(50, 6), lab_of(theme::grid).L, 1) << "a minus has no upright";
}

TEST(Symbols, StandOutOnEveryFieldColor) {
  for (int k = -10; k <= 10; ++k)
    for (const Symbol symbol : {Symbol::circle, Symbol::plus, Symbol::minus}) {
      Canvas canvas(20, 20, diverging_color(k / 10.0));
      draw_symbol(canvas, symbol, {10, 10});
      const Image image = canvas.image(4);
      double least = 100, most = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
          least = std::min(least, lab_of(image.at(x, y)).L);
          most = std::max(most, lab_of(image.at(x, y)).L);
        }
      EXPECT_GT(most - least, 75) << k;
    }
}

TEST(Spike, RunsFromItsFootToItsPoint) {
  Canvas canvas(40, 20, theme::grid);
  draw_spike(canvas, {5, 10}, {0.001, 0}, 25, theme::moved);
  const Image image = canvas.image(8);
  const Lab shaft = lab_of(image.at(8 * 12, 80)), head = lab_of(image.at(8 * 28, 80));
  EXPECT_LT(delta_e(shaft, lab_of(theme::moved)), 1);
  EXPECT_LT(delta_e(head, lab_of(theme::moved)), 1);
  EXPECT_GT(delta_e(lab_of(image.at(8 * 33, 80)), lab_of(theme::moved)), 40);
}

TEST(Symbols, NothingOfNoSizeAndNowhere) {
  Canvas canvas(20, 20), blank(20, 20);
  draw_symbol(canvas, Symbol::plus, {10, 10}, 0);
  draw_symbol(canvas, Symbol::circle, {10, std::nan("")});
  draw_symbol(canvas, Symbol::minus, {std::nan(""), 10});
  draw_symbol(canvas, Symbol::circle, {10, 10}, std::nan(""));
  draw_spike(canvas, {10, 10}, {0, 0});
  draw_spike(canvas, {10, 10}, {std::nan(""), 1});
  draw_spike(canvas, {10, std::nan("")}, {1, 0});
  EXPECT_EQ(canvas.image(), blank.image());
}

}  // namespace
}  // namespace seesaw
