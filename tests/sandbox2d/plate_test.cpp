#include "sandbox2d/plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/rbf/fit.h"
#include "core/scene/document_json.h"
#include "tests/core/window/stage.h"

namespace seesaw {
namespace {

Document<2> scene_of_plate(const std::string& name) {
  return read_document<2>(std::filesystem::path(SEESAW_SOURCE_DIR) / "figures" / "scenes" / (name + ".json"));
}

/// The see-saw of the figure with another interior value.
Document<2> pulled_seesaw(double value) {
  Document<2> document = scene_of_plate("seesaw");
  for (auto& each : document.constraints)
    if (each.constraint.kind == ConstraintKind::interior) each.constraint.value = value;
  return document;
}

Interpolant<2> function_of(const Document<2>& document) { return fit(constraints_of(document)).function; }

/// Any function with its gradient.
class PlateField : public Field<2> {
 public:
  using Function = std::function<double(double, double)>;
  explicit PlateField(Function f) : f_(std::move(f)) {}
  using Field<2>::evaluate;
  void evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values) const override {
    for (Index i = 0; i < points.cols(); ++i) values[i] = f_(points(0, i), points(1, i));
  }
  void evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<2>> gradients) const override {
    evaluate(points, values);
    constexpr double h = 1e-5;
    for (Index i = 0; i < points.cols(); ++i) {
      const double x = points(0, i), y = points(1, i);
      gradients.col(i) << (f_(x + h, y) - f_(x - h, y)) / (2 * h), (f_(x, y + h) - f_(x, y - h)) / (2 * h);
    }
  }
  double gradient_bound(const Box<2>&) const override { return infinity; }
  Box<2> bounding_box() const override { return {}; }

 private:
  Function f_;
};

Box<2> square(double half) { return {Point<2>(-half, -half), Point<2>(half, half)}; }

/// The scene point under a point of view space.
Point<2> ground_under(const PlateSpace& space, const Point<3>& p) {
  return space.center + p.head<2>() / space.scale;
}

double ground_area(const TriangleMesh& mesh, Index face) {
  const auto corner = [&](int k) { return Point<2>(mesh.vertices.col(mesh.faces(k, face)).head<2>()); };
  return cross(corner(1) - corner(0), corner(2) - corner(0)) / 2;
}

/// All that must hold for the plate of any field that is finite in the box.
void expect_good_plate(const Field<2>& field, const Box<2>& box, const PlateMesh& plate) {
  const PlateSpace& space = plate.space;
  const TriangleMesh& mesh = plate.mesh;
  ASSERT_GT(mesh.faces.cols(), 0);
  ASSERT_EQ(plate.colors.size(), slot(mesh.vertices.cols()));
  ASSERT_TRUE(mesh.has_normals());
  EXPECT_NEAR(space.scale * box.sizes().maxCoeff(), 2, 1e-12);
  for (Index v = 0; v < mesh.vertices.cols(); ++v) {
    const Point<3> p = mesh.vertices.col(v);
    const double f = field.value(ground_under(space, p));
    // Where the field is steep its zero is known as well as coordinates are.
    const double slack = 1e-8 * (1 + field.gradient(ground_under(space, p)).norm() / space.scale);
    EXPECT_NEAR(p.z() / space.z_scale, std::clamp(f, -space.limit, space.limit), slack);
    EXPECT_NEAR(mesh.normals.col(v).norm(), 1, 1e-12);
    EXPECT_GT(mesh.normals(2, v), 0);
  }
  double area = 0;
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    double low = infinity, high = -infinity;
    for (int k = 0; k < 3; ++k) {
      low = std::min(low, mesh.vertices(2, mesh.faces(k, f)));
      high = std::max(high, mesh.vertices(2, mesh.faces(k, f)));
    }
    EXPECT_GE(low * high, 0) << "a triangle of both signs";
    // All of a triangle is of one color's side.
    int orange = 0;
    for (int k = 0; k < 3; ++k) {
      const Color& c = plate.colors[slot(mesh.faces(k, f))];
      orange += c.r > c.b;
    }
    EXPECT_EQ(orange, high > 0 || low == 0 ? 3 : 0);
    EXPECT_GT(ground_area(mesh, f), -1e-12);
    area += ground_area(mesh, f);
  }
  const Point<2> sides = space.scale * box.sizes();
  EXPECT_NEAR(area, sides.x() * sides.y(), 1e-9) << "holes or folds";
  // The zero segments: on f = 0, and each end shared with another segment or on the box.
  std::map<std::pair<double, double>, int> ends;
  for (Index i = 0; i < plate.zero.cols(); ++i) {
    const Point<3> p = plate.zero.col(i);
    EXPECT_EQ(p.z(), 0);
    const Point<2> g = ground_under(space, p);
    EXPECT_LE(std::abs(field.value(g)), 1e-9 * (1 + field.gradient(g).norm() * box.sizes().maxCoeff()));
    ++ends[{p.x(), p.y()}];
  }
  for (const auto& [at, count] : ends) {
    const bool on_box = std::abs(std::abs(at.first) - sides.x() / 2) < 1e-12 ||
                        std::abs(std::abs(at.second) - sides.y() / 2) < 1e-12;
    EXPECT_TRUE(on_box || count % 2 == 0) << "the curve ends at " << at.first << ", " << at.second;
  }
}

