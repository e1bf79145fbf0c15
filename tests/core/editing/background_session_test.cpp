// A session on another thread: it follows what is edited meanwhile, and comes back as it was where it is
// stopped.
#include "core/editing/background_session.h"

#include <gtest/gtest.h>

#include "tests/core/rbf/edited.h"

namespace seesaw {
namespace {

TEST(BackgroundSession, FollowsWhatIsEditedMeanwhile) {
  Random random(8);
  auto constraints = random_constraints<2>(300, random);
  BackgroundSession<2> work({constraints});
  for (std::size_t i = 0; i < 40; ++i) constraints[i].value += 0.1;
  work.follow({constraints});
  work.wait();
  EXPECT_TRUE(work.ready());
  EXPECT_EQ(work.fraction(), 1.0);
  auto result = work.take();
  EXPECT_FALSE(result.refusal);
  ASSERT_TRUE(result.session);
  expect_as_fitted(result.session->fit(), fit(constraints));
  EXPECT_LE(result.session->last().solves, 2);
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
  auto constraints = random_constraints<3>(600, random);
  std::optional<EditSession<3>> session(std::in_place, constraints);
  const Fit<3> before = session->fit();
  for (auto& each : constraints) each.at *= 1.01;  // a full fit
  BackgroundSession<3> work({constraints}, {}, std::move(session));
  work.cancel();
  auto result = work.take();
  ASSERT_TRUE(result.session);
  ASSERT_TRUE(result.refusal);
  EXPECT_THROW(std::rethrow_exception(result.refusal), Cancelled);
  EXPECT_EQ(result.session->fit().function.normalized_weights(), before.function.normalized_weights());
  EXPECT_LT(work.fraction(), 1.0);

  BackgroundSession<3> first({constraints});
  first.cancel();
  EXPECT_FALSE(first.take().session);
}

}  // namespace
}  // namespace seesaw
