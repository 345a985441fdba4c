// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "haptics/device/foreign/foreign_device.h"
#include "tests/haptics/device/dhd/dhd_log.h"
#include "tests/haptics/device/foreign/foreign_fixture.h"

namespace relievo::test {

/// The plug-in for devices of Force Dimension in hosts, with a stand-in for their library.
class DhdTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "/relievo-dhd-XXXXXX";
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
    set("RELIEVO_DHD_LOG", folder / "log");
    set("XDG_CONFIG_HOME", folder / "config");  // Nothing that the user has chosen.
    useLibrary("whole");
    is("");
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  static void set(const char* name, const std::string& value) {
    ASSERT_EQ(::setenv(name, value.c_str(), 1), 0);
  }
  static std::string library(const std::string& kind) {
    return std::string(RELIEVO_BINARY_DIR) + "/tests/dhd_stand_ins/" + kind + "/libdhd.so.3";
  }
  static void useLibrary(const std::string& kind) {
    set("RELIEVO_FORCE_DIMENSION_LIBRARY", library(kind));
  }
  /// What is different of the device: stand_in_dhd.cpp.
  static void is(const std::string& what) { set("RELIEVO_DHD", what); }

  static std::unique_ptr<foreign::ForeignDevice> device(const std::string& id = "device.0") {
    return std::make_unique<foreign::ForeignDevice>(
        FORCE_DIMENSION, id, "plugin:force_dimension/" + id, "Stand-in", longPatience());
  }
  /// Why it is not opened, in English.
  static std::string refusal(const std::string& id = "device.0") {
    try {
      device(id)->open();
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "it was opened";
  }
  std::vector<DhdCall> log() const { return dhdLog(folder / "log"); }
  std::vector<DhdCall> logOf(DhdCall::What what) const {
    std::vector<DhdCall> calls = log();
    std::erase_if(calls, [what](const DhdCall& call) { return call.what != what; });
    return calls;
  }
  static double size(const DhdCall& call) {
    return std::hypot(call.given[0], call.given[1], call.given[2]);
  }
  /// Goes on until the library was given that much.
  void pushUntil(Device& device, DeviceN force, double newton) const {
    exchangeUntil(device, force, [&](const DeviceReading&) {
      const auto forces = logOf(DhdCall::What::force);
      return std::any_of(forces.begin(), forces.end(),
                         [&](const DhdCall& call) { return size(call) >= newton; });
    });
  }
  static DeviceReading readingWith(Device& device, DeviceFault fault, DeviceN force = {}) {
    DeviceReading found;
    exchangeUntil(device, force, [&](const DeviceReading& reading) {
      found = reading;
      return reading.fault == fault && reading.time_ns > 0;
    });
    return found;
  }

  std::filesystem::path folder;
};

}  // namespace relievo::test
