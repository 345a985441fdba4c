// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/loss_report.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

TEST(LossWords, SharesAreSaidAsPeopleReadThem) {
  EXPECT_EQ(englishText(percentWords(0.107)), "10.7 %");
  EXPECT_EQ(englishText(percentWords(0.0213)), "2.13 %");
  EXPECT_EQ(englishText(percentWords(0.001)), "0.1 %");
  EXPECT_EQ(englishText(percentWords(7.47e-5)), "less than 0.1 %") << "not 0.00747 %";
  EXPECT_EQ(englishText(percentWords(0)), "0 %") << "nothing is not a little";
}

TEST(LossWords, AHiddenPartThatNobodyWondersAtIsNotSaid) {
  DepthLosses losses;
  losses.hidden_share = 7.47e-5;
  const std::array<double, kOriginCount> shares{};
  const std::string words = englishText(lossReport(losses, 0, shares));
  EXPECT_EQ(words.find("hidden"), std::string::npos) << words;
}

}  // namespace
}  // namespace relievo
