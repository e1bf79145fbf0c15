// The guided tour: what each step asks for can be done by the very gesture that it names, and is then seen.
#include "sandbox2d/tour.h"

#include "tests/sandbox2d/app_stage.h"

namespace seesaw {
namespace {

// A vertex of the curve, far from every constraint and not beneath the tour's panel.
Point<2> free_place_on_curve(AppStage& stage) {
  Point<2> best = Point<2>::Zero();
  double farthest = 0;
  for (const Polyline& line : stage.curve().polylines)
    for (Index i = 0; i < line.vertices.cols(); ++i) {
      const Point<2> p = line.vertices.col(i);
      const Point<2> shown = stage.desk().view().pixel_from_scene(p);
      if (shown.y() > 0.5 * stage.app().layout().scene.height) continue;
      double near = 1e300;
      for (const auto& each : stage.document().constraints)
        near = std::min(near, (each.constraint.at - p).norm());
      if (near > farthest) {
        farthest = near;
        best = p;
      }
    }
  EXPECT_GT(farthest, 12 * stage.pixel());
  return best;
}

class TourTest : public ::testing::Test {
 protected:
  // Where the step begins nothing has been done; `gesture` does it, and "Next" goes on.
  void step(AppStage& stage, int number, const std::string& gesture) {
    const Tour& tour = stage.app().tour();
    ASSERT_EQ(tour.step(), number);
    ASSERT_FALSE(tour.done()) << number;
    stage.play(gesture);
    EXPECT_TRUE(tour.done()) << tour_steps()[static_cast<std::size_t>(number)].task;
    EXPECT_TRUE(tour.pointed().empty());
    EXPECT_TRUE(stage.desk().shape().function);
  }
};

TEST_F(TourTest, EachStepIsDoneByTheGestureItAsksFor) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 1280, .height = 800});
  AppStage stage(window);
  const Tour& tour = stage.app().tour();
  stage.play("key f3\nframes 2");
  ASSERT_TRUE(tour.running());

  EXPECT_EQ(stage.curve().components, 0) << "no curve yet, as the words say";
  step(stage, 0, "key i\n" + stage.click({0.05, 0}));
  EXPECT_EQ(stage.curve().components, 1);

  stage.play("click \"Tour/Next\"\nframes 9");
  step(stage, 1, stage.drag(stage.at(0), stage.at(0) * 1.2));

  stage.play("click \"Tour/Next\"\nframes 9");
  EXPECT_EQ(stage.curve().components, 0);
  step(stage, 2, "key k");
  EXPECT_EQ(stage.document().constraints.size(), 10u);
  const Point<2> right = stage.at(1);
  stage.play(stage.drag(right, right + Point<2>(0.4, 0.2)));
  EXPECT_LT((stage.at(1) - right - Point<2>(0.4, 0.2)).norm(), 2 * stage.pixel());

  stage.play("click \"Tour/Next\"\nframes 9");
  ASSERT_EQ(tour.pointed().size(), 1u);
  const Index marked = tour.pointed().front();
  const auto end = spike_end(stage.desk().constraint(marked), Reaches().spike_length, stage.pixel());
  step(stage, 3, stage.drag(end, stage.at(marked) + Point<2>(0, 26 * stage.pixel())));

  stage.play("click \"Tour/Next\"\nframes 9");
  EXPECT_GT(stage.app().layout().plate.width, 100);
  EXPECT_TRUE(stage.desk().profile());
  step(stage, 4, "drag \"interior value\" \"interior value\" +45 +0 10");

  stage.play("click \"Tour/Next\"\nframes 9");
  stage.picture();
  const Point<2> on_curve = free_place_on_curve(stage);
  const auto function = stage.desk().shape().function;
  const Index count = stage.desk().editor().size();
  step(stage, 5, "doubleclick " + stage.place(on_curve));
  ASSERT_EQ(stage.desk().editor().size(), count + 1);
  const Box<2> seen = stage.desk().view().scene();
  const double largest = function->values(Random(3).points_in<2>(seen, 500)).cwiseAbs().maxCoeff();
  EXPECT_LT(greatest_change(*function, *stage.desk().shape().function, seen), 1e-6 * largest)
      << "nothing moves";
  const Point<2> placed = stage.at(count);
  stage.play(stage.drag(placed, placed + Point<2>(0, 20 * stage.pixel())));
  EXPECT_GT((stage.at(count) - placed).norm(), 15 * stage.pixel());

  stage.play("click \"Tour/Next\"\nframes 9");
  EXPECT_EQ(tour.step(), static_cast<int>(tour_steps().size()) - 1);
  EXPECT_FALSE(stage.has("Tour/Next"));
  stage.play("click \"Tour/End the tour\"");
  EXPECT_FALSE(tour.running());
}

TEST_F(TourTest, GoesBackAndStops) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 1280, .height = 800});
  AppStage stage(window);
  stage.play("key f3\nframes 2\nclick \"Tour/Back\"");  // there is none before the first
  EXPECT_EQ(stage.app().tour().step(), 0);
  stage.play("click \"Tour/Next\"\nframes 2\nclick \"Tour/Next\"\nframes 2");
  EXPECT_EQ(stage.app().tour().step(), 2) << "one may go on without doing anything";
  stage.play("click \"Tour/Back\"\nframes 2");
  EXPECT_EQ(stage.app().tour().step(), 1);
  stage.play("click \"Tour/Stop\"\nframes 2");
  EXPECT_FALSE(stage.app().tour().running());
  EXPECT_FALSE(stage.has("Tour/Next"));
}

TEST_F(TourTest, DoesNotThrowAwayWhatIsUnsaved) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 1280, .height = 800});
  AppStage stage(window);
  stage.play(stage.drag(stage.at(0), stage.at(0) * 1.2));
  const std::string mine = bits_of(stage.document());
  stage.play("key f3\nframes 2");
  EXPECT_TRUE(stage.app().asks());
  stage.play("key escape\nframes 2");
  EXPECT_FALSE(stage.app().tour().running());
  EXPECT_EQ(bits_of(stage.document()), mine);
  // Offered to who starts for the first time.
  AppOptions first;
  EXPECT_TRUE(first.offer_tour);
}

}  // namespace
}  // namespace seesaw
