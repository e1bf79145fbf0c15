#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/image/canvas.h"
#include "core/image/sheet.h"
#include "core/image/svg_text.h"

namespace seesaw {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The box around everything that is darker than paper, in points.
Rect inked(const Canvas& canvas, double scale = 4) {
  const Image image = canvas.image(scale);
  int left = image.width(), right = -1, top = image.height(), bottom = -1;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (image.at(x, y).g < 0.6) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
  return {left / scale, top / scale, (right + 1 - left) / scale, (bottom + 1 - top) / scale};
}

TEST(Text, StandsAtItsAnchorAsAligned) {
  for (const Align align : {Align::left, Align::center, Align::right})
    for (const VerticalAlign vertical :
         {VerticalAlign::baseline, VerticalAlign::middle, VerticalAlign::top}) {
      Canvas canvas(200, 100);
      canvas.text({100, 50}, "HHHH", {.size = 20, .align = align, .vertical = vertical});
      const Rect box = inked(canvas);
      const double x = align == Align::left     ? box.left()
                       : align == Align::center ? box.center().x()
                                                : box.right();
      const double y = vertical == VerticalAlign::baseline ? box.bottom()
                       : vertical == VerticalAlign::middle ? box.center().y()
                                                           : box.top();
      EXPECT_NEAR(x, 100, 2.2);  // letters have room at their sides
      EXPECT_NEAR(y, 50, 0.3);
    }
}

TEST(Text, MeasuresAsItDraws) {
  Canvas canvas(300, 60);
  const TextStyle style{.size = 24, .bold = true};
  canvas.text({10, 40}, "HamburgH", style);
  const TextSize size = measure_text("HamburgH", style);
  const Rect box = inked(canvas);
  EXPECT_NEAR(box.width, size.width, 0.2 * style.size);
  EXPECT_LT(box.width, size.width);
  EXPECT_NEAR(size.ascent, 0.729 * 24, 1e-9);
  EXPECT_NEAR(box.top(), 40 - size.ascent, 0.8);
  EXPECT_LE(box.bottom(), 40 + size.descent + 0.3);
}

TEST(Text, LengthGrowsWithSizeExactly) {
  const double one = measure_text("r² log r", {.size = 1}).width;
  for (const double size : {5.0, 9.5, 33.0})
    EXPECT_NEAR(measure_text("r² log r", {.size = size}).width, one * size, 1e-9);
  EXPECT_GT(measure_text("r", {.bold = true}).width, measure_text("r", {}).width);
  EXPECT_EQ(measure_text("", {}).width, 0);
}

TEST(Text, LooksTheSameAtEveryScale) {
  Canvas canvas(120, 40);
  canvas.text({10, 25}, "scale", {.size = 14});
  const Rect small = inked(canvas, 2), large = inked(canvas, 16);
  EXPECT_NEAR(small.width, large.width, 1);
  EXPECT_NEAR(small.left(), large.left(), 0.6);
}

TEST(Text, RotatesCounterclockwise) {
  Canvas canvas(100, 100);
  canvas.text({50, 80}, "HHH", {.size = 16, .rotation = 90});
  const Rect box = inked(canvas);
  EXPECT_GT(box.height, box.width);
  EXPECT_NEAR(box.right(), 50, 0.4);  // the baseline runs up the page, capitals to its left
  EXPECT_LT(box.bottom(), 80.1);
}

TEST(Text, HaloKeepsLettersOffWhatIsBehind) {
  Canvas plain(60, 30, theme::ink), halo(60, 30, theme::ink);
  plain.text({10, 20}, "l", {.size = 16, .color = theme::ink});
  halo.text({10, 20}, "l", {.size = 16, .color = theme::ink, .halo = 2});
  EXPECT_EQ(plain.image(2), Canvas(60, 30, theme::ink).image(2));
  const Image image = halo.image(2);
  int light = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) light += image.at(x, y).g > 0.9;
  EXPECT_GT(light, 60);
}

TEST(Text, DoesNotDisturbTheNextMark) {
  Canvas with(60, 30), without(60, 30);
  with.text({-30, 10}, "x", {.size = 1e-3});
  for (Canvas* canvas : {&with, &without}) canvas->line({5, 5}, {50, 25}, {.width = 2});
  EXPECT_EQ(with.image(1), without.image(1));
}