TEST(PlateMesh, IsTheGraphOfTheFunctionCutAlongItsZeros) {
  for (const char* name : {"seesaw", "turk2002-fig05-right", "turk2002-fig04-left"}) {
    SCOPED_TRACE(name);
    const Document<2> document = scene_of_plate(name);
    const Interpolant<2> f = function_of(document);
    for (const Box<2>& box : {*document.display.view, Box<2>(Point<2>(-1.1, -0.7), Point<2>(2, 1))})
      expect_good_plate(f, box,
                        make_plate(f, box, {.cells = 33, .height = typical_height(f, document, box)}));
  }
}

// T&O interpolants are exactly zero at their constraints, and those love the corners of grids.
TEST(PlateMesh, ZerosAtCornersAndAlongEdgesAreTheNormalCase) {
  const std::map<std::string, PlateField::Function> functions = {
      {"diamond", [](double x, double y) { return 0.5 - std::abs(x) - std::abs(y); }},
      {"square", [](double x, double y) { return 0.5 - std::max(std::abs(x), std::abs(y)); }},
      {"saddle", [](double x, double y) { return x * y; }},
      {"diagonals", [](double x, double y) { return x * x - y * y; }},
      {"plane", [](double x, double) { return x; }},
      {"touching from above", [](double x, double y) { return x * x + y * y; }},
      {"touching from below", [](double x, double y) { return -x * x - y * y; }},
      {"circle through corners", [](double x, double y) { return 0.25 - x * x - y * y; }},
  };
  for (const auto& [name, function] : functions) {
    SCOPED_TRACE(name);
    const PlateField field(function);
    const PlateMesh plate = make_plate(field, square(1), {.cells = 8, .headroom = 10});
    expect_good_plate(field, square(1), plate);
    const bool touches = name.starts_with("touching");
    EXPECT_EQ(plate.zero.cols() == 0, touches);
  }
  // Twice the same constant: level land belongs to the part above the zero plane, and has no curve.
  const PlateField level([](double, double) { return 0.0; });
  const PlateMesh plate = make_plate(level, square(1), {.cells = 4});
  expect_good_plate(level, square(1), plate);
  EXPECT_EQ(plate.zero.cols(), 0);
}

