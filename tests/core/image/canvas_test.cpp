#include "core/image/canvas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/file.h"
#include "core/image/png.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const double nan = std::nan("");
const double inf = infinity;

Points<2> points_of(std::initializer_list<Point<2>> list) {
  Points<2> points(2, static_cast<Index>(list.size()));
  Index i = 0;
  for (const Point<2>& p : list) points.col(i++) = p;
  return points;
}

bool near(const Color& a, const Color& b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) + std::abs(a.a - b.a) < 0.02;
}

#define EXPECT_COLOR(image, x, y, color) \
  EXPECT_TRUE(near((image).at(x, y), color)) << "at " << (x) << ", " << (y)

TEST(Canvas, UnitsArePointsTimesScaleWithYDown) {
  Canvas canvas(40, 30);
  canvas.fill_rectangle({10, 20, 10, 5}, theme::moved);
  for (const int scale : {1, 2, 3}) {
    const Image image = canvas.image(scale);
    EXPECT_EQ(image.width(), 40 * scale);
    EXPECT_EQ(image.height(), 30 * scale);
    EXPECT_COLOR(image, 10 * scale, 20 * scale, theme::moved);
    EXPECT_COLOR(image, 20 * scale - 1, 25 * scale - 1, theme::moved);
    EXPECT_COLOR(image, 20 * scale, 24 * scale, theme::paper);
    EXPECT_COLOR(image, 15 * scale, 20 * scale - 1, theme::paper);
  }
}

TEST(Canvas, TheExampleOfItsHeader) {
  const ScratchFolder folder;
  const auto path = folder / "example.pdf";
  Canvas canvas(200, 100);
  canvas.fill_circle({50, 50}, 20, theme::moved);
  canvas.text({80, 50}, "a new constraint", {.size = 11, .vertical = VerticalAlign::middle});
  canvas.save(path);
  EXPECT_EQ(read_file(path), canvas.pdf());
  EXPECT_COLOR(canvas.image(1), 50, 50, theme::moved);
}

TEST(Canvas, RedIsRedAndBlueIsBlue) {  // Cairo keeps pixels as BGRA
  Canvas canvas(4, 4, {1, 0, 0});
  EXPECT_EQ(canvas.image(1).at(1, 1), (Color{1, 0, 0, 1}));
  Canvas other(4, 4, {0, 0, 1});
  EXPECT_EQ(other.image(1).at(1, 1), (Color{0, 0, 1, 1}));
}

TEST(Canvas, TransparentPaperKeepsStraightColor) {  // Cairo keeps pixels multiplied by alpha
  Canvas canvas(4, 4, {0, 0, 0, 0});
  EXPECT_EQ(canvas.image(1).at(2, 2).a, 0);
  canvas.fill_rectangle(canvas.bounds(), {1, 0.5, 0, 0.5});
  const Color c = canvas.image(1).at(2, 2);
  EXPECT_NEAR(c.a, 0.5, 0.01);
  EXPECT_NEAR(c.r, 1, 0.01);
  EXPECT_NEAR(c.g, 0.5, 0.01);
  EXPECT_EQ(c.b, 0);
}

TEST(Canvas, FillRulesDecideWhatIsAHole) {
  const std::vector<Points<2>> rings = {points_of({{0, 0}, {20, 0}, {20, 20}, {0, 20}}),
                                        points_of({{5, 5}, {15, 5}, {15, 15}, {5, 15}})};
  Canvas even_odd(20, 20), winding(20, 20);
  even_odd.fill_rings(rings, theme::ink, FillRule::even_odd);
  winding.fill_rings(rings, theme::ink, FillRule::winding);
  EXPECT_COLOR(even_odd.image(1), 10, 10, theme::paper);
  EXPECT_COLOR(even_odd.image(1), 2, 10, theme::ink);
  EXPECT_COLOR(winding.image(1), 10, 10, theme::ink);
}

