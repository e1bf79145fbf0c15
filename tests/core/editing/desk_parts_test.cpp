// What a desk is made of, one by one: view, grid, selection, what is under the cursor, arrangements, keys.
#include <gmock/gmock.h>

#include <set>

#include "core/base/random.h"
#include "core/contour/contour.h"
#include "core/editing/arrangements.h"
#include "core/editing/curve_foot.h"
#include "core/editing/desk_bindings.h"
#include "core/editing/grid.h"
#include "core/editing/selection.h"
#include "core/editing/view_2d.h"
#include "core/implicit/primitives.h"
#include "tests/core/editing/documents.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

void expect_invertible(const View2D& view) {
  for (const Point<2>& p : {Point<2>(0, 0), Point<2>(13.25, 597), Point<2>(view.width(), view.height())}) {
    const Point<2> back = view.pixel_from_scene(view.scene_from_pixel(p));
    ASSERT_LE((back - p).norm(), 1e-2) << view.pixel() << " around " << view.center().transpose();
  }
  const Box<2> seen = view.scene();
  ASSERT_TRUE(seen.min().allFinite() && seen.max().allFinite());
  ASSERT_TRUE((seen.min().array() < seen.max().array()).all());
}

TEST(View2D, PixelsAreScenePointsAndBack) {
  View2D view(800, 600);
  view.show(Box<2>(Point<2>(-2, -2), Point<2>(2, 2)));
  EXPECT_EQ(view.pixel(), 4.0 / 600);
  EXPECT_EQ(view.scene_from_pixel({400, 300}), Point<2>(0, 0));
  EXPECT_LE((view.scene_from_pixel({100, 0}) - Point<2>(-2, 2)).norm(), 1e-15);
  const PlanView plan = view.plan();
  for (const Point<2>& p : {Point<2>(0, 0), Point<2>(-1.3, 0.7), Point<2>(5, 8)})
    EXPECT_LE((plan.page_from_scene(p) - view.pixel_from_scene(p)).norm(), 1e-11);
}

TEST(View2D, ZoomKeepsWhatIsUnderTheCursorAndIsUndoneByItsInverse) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    View2D view(1280, 800);
    view.zoom(std::exp2(random.uniform(-3, 20)), random.points_in<2>(view.scene(), 1));
    const Point<2> pixel(random.uniform(0, 1280), random.uniform(0, 800));
    const Point<2> there = view.scene_from_pixel(pixel);
    const View2D before = view;
    const double factor = std::exp2(random.uniform(-1, 1));
    view.zoom(factor, there);
    ASSERT_LE((view.scene_from_pixel(pixel) - there).norm(), 1e-12 * (1 + there.norm()));
    view.zoom(1 / factor, there);
    ASSERT_NEAR(view.pixel() / before.pixel(), 1, 1e-14);
    ASSERT_LE((view.center() - before.center()).norm(), 1e-12 * (1 + there.norm()));
  }
}

TEST(View2D, HasNoDeadEnd) {
  for (const double where : {0.0, 3.0, -4.5e6, 1e12, 1e-9, 1e200})
    for (const double size : {0.0, 1e-300, 1e-9, 1.0, 1e9, 1e300}) {
      View2D view(640, 480);
      const Point<2> low(where, where);
      view.set_home(Box<2>(low, low + Point<2>::Constant(size)));
      view.show(Box<2>(low, low + Point<2>::Constant(size)));
      expect_invertible(view);
      for (const double factor : {1.3, 1 / 1.3}) {
        for (int i = 0; i < 3000; ++i) view.zoom(factor, view.scene_from_pixel({100, 100}));
        expect_invertible(view);
        const double stuck = view.pixel();
        view.zoom(1 / factor, view.center());
        EXPECT_NEAR(view.pixel() / stuck, factor, 1e-12) << "no way back from " << stuck;
      }
      for (const double x : {1.0, -1.0}) {
        for (int i = 0; i < 3000; ++i) view.pan(Point<2>(0.9 * x, 0) * view.pixel() * view.width());
        expect_invertible(view);
        const double stuck = view.center().x();
        view.pan(Point<2>(-x, 0) * view.pixel() * view.width());
        EXPECT_LT(x * view.center().x(), x * stuck);
      }
      // Nonsense changes nothing.
      const View2D before = view;
      view.zoom(0, view.center());
      view.zoom(-1, view.center());
      view.zoom(NAN, view.center());
      view.zoom(2, Point<2>(NAN, 0));
      view.pan(Point<2>(INFINITY, 0));
      EXPECT_EQ(view, before);
    }
}

