// A thousand fields nobody chose.

#include "tests/core/contour/test_fields.h"

namespace seesaw {
namespace {

// A sum of cosines with random directions, wavelengths and phases: smooth, with many components and near
// misses.
FunctionField waves(Random& random, int count, double highest_frequency) {
  struct Wave {
    Point<2> frequency;
    double amplitude, phase;
  };
  std::vector<Wave> sum;
  for (int k = 0; k < count; ++k)
    sum.push_back({highest_frequency * random.uniform() * random.direction<2>(), random.normal(),
                   random.uniform(0, 2 * M_PI)});
  const double offset = random.uniform(-0.5, 0.5);
  return FunctionField([=](const Point<2>& p) {
    Jet jet{offset, {0, 0}};
    for (const Wave& wave : sum) {
      const double t = wave.frequency.dot(p) + wave.phase;
      jet.f += wave.amplitude * std::cos(t);
      jet.gradient -= wave.amplitude * std::sin(t) * wave.frequency;
    }
    return jet;
  });
}

FunctionField hills(Random& random, int count) {
  struct Hill {
    Point<2> top;
    double height, width;
  };
  std::vector<Hill> sum;
  for (int k = 0; k < count; ++k)
    sum.push_back({random.points_in<2>(box_of(0, 0, 1, 1), 1), random.normal(), random.uniform(0.05, 0.3)});
  const double offset = random.uniform(-0.3, 0.3);
  return FunctionField([=](const Point<2>& p) {
    Jet jet{offset, {0, 0}};
    for (const Hill& hill : sum) {
      const Point<2> d = p - hill.top;
      const double e = hill.height * std::exp(-d.squaredNorm() / (hill.width * hill.width));
      jet.f += e;
      jet.gradient -= 2 / (hill.width * hill.width) * e * d;
    }
    return jet;
  });
}

// Half of them again at four times the resolution: the same closed curves. The number of open ones may differ
// only where a curve runs out of the box and back within a hair's breadth, which is rare.
TEST(RandomFields, AThousandSmoothOnes) {
  Random random(2002);
  const Box<2> box = box_of(0, 0, 1, 1);
  int grazing = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const FunctionField field = trial % 2 == 0 ? waves(random, 6, 20) : hills(random, 12);
    const Contour contour = seesaw::contour(field, box, {.cells = 40});
    expect_sound(field, box, contour);
    expect_inside_on_left(field, contour, 1e-7);
    if (trial % 4 < 2) {
      const Contour fine = seesaw::contour(field, box, {.cells = 160});
      grazing += contour.components != fine.components;
      EXPECT_EQ(contour.closed, fine.closed) << "field " << trial;
      EXPECT_NEAR(contour.area, fine.area, 2e-3) << "field " << trial;
    }
    if (HasFailure()) FAIL() << "field " << trial;
  }
  EXPECT_LE(grazing, 3);
}

// Far too few cells for the field, but a seed on every component: none is lost.
TEST(RandomFields, SeedsSaveEveryComponentOnACoarseLattice) {
  Random random(1999);
  const Box<2> box = box_of(0, 0, 1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const FunctionField field = waves(random, 8, 40);
    const Contour fine = seesaw::contour(field, box, {.cells = 200});
    std::vector<Point<2>> list;
    for (const Polyline& polyline : fine.polylines)
      for (int k = 0; k < 3; ++k)
        list.push_back(polyline.vertices.col(random.index(polyline.vertices.cols())));
    const Points<2> seeds = points_of(list);
    for (const int cells : {10, 20}) {
      const Contour coarse = seesaw::contour(field, box, seeds, {.cells = cells});
      expect_sound(field, box, coarse);
      EXPECT_EQ(coarse.seeds_on_curve, seeds.cols());
      EXPECT_EQ(farthest(coarse, seeds), 0);
      EXPECT_EQ(coarse.components, fine.components) << "field " << trial << " at " << cells;
    }
  }
}

TEST(RandomFields, TwiceTheSame) {
  Random random(8);
  const FunctionField field = waves(random, 10, 30);
  const Contour a = contour(field, box_of(0, 0, 1, 1)), b = contour(field, box_of(0, 0, 1, 1));
  ASSERT_EQ(a.components, b.components);
  for (std::size_t k = 0; k < a.polylines.size(); ++k)
    EXPECT_EQ(a.polylines[k].vertices, b.polylines[k].vertices);
  EXPECT_EQ(a.evaluations, b.evaluations);
}

TEST(RandomFields, RingsThatNearlyTouch) {
  const Box<2> box = box_of(0, 0, 1, 1);
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const double r = 0.2;
    const Point<2> left(0.5 - r - gap / 2, 0.513), right(0.5 + r + gap / 2, 0.513);
    const FunctionField rings(
        [&](const Point<2>& p) { return maximum(disc(p, left, r), disc(p, right, r)); });
    const Points<2> seeds = points_of({{0.5 - gap / 2, 0.513}, {0.5 + gap / 2, 0.513}});
    const Contour contour = seesaw::contour(rings, box, seeds, {.cells = 20});
    expect_sound(rings, box, contour);
    EXPECT_EQ(contour.components, 2) << gap;
    EXPECT_NEAR(contour.area, 2 * M_PI * r * r, 1e-3);
    // Overlapping by as much, they are one.
    const Point<2> l(0.5 - r + gap / 2, 0.513), m(0.5 + r - gap / 2, 0.513);
    const FunctionField joined([&](const Point<2>& p) { return maximum(disc(p, l, r), disc(p, m, r)); });
    const double half = std::sqrt(r * r - std::pow(r - gap / 2, 2));
    const Points<2> waist = points_of({{0.5, 0.513 + half}, {0.5, 0.513 - half}});
    EXPECT_EQ(seesaw::contour(joined, box, waist, {.cells = 20}).components, 1) << gap;
  }
}

}  // namespace
}  // namespace seesaw
