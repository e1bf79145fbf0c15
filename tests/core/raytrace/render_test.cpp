// Pictures: shadows, mirrors, floors, discs, cameras, and the same pixels on any number of threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>

#include "core/base/random.h"
#include "core/implicit/booleans.h"
#include "core/implicit/primitives.h"
#include "core/implicit/torus.h"
#include "core/raytrace/evaluation_counts.h"
#include "core/raytrace/heuristic_tracer.h"
#include "core/raytrace/render.h"
#include "core/raytrace/rigorous_tracer.h"

namespace seesaw {
namespace {

const RenderOptions quick = {.width = 64, .height = 64, .samples = 1, .ambient_rays = 0};

Solid traced_ball(const Point<3>& center, double radius, const Material& material = {}) {
  return Solid(std::make_shared<RigorousTracer>(share(Sphere<3>(center, radius))), material);
}

SpheresObject spheres(const Point<3>& center, double radius, const Material& material = {}) {
  return {.centers = center, .radii = Values::Constant(1, radius), .material = material};
}

// A sphere of triangles: the faces of an octahedron, cut in four `times` times and pushed out.
TriangleMesh sphere_mesh(int times) {
  std::vector<Point<3>> vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<int, 3>> faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                           {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int k = 0; k < times; ++k) {
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const int first = static_cast<int>(vertices.size());
      const auto half = [&](int p, int q) {
        return Point<3>(
            (vertices[static_cast<std::size_t>(p)] + vertices[static_cast<std::size_t>(q)]).normalized());
      };
      const Point<3> ab = half(a, b), bc = half(b, c), ca = half(c, a);
      vertices.insert(vertices.end(), {ab, bc, ca});
      finer.insert(finer.end(), {{a, first, first + 2},
                                 {first, b, first + 1},
                                 {first + 2, first + 1, c},
                                 {first, first + 1, first + 2}});
    }
    faces = finer;
  }
  TriangleMesh mesh;
  mesh.vertices.resize(3, static_cast<Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.vertices.col(static_cast<Index>(i)) = vertices[i];
  mesh.normals = mesh.vertices;
  mesh.faces.resize(3, static_cast<Index>(faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f)
    mesh.faces.col(static_cast<Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
  return mesh;
}

int largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.bytes().size(); ++i)
    largest = std::max(largest, std::abs(int{a.bytes()[i]} - int{b.bytes()[i]}));
  return largest;
}

double lightness(const Image& image, const Point<2>& place) {
  // `place` as the camera has it: the picture is 1 high.
  const int x = static_cast<int>(place.x() * image.height()),
            y = static_cast<int>(place.y() * image.height());
  return lab_of(image.at(x, y)).L;
}

// Everything at once, for the tests that are about how and not what.
Scene everything() {
  Scene scene;
  scene.meshes.push_back({.mesh = sphere_mesh(2), .flat = true, .edges = {.width = 1}});
  scene.spheres.push_back(spheres({2, 0, 0}, 0.7, {.color = surface::blue, .mirror = 0.5}));
  scene.discs.push_back({.centers = Point<3>(0, 0, 1.5),
                         .normals = Point<3>(0.3, 0, 1),
                         .radii = Values::Constant(1, 0.4),
                         .material = {.color = surface::marker}});
  const auto torus = std::make_shared<RigorousTracer>(share(Torus({-2, 0, 0}, {0.2, 1, 0.4}, 0.7, 0.3)));
  scene.solids.push_back(Solid(torus, {.color = surface::orange, .mirror = 0.3}) -
                         traced_ball({-2, 0, 0.7}, 0.5));
  scene.floor = floor_under(bounding_box(scene), Point<3>::UnitY(), Floor::Look::checker);
  scene.floor.mirror = 0.2;
  return scene;
}

TEST(Render, TheSamePixelsOnAnyNumberOfThreads) {
  const Scene scene = everything();
  const RenderOptions options = {.width = 80, .height = 60, .samples = 4, .ambient_rays = 1};
  const PinholeCamera camera = frame(scene, {.aspect = 80. / 60});
  const Image on_all = render(scene, camera, options);
  const auto counts = count_evaluations(scene, camera, options).counts;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  // A scene of its own: its boxes are found in another order.
  EXPECT_EQ(render(everything(), camera, options), on_all);
  EXPECT_EQ(count_evaluations(everything(), camera, options).counts, counts);
}

// The same ball by Embree's triangles, by Embree's sphere, and by both tracers of its field.
TEST(Render, MeshAndTracedSphereAgree) {
  Scene mesh, exact, rigorous, heuristic;
  mesh.meshes.push_back({.mesh = sphere_mesh(6)});
  exact.spheres.push_back(spheres({0, 0, 0}, 1));
  rigorous.solids.push_back(traced_ball({0, 0, 0}, 1));
  heuristic.solids.push_back(Solid(std::make_shared<HeuristicTracer>(share(Sphere<3>({0, 0, 0}, 1)))));
  const PinholeCamera camera = frame(Box<3>(Point<3>(-1, -1, -1), Point<3>(1, 1, 1)));
  const Image by_mesh = render(mesh, camera, quick), by_embree = render(exact, camera, quick);
  const Image by_bounds = render(rigorous, camera, quick), by_samples = render(heuristic, camera, quick);
  // Triangles of 1/64 stand a 1e-4 inside the sphere, and its normals are exact: shades within 2 of 255, but
  // for pixels whose one ray passes the outline between the two.
  int different = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      different += std::abs(int{by_mesh.pixel(x, y)[0]} - int{by_embree.pixel(x, y)[0]}) > 2;
  EXPECT_LE(different, 2);
  EXPECT_LE(largest_difference(by_embree, by_bounds), 1);
  EXPECT_LE(largest_difference(by_bounds, by_samples), 1);
}

// A light straight above a ball of radius 1 that floats 2 above the floor: its shadow is the disc of radius 1
// below.
TEST(Render, ShadowsFallWhereGeometrySays) {
  for (const bool traced : {false, true}) {
    Scene scene;
    if (traced)
      scene.solids.push_back(traced_ball({0, 2, 0}, 1));
    else
      scene.spheres.push_back(spheres({0, 2, 0}, 1));
    scene.floor = {.look = Floor::Look::plain, .point = {0, 0, 0}};
    scene.lights = {{.at = {0, 1, 0}}};
    const PinholeCamera camera = {.eye = {0, 3, 12}, .target = {0, 1, 0}};
    const Image image = render(scene, camera, {.width = 300, .height = 300, .samples = 1, .ambient_rays = 0});
    int dark = 0, light = 0;
    for (int k = 0; k < 60; ++k) {
      const Point<3> spoke(std::cos(k * 0.1), 0, std::sin(k * 0.1));
      dark += lightness(image, picture_place(camera, 0.93 * spoke, 1)) < 90;
      light += lightness(image, picture_place(camera, 1.07 * spoke, 1)) > 99;
    }
    EXPECT_EQ(dark, 60) << traced;
    EXPECT_EQ(light, 60) << traced;
    // A light that throws no shadows, or none at all there, leaves the floor as it is.
    scene.lights[0].shadows = false;
    const Image without =
        render(scene, camera, {.width = 300, .height = 300, .samples = 1, .ambient_rays = 0});
    EXPECT_GT(lightness(without, picture_place(camera, {0, 0, 0}, 1)), 99);
  }
}

// A large soft light: the middle of the penumbra is between the full shadow and the light.
TEST(Render, SoftLightsHavePenumbras) {
  Scene scene;
  scene.spheres.push_back(spheres({0, 2, 0}, 1));
  scene.floor = {.look = Floor::Look::plain, .point = {0, 0, 0}};
  scene.lights = {{.at = {0, 1, 0}, .softness = 10}};
  const PinholeCamera camera = {.eye = {0, 3, 12}, .target = {0, 1, 0}};
  const Image image = render(scene, camera, {.width = 200, .height = 200, .samples = 64, .ambient_rays = 0});
  const double middle = lightness(image, picture_place(camera, {0, 0, 0.3}, 1));
  const double half = lightness(image, picture_place(camera, {1, 0, 0}, 1));
  const double outside = lightness(image, picture_place(camera, {1.6, 0, 0}, 1));
  EXPECT_LT(middle + 5, half);
  EXPECT_LT(half + 5, outside);
}

// A mirror at x = 0 (a large disc) beside a red ball at x = 1: where the ball's mirror image stands, at x =
// -1, the picture is red.
TEST(Render, MirrorsShowTheOtherObject) {
  Scene scene;
  scene.discs.push_back({.centers = Point<3>(0, 0, 0),
                         .normals = Point<3>(1, 0, 0),
                         .radii = Values::Constant(1, 4),
                         .material = {.color = hex("#FFFFFF"), .mirror = 1}});
  scene.solids.push_back(traced_ball({1, 0, 0}, 0.4, {.color = hex("#FF0000")}));
  const PinholeCamera camera = {.eye = {6, 0, 6}, .target = {0, 0, 0}};
  const RenderOptions options = {.width = 200, .height = 200, .samples = 1};
  const Point<2> image_place = picture_place(camera, {-1, 0, 0}, 1);
  const auto is_red = [&](const Image& image) {
    const Color color =
        image.at(static_cast<int>(image_place.x() * 200), static_cast<int>(image_place.y() * 200));
    return color.r > 2 * color.g;
  };
  EXPECT_TRUE(is_red(render(scene, camera, options)));
  RenderOptions no_reflections = options;
  no_reflections.max_depth = 0;
  EXPECT_FALSE(is_red(render(scene, camera, no_reflections)));
}

// CSG's cut shows the color of what was cut away, lit from the cut's own side.
TEST(Render, CutsShowTheCuttersMaterial) {
  Scene scene;
  scene.solids.push_back(traced_ball({0, 0, 0}, 1, {.color = hex("#0000FF")}) -
                         traced_ball({0, 0, 1}, 0.7, {.color = hex("#FF0000")}));
  scene.lights = {{.at = {0, 0, 1}}};
  const PinholeCamera camera = {.eye = {0, 0, 6}, .target = {0, 0, 0}};
  const Image image = render(scene, camera, quick);
  const Color middle = image.at(32, 32), rim = image.at(32, 32 - 17);
  EXPECT_GT(middle.r, 0.5);
  EXPECT_LT(middle.b, 0.5 * middle.r);
  EXPECT_LT(rim.r, 0.5 * rim.b);
}

// Discs are where they should be, and seen from both sides.
TEST(Render, Discs) {
  Scene scene;
  scene.discs.push_back({.centers = Point<3>(0, 0, 0),
                         .normals = Point<3>(0, 0, 5),
                         .radii = Values::Constant(1, 1),
                         .material = {.color = hex("#000000"), .highlight = 0}});
  for (const double side : {1.0, -1.0}) {
    const PinholeCamera camera = {.eye = {0, 0, 6 * side}, .target = {0, 0, 0}};
    const Image image = render(scene, camera, {.width = 200, .height = 200, .samples = 1});
    double black = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x) black += image.pixel(x, y)[0] < 128;
    const double pixel = 2 * 6 * std::tan(15 * 3.14159265358979 / 180) / 200;
    // The area of a disc from its pixels is good to a fraction of a pixel along its rim.
    EXPECT_NEAR(black * pixel * pixel, 3.14159265358979, 0.02);
  }
}

// Every corner of a box within the picture, touching the margin on two sides at least, from any direction.
TEST(Camera, FramesItsSubject) {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    const Point<3> at =
        random.points_in<3>(Box<3>(Point<3>::Constant(-1e3), Point<3>::Constant(1e3)), 1).col(0);
    const Point<3> size(random.uniform(0.1, 3), random.uniform(0.1, 3), random.uniform(0.1, 3));
    const Box<3> box(at, at + size);
    const Framing framing = {.direction = random.direction<3>(),
                             .up = random.direction<3>(),
                             .field_of_view = random.uniform(5, 90),
                             .aspect = random.uniform(0.5, 2),
                             .margin = 0.1};
    const PinholeCamera camera = frame(box, framing);
    Box<2> seen;
    for (int i = 0; i < 8; ++i)
      seen.extend(picture_place(camera, box.corner(static_cast<Box<3>::CornerType>(i)), framing.aspect));
    const double left = seen.min().x() / framing.aspect, right = 1 - seen.max().x() / framing.aspect;
    const double top = seen.min().y(), bottom = 1 - seen.max().y();
    EXPECT_NEAR(std::min({left, right, top, bottom}), 0.1, 1e-8);
    EXPECT_TRUE((std::abs(left - 0.1) < 1e-8 && std::abs(right - 0.1) < 1e-8) ||
                (std::abs(top - 0.1) < 1e-8 && std::abs(bottom - 0.1) < 1e-8));
    // From the side that was asked for.
    EXPECT_NEAR((camera.eye - camera.target).normalized().dot(framing.direction), 1, 1e-8);
  }
}