TEST(PlateMesh, RunawayValuesAreCutFlat) {
  const PlateField steep([](double x, double y) { return 1 - 5 * (x * x + y * y) + x; });
  const PlateMesh plate = make_plate(steep, square(1), {.cells = 24, .height = 0.5, .relief = 0.3});
  expect_good_plate(steep, square(1), plate);
  EXPECT_NEAR(plate.lowest, -0.9, 1e-12);
  EXPECT_LT(plate.highest, 0.9);
  // Level ground there: normals straight up, and the rim is where f = -1.5, not a row of teeth.
  Index rim = 0;
  for (Index v = 0; v < plate.mesh.vertices.cols(); ++v) {
    const Point<3> p = plate.mesh.vertices.col(v);
    const double f = steep.value(ground_under(plate.space, p));
    EXPECT_TRUE(f > -1.51 || plate.mesh.normals(2, v) == 1);
    rim += std::abs(f + 1.5) < 1e-7;
  }
  EXPECT_GT(rim, 40);
}

TEST(PlateMesh, HolesWhereThereIsNoNumberAndFaultsAreNamed) {
  const PlateField broken(
      [](double x, double y) { return x > 0.7 ? std::numeric_limits<double>::quiet_NaN() : x + y; });
  const PlateMesh plate = make_plate(broken, square(1), {.cells = 10});
  EXPECT_EQ(plate.nonfinite, 2 * 11);
  EXPECT_TRUE(plate.mesh.vertices.allFinite());
  EXPECT_LE(plate.mesh.vertices.row(0).maxCoeff(), 0.6 + 1e-12);
  EXPECT_TRUE(plate.grid.allFinite());
  EXPECT_THROW(make_plate(broken, Box<2>()), Error);
  EXPECT_THROW(make_plate(broken, Box<2>(Point<2>(0, 0), Point<2>(1, 0))), Error);
  EXPECT_THROW(make_plate(broken, square(1), {.cells = 0}), Error);
  EXPECT_THROW(make_plate(broken, square(1), {.height = 0}), Error);
}

TEST(PlateMesh, GridLinesLieOnThePlate) {
  const Document<2> document = scene_of_plate("seesaw");
  const Interpolant<2> f = function_of(document);
  const PlateMesh plate = make_plate(f, square(1.6), {.cells = 32, .lines_every = 8});
  ASSERT_GT(plate.grid.cols(), 2 * 2 * 5 * 32 - 1);
  ASSERT_EQ(plate.grid_colors.size(), slot(plate.grid.cols()));
  for (Index i = 0; i < plate.grid.cols(); ++i) {
    const Point<3> p = plate.grid.col(i);
    EXPECT_NEAR(p.z() / plate.space.z_scale, f.value(ground_under(plate.space, p)), 1e-7);
  }
  EXPECT_EQ(make_plate(f, square(1.6), {.cells = 32, .lines_every = 0}).grid.cols(), 0);
}

// Section 4.1: "If we pull the surface up on one side of a boundary constraint (using an interior
// constraint), then the other side tends to move down." With the scale kept, the mesh says so.
TEST(PlateMesh, PullingTheInsideUpTipsThePlateAboutItsBoundaryConstraints) {
  const Document<2> before = pulled_seesaw(1), after = pulled_seesaw(2);
  const Interpolant<2> f = function_of(before), g = function_of(after);
  const PlateOptions options{.cells = 32, .height = 1};
  const PlateMesh low = make_plate(f, square(1.6), options), high = make_plate(g, square(1.6), options);
  EXPECT_EQ(low.space.z_scale, high.space.z_scale);
  EXPECT_NEAR(high.highest, 2 * low.highest, 1e-9);
  EXPECT_LT(high.lowest, low.lowest - 0.1);
  for (const PlateMesh* plate : {&low, &high})
    for (const PlatePole& pole : plate_poles(before, plate->space, square(1.6)))
      EXPECT_TRUE(!pole.open || pole.head.z() == 0);
}

