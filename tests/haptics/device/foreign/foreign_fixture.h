// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "haptics/device/foreign/foreign_device.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/haptics/device/foreign/stand_in_log.h"

namespace relievo::test {

/// The stand-in with that fault.
inline std::filesystem::path standIn(const std::string& fault) {
  return std::filesystem::path(RELIEVO_BINARY_DIR) / "tests/stand_ins" / (fault + ".so");
}
inline constexpr const char* kStandInId = "stand-in.7";

/// A folder of its own, and a log of the forces that stand-ins get.
class ForeignTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "/relievo-foreign-XXXXXX";
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
    ASSERT_EQ(::setenv("RELIEVO_STAND_IN_LOG", logFile().c_str(), 1), 0);
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  std::string logFile() const { return folder / "log"; }
  std::vector<StandInEntry> log() const { return standInLog(logFile()); }

  std::filesystem::path folder;
};

/// A busy computer is no fault of a host: it is given a minute. Only what is to be noticed by time
/// is given less by the tests that ask for it.
inline foreign::Patience longPatience() {
  return {
      .open_s = 120, .silence_ms = 60'000, .close_ms = 60'000, .stale_place_ns = 60'000'000'000};
}

inline std::unique_ptr<foreign::ForeignDevice> deviceOf(
    const std::string& fault, foreign::Patience patience = longPatience()) {
  return std::make_unique<foreign::ForeignDevice>(
      standIn(fault), kStandInId, "plugin:" + fault + "/" + kStandInId, "Stand-in", patience);
}

/// Goes on at 1 kHz until something is so; the test's own time limit ends what never is.
inline void exchangeUntil(Device& device, DeviceN force,
                          const std::function<bool(const DeviceReading&)>& is_so) {
  while (true) {
    const std::int64_t now_ns = monotonicNs();
    if (is_so(device.exchange(force, now_ns))) return;
    sleepUntil(now_ns + 1'000'000);
  }
}

}  // namespace relievo::test