TEST(Canvas, LinesHaveTheirWidthDashAndCap) {
  Canvas canvas(40, 40);
  canvas.line({5, 10}, {35, 10}, {.width = 4, .cap = Cap::butt});
  canvas.line({10, 20}, {30, 20}, {.width = 6, .cap = Cap::round});
  canvas.line({0, 30}, {40, 30}, {.width = 2, .dash = {10, 10}, .cap = Cap::butt});
  const Image image = canvas.image(1);
  EXPECT_COLOR(image, 20, 8, theme::ink);
  EXPECT_COLOR(image, 20, 11, theme::ink);
  EXPECT_COLOR(image, 20, 12, theme::paper);
  EXPECT_COLOR(image, 4, 10, theme::paper);
  EXPECT_COLOR(image, 8, 20, theme::ink);  // within the round cap
  EXPECT_COLOR(image, 5, 30, theme::ink);
  EXPECT_COLOR(image, 15, 30, theme::paper);
  EXPECT_COLOR(image, 25, 30, theme::ink);
}

TEST(Canvas, ArrowEndsExactlyAtItsPoint) {
  Canvas canvas(40, 20);
  canvas.arrow({5, 10}, {30, 10}, {.width = 2}, 8);
  const Image image = canvas.image(4);
  EXPECT_COLOR(image, 4 * 27, 40, theme::ink);
  EXPECT_COLOR(image, 4 * 30 + 1, 40, theme::paper);
  EXPECT_COLOR(image, 4 * 4, 40, theme::paper);
}

TEST(Canvas, FacetsLeaveNoSeam) {
  Canvas plain(20, 20), facets(20, 20);
  const Points<2> left = points_of({{0, 0}, {7.3, 0}, {12.7, 20}, {0, 20}});
  const Points<2> right = points_of({{7.3, 0}, {20, 0}, {20, 20}, {12.7, 20}});
  plain.fill_polygon(left, theme::ink);
  plain.fill_polygon(right, theme::ink);
  facets.facet(left, theme::ink);
  facets.facet(right, theme::ink);
  double lightest_plain = 0, lightest_facets = 0;
  const Image a = plain.image(1), b = facets.image(1);
  for (int y = 1; y < 19; ++y)
    for (int x = 1; x < 19; ++x) {
      lightest_plain = std::max(lightest_plain, a.at(x, y).g);
      lightest_facets = std::max(lightest_facets, b.at(x, y).g);
    }
  EXPECT_GT(lightest_plain, theme::ink.g + 0.1);  // the fault is real
  EXPECT_LT(lightest_facets, theme::ink.g + 0.05);
}

TEST(Canvas, ClipEndsWithItsScope) {
  Canvas canvas(20, 20);
  {
    const auto inside = canvas.clip({0, 0, 10, 20});
    const auto deeper = canvas.clip({0, 0, 20, 10});
    canvas.fill_rectangle(canvas.bounds(), theme::ink);
  }
  canvas.fill_rectangle({15, 15, 5, 5}, theme::moved);
  const Image image = canvas.image(1);
  EXPECT_COLOR(image, 5, 5, theme::ink);
  EXPECT_COLOR(image, 15, 5, theme::paper);
  EXPECT_COLOR(image, 5, 15, theme::paper);
  EXPECT_COLOR(image, 17, 17, theme::moved);
}

TEST(Canvas, LayerIsLaidDownOnce) {
  Canvas canvas(20, 10);
  auto layer = canvas.layer(0.5);
  canvas.fill_rectangle({0, 0, 12, 10}, {0, 0, 0});
  canvas.fill_rectangle({8, 0, 12, 10}, {0, 0, 0});
  EXPECT_NEAR(canvas.image(1).at(10, 5).r, 0.5, 0.01) << "an open layer shows too";
  layer.close();
  EXPECT_NEAR(canvas.image(1).at(2, 5).r, 0.5, 0.01);
  EXPECT_NEAR(canvas.image(1).at(10, 5).r, 0.5, 0.01);
}

