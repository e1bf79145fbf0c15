#include "core/window/view_3d.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/image/theme.h"
#include "core/window/ui.h"
#include "tests/core/window/stage.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

const Color sky = hex("#000000");

/// A square in the plane z = height, x and y from -half to half, facing up.
TriangleMesh level_square(double height, double half = 1) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << -half, half, half, -half, -half, -half, half, half, height, height, height, height;
  mesh.faces.resize(3, 2);
  mesh.faces << 0, 0, 1, 2, 2, 3;
  return mesh;
}

OrbitCamera from_above() { return {.distance = 5, .azimuth = -std::numbers::pi / 2, .elevation = 1.5}; }

double lit_part(const Image& image) {
  double count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += image.at(x, y) != sky;
  return count / (image.width() * image.height());
}

TEST(OrbitCamera, APixelsRayMeetsThePointThatIsSeenThere) {
  const OrbitCamera camera{
      .target = {1, -2, 3}, .distance = 7, .azimuth = 0.7, .elevation = -0.4, .field = 0.9};
  EXPECT_NEAR((camera.eye() - camera.target).norm(), 7, 1e-12);
  EXPECT_NEAR(camera.right().dot(camera.up()), 0, 1e-15);
  const Point<3> middle = camera.pixel_of(camera.target, 640, 480);
  EXPECT_NEAR(middle.x(), 320, 1e-9);
  EXPECT_NEAR(middle.y(), 240, 1e-9);
  EXPECT_NEAR(middle.z(), 7, 1e-12);
  for (const Point<3>& p : {Point<3>(1.5, -2, 3.2), Point<3>(0, -1, 4), Point<3>(2, -4, 2)}) {
    const Point<3> pixel = camera.pixel_of(p, 640, 480);
    const Point<3> ray = camera.ray_through(pixel.head<2>(), 640, 480);
    EXPECT_NEAR(ray.cross(p - camera.eye()).norm(), 0, 1e-12);
    EXPECT_GT(ray.dot(p - camera.eye()), 0);
    // OpenGL's matrices say the same.
    const Eigen::Vector4d clip =
        camera.clip_from_camera(640, 480) * (camera.camera_from_scene() * p.homogeneous());
    EXPECT_NEAR((clip.x() / clip.w() + 1) * 320, pixel.x(), 1e-9);
    EXPECT_NEAR((1 - clip.y() / clip.w()) * 240, pixel.y(), 1e-9);
  }
}

TEST(OrbitCamera, FollowsTheHand) {
  OrbitCamera camera;
  const Point<3> before = camera.target;
  camera.orbit(-37, 0, 400);
  EXPECT_EQ(camera.target, before);
  EXPECT_NEAR((camera.eye() - camera.target).norm(), camera.distance, 1e-12);
  camera.orbit(0, 1e6, 400);
  EXPECT_LT(camera.elevation, std::numbers::pi / 2);
  camera.elevation = 0.5;
  // What the hand has taken hold of stays under it.
  camera.pan(30, -20, 400);
  const Point<3> pixel = camera.pixel_of(before, 640, 400);
  EXPECT_NEAR(pixel.x(), 320 + 30, 1e-9);
  EXPECT_NEAR(pixel.y(), 200 - 20, 1e-9);
  const double distance = camera.distance;
  camera.zoom(2);
  EXPECT_LT(camera.distance, distance);
  camera.zoom(-2);
  EXPECT_NEAR(camera.distance, distance, 1e-12);
  camera.frame({1, 1, 1}, 2, 300, 400);
  // A ball's outline just fits: seen under an angle whose sine is radius / distance.
  EXPECT_NEAR(std::asin(2 / camera.distance), std::atan(std::tan(camera.field / 2) * 0.75), 1e-12);
}

TEST(View3D, NearTrianglesHideFarOnesWhateverTheOrder) {
  SEESAW_WINDOW_OR_SKIP(window);
  View3D view;
  Drawable low, high;
  low.set_triangles(level_square(0, 1.48));
  high.set_triangles(level_square(1));
  for (const bool high_first : {false, true}) {
    view.begin(120, 120, from_above(), sky);
    const DrawLook red{.color = hex("#FF0000"), .lit = false}, blue{.color = hex("#0000FF"), .lit = false};
    if (high_first) view.draw(high, red);
    view.draw(low, blue);
    if (!high_first) view.draw(high, red);
    view.end();
    const Image image = view.image();
    EXPECT_EQ(image.at(60, 60), hex("#FF0000"));
    const Point<3> beside = from_above().pixel_of({1.4, 0, 0}, 120, 120);
    EXPECT_EQ(image.at(static_cast<int>(beside.x()), static_cast<int>(beside.y())), hex("#0000FF"));
    EXPECT_EQ(image.at(0, 60), sky);
  }
}