TEST(View2D, BeyondItsReachEveryStepTowardTheDocumentIsOpen) {
  View2D view(640, 480);
  view.show(Box<2>(Point<2>(1e6, 1e6), Point<2>(2e6, 2e6)));
  view.set_home(Box<2>(Point<2>(0, 0), Point<2>(1, 1)));  // The rest was deleted.
  const double pixel = view.pixel();
  view.zoom(0.5, view.center());
  EXPECT_EQ(view.pixel(), pixel) << "farther out is closed";
  view.zoom(2, view.center());
  EXPECT_EQ(view.pixel(), pixel / 2);
  view.pan({-5e5, -5e5});
  EXPECT_EQ(view.center(), Point<2>(1e6, 1e6));
  view.pan({1, 0});
  EXPECT_EQ(view.center(), Point<2>(1e6, 1e6));
}

TEST(Grid, StepsAreRound) {
  EXPECT_EQ(round_step(0.16), 0.2);
  EXPECT_EQ(round_step(0.2), 0.2);
  EXPECT_EQ(round_step(0.20001), 0.5);
  EXPECT_EQ(round_step(6), 10);
  EXPECT_EQ(round_step(1), 1);
  double step = 1e-7;
  for (const double next : {2e-7, 5e-7, 1e-6, 2e-6, 5e-6, 1e-5}) {
    EXPECT_EQ(next_step(step, true), next);
    EXPECT_EQ(next_step(next, false), step);
    step = next;
  }
}

TEST(Grid, PointsSnapToTheNumbersThatAPersonWouldType) {
  Random random(5);
  EXPECT_NE(3 * 0.1, 0.3) << "else this tests nothing";
  EXPECT_EQ(nearest_multiple(0.29, 0.1), 0.3);
  for (const char* step : {"1e-9", "2e-4", "5e-3", "1e-1", "2e-1", "5e-1", "1e0", "2e0", "5e1", "1e6"})
    for (int i = 0; i < 200; ++i) {
      const double size = std::stod(step);
      const auto count = static_cast<long>(random.index(20001)) - 10000;
      // "-37" times 5e-3 is the number that is written -185e-3.
      const std::string typed = std::to_string(count * (step[0] - '0')) + (step + 1);
      const double off = random.uniform(-0.45, 0.45) * size;
      ASSERT_EQ(nearest_multiple(static_cast<double>(count) * size + off, size), std::stod(typed)) << typed;
    }
  EXPECT_FALSE(std::signbit(nearest_multiple(-0.01, 0.5)));
  EXPECT_EQ(nearest_multiple(1e300, 0.1), 1e300);
  EXPECT_NEAR(nearest_multiple(1.0, 0.3), 0.9, 1e-15);
}

TEST(Selection, IsASortedSet) {
  Selection selection({5, 1, 5, 3});
  EXPECT_THAT(selection.indices(), ElementsAre(1, 3, 5));
  selection.toggle(3);
  selection.toggle(0);
  selection.add({5, 9});
  EXPECT_THAT(selection.indices(), ElementsAre(0, 1, 5, 9));
  EXPECT_TRUE(selection.contains(5));
  EXPECT_FALSE(selection.contains(3));
}

