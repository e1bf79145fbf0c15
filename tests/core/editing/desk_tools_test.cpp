// Every tool of the desk: what it places, draws and shows, and that one undo takes all of it back.
#include "core/editing/desk.h"

#include <gmock/gmock.h>

#include "core/contour/contour.h"
#include "core/scene/crowding.h"
#include "tests/core/editing/desk_at_hand.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using K = DeskKey;

TEST_F(DeskTest, AToolPlacesItsKind) {
  const struct {
    K key;
    ConstraintKind kind;
    double value;
  } cases[] = {{K::b, ConstraintKind::boundary, 0},
               {K::i, ConstraintKind::interior, 1},
               {K::e, ConstraintKind::exterior, -1}};
  for (const auto& each : cases) {
    hand.key(each.key);
    const double y = each.value + 1.5;
    one_step([&] { hand.click({2, y}); });
    const Index last = desk.editor().size() - 1;
    EXPECT_EQ(desk.constraint(last).kind, each.kind);
    EXPECT_EQ(desk.constraint(last).value, each.value);
    EXPECT_EQ(place(last), Point<2>(2, y));
    EXPECT_THAT(desk.selection().indices(), ElementsAre(last));
    one_step([&] { hand.drag({-2, y}, {-2.5, y}); });
    EXPECT_EQ(desk.editor().size(), last + 2);
    EXPECT_LE((place(last + 1) - Point<2>(-2.5, y)).norm(), 1e-15) << "placed and dragged in one";
    no_step([&] {
      hand.down({3, y});
      hand.to({2, y});
      EXPECT_EQ(desk.editor().size(), last + 3);
      hand.key(K::escape);
      hand.up({2, y});
    });
    one_step([&] { hand.drag({-2.5, y}, {-3, y}); });
    EXPECT_EQ(desk.editor().size(), last + 2) << "one that is there is dragged";
  }
  hand.key(K::escape);
  hand.key(K::escape);
  EXPECT_EQ(desk.tool(), Tool::select);
}

TEST_F(DeskTest, OnTheCurveNothingChanges) {
  hand.key(K::b);
  const auto before = desk.shape().function;
  const FitReport report = desk.shape().report;
  // Some pixels beside the curve.
  const Contour curve =
      contour(*before, Box<2>(Point<2>(-2, -2), Point<2>(2, 2)), boundary_points(desk.document()));
  ASSERT_EQ(curve.components, 1);
  const auto& vertices = curve.polylines[0].vertices;
  Index placed = 0;
  for (Index i = 0; i < vertices.cols(); i += vertices.cols() / 8) {
    const Point<2> at = vertices.col(i);
    const Point<2> beside = at - 4 * pixel_of_tests * before->gradient(at).normalized();
    hand.to(beside);
    if (desk.hover().over != Over::curve) continue;  // A constraint is near.
    EXPECT_LE((desk.hover().at - at).norm(), 2 * pixel_of_tests);
    one_step([&] { hand.click(beside); });
    ++placed;
    const Point<2> there = place(desk.editor().size() - 1);
    EXPECT_LE(std::abs(before->value(there)), 1e-14);
    EXPECT_LE((there - at).norm(), pixel_of_tests);
  }
  EXPECT_GE(placed, 4);
  const Box<2> box(Point<2>(-2, -2), Point<2>(2, 2));
  EXPECT_LE(greatest_change<2>(*before, *desk.shape().function, box),
            100 * (rounding<2>(report, *before, box) + rounding<2>(desk.shape().report, *before, box)));

  hand.key(K::v);
  const Point<2> at = vertices.col(vertices.cols() / 16);
  hand.to(at);
  ASSERT_EQ(desk.hover().over, Over::curve);
  one_step([&] { hand.click(at, {}, 2); });
  EXPECT_EQ(desk.editor().size(), 6 + placed) << "a double click with the select tool";
  // From there the curve is pulled.
  one_step([&] { hand.drag(at, 1.3 * at); });
  EXPECT_LE(std::abs(desk.shape().function->value(1.3 * at)), 1e-12);
}