TEST(View3D, PointsAndLinesStandWhereTheCameraSaysAndAreAsWideAsAsked) {
  SEESAW_WINDOW_OR_SKIP(window);
  View3D view;
  const OrbitCamera camera{.distance = 6, .azimuth = 0.4, .elevation = 0.3};
  Points<3> points(3, 2);
  points << 0.5, -1, 0.2, 0.9, 0.7, -0.4;
  Drawable dots, line;
  dots.set_points(points.leftCols(1));
  line.set_polyline(points);
  for (const bool dot : {true, false}) {
    view.begin(200, 160, camera, sky);
    view.draw(dot ? dots : line, {.color = hex("#FFFFFF"), .size = 9, .lit = false});
    view.end();
    const Image image = view.image();
    double weight = 0;
    Point<2> center(0, 0);
    for (int y = 0; y < 160; ++y)
      for (int x = 0; x < 200; ++x) {
        const double w = image.at(x, y).r;
        weight += w;
        center += w * Point<2>(x + 0.5, y + 0.5);
      }
    const Point<2> a = camera.pixel_of(points.col(0), 200, 160).head<2>(),
                   b = camera.pixel_of(points.col(1), 200, 160).head<2>();
    const Point<2> wanted = dot ? a : Point<2>((a + b) / 2);
    EXPECT_LT((center / weight - wanted).norm(), 0.5) << dot;
    const double area = dot ? std::numbers::pi * 4.5 * 4.5 : 9 * (b - a).norm();
    EXPECT_NEAR(weight / area, 1, 0.05) << dot;
  }
}

// Cut at the near plane, not turned inside out: a line from before the eye to behind it.
TEST(View3D, ALineThatPassesTheEyeEndsAtThePicturesEdge) {
  SEESAW_WINDOW_OR_SKIP(window);
  View3D view;
  const OrbitCamera camera{.distance = 2, .azimuth = 0, .elevation = 0};
  Points<3> ends(3, 2);
  ends << 0, 5, 0, 0.4, 0, 0;
  Drawable line;
  line.set_segments(ends);
  view.begin(100, 100, camera, sky);
  view.draw(line, {.color = hex("#FFFFFF"), .size = 3});
  view.end();
  const Image image = view.image();
  EXPECT_EQ(image.at(50, 50), hex("#FFFFFF"));
  EXPECT_EQ(image.at(70, 50), hex("#FFFFFF"));
  EXPECT_EQ(image.at(40, 50), sky);
}

TEST(View3D, LightFollowsNormalsAndBothSidesAreLit) {
  SEESAW_WINDOW_OR_SKIP(window);
  View3D view;
  TriangleMesh square = level_square(0);
  const auto brightness = [&](double elevation) {
    Drawable drawable;
    drawable.set_triangles(square);
    view.begin(60, 60, {.distance = 5, .azimuth = 0, .elevation = elevation}, sky);
    view.draw(drawable, {.color = hex("#808080")});
    view.end();
    return view.image().at(30, 30).r;
  };
  const double above = brightness(1.2), flat = brightness(0.1), below = brightness(-1.2);
  EXPECT_GT(above, flat + 0.04);
  EXPECT_GT(below, 0.3);
  // Given normals win over the facet's own, of any length.
  square.normals = Points<3>::Zero(3, 4);
  square.normals.row(2).setConstant(3);
  EXPECT_NEAR(brightness(1.2), above, 0.02);
}

TEST(View3D, TranslucentThingsMixAndHideNothing) {
  SEESAW_WINDOW_OR_SKIP(window);
  View3D view;
  Drawable low, high;
  low.set_triangles(level_square(0));
  high.set_triangles(level_square(1, 0.5));
  view.begin(80, 80, from_above(), sky);
  view.draw(high, {.color = hex("#FF0000"), .opacity = 0.25, .lit = false});
  view.draw(low, {.color = hex("#0000FF"), .opacity = 0.5, .lit = false});
  view.end();
  const Color mixed = view.image().at(40, 40);
  EXPECT_NEAR(mixed.r, 0.125, 0.01);
  EXPECT_NEAR(mixed.b, 0.5, 0.01);
}

