#include "core/image/height_plot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seesaw {
namespace {

template <class F>
HeightPlot plot_of(F f, Index n = 41) {
  HeightPlot plot;
  plot.field.ground = Box<2>(Point<2>(-1, -1), Point<2>(1, 1));
  plot.field.heights.resize(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Point<2> g = plot.field.ground_point(static_cast<double>(i), static_cast<double>(j));
      plot.field.heights(i, j) = f(g.x(), g.y());
    }
  return plot;
}

double bump(double x, double y) { return std::exp(-4 * (x * x + y * y)) - 0.3; }

Color color_at(const Image& image, const Point<2>& p, double scale) {
  return image.at(static_cast<int>(p.x() * scale), static_cast<int>(p.y() * scale));
}

TEST(HeightField, IsBilinearBetweenItsPoints) {
  const HeightPlot plot = plot_of([](double x, double y) { return 2 * x - 3 * y + 1; }, 5);
  EXPECT_NEAR(plot.field.height_at({0.3, -0.7}), 2 * 0.3 + 3 * 0.7 + 1, 1e-12);
  EXPECT_NEAR(plot.field.height_at({1, 1}), 0, 1e-12);
  EXPECT_TRUE(std::isnan(plot.field.height_at({1.01, 0})));
}

TEST(HeightProjection, FromAboveItIsAMap) {
  HeightPlot plot = plot_of(bump);
  plot.azimuth = -90;
  plot.elevation = 90;
  const HeightProjection view = project(plot, {0, 0, 200, 200});
  EXPECT_LT((view.pixel_from_scene({-1, 1, 0}) - Point<2>(0, 0)).norm(), 1e-9);
  EXPECT_LT((view.pixel_from_scene({1, -1, 0}) - Point<2>(200, 200)).norm(), 1e-9);
  EXPECT_LT((view.pixel_from_scene({0, 0, 5}) - Point<2>(100, 100)).norm(), 1e-9) << "height does not show";
}

TEST(HeightProjection, UpIsUpNearIsLowAndParallelsStayParallel) {
  const HeightProjection view = project(plot_of(bump), {0, 0, 300, 200});
  const Point<2> o = view.pixel_from_scene({0, 0, 0});
  const Point<2> z = view.pixel_from_scene({0, 0, 0.5}) - o;
  EXPECT_NEAR(z.x(), 0, 1e-9);
  EXPECT_LT(z.y(), 0);
  EXPECT_GT(view.pixel_from_scene({0.3, -1, 0}).y(), o.y());
  EXPECT_LT((view.pixel_from_scene({0.5, 0.5, 0.7}) - view.pixel_from_scene({0.5, 0.5, 0.2}) - z).norm(),
            1e-9);
}

TEST(HeightProjection, FitsItsRegionTightly) {
  HeightPlot plot = plot_of(bump);
  plot.poles.push_back({.top = {0, 0, 2}});
  const Rect region{10, 20, 300, 200};
  const HeightProjection view = project(plot, region);
  Box<2> page;
  for (Index i = 0; i < 41; ++i)
    for (Index j = 0; j < 41; ++j) {
      const Point<2> g = plot.field.ground_point(static_cast<double>(i), static_cast<double>(j));
      page.extend(view.pixel_from_scene({g.x(), g.y(), plot.field.heights(i, j)}));
      page.extend(view.pixel_from_scene({g.x(), g.y(), 0}));
    }
  page.extend(view.pixel_from_scene({0, 0, 2}));
  EXPECT_TRUE(region.inset(-1e-9).contains(page.min()));
  EXPECT_TRUE(region.inset(-1e-9).contains(page.max()));
  EXPECT_LT(std::min(region.width - page.sizes().x(), region.height - page.sizes().y()), 1e-6);
}

TEST(HeightProjection, ReliefIsAFractionOfTheGround) {
  HeightPlot plot = plot_of(bump);
  plot.relief = 0.5;
  const double range = plot.field.heights.maxCoeff() - plot.field.heights.minCoeff();
  EXPECT_NEAR(project(plot, {0, 0, 100, 100}).exaggeration() * range, 0.5 * 2, 1e-12);
  plot.exaggeration = 3;
  EXPECT_EQ(project(plot, {0, 0, 100, 100}).exaggeration(), 3);
}

TEST(HeightProjection, AHillHidesWhatIsBehindIt) {
  HeightPlot plot = plot_of(bump);
  plot.azimuth = -90;
  plot.elevation = 15;
  const HeightProjection view = project(plot, {0, 0, 300, 200});
  EXPECT_FALSE(view.sees({0, 0.6, 0}, plot.field, 1e-3)) << "behind the hill";
  EXPECT_TRUE(view.sees({0, -0.6, 0}, plot.field, 1e-3)) << "before it";
  EXPECT_TRUE(view.sees({0.9, 0.6, 0}, plot.field, 1e-3)) << "beside it";
  EXPECT_FALSE(view.sees({0, 0, 0}, plot.field, 1e-3)) << "inside it";
  plot.elevation = 90;
  EXPECT_TRUE(project(plot, {0, 0, 300, 200}).sees({0, 0.8, 0}, plot.field, 1e-3));
  EXPECT_FALSE(project(plot, {0, 0, 300, 200}).sees({0, 0, 0}, plot.field, 1e-3));
}

TEST(HeightPlot, OrangeAboveBlueBelow) {
  HeightPlot plot = plot_of(bump);
  plot.zero_plane = false;
  plot.elevation = 60;
  Canvas canvas(300, 200);
  const HeightProjection view = draw_height_plot(canvas, canvas.bounds().inset(5), plot);
  const Image image = canvas.image(2);
  const Color top = color_at(image, view.pixel_from_scene({0, 0, bump(0, 0)}), 2);
  const Color low = color_at(image, view.pixel_from_scene({0.8, -0.8, bump(0.8, -0.8)}), 2);
  EXPECT_GT(top.r, top.b + 0.2);
  EXPECT_GT(low.b, low.r + 0.1);
}

TEST(HeightPlot, TheSheetVeilsWhatIsBelowAndNotWhatIsAbove) {
  HeightPlot plot = plot_of(bump);
  plot.elevation = 60;
  Canvas with(300, 200), without(300, 200);
  const HeightProjection view = draw_height_plot(with, with.bounds().inset(5), plot);
  plot.zero_plane = false;
  draw_height_plot(without, without.bounds().inset(5), plot);
  const Image a = with.image(2), b = without.image(2);
  const Point<2> top = view.pixel_from_scene({0, -0.1, bump(0, -0.1)}),
                 low = view.pixel_from_scene({0.5, -0.7, bump(0.5, -0.7)});
  EXPECT_EQ(color_at(a, top, 2), color_at(b, top, 2));
  EXPECT_GT(lab_of(color_at(a, low, 2)).L, lab_of(color_at(b, low, 2)).L + 3);
}

TEST(HeightPlot, NearLandHidesFarLandFromEverySide) {
  // A wall before a dark pit: from the wall's side the pit's floor cannot be seen, whatever the side.
  for (const double azimuth : {-90.0, 0.0, 90.0, 180.0, -45.0, 135.0}) {
    const double a = azimuth * 3.14159265358979 / 180;
    HeightPlot plot = plot_of([&](double x, double y) {
      const double d = x * std::cos(a) + y * std::sin(a);  // grows toward the camera
      return std::exp(-30 * (d - 0.3) * (d - 0.3)) - 0.6 * std::exp(-30 * (d + 0.1) * (d + 0.1)) + 0.01;
    });
    plot.azimuth = azimuth;
    plot.elevation = 20;
    plot.zero_plane = false;
    Canvas canvas(300, 300);
    const HeightProjection view = draw_height_plot(canvas, canvas.bounds().inset(5), plot);
    const Color seen =
        color_at(canvas.image(2), view.pixel_from_scene({-0.1 * std::cos(a), -0.1 * std::sin(a), -0.55}), 2);
    EXPECT_GT(seen.r, seen.b) << azimuth << ": the wall's orange, not the pit's blue";
  }
}

TEST(HeightPlot, TheCurveIsBoldWhereItIsInSight) {
  HeightPlot plot = plot_of(bump, 81);
  plot.azimuth = -90;
  plot.elevation = 25;
  Points<2> circle(2, 181);
  const double radius = std::sqrt(-std::log(0.3) / 4);
  for (Index i = 0; i <= 180; ++i) {
    const double a = static_cast<double>(i) * 2 * 3.14159265358979 / 180;
    circle.col(i) << radius * std::cos(a), radius * std::sin(a);
  }
  plot.zero_curves = {circle};
  Canvas canvas(300, 200);
  const HeightProjection view = draw_height_plot(canvas, canvas.bounds().inset(5), plot);
  const Image image = canvas.image(4);
  EXPECT_LT(delta_e(lab_of(color_at(image, view.pixel_from_scene({0, -radius, 0}), 4)), lab_of(theme::curve)),
            3);
  EXPECT_LT(delta_e(lab_of(color_at(image, view.pixel_from_scene({radius, 0, 0}), 4)), lab_of(theme::curve)),
            3);
  EXPECT_GT(delta_e(lab_of(color_at(image, view.pixel_from_scene({0, radius, 0}), 4)), lab_of(theme::curve)),
            30);
}

TEST(HeightPlot, PolesStandFromTheSheetToTheirHeads) {
  HeightPlot plot = plot_of([](double, double) { return -0.5; });
  plot.poles.push_back({.top = {0.3, -0.2, 0.4}, .head = Symbol::plus, .color = theme::moved, .size = 10});
  Canvas canvas(300, 200);
  const HeightProjection view = draw_height_plot(canvas, canvas.bounds().inset(20), plot);
  const Image image = canvas.image(4);
  for (const double z : {0.0, 0.1, 0.2, 0.4})
    EXPECT_LT(
        delta_e(lab_of(color_at(image, view.pixel_from_scene({0.3, -0.2, z}), 4)), lab_of(theme::moved)), 8)
        << z;
}

TEST(HeightPlot, HolesAreLeftOutAndTheRestIsDrawn) {
  HeightPlot plot = plot_of([](double x, double) { return x > 0 ? std::nan("") : 0.5; });
  plot.zero_plane = false;
  plot.azimuth = -90;
  plot.elevation = 90;
  Canvas canvas(100, 100);
  draw_height_plot(canvas, canvas.bounds(), plot);
  const Image image = canvas.image(1);
  EXPECT_EQ(image.at(75, 50), theme::paper);
  EXPECT_NE(image.at(25, 50), theme::paper);
}

TEST(HeightPlot, RefusesWhatCannotBeDrawn) {
  Canvas canvas(100, 100);
  HeightPlot thin = plot_of(bump);
  thin.field.heights.resize(1, 5);
  EXPECT_THROW(draw_height_plot(canvas, canvas.bounds(), thin), Error);
  HeightPlot empty = plot_of(bump);
  empty.field.ground = Box<2>();
  EXPECT_THROW(draw_height_plot(canvas, canvas.bounds(), empty), Error);
  EXPECT_THROW(
      draw_height_plot(canvas, canvas.bounds(), plot_of([](double, double) { return std::nan(""); })), Error);
}

TEST(HeightPlot, FlatLandAtZeroIsDrawnOnce) {
  HeightPlot plot = plot_of([](double, double) { return 0.0; }, 3);
  plot.elevation = 90;
  Canvas canvas(100, 100);
  EXPECT_NO_THROW(draw_height_plot(canvas, canvas.bounds(), plot));
  EXPECT_NE(canvas.image(1).at(50, 50), theme::paper);
}

}  // namespace
}  // namespace seesaw
