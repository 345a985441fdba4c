// SPDX-License-Identifier: BSD-3-Clause
// Devices of Haply by the command line, on a mock of their service: listed, touched with, replayed.
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/app/command_test.h"
#include "tests/emulator/haply/inverse_service.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using emulator::HaplyFault;
using emulator::HaplyWorld;
using emulator::InverseService;
using test::CommandResult;
using testing::HasSubstr;
using testing::Not;

class HaplyVerbs : public test::CommandTest {
 protected:
  InverseService mock_;

  CommandResult run(const std::vector<std::string>& words) const {
    return test::runRelievo(words, {"RELIEVO_HAPLY_SERVICE=" + std::to_string(mock_.port()),
                                    "RELIEVO_HAPLY_PATIENCE_S=60"});
  }
  nlohmann::json listed() const {
    return nlohmann::json::parse(run({"devices", "--report", "json"}).out, nullptr, false);
  }
  void plant(HaplyFault fault) {
    mock_.with([&](HaplyWorld& world) { world.fault = fault; });
  }
};

TEST_F(HaplyVerbs, EveryDeviceIsListedWithItsStateAndLimits) {
  const nlohmann::json report = listed();
  EXPECT_EQ(report["haply_service"]["version"], "3.5.0.0");
  EXPECT_EQ(report["haply_service"]["state"], "ready");
  ASSERT_EQ(report["haplys"].size(), 1U);
  const nlohmann::json& device = report["haplys"][0];
  EXPECT_EQ(device["id"], "haply:049D");
  EXPECT_EQ(device["name"], "Haply Inverse3 049D");
  EXPECT_EQ(device["state"], "ready");
  EXPECT_EQ(device["code"], "");
  EXPECT_EQ(device["max_force_n"], 5);
  EXPECT_EQ(report["tried_on_hardware"]["haply"], "never");
  EXPECT_THAT(run({"devices"}).out, AllOf(HasSubstr("haply:049D: Haply Inverse3 049D, ready"),
                                          HasSubstr("haply: tried on hardware: never")));
}

TEST_F(HaplyVerbs, WhatKeepsItFromBeingUsedIsSaidWithWhatToDo) {
  plant(HaplyFault::uncalibrated);
  const CommandResult uncalibrated = run({"devices"});
  EXPECT_EQ(uncalibrated.exit_code, 6);
  EXPECT_THAT(uncalibrated.out, HasSubstr("not_calibrated"));
  EXPECT_THAT(uncalibrated.err, AllOf(HasSubstr("E314"), HasSubstr("inkwell")));
  plant(HaplyFault::no_power);
  EXPECT_THAT(run({"devices"}).err, AllOf(HasSubstr("E315"), HasSubstr("power supply")));
  plant(HaplyFault::device_absent);
  const CommandResult absent = run({"devices"});
  EXPECT_EQ(absent.exit_code, 0) << "nothing is plugged in, and nothing is wrong";
  EXPECT_THAT(absent.err, HasSubstr("E313"));
  mock_.with([](HaplyWorld& world) { world.version = "3.0.5"; });
  EXPECT_THAT(run({"devices"}).err, AllOf(HasSubstr("E312"), HasSubstr("3.0.5")));
}

TEST_F(HaplyVerbs, WhereNoServiceListensNothingIsSaid) {
  const auto quiet = [](const std::string& address) {
    return test::runRelievo({"devices"}, {"RELIEVO_HAPLY_SERVICE=" + address});
  };
  EXPECT_THAT(quiet("1").out, Not(HasSubstr("Inverse Service")));
  const CommandResult bad = quiet("nonsense");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_THAT(bad.err, HasSubstr("RELIEVO_HAPLY_SERVICE"));
}

TEST_F(HaplyVerbs, ARecordingNamesTheDeviceAndIsReplayedWithoutIt) {
  mock_.with([](HaplyWorld& world) { world.pullToward({0, 0, 0}); });
  // A busy computer may interrupt it: then it is saved and says so.
  const CommandResult record =
      run({"record", test::kReliefF, "--unit", "mm", "--device", "haply:049D", "--seconds", "0.3",
           "-o", path("log.csv"), "--report", "json"});
  const nlohmann::json report = nlohmann::json::parse(record.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << record.out << record.err;
  EXPECT_EQ(report["device"], "haply:049D");
  EXPECT_EQ(report["violations"], 0);
  EXPECT_EQ(report["ticks"], 300);
  EXPECT_THAT(test::bytesOf(path("log.csv")), HasSubstr("device told {"));
  const nlohmann::json replayed =
      test::reportOf(test::runRelievo({"replay", path("log.csv"), "--report", "json"}));
  EXPECT_EQ(replayed["identical"], true) << replayed;
  EXPECT_LE(mock_.with([](HaplyWorld& world) { return world.largest_n; }), 5.001);
}

TEST_F(HaplyVerbs, ADeviceThatIsNotThereOrNotReadyRecordsNothing) {
  const CommandResult other = run(
      {"record", test::kReliefF, "--unit", "mm", "--device", "haply:04BA", "-o", path("log.csv")});
  EXPECT_EQ(other.exit_code, 6);
  EXPECT_THAT(other.err, AllOf(HasSubstr("E313"), HasSubstr("049D")));
  plant(HaplyFault::uncalibrated);
  const CommandResult waits = run({"record", test::kReliefF, "--unit", "mm", "--device", "haply",
                                   "--ready", "1", "-o", path("log.csv")});
  EXPECT_EQ(waits.exit_code, 6);
  EXPECT_THAT(waits.err, HasSubstr("inkwell"));
  EXPECT_FALSE(fs::exists(path("log.csv")));
}

}  // namespace
}  // namespace relievo