TEST(PlateParts, PolesReachTheValuesThatConstraintsAskFor) {
  Document<2> document;
  document.constraints = {{boundary<2>({0, 0}, {0, 2}, 0.1, 0.5)},
                          {interior<2>({0.5, 0.5}, 1.0)},
                          {exterior<2>({0.5, -0.5}, -40.0), true},
                          {boundary<2>({9, 9})}};
  const PlateSpace space{.scale = 1, .z_scale = 0.2, .limit = 3};
  const std::vector<PlatePole> poles = plate_poles(document, space, square(1));
  ASSERT_EQ(poles.size(), 4u);
  EXPECT_TRUE(poles[0].open);
  EXPECT_EQ(poles[0].head, Point<3>(0, 0, 0));
  EXPECT_TRUE(poles[1].small);
  EXPECT_EQ(poles[1].head, Point<3>(0, -0.1, 0.1));
  EXPECT_EQ(poles[2].foot, Point<3>(0.5, 0.5, 0));
  EXPECT_EQ(poles[2].head, Point<3>(0.5, 0.5, 0.2));
  EXPECT_NEAR(poles[3].head.z(), -0.6, 1e-15) << "at the limit";
  EXPECT_TRUE(poles[3].highlight);
  EXPECT_FALSE(poles[2].highlight);
}

TEST(PlateParts, TheProfileLiesOnThePlateAndItsCurtainEndsAtZero) {
  const Document<2> document = scene_of_plate("seesaw");
  const Interpolant<2> f = function_of(document);
  const PlateMesh plate = make_plate(f, square(1.6));
  const PlateProfile profile =
      plate_profile(f, {{-5, 0.1}, {5, 0.1}}, plate.space, square(1.6));  // goes on beyond the box
  ASSERT_EQ(profile.line.cols(), 161);
  EXPECT_NEAR(profile.line(0, 0), -1, 1e-12);
  EXPECT_NEAR(profile.line(0, 160), 1, 1e-12);
  for (Index i = 0; i < profile.line.cols(); ++i)
    EXPECT_NEAR(profile.line(2, i) / plate.space.z_scale,
                f.value(ground_under(plate.space, profile.line.col(i))), 1e-9);
  EXPECT_GE(profile.above.vertices.row(2).minCoeff(), 0);
  EXPECT_LE(profile.below.vertices.row(2).maxCoeff(), 0);
  EXPECT_GT(profile.above.vertices.row(2).maxCoeff(), 0.1);
  EXPECT_LT(profile.below.vertices.row(2).minCoeff(), -0.1);
  EXPECT_EQ(plate_profile(f, {{-5, 3}, {5, 3}}, plate.space, square(1.6)).line.cols(), 0);
}

/// How many pixels are clearly orange, clearly blue, and as dark as the curve.
struct PlateInk {
  int orange = 0, blue = 0, dark = 0, red = 0;
};
PlateInk ink_of(const Image& image) {
  PlateInk ink;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Color c = image.at(x, y);
      ink.orange += c.r > c.b + 0.25 && c.g > 0.35;
      ink.blue += c.b > c.r + 0.12 && c.b > 0.5;
      ink.dark += c.r < 0.2 && c.g < 0.25 && c.b < 0.35;
      ink.red += c.r > 0.6 && c.g < 0.35 && c.b < 0.3;
    }
  return ink;
}

