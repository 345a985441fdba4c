// SPDX-License-Identifier: BSD-3-Clause
// Numbers of files as people read them.
#include "app/cli/report_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace relievo::batch {
namespace {

TEST(ReportText, ANumberStoredAsFloatIsShownAsItWasStored) {
  EXPECT_EQ(shownNumber(static_cast<double>(0.1F)), 0.1);
  EXPECT_EQ(shownNumber(static_cast<double>(-11.996347F)), -11.996347);
  EXPECT_EQ(shownNumber(static_cast<double>(-1.0064105e-07F)), -1.0064105e-07);
  EXPECT_EQ(shownNumber(static_cast<double>(357.03F)), 357.03);
}

TEST(ReportText, ANumberOfAScaleIsShownWithoutTheRestOfItsProduct) {
  EXPECT_EQ(shownNumber(84893520 * 0.01), 848935.2);
  EXPECT_EQ(shownNumber(40659 * 0.01), 406.59);
  ASSERT_NE(40659 * 0.01, 406.59) << "else this shows nothing";
}

TEST(ReportText, ANumberThatIsShortStaysAsItIs) {
  for (const double value : {0.0, -0.5, 636001.76, 512022.46875, 848899.8125, 123456789.0}) {
    EXPECT_EQ(shownNumber(value), value);
  }
  EXPECT_EQ(shownNumber(std::numeric_limits<double>::max()), std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isnan(shownNumber(std::nan(""))));
}

TEST(ReportText, FifteenDigitsStay) {
  EXPECT_EQ(shownNumber(1.0 / 3), 0.333333333333333);
}

}  // namespace
}  // namespace relievo::batch