TEST_F(DeskTest, ModifierKeysPlaceWithAnyToolAndMakeKinds) {
  const Held interior_keys{.shift = true, .ctrl = true}, exterior_keys{.ctrl = true, .alt = true};
  for (const K tool : {K::v, K::b, K::e, K::n, K::l, K::c, K::p, K::h}) {
    hand.key(tool);
    one_step([&] { hand.click({2, 2}, ctrl_key); });
    const Index last = desk.editor().size() - 1;
    EXPECT_EQ(desk.constraint(last).kind, ConstraintKind::boundary);
    one_step([&] { hand.click({2, 2}, interior_keys); });
    EXPECT_EQ(desk.editor().size(), last + 1);
    EXPECT_EQ(desk.constraint(last).kind, ConstraintKind::interior);
    EXPECT_EQ(desk.constraint(last).value, 1);
    one_step([&] { hand.click({2, 2}, exterior_keys); });
    EXPECT_EQ(desk.constraint(last).kind, ConstraintKind::exterior);
    EXPECT_EQ(desk.constraint(last).value, -1);
    no_step([&] { hand.click({2, 2}, exterior_keys); });
    EXPECT_THAT(desk.selection().indices(), ElementsAre(last));
    one_step([&] { hand.key(K::del); });
  }
  one_step([&] { hand.click({2, 2}, interior_keys); });
  one_step([&] { hand.click({2, -2}, exterior_keys); });
  EXPECT_EQ(desk.constraint(6).kind, ConstraintKind::exterior);
  hand.key(K::a, ctrl_key);
  one_step([&] { hand.key(K::i, ctrl_key); });
  EXPECT_EQ(all_of(desk.document(), ConstraintKind::interior).size(), 7u);
  one_step([&] { hand.key(K::e, ctrl_key); });
  one_step([&] { hand.key(K::b, ctrl_key); });
  EXPECT_EQ(all_of(desk.document(), ConstraintKind::boundary).size(), 7u);
  no_step([&] { hand.key(K::b, ctrl_key); });
}

TEST_F(DeskTest, SpikesAreFoundWhereTheyAreDrawnInACrowdToo) {
  Document<2> document;
  for (int i = 0; i < 300; ++i) {
    const Point<2> out(std::cos(2 * M_PI * i / 300), std::sin(2 * M_PI * i / 300));
    document.constraints.push_back({.constraint = boundary<2>(out, out, 0.05)});
  }
  desk.exchange(document);
  desk.view().show(Box<2>(Point<2>(-4, -3), Point<2>(4, 3)));
  const double length = 26 * symbol_share(usual_spacing(document), 100, 11);
  EXPECT_NEAR(length, 26 * 0.3, 1e-9) << "two pixels from one to the next";
  hand.key(K::v);
  hand.drag(Point<2>(1 + 0.01 * length, 0), {1.0, 0.3});
  EXPECT_LE((desk.constraint(0).normal->direction - Point<2>(0, 1)).norm(), 1e-12);
  EXPECT_EQ(desk.constraint(0).at, Point<2>(1, 0));
}