TEST(Canvas, PicturesKeepTheirPlacesAndSampling) {
  Image checks(2, 2, theme::paper);
  checks.set(0, 0, {1, 0, 0});
  checks.set(1, 1, {0, 0, 1});
  Canvas canvas(30, 30, {0, 1, 0});
  canvas.picture(checks, {5, 5, 20, 20}, Sampling::nearest);
  const Image image = canvas.image(1);
  EXPECT_COLOR(image, 5, 5, (Color{1, 0, 0}));
  EXPECT_COLOR(image, 14, 14, (Color{1, 0, 0}));
  EXPECT_COLOR(image, 15, 14, theme::paper);
  EXPECT_COLOR(image, 24, 24, (Color{0, 0, 1}));
  EXPECT_COLOR(image, 25, 25, (Color{0, 1, 0}));
  Canvas smooth(30, 30, {0, 1, 0});
  smooth.picture(checks, {5, 5, 20, 20}, Sampling::smooth);
  EXPECT_COLOR(smooth.image(1), 6, 6, (Color{1, 0, 0}));
  EXPECT_EQ(smooth.image(1).at(5, 5).b, 0) << "no background leaks in at the rim";
  const Color middle = smooth.image(1).at(15, 8);
  EXPECT_TRUE(middle.g > 0.2 && middle.g < 0.9) << middle.g;
}

TEST(Canvas, NumbersThatAreNoneHarmNothing) {
  Canvas clean(40, 40), canvas(40, 40);
  for (const double bad : {nan, inf, -inf}) {
    canvas.line({bad, 1}, {5, 5});
    canvas.polygon(points_of({{bad, bad}}));
    canvas.polyline(points_of({}));
    canvas.circle({1, bad}, 5);
    canvas.circle({20, 20}, bad);
    canvas.fill_circle({bad, 1}, 5, theme::ink);
    canvas.fill_rectangle({bad, 0, 5, 5}, theme::ink, 2);
    canvas.fill_rectangle({0, 0, bad, 5}, theme::ink);
    canvas.arrow({0, 0}, {bad, 3});
    canvas.text({bad, 5}, "no");
    canvas.text({5, 5}, "no", {.size = bad});
    canvas.text({5, 5}, "no", {.rotation = bad});
    canvas.picture(Image(2, 2, theme::ink), {0, bad, 3, 3});
    canvas.line({0, 0}, {9, 9}, {.width = bad});
  }
  canvas.line({0, 0}, {9, 9}, {.width = -1});
  canvas.circle({20, 20}, 0);
  canvas.text({5, 5}, "");
  EXPECT_EQ(canvas.image(2), clean.image(2));
  EXPECT_EQ(canvas.svg(), clean.svg());
  EXPECT_NO_THROW(canvas.pdf());
}

TEST(Canvas, BadDashAndColorStillDraw) {
  Canvas canvas(20, 20);
  canvas.line({0, 5}, {20, 5}, {.width = 4, .dash = {-1, 3}});
  canvas.line({0, 15}, {20, 15}, {.width = 4, .dash = {0, 0}});
  canvas.fill_rectangle({0, 8, 20, 4}, {nan, 2, -1, 1});
  const Image image = canvas.image(1);
  EXPECT_COLOR(image, 10, 5, theme::ink);
  EXPECT_COLOR(image, 10, 15, theme::ink);
  EXPECT_COLOR(image, 10, 10, (Color{0, 1, 0}));
}

TEST(Canvas, APolylineBreaksAtAMissingPoint) {
  Canvas canvas(40, 10);
  canvas.polyline(points_of({{0, 5}, {10, 5}, {nan, 5}, {30, 5}, {40, 5}}), {.width = 4, .cap = Cap::butt});
  const Image image = canvas.image(1);
  EXPECT_COLOR(image, 5, 5, theme::ink);
  EXPECT_COLOR(image, 20, 5, theme::paper);
  EXPECT_COLOR(image, 35, 5, theme::ink);
}

