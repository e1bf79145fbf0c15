#include "core/image/compare.h"

#include <gtest/gtest.h>

#include "core/image/canvas.h"
#include "core/image/symbols.h"

namespace seesaw {
namespace {

// A page with a thin curve and three symbols; the curve may be shifted, a symbol left out or recolored.
Image page(double shift = 0, bool all_symbols = true, const Color& color = theme::curve) {
  Canvas canvas(200, 150);
  canvas.circle({100 + shift, 75}, 50, {.color = color, .width = 1});
  draw_symbol(canvas, Symbol::plus, {100, 75});
  draw_symbol(canvas, Symbol::circle, {60, 20});
  if (all_symbols) draw_symbol(canvas, Symbol::minus, {170, 120});
  return canvas.image(2);
}

TEST(Compare, AlikeIsZero) {
  const Comparison c = compare_images(page(), page());
  EXPECT_TRUE(c.same_size);
  EXPECT_EQ(c.mean, 0);
  EXPECT_EQ(c.percentile, 0);
  EXPECT_EQ(c.worst, 0);
  EXPECT_EQ(c.noticeable, 0);
  EXPECT_EQ(compare_images(Image(), Image()).worst, 0);
}

TEST(Compare, AOnePixelShiftCostsLittleAMissingSymbolMuch) {
  const Comparison tenth = compare_images(page(), page(0.05)), pixel = compare_images(page(), page(0.5));
  const Comparison missing = compare_images(page(), page(0, false));
  EXPECT_LT(tenth.worst, 2.3);
  EXPECT_LT(pixel.worst, 16);
  EXPECT_GT(missing.worst, 25);
  EXPECT_GT(missing.worst, 2 * pixel.worst);
  EXPECT_LT(pixel.mean, 0.5);
}

TEST(Compare, AChangeOfHueIsFlagged) {
  const Comparison c = compare_images(page(), page(0, true, theme::moved));
  EXPECT_GT(c.worst, 10);
  EXPECT_GT(c.noticeable, 0.005);
  // One lightness, two hues: a gray comparison would see nothing.
  const Comparison flat =
      compare_images(Image(20, 20, color_of(Lab{60, 30, 0})), Image(20, 20, color_of(Lab{60, -30, 0})));
  EXPECT_NEAR(flat.mean, 60, 1);
  EXPECT_EQ(flat.noticeable, 1);
}

TEST(Compare, NumbersMeanWhatTheySay) {
  Image a(100, 100, {0, 0, 0}), b = a;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 10; ++x) b.set(x, y, {1, 1, 1});
  const Comparison sharp = compare_images(a, b, {.blur = 0});
  EXPECT_NEAR(sharp.mean, 10, 1e-3);
  EXPECT_NEAR(sharp.worst, 100, 1e-3);
  EXPECT_NEAR(sharp.noticeable, 0.1, 1e-12);
  EXPECT_NEAR(compare_images(a, b).mean, 10, 0.5) << "blur keeps the sum";
  EXPECT_EQ(compare_images(a, b).mean, compare_images(b, a).mean);
}

TEST(Compare, TransparencyIsPaper) {
  EXPECT_EQ(compare_images(Image(5, 5, {0, 0, 0, 0}), Image(5, 5, theme::paper)).worst, 0);
}

TEST(Compare, DifferentSizesAreDifferent) {
  const Comparison c = compare_images(Image(5, 5, theme::paper), Image(5, 6, theme::paper));
  EXPECT_FALSE(c.same_size);
  EXPECT_EQ(c.worst, 100);
  EXPECT_EQ(c.noticeable, 1);
  EXPECT_FALSE(compare_images(Image(), Image(1, 1, theme::paper)).same_size);
}

TEST(DifferencePicture, ShowsBothAndWhereTheyDiffer) {
  const Image a = page(), b = page(0, false);
  const Image picture = difference_picture(a, b);
  EXPECT_EQ(picture.width(), 3 * a.width() + 16);
  EXPECT_EQ(picture.height(), a.height());
  EXPECT_EQ(picture.at(340, 240), a.at(340, 240));
  EXPECT_EQ(picture.at(a.width() + 8 + 340, 240), b.at(340, 240));
  const int heat = 2 * (a.width() + 8);
  EXPECT_LT(lab_of(picture.at(heat + 340, 240)).L, 40) << "dark where the symbol is missing";
  EXPECT_GT(lab_of(picture.at(heat + 20, 20)).L, 95) << "pale elsewhere";
}

TEST(DifferencePicture, SizesMayDiffer) {
  const Image picture = difference_picture(Image(40, 100, theme::ink), Image(80, 50, theme::ink));
  EXPECT_EQ(picture.width(), 3 * 80 + 16);
  EXPECT_EQ(picture.height(), 100);
  const int heat = 2 * (80 + 8);
  EXPECT_GT(lab_of(picture.at(heat + 10, 10)).L, 95) << "both";
  EXPECT_LT(lab_of(picture.at(heat + 10, 80)).L, 25) << "one";
  EXPECT_LT(lab_of(picture.at(heat + 60, 80)).L, 25) << "neither";
  EXPECT_TRUE(difference_picture(Image(), Image()).empty());
}

}  // namespace
}  // namespace seesaw