TEST_F(DeskTest, NormalsAreGivenTurnedAndRemoved) {
  hand.key(K::n);
  const auto before = desk.shape().function;
  one_step([&] { hand.click(place(2)); });
  const NormalConstraint<2> given = *desk.constraint(2).normal;
  EXPECT_LE((given.direction + before->gradient(place(2)).normalized()).norm(), 1e-12);
  const Box<2> box(Point<2>(-2, -2), Point<2>(2, 2));
  EXPECT_LE(greatest_change<2>(*before, *desk.shape().function, box),
            100 * rounding<2>(desk.shape().report, *before, box));
  no_step([&] { hand.click(place(2)); });
  no_step([&] { hand.click(place(4)); });
  EXPECT_THAT(desk.message().text, HasSubstr("only a boundary constraint has a normal"));
  EXPECT_TRUE(desk.message().trouble);

  const auto spike = [&] { return spike_end(desk.constraint(2), 26, pixel_of_tests); };
  hand.to(spike());
  EXPECT_EQ(desk.hover().over, Over::spike);
  EXPECT_EQ(desk.hover().which, 2);
  hand.key(K::v);
  one_step([&] { hand.drag(spike(), place(2) + Point<2>(0.3, 0.4)); });
  EXPECT_LE((desk.constraint(2).normal->direction - Point<2>(0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(desk.constraint(2).normal->value, given.value);
  EXPECT_EQ(desk.constraint(2).normal->offset, given.offset);
  one_step([&] { hand.drag(spike(), place(2) + Point<2>(0.0, 0.52), no_keys, ctrl_key); });
  EXPECT_NEAR(desk.constraint(2).normal->value, 2 * given.value, 1e-12 * std::abs(given.value))
      << "twice as long, twice the value";
  const double twice = desk.constraint(2).normal->value;
  one_step([&] { hand.drag(spike(), place(2) + Point<2>(0.0, 0.52), ctrl_key, ctrl_key); });
  EXPECT_NEAR(desk.constraint(2).normal->value, 2 * twice, 1e-12 * std::abs(twice))
      << "also held from the start";
  hand.key(K::z, ctrl_key);
  one_step([&] { hand.drag(spike(), place(2) + Point<2>(0.5, 0.05), no_keys, shift_key); });
  EXPECT_EQ(desk.constraint(2).normal->direction, Point<2>(1, 0)) << "steps of 15 degrees";
  no_step([&] {
    hand.down(spike());
    hand.to({2, 2});
    hand.key(K::escape);
  });

  hand.key(K::a, ctrl_key);
  one_step([&] { hand.key(K::n, {.shift = true, .ctrl = true}); });
  hand.key(K::n, shift_key);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 1, 2, 3));
  one_step([&] { hand.key(K::del, shift_key); });
  hand.key(K::n, shift_key);
  EXPECT_TRUE(desk.selection().empty());
  EXPECT_EQ(desk.editor().size(), 5);
}

TEST_F(DeskTest, TheNormalToolPlacesOneWithItsNormalAndTurnsIt) {
  hand.key(K::n);
  one_step([&] { hand.drag({2, 1}, {2, 2}); });
  ASSERT_EQ(desk.editor().size(), 6);
  EXPECT_EQ(place(5), Point<2>(2, 1));
  ASSERT_TRUE(desk.constraint(5).normal);
  EXPECT_LE((desk.constraint(5).normal->direction - Point<2>(0, 1)).norm(), 1e-15);
  no_step([&] {
    hand.down({-2, 1});
    EXPECT_TRUE(desk.constraint(6).normal);
    hand.to({-2, 2});
    hand.key(K::escape);
  });
}

TEST_F(DeskTest, LinesAndCirclesOfConstraints) {
  hand.key(K::i);
  hand.key(K::l);
  one_step([&] {
    hand.down({-2, 2});
    EXPECT_EQ(desk.preview().cols(), 0);
    hand.to({1, 2});
    EXPECT_EQ(desk.preview().cols(), 8);
    desk.handle(WheelTurned{{1, 2}, -1});
    hand.key(K::minus);
    hand.key(K::minus);
    hand.key(K::minus);
    EXPECT_EQ(desk.preview().cols(), 4);
    hand.up({1, 2});
  });
  ASSERT_EQ(desk.editor().size(), 9);
  for (Index i = 5; i < 9; ++i) {
    EXPECT_EQ(desk.constraint(i).kind, ConstraintKind::interior) << "the kind of the last placing tool";
    EXPECT_LE((place(i) - Point<2>(-2.0 + static_cast<double>(i - 5), 2)).norm(), 1e-15);
  }
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5, 6, 7, 8));
  no_step([&] { hand.click({2, 2}); });
  no_step([&] {
    hand.down({-2, -2});
    hand.to({1, -2});
    hand.key(K::escape);
    hand.up({1, -2});
  });
  one_step([&] { hand.drag({-2, -2}, {1, -1.8}, no_keys, shift_key); });
  EXPECT_EQ(place(desk.editor().size() - 1).y(), -2) << "straight";

  hand.key(K::e);
  hand.key(K::c);
  desk.set_count(6);
  one_step([&] {
    hand.down({0, 0});
    hand.to({3, 0});
    hand.key(K::plus);
    hand.up({3, 0});
  });
  const Index n = desk.editor().size();
  for (Index i = n - 7; i < n; ++i) {
    EXPECT_EQ(desk.constraint(i).kind, ConstraintKind::exterior);
    EXPECT_NEAR(place(i).norm(), 3, 1e-15);
  }
  desk.set_count(7);
  no_step([&] { hand.drag({0, 0}, {3, 0}); });
  EXPECT_THAT(desk.message().text, HasSubstr("already"));
}

