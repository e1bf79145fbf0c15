#include "sandbox2d/profile_chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/rbf/fit.h"
#include "core/scene/document_json.h"

namespace seesaw {
namespace {

Document<2> seesaw_with(double value) {
  Document<2> document =
      read_document<2>(std::filesystem::path(SEESAW_SOURCE_DIR) / "figures" / "scenes" / "seesaw.json");
  for (auto& each : document.constraints)
    if (each.constraint.kind == ConstraintKind::interior) each.constraint.value = value;
  return document;
}

Interpolant<2> fitted(const Document<2>& document) { return fit(constraints_of(document)).function; }

const Point<2> pivot(0.35, -0.85);  // the highlighted boundary constraint of the see-saw
/// From the lever, the interior constraint, over the pivot and as far beyond.
const ProfileLine over_the_pivot{{0, 0}, {0.7, -1.7}};

TEST(Profile, IsTheFunctionAlongTheLine) {
  const Document<2> document = seesaw_with(1);
  const Interpolant<2> f = fitted(document);
  const ProfileData profile = profile_of(f, over_the_pivot, document, nullptr, 0.05);
  ASSERT_EQ(profile.along.size(), 257);
  EXPECT_NEAR(profile.length, 2 * pivot.norm(), 1e-15);
  EXPECT_EQ(profile.along[0], 0);
  EXPECT_EQ(profile.along[256], profile.length);
  EXPECT_EQ(profile.other.size(), 0);
  for (const Index i : {0, 13, 128, 256}) {
    const Point<2> p = profile.along[i] * pivot.normalized();
    EXPECT_NEAR(profile.values[i], f.value(p), 1e-12);
    EXPECT_NEAR(profile.at(profile.along[i]), profile.values[i], 1e-12);
  }
  EXPECT_TRUE(std::isnan(profile.at(-0.1)));
  EXPECT_TRUE(std::isnan(profile.at(profile.length + 0.1)));
  EXPECT_TRUE(profile_of(f, {{1, 1}, {1, 1}}, document, nullptr, 0.05).empty());
}

// Turk and O'Brien 2002, section 4.1, in one picture: all profiles pass through zero at the constraint;
// inside it each pull raises the function, beyond it each pull lowers it.
TEST(Profile, ShowsTheSeesaw) {
  ProfileData last;
  for (const double value : {0.5, 1.0, 1.5, 2.0}) {
    const Document<2> document = seesaw_with(value);
    const ProfileData profile = profile_of(fitted(document), over_the_pivot, document, nullptr, 0.05);
    EXPECT_NEAR(profile.at(pivot.norm()), 0, 1e-6);
    EXPECT_NEAR(profile.at(0), value, 1e-9);
    if (!last.empty()) {
      for (const double part : {0.0, 0.25, 0.5, 0.75})
        EXPECT_GT(profile.at(part * pivot.norm()), last.at(part * pivot.norm()) + 0.05);
      for (const double part : {1.25, 1.5, 2.0})
        EXPECT_LT(profile.at(part * pivot.norm()), last.at(part * pivot.norm()) - 0.02);
    }
    last = profile;
  }
}

TEST(Profile, ConstraintsNearTheLineStandOnIt) {
  Document<2> document;
  document.constraints = {{interior<2>({0, 0}, 1.0)},
                          {boundary<2>({1, 0.02}, {1, 0}, 0.2, 0.5), false, true},
                          {exterior<2>({2, 0}, -1.0), true},
                          {boundary<2>({1.5, 0.2})},
                          {boundary<2>({-0.5, 0})}};
  const Interpolant<2> f = fitted(document);
  const ProfileData profile = profile_of(f, {{0, 0}, {2, 0}}, document, nullptr, 0.05);
  ASSERT_EQ(profile.marks.size(), 4u);
  EXPECT_EQ(profile.marks[0].kind, ConstraintKind::interior);
  EXPECT_TRUE(profile.marks[1].normal);
  EXPECT_TRUE(profile.marks[1].highlight);
  EXPECT_NEAR(profile.marks[1].along, 0.8, 1e-12);
  EXPECT_EQ(profile.marks[1].value, 0.5);
  EXPECT_NEAR(profile.marks[2].along, 1, 1e-12);
  EXPECT_EQ(profile.marks[2].value, 0);
  EXPECT_FALSE(profile.marks[2].highlight);
  EXPECT_EQ(profile.marks[3].along, 2);
  EXPECT_TRUE(profile.marks[3].highlight);
}

TEST(Profile, ItsScaleGrowsAtOnceAndShrinksOnlyWhenAsked) {
  const auto profile = [](double value) {
    const Document<2> document = seesaw_with(value);
    return profile_of(fitted(document), over_the_pivot, document, nullptr, 0.05);
  };
  ProfileRange range;
  range.include(profile(1));
  const double low = range.low(), high = range.high();
  EXPECT_GT(high, 1);
  EXPECT_LT(high, 1.5);
  EXPECT_LT(low, profile(1).values.minCoeff());
  range.include(profile(0.5));
  EXPECT_EQ(range.low(), low);
  EXPECT_EQ(range.high(), high);
  range.include(profile(2));
  EXPECT_GT(range.high(), 2);
  EXPECT_LT(range.low(), profile(2).values.minCoeff());
  // By a step: it does not crawl with each frame of the pull.
  const double grown = range.high();
  range.include(profile(2.05));
  EXPECT_EQ(range.high(), grown);
  // At rest it shrinks where most of it would be empty.
  range.settle(profile(1));
  EXPECT_EQ(range.high(), grown);
  range.settle(profile(0.4));
  EXPECT_LT(range.high(), 0.6);
  range.reset();
  range.include(profile(1));
  EXPECT_EQ(range.low(), low);
  EXPECT_EQ(range.high(), high);
  // Nothing to show: no range, and it still draws.
  range.reset();
  range.include({});
  EXPECT_EQ(range.low(), range.high());
}

struct Shades {
  int orange = 0, blue = 0, red = 0;
};
Shades shades_of(const Image& image) {
  Shades shades;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Color c = image.at(x, y);
      const bool orange = c.r > c.b + 0.15 && c.g > 0.5, blue = c.b > c.r + 0.12;
      shades.orange += orange;
      shades.blue += blue;
      shades.red += c.r > 0.7 && c.g < 0.3;
    }
  return shades;
}

TEST(Profile, IsDrawnWithBothSidesShadedAtAnySize) {
  const Document<2> document = seesaw_with(1), weaker = seesaw_with(0.6);
  const Interpolant<2> f = fitted(document), g = fitted(weaker);
  const ProfileData plain = profile_of(f, over_the_pivot, document, nullptr, 0.05),
                    both = profile_of(f, over_the_pivot, document, &g, 0.05);
  ProfileRange range;
  range.include(both);
  for (const bool dark : {false, true})
    for (const double scale : {1.0, 2.0}) {
      const ProfileLook look{.text_size = 11 * scale, .colors = ui_colors(dark)};
      Canvas canvas(420 * scale, 150 * scale, look.colors.panel),
          with(420 * scale, 150 * scale, look.colors.panel);
      draw_profile(canvas, canvas.bounds(), plain, range, look);
      draw_profile(with, with.bounds(), both, range, look);
      const Shades shades = shades_of(canvas.image(1));
      EXPECT_GT(shades.orange, 3000 * scale);
      EXPECT_GT(shades.blue, 2000 * scale);
      EXPECT_GT(shades.red, 200 * scale);
      EXPECT_FALSE(canvas.image(1) == with.image(1)) << "the other function is seen";
    }
}

TEST(Profile, HoldsItsTongueWhereThereIsNoLineOrNoRoom) {
  Canvas small(20, 12), empty(300, 120), bare(300, 120);
  draw_profile(small, small.bounds(), {}, {});
  draw_profile(empty, empty.bounds(), {}, {});
  EXPECT_FALSE(empty.image(1) == bare.image(1)) << "the axes are there";
  // Values that are not numbers leave a gap.
  ProfileData gap;
  gap.length = 2;
  gap.along = Values::LinSpaced(5, 0, 2);
  gap.values.resize(5);
  gap.values << 1, 0.5, std::nan(""), -0.5, -1;
  ProfileRange range;
  range.include(gap);
  EXPECT_TRUE(std::isfinite(range.low()) && std::isfinite(range.high()));
  draw_profile(empty, empty.bounds(), gap, range);
  EXPECT_TRUE(std::isnan(gap.at(1.1)));
}

}  // namespace
}  // namespace seesaw