TEST(Selection, FollowsTheDocument) {
  Editor<2> editor(start_document<2>());
  Selection selection({1, 2});
  const auto apply = [&](const Action<2>& action) {
    const Index before = editor.size();
    const Outcome done = editor.apply(action);
    selection.follow(done, before, editor.size());
  };
  const auto undo = [&](bool back) {
    const Index before = editor.size();
    const Outcome done = back ? editor.undo() : editor.redo();
    selection.follow_undo(done, before, editor.size(), false);
  };
  apply(Move<2>{{1, 2}, {0.1, 0}});
  EXPECT_THAT(selection.indices(), ElementsAre(1, 2));
  apply(Delete{{1, 2}});
  EXPECT_TRUE(selection.empty());
  undo(true);
  EXPECT_THAT(selection.indices(), ElementsAre(1, 2)) << "what came back";
  undo(true);
  selection.add({4});
  undo(false);
  EXPECT_THAT(selection.indices(), ElementsAre(1, 2, 4)) << "what moves is selected already";
  undo(false);
  EXPECT_TRUE(selection.empty());
  apply(Add<2>{{{boundary<2>({2, 2})}, {boundary<2>({2, 1})}}});
  EXPECT_THAT(selection.indices(), ElementsAre(10, 11)) << "what is new";
  apply(SetKernel{Kernel::linear});
  undo(true);
  EXPECT_THAT(selection.indices(), ElementsAre(10, 11)) << "a kernel selects nothing";
  undo(true);
  EXPECT_TRUE(selection.empty());
}

TEST(HitTest, TheNearestWinsAndTiesAreDecided) {
  Document<2> document;
  document.constraints = {
      {boundary<2>({0, 0})}, {boundary<2>({0.1, 0}, {0, 2})}, {interior<2>({0.1, 0})}, {exterior<2>({5, 5})}};
  const ProfileLine profile{{1, -1}, {1, 1}};
  HitScene scene{.document = document, .display = document.display, .profile = &profile, .pixel = 0.01};
  const auto at = [&](double x, double y) { return first_hit({x, y}, scene); };
  EXPECT_EQ(at(0.04, 0).which, 0);
  EXPECT_EQ(at(0.06, 0).which, 2) << "of two in one place the last";
  EXPECT_EQ(at(0.06, 0).over, Over::constraint);
  EXPECT_NEAR(at(0.06, 0).pixels, 4, 1e-12);
  EXPECT_EQ(at(0.05, 0).which, 2) << "halfway";
  EXPECT_EQ(at(0.1, 0.25).over, Over::spike) << "26 pixels along a normal of any length";
  EXPECT_EQ(at(0.1, 0.25).which, 1);
  EXPECT_EQ(at(1, -0.95).over, Over::profile_start);
  EXPECT_EQ(at(1.02, 0.99).over, Over::profile_end);
  EXPECT_EQ(at(1.02, 0.5).over, Over::profile);
  EXPECT_EQ(at(1.02, 0.5).at, Point<2>(1, 0.5));
  EXPECT_EQ(at(3, 3).over, Over::nothing);
  EXPECT_EQ(hits({0.05, 0}, scene).size(), 3u);
  Display<2> hidden;
  hidden.normals = false;
  EXPECT_EQ(first_hit({0.1, 0.25}, {document, hidden, nullptr, nullptr, 0.01}).over, Over::nothing);
  hidden.constraints = false;
  EXPECT_EQ(first_hit({0.1, 0}, {document, hidden, nullptr, nullptr, 0.01}).over, Over::nothing);
}