TEST(View3D, ColorsOfVerticesNothingToDrawAndSmoothEdges) {
  SEESAW_WINDOW_OR_SKIP(window);
  View3D rough, smooth(4);
  Drawable square, nothing;
  square.set_triangles(level_square(0), std::vector<Color>(4, hex("#20C040")));
  nothing.set_points(Points<3>(3, 0));
  EXPECT_TRUE(nothing.empty());
  const OrbitCamera tilted{.distance = 6, .azimuth = 0.6, .elevation = 1};
  int mixed[2] = {};
  for (View3D* view : {&rough, &smooth}) {
    view->begin(90, 70, tilted, sky);
    view->draw(nothing);
    view->draw(Drawable());
    view->draw(square, {.lit = false});
    view->end();
    const Image image = view->image();
    EXPECT_EQ(image.at(45, 35), hex("#20C040"));
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 90; ++x)
        mixed[view == &smooth] += image.at(x, y).g > 0.01 && image.at(x, y).g < 0.74;
  }
  EXPECT_EQ(mixed[0], 0);
  EXPECT_GT(mixed[1], 50);
  // The same view at another size, and a Drawable that gets other contents.
  square.set_triangles(TriangleMesh());
  rough.begin(33, 44, tilted, sky);
  rough.draw(square);
  rough.end();
  EXPECT_EQ(rough.image().width(), 33);
  EXPECT_EQ(lit_part(rough.image()), 0);
}

/// f = 1 - x^2 - y^2 + x / 2, tipped, over a square, colored by its sign.
TriangleMesh plate(int n, std::vector<Color>& colors) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, n * n);
  mesh.faces.resize(3, 2 * (n - 1) * (n - 1));
  Index face = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = 3.0 * i / (n - 1) - 1.5, y = 3.0 * j / (n - 1) - 1.5,
                   f = 0.5 * (1 - x * x - y * y + x / 2);
      mesh.vertices.col(j * n + i) << x, y, f;
      colors.push_back(f >= 0 ? hex("#E0A060") : hex("#7FA8CC"));
      if (i + 1 == n || j + 1 == n) continue;
      const int a = j * n + i;
      mesh.faces.col(face++) << a, a + 1, a + n + 1;
      mesh.faces.col(face++) << a, a + n + 1, a + n;
    }
  return mesh;
}

// The see-saw in a panel: SEESAW_KEEP=1 leaves its picture.
TEST(View3D, APlateInAPanelIsOrbitedByTheMouse) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 520, .height = 400});
  View3D view(4);
  std::vector<Color> colors;
  Drawable surface, zero, pole, ends;
  surface.set_triangles(plate(60, colors), colors);
  zero.set_triangles(level_square(0, 1.7));
  Points<3> at(3, 2);
  at << 0.25, 0.25, 0, 0, 0, 0.53125;
  pole.set_segments(at);
  ends.set_points(at);
  OrbitCamera camera{.distance = 7};
  const ScratchFolder folder;
  const auto path = folder / "plate.png";
  const auto draw = [&] {
    if (const auto panel = ui::panel("See-saw", {10, 10, 500, 380})) {
      const int width = static_cast<int>(ui::width_left()), height = static_cast<int>(ui::height_left());
      view.begin(width, height, camera, ui::colors().panel);
      view.draw(surface);
      view.draw(pole, {.color = theme::ink, .size = 3});
      view.draw(ends, {.color = theme::moved, .size = 11});
      view.draw(zero, {.color = theme::series[0], .opacity = 0.25, .lit = false});
      const ui::PictureUse use = ui::picture("Plate", view.end(), width, height);
      if (use.held) camera.orbit(use.dx, use.dy, height);
      camera.zoom(use.wheel);
    }
  };
  const Played before = play(window, "frames 2\nscreenshot \"" + path.string() + "\"", draw);
  const double azimuth = camera.azimuth;
  const Played after = play(window, "drag \"Plate\" \"Plate\" +60 +10 4\nwheel 0 1\nframes 1\n", draw);
  EXPECT_LT(camera.azimuth, azimuth - 0.3);
  EXPECT_LT(camera.distance, 7);
  EXPECT_FALSE(before.picture == after.picture);
}

}  // namespace
}  // namespace seesaw
