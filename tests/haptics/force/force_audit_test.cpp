// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/force_audit.h"

#include <gtest/gtest.h>

#include <limits>

namespace relievo {
namespace {

constexpr ForceBounds kOn{false, 6, 0.2};
constexpr ForceBounds kZero{true, 6, 0.2};

TEST(ForceAudit, CountsNothingWhileAllIsWithinBounds) {
  ForceAudit audit;
  audit = audited(audit, kOn, {0, 0, 5.9}, {0, 0, 6});
  audit = audited(audit, kOn, {0, 0, 6}, {});  // Letting go is always allowed.
  audit = audited(audit, kZero, {0, 0, 6}, {});
  EXPECT_EQ(audit.violations(), 0U);
  EXPECT_EQ(audit.ticks, 3U);
  EXPECT_EQ(audit.zero_demanded, 1U);
  EXPECT_EQ(audit.largest_n, 6);
  EXPECT_NEAR(audit.largest_step_n, 0.1, 1e-12);
}

TEST(ForceAudit, SeesAForceWhereZeroIsDemanded) {
  EXPECT_EQ(audited({}, kZero, {0, 0, 1e-6}, {0, 0, 1e-6}).zero_violations, 1U);
}

TEST(ForceAudit, SeesAForceAboveTheCapAndOneThatIsNoNumber) {
  EXPECT_EQ(audited({}, kOn, {0, 0, 6}, {0, 0, 6.001}).limit_violations, 1U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(audited({}, kOn, {}, {nan, 0, 0}).limit_violations, 1U);
}

TEST(ForceAudit, SeesAStepThatIsTooLargeButAllowsACapThatComesDown) {
  EXPECT_EQ(audited({}, kOn, {0, 0, 1}, {0, 0, 1.3}).step_violations, 1U);
  EXPECT_EQ(audited({}, kOn, {0, 0, 1}, {0, 0.3, 1}).step_violations, 1U) << "sideways, too";
  EXPECT_EQ(audited({}, {false, 2, 0.2}, {0, 0, 5}, {0, 0, 2}).violations(), 0U);
  EXPECT_EQ(audited({}, {false, 2, 0.2}, {0, 0, 5}, {0, 0, 2}).fast_falls, 1U) << "named, too";
  EXPECT_EQ(audited({}, kOn, {0, 0, 5}, {0, 0, 4.8}).fast_falls, 0U);
  EXPECT_EQ(audited({}, {false, 2, 0.2}, {0, 0, 5}, {0, 2, 0}).step_violations, 1U)
      << "it may fall, but not turn";
  EXPECT_EQ(audited({}, {false, 2, 0.2}, {0, 0, 5}, {0, 0, 1}).step_violations, 1U);
}

}  // namespace
}  // namespace relievo