TEST(Camera, PlacesAndRaysAreInverse) {
  const PinholeCamera camera = {
      .eye = {1, 2, 3}, .target = {0, 0.5, 0}, .up = {0, 0, 1}, .field_of_view = 50};
  for (const double x : {0.1, 0.7, 1.3})
    for (const double y : {0.05, 0.5, 0.9}) {
      const Point<2> place = picture_place(camera, ray_through(camera, x, y, 1.5).at(7), 1.5);
      EXPECT_NEAR(place.x(), x, 1e-12);
      EXPECT_NEAR(place.y(), y, 1e-12);
    }
  // What is up in the scene is up in the picture.
  EXPECT_LT(picture_place(camera, {0, 0.5, 0.5}, 1).y(), 0.5);
  EXPECT_TRUE(std::isnan(picture_place(camera, {2, 4, 6}, 1).x()));
}

TEST(Camera, PrintsItselfAsFlags) {
  const PinholeCamera camera = {
      .eye = {1, -2.5, 1e-3}, .target = {0, 0, 0}, .up = {0, 0, 1}, .field_of_view = 28};
  EXPECT_EQ(to_flags(camera), "--eye 1,-2.5,0.001 --target 0,0,0 --up 0,0,1 --fov 28");
}

TEST(Render, ProgressAndCancel) {
  const Scene scene = everything();
  const PinholeCamera camera = frame(scene);
  double last = -1;
  render(scene, camera, quick, [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1);
  EXPECT_THROW(render(scene, camera, quick, [](double) { return false; }), Cancelled);
  int calls = 0;
  EXPECT_THROW(render(scene, camera, quick, [&](double) { return ++calls < 3; }), Cancelled);
}

TEST(Render, RefusesImpossibleSizes) {
  EXPECT_THROW(render({}, {}, {.width = 0}), Error);
  EXPECT_THROW(render({}, {}, {.width = 20000}), Error);
  EXPECT_THROW(render({}, {}, {.width = 16384, .height = 16384}), Error);
  EXPECT_THROW(render({}, {}, {.samples = 0}), Error);
  EXPECT_THROW(render({}, {}, {.max_depth = 17}), Error);
}

TEST(Render, AnEmptySceneIsBackground) {
  Scene scene;
  scene.background = hex("#336699");
  const Image image = render(scene, {}, {.width = 5, .height = 3, .samples = 2});
  EXPECT_EQ(image, Image(5, 3, hex("#336699")));
  scene.background = hex("#00000000");
  EXPECT_EQ(render(scene, {}, {.width = 5, .height = 3}).at(2, 1).a, 0);
}

// A model far from the origin is seen as well as one near it.
TEST(Render, FarFromTheOrigin) {
  const auto picture = [](const Point<3>& offset) {
    Scene scene;
    TriangleMesh mesh = sphere_mesh(3);
    mesh.vertices.colwise() += offset;
    scene.meshes.push_back({.mesh = mesh});
    scene.floor = floor_under(bounding_box(scene), Point<3>::UnitY());
    return render(scene, frame(scene), quick);
  };
  const Image near = picture({0, 0, 0}), far = picture({4.5e6, -4.5e6, 4.5e6});
  int different = 0;
  for (std::size_t i = 0; i < near.bytes().size(); ++i)
    different += std::abs(int{near.bytes()[i]} - int{far.bytes()[i]}) > 3;
  EXPECT_LE(different, 40);  // of 16384: outlines, where one ray a pixel decides
}

TEST(EvaluationCounts, GrazingRaysCostMost) {
  Scene scene;
  scene.solids.push_back(traced_ball({0, 0, 0}, 1));
  const PinholeCamera camera = {.eye = {0, 0, 6}, .target = {0, 0, 0}};
  const EvaluationCounts counts = count_evaluations(scene, camera, quick);
  EXPECT_EQ(counts.counts[0], 0);  // past the box
  const Index middle = counts.counts[32 * 64 + 32];
  EXPECT_GT(middle, 1);
  EXPECT_LT(middle, 20);
  EXPECT_GT(counts.largest(), middle);
  EXPECT_GT(counts.total(), 0);
  const Image heat = heat_image(counts);
  EXPECT_EQ(heat.width(), 64);
  EXPECT_GT(lab_of(heat.at(0, 0)).L, lab_of(heat.at(32, 32)).L);
}

}  // namespace
}  // namespace seesaw
