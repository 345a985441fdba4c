// SPDX-License-Identifier: BSD-3-Clause
// What relievo pyramid says of the levels it writes.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using Json = nlohmann::json;
using test::reportOf;
using test::runRelievo;

class PyramidVerb : public test::CommandTest {};

TEST_F(PyramidVerb, ReportsHowMuchEachLevelIsSmoothed) {
  const Json report = reportOf(runRelievo({"pyramid", test::kReliefF, "--unit", "mm", "--view",
                                           "top", "-o", path("p.tif"), "--report", "json"}));
  const Json& levels = report["levels"];
  ASSERT_EQ(levels.size(), 4U);
  const double spacing_mm = levels[0]["spacing_mm"];
  for (std::size_t l = 0; l < levels.size(); ++l) {
    // The kernel's variance is 1 in the spacings of each step: a sum of powers of four.
    const double variance = (std::pow(4.0, static_cast<double>(l)) - 1) / 3;
    EXPECT_NEAR(levels[l]["sigma_mm"], spacing_mm * std::sqrt(variance), 1e-9) << l;
    EXPECT_NEAR(levels[l]["spacing_mm"], spacing_mm * std::pow(2.0, static_cast<double>(l)), 1e-9);
  }
}

}  // namespace
}  // namespace relievo
