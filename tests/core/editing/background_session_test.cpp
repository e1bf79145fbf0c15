// A session on another thread: it follows what is edited meanwhile, and comes back as it was where it is
// stopped.
#include "core/editing/background_session.h"

#include <gtest/gtest.h>

#include "tests/core/rbf/edited.h"

namespace seesaw {
namespace {

// A small fit may end before the test says another word. Then again with twice as many rows, which take
// eight times as long.
constexpr Index most_rows = 5000;

TEST(BackgroundSession, FollowsWhatIsEditedMeanwhile) {
  Random random(8);
  bool followed = false;
  for (Index count = 300; !followed && count < most_rows; count *= 2) {
    const auto constraints = random_constraints<2>(count, random);
    auto edited = constraints;
    for (std::size_t i = 0; i < 40; ++i) edited[i].value += 0.1;
    BackgroundSession<2> work({constraints});
    work.follow({edited});
    work.wait();
    EXPECT_TRUE(work.ready());
    EXPECT_EQ(work.fraction(), 1.0);
    auto result = work.take();
    EXPECT_FALSE(result.refusal);
    ASSERT_TRUE(result.session);
    followed = result.session->last().full == Full::no;
    expect_as_fitted(result.session->fit(), fit(followed ? edited : constraints));
    if (followed) {
      EXPECT_LE(result.session->last().solves, 2);
    }
  }
  EXPECT_TRUE(followed) << "it was always told too late";
}

TEST(BackgroundSession, FollowsNoFartherThanABorderGoes) {
  const Constraints<2> shape = ring();
  Constraints<2> bad = shape;
  bad[4].at = bad[60].at;
  BackgroundSession<2> other_kernel({shape}), impossible({shape});
  other_kernel.follow({shape, {.kernel = Kernel::cubic}});
  impossible.follow({bad});
  for (BackgroundSession<2>* each : {&other_kernel, &impossible}) {
    auto result = each->take();
    EXPECT_FALSE(result.refusal);
    ASSERT_TRUE(result.session);
    EXPECT_LE(difference(result.session->fit().function, fit(shape).function), as_good_as_fit);
  }
}

TEST(BackgroundSession, CancelledItComesBackAsItWas) {
  Random random(9);
  bool cancelled = false;
  for (Index count = 600; !cancelled && count < most_rows; count *= 2) {
    auto constraints = random_constraints<3>(count, random);
    std::optional<EditSession<3>> session(std::in_place, constraints);
    const Fit<3> before = session->fit();
    for (auto& each : constraints) each.at *= 1.01;  // a full fit
    BackgroundSession<3> work({constraints}, {}, std::move(session));
    work.cancel();
    auto result = work.take();
    ASSERT_TRUE(result.session);
    cancelled = result.refusal != nullptr;
    if (cancelled) {
      EXPECT_THROW(std::rethrow_exception(result.refusal), Cancelled);
      EXPECT_EQ(result.session->fit().function.normalized_weights(), before.function.normalized_weights());
      EXPECT_LT(work.fraction(), 1.0);
    } else {
      expect_as_fitted(result.session->fit(), fit(constraints));
    }
  }
  EXPECT_TRUE(cancelled) << "it was always done before";
}

TEST(BackgroundSession, CancelledInItsFirstFitThereIsNone) {
  Random random(10);
  bool cancelled = false;
  for (Index count = 600; !cancelled && count < most_rows; count *= 2) {
    const auto constraints = random_constraints<3>(count, random);
    BackgroundSession<3> work({constraints});
    work.cancel();
    auto result = work.take();
    cancelled = !result.session;
    if (cancelled) {
      ASSERT_TRUE(result.refusal);
      EXPECT_THROW(std::rethrow_exception(result.refusal), Cancelled);
    } else {
      EXPECT_FALSE(result.refusal);
      expect_as_fitted(result.session->fit(), fit(constraints));
    }
  }
  EXPECT_TRUE(cancelled) << "it was always done before";
}

}  // namespace
}  // namespace seesaw