TEST(Plate, ShowsLandAboveAndBelowItsCurveAndItsProfile) {
  SEESAW_WINDOW_OR_SKIP(window);
  const Document<2> document = scene_of_plate("seesaw");
  const Interpolant<2> f = function_of(document);
  Plate plate;
  const UiColors colors = ui_colors(false);
  plate.show(f, document, square(1.6), {}, 48, 1);
  plate.draw(300, 240, colors);
  EXPECT_FALSE(plate.settled());
  const PlateInk rough = ink_of(plate.image());
  EXPECT_GT(rough.orange, 1000);
  EXPECT_GT(rough.blue, 3000);
  EXPECT_GT(rough.dark, 150);
  EXPECT_GT(plate.mesh().zero.cols(), 80);
  // At rest it is drawn once more, smooth, and then no more.
  plate.draw(300, 240, colors);
  EXPECT_TRUE(plate.settled());
  const Image smooth = plate.image();
  plate.draw(300, 240, colors);
  EXPECT_TRUE(plate.settled());
  EXPECT_TRUE(smooth == plate.image());
  plate.show(f, document, square(1.6), {}, 48, 1);
  plate.draw(300, 240, colors);
  EXPECT_TRUE(plate.settled());
  // The same with a profile.
  plate.show(f, document, square(1.6), ProfileLine{{0, 0}, {0.7, -1.7}}, 48, 1);
  plate.draw(300, 240, colors);
  EXPECT_FALSE(plate.settled());
  EXPECT_GT(ink_of(plate.image()).red, ink_of(smooth).red + 60);
  plate.clear();
  plate.draw(300, 240, colors);
  EXPECT_EQ(ink_of(plate.image()).orange, 0);
}

TEST(Plate, ThePictureFillsItsPlaceWhateverItsShapeUntilAHandTakesIt) {
  SEESAW_WINDOW_OR_SKIP(window);
  const Document<2> document = scene_of_plate("turk2002-fig04-left");
  const Interpolant<2> f = function_of(document);
  Plate plate;
  plate.show(f, document, *document.display.view, {}, 32, 1);
  for (const auto& [width, height] : {std::pair(460, 400), {900, 300}, {260, 500}}) {
    plate.draw(width, height, ui_colors(true));
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (Index v = 0; v < plate.mesh().mesh.vertices.cols(); ++v) {
      const Point<3> p = plate.camera().pixel_of(plate.mesh().mesh.vertices.col(v), width, height);
      left = std::min(left, p.x());
      right = std::max(right, p.x());
      top = std::min(top, p.y());
      bottom = std::max(bottom, p.y());
    }
    EXPECT_GE(left, 0);
    EXPECT_GE(top, 0);
    EXPECT_LE(right, width);
    EXPECT_LE(bottom, height);
    EXPECT_TRUE(right - left > 0.8 * width || bottom - top > 0.6 * height) << width << " x " << height;
  }
}

TEST(Plate, TheHandOrbitsPansAndComesNearer) {
  SEESAW_WINDOW_OR_SKIP(window);
  const Document<2> document = scene_of_plate("seesaw");
  const Interpolant<2> f = function_of(document);
  Plate plate;
  plate.show(f, document, square(1.6), {}, 32, 1);
  plate.draw(200, 160, ui_colors(false));
  const OrbitCamera first = plate.camera();
  const Image before = plate.image();
  EXPECT_NEAR(first.azimuth, -62 * std::numbers::pi / 180, 1e-12);
  ui::PictureUse drag{.hovered = true, .held = true, .dx = 30, .dy = -10, .place = {0, 0, 200, 160}};
  plate.use(drag);
  EXPECT_EQ(plate.camera().target, first.target);
  EXPECT_LT(plate.camera().azimuth, first.azimuth);
  EXPECT_LT(plate.camera().elevation, first.elevation);
  plate.draw(200, 160, ui_colors(false));
  EXPECT_FALSE(plate.image() == before);
  const OrbitCamera turned = plate.camera();
  plate.use(drag, true);
  EXPECT_EQ(plate.camera().azimuth, turned.azimuth);
  EXPECT_NE(plate.camera().target, turned.target);
  const Point<3> target = plate.camera().target;
  drag.button = 2;
  plate.use(drag);
  EXPECT_NE(plate.camera().target, target);
  plate.use({.hovered = true, .wheel = 2, .place = {}});
  EXPECT_LT(plate.camera().distance, turned.distance);
  // A hand's view is kept, also for another picture size.
  const double distance = plate.camera().distance;
  plate.draw(300, 160, ui_colors(false));
  EXPECT_EQ(plate.camera().distance, distance);
  plate.use({.hovered = true, .double_clicked = true, .place = {}});
  plate.draw(200, 160, ui_colors(false));
  EXPECT_TRUE(plate.image() == before);
}

