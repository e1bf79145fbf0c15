// A scene's picture: where things are on the page, and which colors stand there.
#include "core/scene/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/implicit/primitives.h"
#include "core/scene/field_layer.h"
#include "tests/support/shapes.h"

namespace seesaw {
namespace {

Document<2> pictured_example() {
  Document<2> document;
  for (const auto& constraint : four_around_one()) document.constraints.push_back({.constraint = constraint});
  return document;
}

Color color_at(const Image& image, const Point<2>& page) {
  return image.at(static_cast<int>(page.x()), static_cast<int>(page.y()));
}

TEST(PlanView, KeepsShapesAndShowsAll) {
  const Box<2> scene(Point<2>(-1, 0), Point<2>(3, 1));
  const PlanView view = plan_view(scene, {10, 20, 200, 100});
  EXPECT_EQ(view.scale, 50);  // the width decides
  EXPECT_TRUE(view.scene.contains(scene));
  EXPECT_EQ(view.page_from_scene(Point<2>(1, 0.5)), Point<2>(110, 70));  // middle to middle
  EXPECT_EQ(view.page_from_scene(Point<2>(1, 1.5)), Point<2>(110, 20));  // y points up
  const Point<2> p(0.3, -0.2);
  EXPECT_LE((view.scene_from_page(view.page_from_scene(p)) - p).norm(), 1e-14);
}

TEST(PlanView, AScenesOwnViewWins) {
  Document<2> document = pictured_example();
  const Fit<2> fitted = fit(document);
  const Box<2> chosen = view_box(document, fitted.function);
  for (const auto& each : document.constraints) EXPECT_TRUE(chosen.contains(each.constraint.at));
  EXPECT_EQ(contour(document, fitted.function, chosen).closed, 1);
  document.display.view = Box<2>(Point<2>(0, 0), Point<2>(1, 1));
  EXPECT_EQ(view_box(document, fitted.function).max(), Point<2>(1, 1));
}

TEST(PlanView, OneConstraintStillHasAView) {
  Document<2> document;
  document.constraints.push_back({.constraint = boundary<2>({5, 5})});
  const Fit<2> fitted = fit(document);
  const Box<2> box = view_box(document, fitted.function);
  EXPECT_TRUE(box.contains(Point<2>(5, 5)));
  EXPECT_GT(box.sizes().minCoeff(), 0);
}

TEST(Isolines, LevelsAreRoundNumbersOnBothSides) {
  EXPECT_THAT(isoline_levels(-1.3, 1.1), testing::ElementsAre(-1, -0.5, -0.2, -0.1, 0.1, 0.2, 0.5, 1));
  EXPECT_THAT(isoline_levels(-30, 0.4), testing::ElementsAre(-20, -10, -5, -2, 0.02, 0.05, 0.1, 0.2));
  EXPECT_THAT(isoline_levels(0, 0), testing::IsEmpty());
  EXPECT_THAT(isoline_levels(0, 3e-9), testing::Each(testing::Gt(0)));
}

TEST(Isolines, ColorsDeepenWithTheValueAndKeepItsSign) {
  EXPECT_EQ(color_depth(0, 2), 0);
  EXPECT_EQ(color_depth(2, 2), 1);
  EXPECT_EQ(color_depth(-0.5, 2), -0.5);
}

TEST(Picture, InsideIsWarmOutsideIsCoolAndTheCurveIsDark) {
  Document<2> document = pictured_example();
  document.display.field = true;
  document.constraints[1].highlight = true;
  const Fit<2> fitted = fit(document);
  Canvas canvas(240, 240);
  const DrawnPicture drawn = draw_document(canvas, canvas.bounds(), document, fitted.function);
  EXPECT_EQ(drawn.curve.seeds_on_curve, 4);
  const Image image = canvas.image(1);
  const Color inside = color_at(image, drawn.view.page_from_scene(Point<2>(0.15, 0.2)));
  const Color outside = color_at(image, {5, 5});
  EXPECT_GT(inside.r, inside.b + 0.1);
  EXPECT_GT(outside.b, outside.r + 0.1);
  // A vertex of the curve away from the symbols.
  const Polyline& curve = drawn.curve.polylines[0];
  for (Index i = 0; i < curve.vertices.cols(); i += 7) {
    const Point<2> page = drawn.view.page_from_scene(Point<2>(curve.vertices.col(i)));
    double clear = 1e9;
    for (const auto& each : document.constraints)
      clear = std::min(clear, (drawn.view.page_from_scene(each.constraint.at) - page).norm());
    if (clear < 10) continue;
    const Color color = color_at(image, page);
    EXPECT_LT(color.r + color.g + color.b, 1.6);
  }
  // The highlighted circle has a red rim.
  const Point<2> at = drawn.view.page_from_scene(document.constraints[1].constraint.at);
  bool red = false;
  for (int dx = -6; dx <= 6; ++dx) {
    const Color color = color_at(image, at + Point<2>(dx, 0));
    red = red || (color.r > 0.6 && color.g < 0.45 && color.b < 0.4);
  }
  EXPECT_TRUE(red);
}

TEST(Picture, EverySwitchChangesIt) {
  Document<2> document = pictured_example();
  document.constraints[0].constraint.normal = NormalConstraint<2>{{-1, 0}, 0.01, 0.01};
  const Fit<2> fitted = fit(document);
  const auto picture = [&](const Document<2>& d) {
    Canvas canvas(200, 200);
    draw_document(canvas, canvas.bounds(), d, fitted.function);
    return canvas.image(1);
  };
  const Image plain = picture(document);
  EXPECT_EQ(picture(document), plain);  // the same document, the same bytes
  for (const auto& each : display_switches<2>) {
    Document<2> changed = document;
    changed.display.*each.member = !(changed.display.*each.member);
    EXPECT_FALSE(picture(changed) == plain) << each.key;
  }
}

TEST(Picture, DrawsAnyField) {  // the picture needs a Field, not an interpolant
  Document<2> document;
  document.display.view = Box<2>(Point<2>(-2, -2), Point<2>(2, 2));
  Canvas canvas(100, 100);
  const DrawnPicture drawn = draw_document(canvas, canvas.bounds(), document, Sphere<2>({0, 0}, 1));
  EXPECT_EQ(drawn.curve.closed, 1);
  EXPECT_NEAR(drawn.curve.area, M_PI, 0.01);
}

}  // namespace
}  // namespace seesaw