TEST(CurveFoot, IsTheNearestPointOfACircle) {
  const Sphere<2> circle({0.3, -0.2}, 1.5);
  Random random(8);
  for (int i = 0; i < 500; ++i) {
    const Point<2> out = random.direction<2>();
    const double off = random.uniform(-0.3, 0.3);
    const Point<2> p = Point<2>(0.3, -0.2) + (1.5 + off) * out;
    const auto foot = curve_foot(circle, p, 0.25);
    ASSERT_EQ(foot.has_value(), std::abs(off) < 0.25) << off;
    if (foot) {
      ASSERT_LE((*foot - (Point<2>(0.3, -0.2) + 1.5 * out)).norm(), 1e-6) << off;
      ASSERT_LE(std::abs((*foot - Point<2>(0.3, -0.2)).norm() - 1.5), 1e-14);
    }
  }
  EXPECT_FALSE(curve_foot(circle, {0.3, -0.2}, 0.25)) << "the middle, where the gradient is zero";
  EXPECT_FALSE(curve_foot(circle, {NAN, 0}, 0.25));
}

TEST(CurveFoot, StandsOnAnInterpolantAndIsPerpendicular) {
  Editor<2> editor(start_document<2>());
  for (const Kernel kernel : all_kernels) {
    editor.apply(SetKernel{kernel});
    const Interpolant<2>& f = *editor.shape().function;
    const Box<2> box(Point<2>(-1.2, -1.2), Point<2>(1.2, 1.2));
    const Contour curve = contour(f, box, boundary_points(editor.document()));
    Random random(2);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
      const Point<2> p = random.points_in<2>(box, 1);
      double d = infinity;
      for (const Polyline& each : curve.polylines) d = std::min(d, distance(each, p));
      const auto foot = curve_foot(f, p, 0.05);
      if (d < 0.045) {
        ASSERT_TRUE(foot) << p.transpose();
      }
      if (d > 0.055) {
        ASSERT_FALSE(foot) << p.transpose();
      }
      if (!foot) continue;
      ++found;
      ASSERT_LE((*foot - p).norm(), d * 1.2 + 1e-3);
      ASSERT_LE(std::abs(f.value(*foot)), 1e-13);
    }
    EXPECT_GT(found, 10);
    for (const SceneConstraint<2>& each : editor.document().constraints)
      if (each.constraint.kind == ConstraintKind::boundary) {
        EXPECT_TRUE(curve_foot(f, each.constraint.at, 0.05)) << "at a center, also at the tip of a cone";
      }
  }
}

TEST(Arrangements, LinesAndCirclesAreEven) {
  const Points<2> line = points_on_line({0.1, 0.2}, {1.7, -0.4}, 6);
  EXPECT_EQ(Point<2>(line.col(0)), Point<2>(0.1, 0.2));
  EXPECT_EQ(Point<2>(line.col(5)), Point<2>(1.7, -0.4));
  for (int i = 1; i < 5; ++i) EXPECT_LE((line.col(i - 1) + line.col(i + 1) - 2 * line.col(i)).norm(), 1e-15);
  EXPECT_EQ(Point<2>(points_on_line({0, 0}, {2, 4}, 1).col(0)), Point<2>(1, 2));
  const Point<2> center(0.5, 0.25);
  const Points<2> circle = points_on_circle(center, {1.5, 0.25}, 7);
  EXPECT_EQ(Point<2>(circle.col(0)), Point<2>(1.5, 0.25));
  EXPECT_LE((circle.rowwise().mean() - center).norm(), 1e-15);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR((circle.col(i) - center).norm(), 1, 1e-15);
  EXPECT_GT(cross(circle.col(0) - center, circle.col(1) - center), 0) << "counter-clockwise";
}

TEST(Arrangements, ACageGoesAroundWhatItEnclosesAndTwiceIsOnce) {
  Document<2> document;
  document.constraints = {{boundary<2>({1, 1})}, {boundary<2>({3, 1})}, {interior<2>({2, 1})}};
  const Box<2> view(Point<2>(-4, -4), Point<2>(4, 4));
  const Constraints<2> cage = cage_around(document, view);
  ASSERT_EQ(cage.size(), 8u);
  for (const Constraint<2>& each : cage) {
    EXPECT_EQ(each.kind, ConstraintKind::exterior);
    EXPECT_NEAR((each.at - Point<2>(2, 1)).norm(), 1.6, 1e-15);
    document.constraints.push_back({each});
  }
  EXPECT_TRUE(without_doubles(cage_around(document, view), document).empty());
  EXPECT_NEAR(cage_around({}, view)[0].at.x(), 3.2, 1e-15);
  EXPECT_EQ(without_doubles({boundary<2>({0, 0}), interior<2>({-0.0, 0})}, {}).size(), 1u);
}

