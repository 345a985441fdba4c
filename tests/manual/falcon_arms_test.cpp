// SPDX-License-Identifier: BSD-3-Clause
// The tool of the test plan does what its cases say, on an emulated Falcon.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/emulator/mock_usb.h"

namespace relievo {
namespace {

TEST(FalconArms, EachMotorMovesItsOwnArmMostAndTheEncodersAreShown) {
  emulator::MockUsb usb;
  if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
  const auto falcon = std::make_shared<emulator::SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  falcon->with([](auto& f) { f.body.letGo(0); });
  usb.plugIn(falcon);
  FILE* tool =
      popen("XDG_CONFIG_HOME=/nonexistent " RELIEVO_BINARY_DIR "/tests/falcon_arms 0.5", "r");
  ASSERT_NE(tool, nullptr);
  std::array<char, 200> line{};
  int pulses = 0, shown = 0;
  while (std::fgets(line.data(), line.size(), tool) != nullptr) {
    std::array<int, 3> moved{};
    std::array<char, 10> motor{};
    if (std::sscanf(line.data(), "%9s motor, 100 counts for 150 ms: top %d, right %d, left %d",
                    motor.data(), &moved[0], &moved[1], &moved[2]) == 4) {
      const std::size_t own = std::string(motor.data()) == "top" ? 0 : motor[0] == 'r' ? 1 : 2;
      EXPECT_GT(moved[own], 5) << line.data();
      for (const int other : moved) EXPECT_LE(other, moved[own]) << line.data();
      ++pulses;
    }
    if (std::string(line.data()).starts_with("encoders: top ")) ++shown;
  }
  EXPECT_EQ(pclose(tool), 0);
  EXPECT_EQ(pulses, 3);
  EXPECT_EQ(shown, 2);
  falcon->with([](auto& f) { EXPECT_TRUE(f.commands().back().neutral()); });
}

}  // namespace
}  // namespace relievo