TEST(Text, BadUtf8IsReplacedAndGoodIsKept) {
  EXPECT_EQ(clean_utf8("φ(r) = r² − 1 €, 𝛑"), "φ(r) = r² − 1 €, 𝛑");
  EXPECT_EQ(clean_utf8("a\xFFz"), "a\uFFFDz");
  EXPECT_EQ(clean_utf8("a\xC3"), "a\uFFFD");
  EXPECT_EQ(clean_utf8("\xC0\x80"), "\uFFFD\uFFFD");
  EXPECT_EQ(clean_utf8("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(clean_utf8(std::string_view("a\0b", 3)), "a\uFFFDb");
  Canvas canvas(50, 20);
  canvas.text({5, 15}, "\xFF\xFE\xC3(");
  EXPECT_NO_THROW(canvas.image());
  EXPECT_NO_THROW(canvas.svg());
  EXPECT_NO_THROW(canvas.pdf());
}

TEST(TextBlock, BreaksAtItsWidthAndReturnsItsHeight) {
  Canvas canvas(200, 200);
  const TextStyle style{.size = 10};
  const std::string text = "a curve is where the seesaw balances and nowhere else";
  const double width = 90;
  const double height = canvas.text_block({10, 20}, width, text, style);
  const Rect box = inked(canvas);
  EXPECT_LE(box.right(), 10 + width + 0.5);
  EXPECT_NEAR(box.top(), 20, 1);
  EXPECT_LE(box.bottom(), 20 + height + 0.5);
  EXPECT_GE(box.bottom(), 20 + height - 0.4 * style.size);
  // As many lines as the height says.
  const double one = canvas.text_block({0, 0}, 1000, "a", style);
  EXPECT_NEAR(one, measure_text("a", style).height(), 1e-9);
  EXPECT_NEAR(std::remainder(height - one, 14.0), 0, 1e-9);
}

TEST(TextBlock, NewlinesBreakAndLongWordsStandAlone) {
  Canvas canvas(300, 200);
  const TextStyle style{.size = 10};
  const double one = measure_text("x", style).height();
  EXPECT_NEAR(canvas.text_block({0, 0}, 1000, "a\nb\n\nc", style), one + 3 * 14, 1e-9);
  EXPECT_NEAR(canvas.text_block({0, 0}, 20, "a incomprehensibilities b", style), one + 2 * 14, 1e-9);
  EXPECT_EQ(canvas.text_block({0, 0}, 20, "", style), 0);
}

TEST(Svg, TellsItsWordsAndIsEscaped) {
  Canvas canvas(100, 50);
  canvas.text({10, 20}, "f < 0 & g > 0");
  canvas.text({10, 40}, "φ(r)");
  const std::string svg = canvas.svg();
  EXPECT_THAT(svg, HasSubstr("<desc>f &lt; 0 &amp; g &gt; 0\nφ(r)</desc>"));
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 100 50\""));
  EXPECT_THAT(Canvas(10, 10).svg(), Not(HasSubstr("<desc>")));
}

// Every tag closed in order, every attribute quoted, every part that is used declared once.
void expect_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  std::vector<std::string> declared;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = svg.substr(at + 1, end - at - 1);
    EXPECT_EQ(std::count(tag.begin(), tag.end(), '"') % 2, 0) << tag;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (tag[0] == '?') continue;
    if (tag[0] == '/') {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), tag.substr(1));
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    const std::size_t id = tag.find(" id=\"");
    if (id != std::string::npos) declared.push_back(tag.substr(id + 5, tag.find('"', id + 5) - id - 5));
  }
  EXPECT_TRUE(open.empty());
  for (const char* opening : {"url(#", "href=\"#"})
    for (std::size_t at = svg.find(opening); at != std::string::npos; at = svg.find(opening, at + 1)) {
      const std::size_t from = at + std::string(opening).size();
      const std::string name = svg.substr(from, svg.find_first_of("\")", from) - from);
      EXPECT_EQ(std::count(declared.begin(), declared.end(), name), 1) << name;
    }
}

TEST(Svg, IsWellFormedWithLayersClipsTextAndPictures) {
  Canvas canvas(100, 80);
  canvas.text({10, 20}, "words < more", {.halo = 1});
  canvas.picture(Image(4, 4, theme::moved.with_alpha(0.5)), {40, 40, 30, 30});
  canvas.picture(Image(4, 4, theme::curve), {60, 40, 30, 30}, Sampling::nearest);
  {
    const auto clip = canvas.clip({10, 10, 50, 50});
    const auto layer = canvas.layer(0.4);
    canvas.fill_circle({30, 30}, 20, theme::ink);
    canvas.circle({30, 30}, 25, {.color = theme::moved.with_alpha(0.5)});
  }
  expect_well_formed(canvas.svg());
}

TEST(TidiedSvg, RenumbersRoundsAndKeepsImagesAlone) {
  const std::string svg =
      "<svg width=\"10pt\"><g id=\"surface17\"><path "
      "style=\"fill-opacity:1;stroke-opacity:1;stroke-miterlimit:10;\" "
      "d=\"M 1.2345678 -3.9999999 L 5 6.5\"/></g><use xlink:href=\"#surface17\" clip-path=\"url(#clip3)\"/>"
      "<clipPath id=\"clip3\"/><image href=\"data:surface17,123456789\"/></svg>";
  EXPECT_EQ(tidied_svg(svg, {}),
            "<svg width=\"10pt\"><g id=\"part0\"><path style=\"\" d=\"M 1.235 -4 L 5 6.5\"/></g>"
            "<use xlink:href=\"#part0\" clip-path=\"url(#part1)\"/><clipPath id=\"part1\"/>"
            "<image href=\"data:surface17,123456789\"/></svg>");
}

TEST(Sheet, APolylineIsCutWhereItLeavesAndComesBack) {
  const Box<2> box(Point<2>(0, 0), Point<2>(10, 10));
  Points<2> line(2, 4);
  line << -5, 5, 15, 15, 5, 5, 5, 8;
  const auto pieces = pieces_within(line, box);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].col(0), Point<2>(0, 5));
  EXPECT_EQ(pieces[0].col(1), Point<2>(5, 5));
  EXPECT_EQ(pieces[0].col(2), Point<2>(10, 5));
}

TEST(Sheet, ARingKeepsItsAreaInsideTheBox) {
  const Box<2> box(Point<2>(0, 0), Point<2>(10, 10));
  Points<2> diamond(2, 4);
  diamond << 5, 15, 5, -5, -5, 5, 15, 5;
  const Points<2> cut = ring_within(diamond, box);
  double area = 0;
  for (Index i = 0; i < cut.cols(); ++i) {
    const Point<2> a = cut.col(i), b = cut.col((i + 1) % cut.cols());
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
    EXPECT_TRUE(box.contains(a));
  }
  EXPECT_NEAR(area, 100, 1e-12);
}

}  // namespace
}  // namespace seesaw
