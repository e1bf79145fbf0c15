#include "core/image/color.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/image/colormap.h"
#include "core/image/theme.h"

namespace seesaw {
namespace {

TEST(Color, HexReadsRedGreenBlueAndAlpha) {
  static_assert(hex("#FF0080").r == 1 && hex("#FF0080").g == 0);
  EXPECT_EQ(hex("#ff000080").a, 128 / 255.0);
  EXPECT_EQ(hex("#FFFFFF"), (Color{1, 1, 1, 1}));
  EXPECT_EQ(byte_of(hex("#0A141E").b), 0x1E);
}

TEST(Color, HexRefusesWhatIsNotAColor) {
  for (const char* text : {"", "#", "D55E00", "#D55E0", "#D55E0G", "#D55E001", "#D55E00112", " #D55E00"})
    EXPECT_THROW(hex(text), Error) << text;
}

TEST(Color, BytesRoundAndClamp) {
  EXPECT_EQ(byte_of(-1), 0);
  EXPECT_EQ(byte_of(2), 255);
  EXPECT_EQ(byte_of(std::nan("")), 0);
  for (int k = 0; k < 256; ++k) EXPECT_EQ(byte_of(k / 255.0), k);
}

TEST(Color, MixEndsAtItsEndsAndClamps) {
  const Color a = hex("#102030"), b = hex("#D0E0F0");
  EXPECT_EQ(mix(a, b, 0), a);
  EXPECT_EQ(mix(a, b, -3), a);
  EXPECT_NEAR(mix(a, b, 1).g, b.g, 1e-15);
  EXPECT_NEAR(mix(a, b, 0.5).r, (a.r + b.r) / 2, 1e-15);
}

TEST(Lab, KnownColors) {
  EXPECT_NEAR(lab_of(theme::paper).L, 100, 1e-9);
  EXPECT_NEAR(lab_of(theme::paper).a, 0, 1e-9);
  EXPECT_NEAR(lab_of(theme::paper).b, 0, 1e-9);
  EXPECT_NEAR(lab_of({0, 0, 0}).L, 0, 1e-9);
  // Red in sRGB, D65: L 53.24, a 80.09, b 67.20 in every table.
  const Lab red = lab_of({1, 0, 0});
  EXPECT_NEAR(red.L, 53.24, 0.02);
  EXPECT_NEAR(red.a, 80.09, 0.05);
  EXPECT_NEAR(red.b, 67.20, 0.05);
  EXPECT_NEAR(delta_e(lab_of({0, 0, 0}), lab_of({1, 1, 1})), 100, 1e-9);
}

TEST(Lab, ThereAndBackAgain) {
  for (int r = 0; r <= 10; ++r)
    for (int g = 0; g <= 10; ++g)
      for (int b = 0; b <= 10; ++b) {
        const Color c{r / 10.0, g / 10.0, b / 10.0}, d = color_of(lab_of(c));
        EXPECT_NEAR(c.r, d.r, 1e-5);
        EXPECT_NEAR(c.g, d.g, 1e-5);
        EXPECT_NEAR(c.b, d.b, 1e-5);
      }
}

TEST(DivergingColor, LightnessFallsStraightAndAlikeToBothSides) {
  EXPECT_NEAR(lab_of(diverging_color(0)).L, 97, 0.1);
  for (int k = 0; k <= 100; ++k) {
    const double t = k / 100.0;
    const double outside = lab_of(diverging_color(-t)).L, inside = lab_of(diverging_color(t)).L;
    EXPECT_NEAR(outside, inside, 0.3) << t;
    EXPECT_NEAR(inside, 97 - 51 * t, 0.3) << t;
    if (k == 0) continue;
    EXPECT_LT(outside, lab_of(diverging_color(-t + 0.01)).L);
    EXPECT_LT(inside, lab_of(diverging_color(t - 0.01)).L);
  }
}

TEST(DivergingColor, BlueOutsideOrangeInsideForColorBlindEyesToo) {
  for (const double t : {0.1, 0.25, 0.5, 1.0}) {
    const Color outside = diverging_color(-t), inside = diverging_color(t);
    EXPECT_GT(outside.b, outside.r);
    EXPECT_GT(inside.r, inside.g);
    EXPECT_GT(inside.g, inside.b);
    const double seen = delta_e(lab_of(outside), lab_of(inside));
    const double seen_by_deuteranope =
        delta_e(lab_of(seen_without_green_cones(outside)), lab_of(seen_without_green_cones(inside)));
    EXPECT_GT(seen_by_deuteranope, 12 * std::sqrt(t / 0.1)) << t;
    EXPECT_GT(seen_by_deuteranope, 0.6 * seen) << t;
  }
}

TEST(DivergingColor, InkIsLegibleOnAllOfIt) {
  for (int k = -10; k <= 10; ++k)
    EXPECT_GT(lab_of(diverging_color(k / 10.0)).L - lab_of(theme::ink).L, 30) << k;
}

TEST(Colormaps, ClampAndMarkWhatIsMissing) {
  EXPECT_EQ(diverging_color(-7), diverging_color(-1));
  EXPECT_EQ(diverging_color(infinity), diverging_color(1));
  EXPECT_EQ(diverging_color(std::nan("")), theme::missing);
  EXPECT_EQ(sequential_color(-0.1), sequential_color(0));
  EXPECT_EQ(sequential_color(std::nan("")), theme::missing);
}

TEST(SequentialColor, LightnessFallsAllTheWay) {
  for (int k = 1; k <= 200; ++k)
    EXPECT_LT(lab_of(sequential_color(k / 200.0)).L, lab_of(sequential_color((k - 1) / 200.0)).L) << k;
  EXPECT_GT(lab_of(sequential_color(0)).L, 95);
  EXPECT_LT(lab_of(sequential_color(1)).L, 22);
}

TEST(Theme, ColorBlindReadersTellTheColorsApart) {
  const auto seen = [](const Color& c) { return lab_of(seen_without_green_cones(c)); };
  EXPECT_GT(delta_e(seen(theme::moved), seen(theme::curve)), 40);
  EXPECT_GT(delta_e(seen(theme::moved), seen(theme::ink)), 30);
  for (std::size_t i = 0; i < theme::series.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(delta_e(seen(theme::series[i]), seen(theme::series[j])), 12) << i << ' ' << j;
  EXPECT_EQ(theme::series_color(7), theme::series_color(0));
}

TEST(Theme, WordsAreLegibleOnPaper) {
  // W3C asks 4.5 : 1 of text; 4.5 against white is about L = 50.
  for (const Color& c : {theme::ink, theme::soft_ink, theme::curve, theme::moved}) EXPECT_LT(lab_of(c).L, 50);
}

}  // namespace
}  // namespace seesaw
