#include "core/image/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace seesaw {
namespace {

const double not_a_number = std::nan("");

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> labels_of(const std::vector<Tick>& ticks) {
  std::vector<std::string> labels;
  for (const Tick& t : ticks)
    if (t.major) labels.push_back(t.label);
  return labels;
}

TEST(LinearTicks, AreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_THAT(labels_of(linear_ticks(0, 10, 5)), ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_THAT(labels_of(linear_ticks(0, 1, 5)), ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels_of(linear_ticks(-1, 1, 4)), ElementsAre("−1.0", "−0.5", "0.0", "0.5", "1.0"));
  EXPECT_THAT(labels_of(linear_ticks(3, 247, 5)), ElementsAre("50", "100", "150", "200"));
  EXPECT_THAT(labels_of(linear_ticks(0.98, 1.02, 4)), ElementsAre("0.98", "0.99", "1.00", "1.01", "1.02"));
  EXPECT_THAT(labels_of(linear_ticks(0, 4e6, 4)), ElementsAre("0", "10⁶", "2×10⁶", "3×10⁶", "4×10⁶"));
  EXPECT_THAT(labels_of(linear_ticks(0, 1e-5, 2)), ElementsAre("0", "5×10⁻⁶", "10⁻⁵"));
}

TEST(LinearTicks, ValuesAreTheDoublesOfTheirLabels) {
  const auto ticks = linear_ticks(-1, 1, 20);
  ASSERT_EQ(ticks.size(), 21u);
  for (int k = -10; k <= 10; ++k) EXPECT_EQ(ticks[static_cast<std::size_t>(k + 10)].value, k / 10.0);
  EXPECT_FALSE(std::signbit(ticks[10].value));
}

TEST(LinearTicks, AreNeverMoreThanAskedAndNeverAbsent) {
  for (double range = 1e-9; range < 1e12; range *= 1.37)
    for (const int about : {2, 4, 6, 10}) {
      const auto ticks = linear_ticks(-0.3 * range, 0.7 * range, about);
      EXPECT_LE(static_cast<int>(ticks.size()), about + 1) << range;
      EXPECT_GE(static_cast<double>(ticks.size()), about / 2.5 - 1) << range;
    }
}

TEST(LinearTicks, BadRangesHaveNone) {
  EXPECT_TRUE(linear_ticks(1, 1).empty());
  EXPECT_TRUE(linear_ticks(2, 1).empty());
  EXPECT_TRUE(linear_ticks(not_a_number, 1).empty());
  EXPECT_TRUE(linear_ticks(0, infinity).empty());
  EXPECT_FALSE(linear_ticks(0, 1, 0).empty());
  EXPECT_TRUE(log_ticks(0, 1).empty());
  EXPECT_TRUE(log_ticks(-1, 1).empty());
  EXPECT_TRUE(log_ticks(1, infinity).empty());
}

TEST(LogTicks, MarkDecades) {
  EXPECT_THAT(labels_of(log_ticks(1, 1000)), ElementsAre("1", "10", "100", "1000"));
  EXPECT_THAT(labels_of(log_ticks(0.5e-4, 2)), ElementsAre("10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"));
  EXPECT_THAT(labels_of(log_ticks(1e-12, 1, 4)), ElementsAre("10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"));
  std::size_t minor = 0;
  for (const Tick& t : log_ticks(1, 1000)) minor += !t.major;
  EXPECT_EQ(minor, 24u);
}

TEST(LogTicks, UnderThreeDecadesMarkOneTwoFive) {
  EXPECT_THAT(labels_of(log_ticks(1, 12)), ElementsAre("1", "2", "5", "10"));
  EXPECT_THAT(labels_of(log_ticks(0.15, 1.5)), ElementsAre("0.2", "0.5", "1"));
  EXPECT_THAT(labels_of(log_ticks(3, 4, 5)), ElementsAre("3.0", "3.2", "3.4", "3.6", "3.8", "4.0"));
}

TEST(NumberLabel, IsForPeople) {
  EXPECT_EQ(number_label(0), "0");
  EXPECT_EQ(number_label(-0.25), "−0.25");
  EXPECT_EQ(number_label(123456, 3), "123000");
  EXPECT_EQ(number_label(1.5e6), "1.5×10⁶");
  EXPECT_EQ(number_label(-1e-7), "−10⁻⁷");
  EXPECT_EQ(number_label(9.99999e8, 3), "10⁹");
  EXPECT_EQ(power_of_ten_label(-12), "10⁻¹²");
}

Chart sample_chart() {
  Chart chart{.title = "A title", .x = {.label = "distance"}, .y = {.label = "height"}};
  chart.series.push_back({.name = "first", .x = {0, 1, 2}, .y = {0, 1, 4}});
  chart.series.push_back({.name = "second", .x = {0, 1, 2}, .y = {4, 3, 2}, .marker = Marker::circle});
  return chart;
}

TEST(ChartFrame, GoesToThePageAndBack) {
  for (const bool logarithmic : {false, true}) {
    Chart chart = sample_chart();
    chart.x = {.logarithmic = logarithmic, .low = 0.5, .high = 50};
    const ChartFrame frame = lay_out(chart, {10, 20, 300, 200});
    EXPECT_NEAR(frame.pixel_from_data({0.5, 0}).x(), frame.plot.left(), 1e-9);
    EXPECT_NEAR(frame.pixel_from_data({50, 0}).x(), frame.plot.right(), 1e-9);
    for (const double x : {0.7, 3.0, 45.0}) {
      const Point<2> back = frame.data_from_pixel(frame.pixel_from_data({x, 1.5}));
      EXPECT_NEAR(back.x(), x, 1e-12 * 50);
      EXPECT_NEAR(back.y(), 1.5, 1e-12 * 50);
    }
  }
}

TEST(ChartFrame, UpIsUpAndEverythingFits) {
  const Rect region{10, 20, 300, 200};
  const ChartFrame frame = lay_out(sample_chart(), region);
  EXPECT_LT(frame.pixel_from_data({0, 4}).y(), frame.pixel_from_data({0, 0}).y());
  EXPECT_TRUE(region.contains({frame.plot.left(), frame.plot.top()}));
  EXPECT_TRUE(region.contains({frame.plot.right(), frame.plot.bottom()}));
  for (const double x : {0.0, 2.0})
    for (const double y : {0.0, 4.0}) EXPECT_TRUE(frame.plot.contains(frame.pixel_from_data({x, y})));
}

TEST(ChartFrame, AnAxisThatStartsAtZeroStaysThere) {
  EXPECT_EQ(scale_for({}, {0, 5}).low(), 0);
  EXPECT_GT(scale_for({}, {0, 5}).high(), 5);
  EXPECT_LT(scale_for({}, {1, 5}).low(), 1);
  EXPECT_EQ(scale_for({.low = 1, .high = 2}, {0, 5}).high(), 2);
}

TEST(ChartFrame, OddDataStillGivesAScale) {
  for (const bool logarithmic : {false, true})
    for (const auto& values : std::vector<std::vector<double>>{
             {}, {not_a_number}, {infinity, -infinity}, {3}, {3, 3}, {0}, {-1, -2}}) {
      const Scale s = scale_for({.logarithmic = logarithmic}, values);
      EXPECT_LT(s.low(), s.high());
      EXPECT_TRUE(std::isfinite(s.low()) && std::isfinite(s.high()));
      EXPECT_TRUE(!logarithmic || s.low() > 0);
    }
  EXPECT_TRUE(std::isnan(Scale(1, 10, true).fraction(0)));
  EXPECT_TRUE(std::isnan(Scale(1, 10, true).fraction(-1)));
  EXPECT_LT(Scale(5, 2, false).low(), Scale(5, 2, false).high());
  EXPECT_GT(Scale(-5, 2, true).low(), 0);
}

TEST(Chart, DrawsWhatTheFrameSays) {
  Canvas canvas(320, 220);
  Chart chart = sample_chart();
  chart.legend = Legend::none;
  const ChartFrame frame = draw_chart(canvas, canvas.bounds().inset(8), chart);
  const Image image = canvas.image(4);
  const auto at = [&](const Point<2>& p) {
    return lab_of(image.at(static_cast<int>(4 * p.x()), static_cast<int>(4 * p.y())));
  };
  EXPECT_LT(delta_e(at(frame.pixel_from_data({0.5, 0.5})), lab_of(theme::series[0])), 2)
      << "on the first line";
  EXPECT_LT(delta_e(at(frame.pixel_from_data({1, 3})), lab_of(theme::series[1])), 2) << "on a marker";
  EXPECT_LT(at({frame.plot.left(), frame.plot.center().y() + 3}).L, 50) << "on the axis";
}

TEST(Chart, TheExampleOfItsHeader) {
  const std::vector<double> sizes = {10, 100, 1000}, errors = {1e-2, 1e-3, 1e-4};
  Canvas canvas(360, 240);
  Chart chart{.title = "Convergence", .x = {.label = "N", .logarithmic = true}};
  chart.series.push_back({.name = "error", .x = sizes, .y = errors, .marker = Marker::circle});
  const ChartFrame frame = draw_chart(canvas, {0, 0, 360, 240}, chart);
  canvas.circle(frame.pixel_from_data({100, 1e-3}), 6, {.color = theme::moved});
  EXPECT_NEAR(frame.pixel_from_data({100, 1e-3}).x(), frame.plot.center().x(), 1e-9);
  EXPECT_EQ(labels_of(frame.x_ticks), (std::vector<std::string>{"10", "100", "1000"}));
}

TEST(Chart, SaysItsWords) {
  Canvas canvas(320, 220);
  Chart chart = sample_chart();
  chart.horizontal.push_back({.value = 2, .label = "two"});
  chart.vertical.push_back({.value = 1, .label = "one"});
  chart.annotations.push_back({.at = {1, 1}, .text = "here\nand here"});
  for (const Legend legend : {Legend::automatic, Legend::direct, Legend::bottom_left}) {
    Canvas page(320, 220);
    chart.legend = legend;
    draw_chart(page, page.bounds(), chart);
    const std::string svg = page.svg();
    for (const char* word :
         {"A title", "distance", "height", "first", "second", "two", "one", "here", "and here"})
      EXPECT_THAT(svg, HasSubstr(word));
  }
}

TEST(Chart, NothingOfALineLeavesThePlot) {
  Canvas with(320, 220), without(320, 220);
  Chart chart{.x = {.low = 0, .high = 1}, .y = {.low = 0, .high = 1}};
  draw_chart(without, without.bounds(), chart);
  chart.series.push_back({.x = {-10, 10}, .y = {-10, 10}, .marker = Marker::square});
  const ChartFrame frame = draw_chart(with, with.bounds(), chart);
  const Image a = with.image(1), b = without.image(1);
  int changed = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if (frame.plot.inset(-3).contains({x + 0.5, y + 0.5}))
        changed += a.at(x, y) != b.at(x, y);
      else
        EXPECT_EQ(a.at(x, y), b.at(x, y)) << x << ' ' << y;
    }
  EXPECT_GT(changed, 300) << "inside it is there";
}

TEST(Chart, LegendStandsWhereItHidesNothing) {
  // A line from the bottom left to the top right leaves the other two corners.
  Canvas canvas(320, 220);
  Chart chart;
  for (const char* name : {"one name", "another name"})
    chart.series.push_back({.name = name, .x = {0, 1}, .y = {0, 1}});
  Canvas forced(320, 220);
  draw_chart(canvas, canvas.bounds(), chart);
  chart.legend = Legend::top_left;
  draw_chart(forced, forced.bounds(), chart);
  EXPECT_EQ(canvas.image(1), forced.image(1));
}

TEST(Chart, MistakesAreToldNotDrawn) {
  Chart chart = sample_chart();
  chart.series[0].y.pop_back();
  EXPECT_THROW(lay_out(chart, {0, 0, 300, 200}), Error);
  EXPECT_THROW(lay_out(sample_chart(), {0, 0, 30, 20}), Error);
}

TEST(Chart, EmptyAndOddSeriesDrawAxesOnly) {
  for (const bool logarithmic : {false, true}) {
    Chart chart{.x = {.logarithmic = logarithmic}, .y = {.logarithmic = logarithmic}};
    chart.series.push_back({.name = "odd",
                            .x = {not_a_number, 1, infinity, -1},
                            .y = {1, not_a_number, 2, -infinity},
                            .marker = Marker::cross});
    chart.series.push_back({.name = "empty"});
    for (const Legend legend : {Legend::automatic, Legend::direct}) {
      chart.legend = legend;
      Canvas canvas(200, 150);
      draw_chart(canvas, canvas.bounds(), chart);
      EXPECT_NO_THROW(canvas.image(1));
    }
  }
}

}  // namespace
}  // namespace seesaw