TEST(Bindings, EveryCommandHasAKeyAndNoKeyHasTwo) {
  std::set<std::string> keys;
  std::set<DeskCommand> commands;
  for (const KeyBinding& row : key_bindings()) {
    EXPECT_TRUE(keys.insert(name_of(row.held) + name_of(row.key)).second) << name_of(row.key);
    EXPECT_EQ(command_of(row.key, row.held), row.command);
    commands.insert(row.command);
  }
  EXPECT_EQ(commands.size(), static_cast<std::size_t>(desk_commands)) << "a command that no key reaches";
  EXPECT_EQ(keys_of(DeskCommand::redo), "Ctrl+Shift+Z");
  EXPECT_EQ(command_of(DeskKey::z, {.shift = true, .alt = true}), std::nullopt);
  std::set<std::string> names;
  for (int k = 0; k < desk_keys; ++k) names.insert(name_of(static_cast<DeskKey>(k)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(desk_keys));
}

TEST(Bindings, NoRowIsHiddenByAnother) {
  std::set<Gesture> gestures;
  for (const PointerBinding& row : pointer_bindings()) {
    bool reached = false;
    for (int tool = 0; tool < tool_count && !reached; ++tool)
      for (int over = 0; over <= static_cast<int>(Over::curve) && !reached; ++over)
        if ((row.tools >> tool & 1) && (row.over >> over & 1))
          reached = gesture_of(static_cast<Tool>(tool), static_cast<Over>(over), row.button,
                               row.held.value_or(Held{}), std::max(1, row.clicks)) == row.gesture;
    EXPECT_TRUE(reached) << row.click << row.drag;
    EXPECT_TRUE(*row.click || *row.drag);
    gestures.insert(row.gesture);
  }
  EXPECT_EQ(gestures.size(), static_cast<std::size_t>(Gesture::values)) << "a gesture that nothing begins";
}

TEST(Bindings, TheHelpHasAllOfThem) {
  const std::vector<HelpLine> lines = help_lines();
  const auto says = [&](const std::string& keys, const std::string& words) {
    return std::ranges::any_of(lines, [&](const HelpLine& line) {
      return (", " + line.keys + ",").find(", " + keys + ",") != std::string::npos && line.words == words;
    });
  };
  for (const KeyBinding& row : key_bindings()) {
    EXPECT_TRUE(says(name_of(row.held) + name_of(row.key), row.words)) << row.words;
  }
  EXPECT_TRUE(says("Ctrl+Shift+Z, Ctrl+Y", "redo"));
  EXPECT_TRUE(says("double click on the curve", "place a boundary constraint on it; nothing changes"));
  EXPECT_TRUE(says("middle button", "pan"));
  EXPECT_TRUE(says("Space held", "pan, as with the pan tool"));
  std::set<std::string> sections;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (i == 0 || lines[i].section != lines[i - 1].section) {
      EXPECT_TRUE(sections.insert(lines[i].section).second) << "torn apart: " << lines[i].section;
    }
  EXPECT_TRUE(
      says("Shift+click on a constraint", "into the selection, or out of it; drag: move the selection"));
  EXPECT_TRUE(says("drag", "draw the profile line"));
  EXPECT_TRUE(says("Alt", "snap to nothing"));
  EXPECT_TRUE(says("Wheel", "zoom about the cursor"));
  for (const HelpLine& line : lines)
    EXPECT_FALSE(line.section.empty() || line.keys.empty() || line.words.empty());
}

}  // namespace
}  // namespace seesaw
