#include "core/image/raster.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "core/base/random.h"

namespace seesaw {
namespace {

static_assert(!std::is_copy_constructible_v<Raster> && std::is_nothrow_move_constructible_v<Raster>);

struct Parts {
  int r, g, b, a;
  friend bool operator==(const Parts&, const Parts&) = default;
};

Parts parts_at(const Raster& raster, int x, int y) {
  const std::uint8_t* p = raster.data() + static_cast<std::ptrdiff_t>(y) * raster.stride() + 4 * x;
  return {p[2], p[1], p[0], p[3]};
}

Parts parts_of(const Color& color) {
  return {byte_of(color.r), byte_of(color.g), byte_of(color.b), byte_of(color.a)};
}

void expect_same(const Raster& raster, const Image& image) {
  ASSERT_EQ(raster.width(), image.width());
  ASSERT_EQ(raster.height(), image.height());
  ASSERT_GE(raster.stride(), 4 * raster.width());
  ASSERT_EQ(raster.stride() % 4, 0);
  int other = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) other += parts_at(raster, x, y) != parts_of(image.at(x, y));
  EXPECT_EQ(other, 0);
}

Canvas drawing(double width = 120, double height = 80, const Color& background = theme::paper) {
  Canvas canvas(width, height, background);
  canvas.fill_circle({50, 40}, 30, theme::moved);
  canvas.line({3, 5}, {110, 71}, {.width = 3});
  canvas.text({10, 60}, "a word");
  const auto layer = canvas.layer(0.4);
  canvas.fill_rectangle({20, 10, 60, 50}, {0.1, 0.4, 0.9});
  return canvas;
}

/// One pixel of each color, side by side.
Raster raster_of(const std::vector<Color>& colors, const Color& background = theme::paper) {
  Canvas canvas(static_cast<double>(colors.size()), 2, background);
  for (std::size_t i = 0; i < colors.size(); ++i)
    canvas.fill_rectangle({static_cast<double>(i), 0, 1, 2}, colors[i]);
  Raster raster;
  raster.paint(canvas);
  return raster;
}

TEST(Raster, IsTheCanvassImageByteForByte) {
  Raster raster;
  for (const double scale : {1.0, 2.0, 1.37}) {
    raster.paint(drawing(), scale);
    expect_same(raster, drawing().image(scale));
  }
}

TEST(Raster, MemoryIsKeptAndNothingOfThePictureBefore) {
  Raster raster;
  raster.paint(drawing(), 2);
  const std::uint8_t* const before = raster.data();
  for (const Color& background : {Color{0.2, 0.9, 0.4}, Color{1, 1, 1, 0}, Color{0.9, 0.1, 0.2, 0.5}}) {
    const Canvas other(120, 80, background);
    raster.paint(other, 2);
    EXPECT_EQ(raster.data(), before);
    Raster fresh;
    fresh.paint(other, 2);
    for (int x = 0; x < raster.width(); ++x) ASSERT_EQ(parts_at(raster, x, 70), parts_at(fresh, x, 70));
  }
  raster.paint(drawing(), 2);
  raster.negative(hex("#15181D"));
  raster.paint(drawing(), 2);
  EXPECT_EQ(raster.data(), before);
  expect_same(raster, drawing().image(2));
  raster.paint(drawing(90, 30), 1);
  expect_same(raster, drawing(90, 30).image(1));
}

TEST(Raster, MovesWithItsPixels) {
  Raster raster;
  EXPECT_TRUE(raster.empty());
  EXPECT_EQ(raster.data(), nullptr);
  EXPECT_EQ(raster.width() + raster.height() + raster.stride(), 0);
  raster.negative({0, 0, 0});
  raster.paint(drawing());
  const std::uint8_t* const pixels = raster.data();
  Raster other = std::move(raster);
  EXPECT_EQ(other.data(), pixels);
  Raster third;
  third = std::move(other);
  EXPECT_EQ(third.data(), pixels);
  expect_same(third, drawing().image(1));
}

TEST(Raster, RefusesTheSizesThatAnImageRefuses) {
  Raster raster;
  for (const double scale : {0.0, -1.0, std::nan(""), 1e9, 400.0}) {
    raster.paint(drawing());
    std::string expected, message;
    try {
      drawing().image(scale);
    } catch (const Error& error) {
      expected = error.what();
    }
    try {
      raster.paint(drawing(), scale);
    } catch (const Error& error) {
      message = error.what();
    }
    EXPECT_FALSE(message.empty());
    EXPECT_EQ(message, expected);
    EXPECT_TRUE(raster.empty());
  }
  raster.paint(drawing(), 0.001);
  EXPECT_EQ(raster.width(), 1);
}

TEST(Raster, ColorIsPremultiplied) {
  const Raster raster = raster_of({Color{1, 0.5, 0, 0.5}}, {0, 0, 0, 0});
  const Parts p = parts_at(raster, 0, 0);
  EXPECT_NEAR(p.a, 128, 1);
  EXPECT_NEAR(p.r, 128, 1);
  EXPECT_NEAR(p.g, 64, 1);
  EXPECT_EQ(p.b, 0);
}

TEST(RasterNegative, PaperBecomesBlackAndBlackBecomesWhite) {
  for (const char* text : {"#15181D", "#000000", "#FFFFFF", "#2B0001", "#010203"}) {
    Raster raster = raster_of({{1, 1, 1}, {0, 0, 0}});
    raster.negative(hex(text));
    EXPECT_EQ(parts_at(raster, 0, 0), parts_of(hex(text)));
    EXPECT_EQ(parts_at(raster, 1, 1), (Parts{255, 255, 255, 255}));
  }
}

TEST(RasterNegative, KeepsTheHueAndTurnsTheOrderOfLightness) {
  Random random(1);
  std::vector<Color> colors;
  for (int i = 0; i < 300; ++i) colors.push_back({random.uniform(), random.uniform(), random.uniform()});
  const Raster before = raster_of(colors);
  Raster after = raster_of(colors);
  after.negative({0, 0, 0});
  const auto lightness = [](const Parts& p) { return std::max({p.r, p.g, p.b}) + std::min({p.r, p.g, p.b}); };
  for (int x = 0; x < 300; ++x) {
    const Parts p = parts_at(before, x, 0), q = parts_at(after, x, 0);
    EXPECT_EQ(q.r - q.g, p.r - p.g);
    EXPECT_EQ(q.g - q.b, p.g - p.b);
    EXPECT_EQ(lightness(q), 510 - lightness(p));
  }
  Raster dark = raster_of(colors);
  dark.negative(hex("#15181D"));
  for (int x = 0; x < 300; ++x) {
    const Parts p = parts_at(after, x, 0), q = parts_at(dark, x, 0);
    EXPECT_NEAR(q.r, 0x15 + p.r * (255 - 0x15) / 255.0, 0.5);
    EXPECT_NEAR(q.g, 0x18 + p.g * (255 - 0x18) / 255.0, 0.5);
    EXPECT_NEAR(q.b, 0x1D + p.b * (255 - 0x1D) / 255.0, 0.5);
    EXPECT_EQ(q.a, 255);
  }
}

TEST(RasterNegative, TwiceIsThePictureItself) {
  Raster raster;
  raster.paint(drawing());
  raster.negative({0, 0, 0});
  raster.negative({0, 0, 0});
  expect_same(raster, drawing().image(1));
}

TEST(RasterNegative, TransparencyStaysAndColorsStayBelowIt) {
  std::vector<Color> colors;
  for (int i = 0; i <= 20; ++i) colors.push_back({1, 0.05 * i, 0.3, 0.05 * i});
  const Raster before = raster_of(colors, {0, 0, 0, 0});
  Raster after = raster_of(colors, {0, 0, 0, 0});
  after.negative(hex("#15181D"));
  for (int x = 0; x <= 20; ++x) {
    const Parts p = parts_at(before, x, 0), q = parts_at(after, x, 0);
    EXPECT_EQ(q.a, p.a);
    EXPECT_LE(std::max({q.r, q.g, q.b}), q.a);
  }
  EXPECT_EQ(parts_at(after, 0, 0), (Parts{0, 0, 0, 0}));
}

TEST(Raster, PaintsOverACopyAndLeavesTheOriginal) {
  Canvas base(40, 30, hex("#336699"));
  base.fill_circle({20, 15}, 9, hex("#FFCC00"));
  Canvas over(40, 30, Color{0, 0, 0, 0});
  over.line({0, 5}, {40, 20}, {.color = theme::moved.with_alpha(0.6), .width = 3});
  Canvas both(40, 30, hex("#336699"));
  both.fill_circle({20, 15}, 9, hex("#FFCC00"));
  both.line({0, 5}, {40, 20}, {.color = theme::moved.with_alpha(0.6), .width = 3});
  Raster original, copy, expected;
  original.paint(base, 2);
  expected.paint(both, 2);
  const auto bytes = [](const Raster& raster) {
    return std::vector<std::uint8_t>(raster.data(), raster.data() + raster.stride() * raster.height());
  };
  const auto before = bytes(original);
  copy.copy(original);
  EXPECT_EQ(bytes(copy), before);
  copy.paint_over(over);
  EXPECT_EQ(bytes(copy), bytes(expected));
  EXPECT_EQ(bytes(original), before);
  copy.copy(Raster());
  EXPECT_TRUE(copy.empty());
  copy.paint_over(over);
  EXPECT_TRUE(copy.empty());
}

}  // namespace
}  // namespace seesaw