TEST(Canvas, MarksFarOutsideAreCutExactly) {
  // Cairo's own numbers wrap at 2^23; the slope of these must survive.
  Canvas canvas(40, 40);
  canvas.line({-1e12, -2e12 + 20}, {1e12, 2e12 + 20}, {.width = 2});
  const Image line = canvas.image(1);
  EXPECT_COLOR(line, 5, 30, theme::ink);
  EXPECT_COLOR(line, 30, 5, theme::paper);

  Canvas area(40, 40);
  area.fill_polygon(points_of({{20, -1e15}, {1e15, -1e15}, {1e15, 1e15}, {20, 1e15}}), theme::ink);
  EXPECT_COLOR(area.image(1), 19, 20, theme::paper);
  EXPECT_COLOR(area.image(1), 21, 20, theme::ink);

  Canvas round(40, 40);
  round.fill_circle({-1e9, 20}, 1e9 + 20, theme::ink);
  EXPECT_COLOR(round.image(1), 10, 20, theme::ink);
  EXPECT_COLOR(round.image(1), 30, 20, theme::paper);
}

TEST(Canvas, SameCallsSameBytesInEveryFormat) {
  const auto draw = [] {
    Canvas canvas(80, 60);
    canvas.text({40, 30}, "f(x) = 0", {.align = Align::center, .halo = 1});
    const auto layer = canvas.layer(0.7);
    const auto clip = canvas.clip({0, 0, 50, 50});
    canvas.circle({20, 20}, 10, {.dash = {3, 2}});
    canvas.picture(Image(3, 3, theme::moved), {40, 40, 20, 10});
    return canvas;
  };
  const Canvas a = draw(), b = draw();
  EXPECT_EQ(png_bytes(a.image()), png_bytes(b.image()));
  EXPECT_EQ(a.svg(), b.svg());
  EXPECT_EQ(a.svg(), a.svg());
  EXPECT_EQ(a.pdf(), b.pdf());
}

TEST(Canvas, SizesThatMakeNoPictureAreRefused) {
  for (const double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_THROW(Canvas(bad, 10), Error);
    EXPECT_THROW(Canvas(10, bad), Error);
    EXPECT_THROW(Canvas(10, 10).image(bad), Error);
  }
  EXPECT_THROW(Canvas(1000, 10).image(100), Error);
  EXPECT_EQ(Canvas(0.1, 0.1).image(1).width(), 1);
}

TEST(Canvas, SavesByTheEndingOfThePath) {
  const ScratchFolder folder;
  Canvas canvas(20, 10);
  canvas.fill_circle({5, 5}, 3, theme::moved);
  canvas.save(folder / "a.png");
  canvas.save(folder / "a.SVG");
  canvas.save(folder / "a.pdf");
  EXPECT_EQ(read_png(folder / "a.png"), canvas.image(2));
  EXPECT_EQ(read_file(folder / "a.SVG"), canvas.svg());
  EXPECT_THAT(read_file(folder / "a.pdf"), StartsWith("%PDF-"));
  for (const char* name : {"a.jpg", "a", "a.png.gz"}) {
    try {
      canvas.save(folder / name);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(".png, .svg or .pdf")) << name;
    }
  }
  EXPECT_THROW(canvas.save(folder / "no" / "a.svg"), FileError);
}

TEST(CanvasPdf, HasOnePageAFixedDateAndItsFont) {
  Canvas canvas(200, 100);
  canvas.text({10, 50}, "words");
  const std::string pdf = canvas.pdf();
  EXPECT_THAT(pdf, StartsWith("%PDF-1."));
  EXPECT_THAT(pdf, HasSubstr("%%EOF"));
  EXPECT_THAT(pdf, HasSubstr("20000101000000"));
  EXPECT_THAT(pdf, HasSubstr("DejaVuSans"));
}

}  // namespace
}  // namespace seesaw