TEST(Plate, ItsScaleStandsStillWhileAValueIsPulled) {
  SEESAW_WINDOW_OR_SKIP(window);
  Plate plate;
  std::uint64_t version = 0;
  const auto show = [&](double value, const Box<2>& seen) {
    const Document<2> document = pulled_seesaw(value);
    plate.show(function_of(document), document, seen, {}, 32, ++version);
    plate.draw(300, 130, ui_colors(false));
    // However high it is pulled, it is seen whole.
    for (const auto& each : plate.mesh().mesh.vertices.colwise()) {
      const Point<3> p = plate.camera().pixel_of(each, 300, 130);
      EXPECT_TRUE(p.x() > 0 && p.x() < 300 && p.y() > 0 && p.y() < 130) << value << " at " << p.transpose();
    }
    return plate.mesh().highest;
  };
  const double at_one = show(1, square(1.6));
  const double near = plate.camera().distance;
  EXPECT_NEAR(show(0.4, square(1.6)), 0.4 * at_one, 1e-9);
  EXPECT_EQ(plate.camera().distance, near);
  EXPECT_NEAR(show(1.5, square(1.6)), 1.5 * at_one, 1e-9);
  EXPECT_NEAR(show(2.5, square(1.6)), 2.5 * at_one, 1e-9);
  const double far = plate.camera().distance;
  EXPECT_GT(far, near);
  EXPECT_NEAR(show(1.5, square(1.6)), 1.5 * at_one, 1e-9);
  EXPECT_EQ(plate.camera().distance, far) << "it does not breathe with the hand";
  EXPECT_EQ(plate.height(), 1);
  // Three times as high, or a third: anew. Pulled back, that one is kept.
  EXPECT_NEAR(show(3.1, square(1.6)), at_one, 1e-9);
  EXPECT_NEAR(show(1.55, square(1.6)), at_one / 2, 1e-9);
  EXPECT_NEAR(show(0.1, square(1.6)), at_one, 1e-9);
  show(0.2, square(1.6));
  plate.rescale();
  EXPECT_NEAR(show(0.2, square(1.6)), at_one, 1e-9);
  // Panned: kept. Zoomed: anew.
  show(0.3, {Point<2>(-1.5, -1.6), Point<2>(1.7, 1.6)});
  EXPECT_EQ(plate.height(), 0.2);
  show(0.3, square(1.2));
  EXPECT_EQ(plate.height(), 0.3);
}

// In a panel, by the mouse, as a person has it.
TEST(Plate, IsTurnedByTheMouseInAPanel) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 520, .height = 440});
  const Document<2> document = scene_of_plate("seesaw");
  const Interpolant<2> f = function_of(document);
  Plate plate;
  const auto draw = [&] {
    if (const auto panel = ui::panel("See-saw", {10, 10, 500, 420})) {
      const int width = static_cast<int>(ui::width_left()), height = static_cast<int>(ui::height_left());
      plate.show(f, document, square(1.6), {}, 48, 1);
      plate.use(ui::picture("Plate", plate.draw(width, height, ui::colors()), width, height));
    }
  };
  const Played before = play(window, "frames 3\n", draw);
  EXPECT_TRUE(plate.settled());
  EXPECT_GT(ink_of(before.picture).orange, 2000);
  const double azimuth = plate.camera().azimuth;
  play(window, "drag \"Plate\" \"Plate\" +60 +10 4\nframes 1\n", draw);
  EXPECT_LT(plate.camera().azimuth, azimuth - 0.3);
}

}  // namespace
}  // namespace seesaw