TEST_F(DeskTest, ACageByOneKey) {
  one_step([&] { hand.key(K::k); });
  EXPECT_EQ(all_of(desk.document(), ConstraintKind::exterior).size(), 8u);
  EXPECT_TRUE(desk.shape().current());
  no_step([&] { hand.key(K::k); });
  EXPECT_THAT(desk.message().text, HasSubstr("already"));
}

TEST_F(DeskTest, TheProfileLineIsDrawnAndMoved) {
  no_step([&] {
    hand.key(K::p);
    hand.drag({-2, 0.5}, {2, 0.5});
    ASSERT_TRUE(desk.profile());
    EXPECT_EQ(*desk.profile(), (ProfileLine{{-2, 0.5}, {2, 0.5}}));
    hand.drag({2, 0.5}, {2, 1});
    EXPECT_EQ(desk.profile()->to, Point<2>(2, 1));
    hand.key(K::v);
    hand.drag({-2, 0.5}, {-2, 1});
    EXPECT_EQ(desk.profile()->from, Point<2>(-2, 1));
    hand.drag({1.5, 1}, {1.5, 2});
    EXPECT_EQ(*desk.profile(), (ProfileLine{{-2, 2}, {2, 2}}));
    hand.down({-2, 2});
    hand.to({0, 0});
    hand.key(K::escape);
    EXPECT_EQ(*desk.profile(), (ProfileLine{{-2, 2}, {2, 2}}));
    hand.drag({2, 2}, {1.9, 1.8}, no_keys, shift_key);
    EXPECT_EQ(desk.profile()->to.y(), 2) << "along an axis";
    hand.key(K::p, shift_key);
    EXPECT_FALSE(desk.profile());
    hand.key(K::p, shift_key);
    EXPECT_TRUE(desk.profile());
  });
}

TEST_F(DeskTest, TheViewIsPannedZoomedAndFitted) {
  no_step([&] {
    const View2D view = desk.view();
    const auto centered_at = [&](const Point<2>& at) {
      EXPECT_LE((desk.view().center() - at).norm(), 1e-12);
      desk.view() = view;
    };
    // The hand tells scene points of the view as it was, so a drag in one move is exact.
    const auto pan = [&](Held held, PointerButton button) {
      hand.down({3, 2}, held, button);
      hand.to({2, 1.5}, held);
      EXPECT_EQ(desk.gesture(), Gesture::pan);
      desk.handle(PointerUp{*desk.cursor(), button, held});
      centered_at({1, 0.5});
    };
    pan({}, PointerButton::middle);
    pan({}, PointerButton::right);
    pan(shift_key, PointerButton::left);
    hand.key(K::h);
    pan({}, PointerButton::left);
    hand.key(K::b);
    desk.handle(KeyDown{K::space});
    desk.handle(KeyDown{K::space, {}, true});
    EXPECT_EQ(desk.tool(), Tool::pan);
    pan({}, PointerButton::left);
    desk.handle(KeyUp{K::space});
    EXPECT_EQ(desk.tool(), Tool::boundary);
    hand.key(K::v);
    hand.down({3, 2}, {}, PointerButton::middle);
    hand.to({2, 1.5});
    hand.key(K::escape);
    centered_at({0, 0});

    desk.handle(WheelTurned{{1, 1}, 4});
    EXPECT_NEAR(desk.view().pixel(), 0.005, 1e-17);
    centered_at({0.5, 0.5});
    desk.handle(WheelTurned{{1, 1}, 1, 0, shift_key});
    EXPECT_NEAR(desk.view().center().x(), -0.4, 1e-15);
    desk.view() = view;
    hand.click({-3, 2}, {}, 2);
    centered_at({-3, 2});
    hand.key(K::plus);
    EXPECT_NEAR(desk.view().pixel(), 0.008, 1e-17);
    hand.key(K::minus);
    centered_at({0, 0});
    hand.key(K::right);
    centered_at({0.4, 0});
    hand.key(K::up, shift_key);
    centered_at({0, 4});
    desk.view().pan({100, 100});
    hand.key(K::f);
    for (Index i = 0; i < 5; ++i) EXPECT_TRUE(desk.view().scene().contains(place(i)));
    EXPECT_LT(desk.view().scene().sizes().minCoeff(), 4);
  });
}

}  // namespace
}  // namespace seesaw
