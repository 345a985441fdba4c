// SPDX-License-Identifier: BSD-3-Clause
// What can go wrong with a device of Force Dimension and its maker's library, one fault each: the
// right sentence or fault, and zero force.
#include <sys/stat.h>

#include "haptics/device/foreign/ask_host.h"
#include "haptics/device/foreign/plugin_settings.h"
#include "tests/haptics/device/dhd/dhd_fixture.h"

namespace relievo::foreign {
namespace {

namespace fs = std::filesystem;
using test::DhdCall;
using testing::HasSubstr;
using What = DhdCall::What;

constexpr int kErrors = 23;  // The library numbers them from 0.

class DhdFaults : public test::DhdTest {
 protected:
  /// Nothing was pushed since it was opened or since its force was switched on last.
  void expectZeroAfterTheFault() const {
    const auto forces = logOf(What::force);
    ASSERT_FALSE(forces.empty());
    EXPECT_EQ(size(forces.back()), 0);
  }
  std::string troubleOfScan() const {
    const ScannedPlugin plugin = scanPlugin(fs::path(FORCE_DIMENSION));
    return plugin.trouble ? codeOf(*plugin.trouble) + " " + englishText(*plugin.trouble) : "";
  }
};

TEST_F(DhdFaults, OpeningSaysWhatTheLibrarySaysOfEachError) {
  for (int error = 0; error < kErrors; ++error) {
    is("open " + std::to_string(error));
    EXPECT_THAT(refusal(), HasSubstr("it was not opened: the stand-in says why")) << error;
  }
  EXPECT_TRUE(logOf(What::force).empty());
}

TEST_F(DhdFaults, EachErrorOfAStepIsTheRightFaultAtZeroForce) {
  for (const char* const what : {"error ", "force_error "}) {
    for (int error = 0; error < kErrors; ++error) {
      std::filesystem::remove(folder / "log");
      is(what + std::to_string(error));
      DeviceFault fault = DeviceFault::protocol;
      if (error == 2 || error == 7) fault = DeviceFault::timeout;
      if (error == 5) fault = DeviceFault::disconnected;
      if (error == 12) fault = DeviceFault::not_ready;
      const auto device = this->device();
      device->open();
      readingWith(*device, fault, {0, 0, 1});
      if (fault != DeviceFault::disconnected) {
        // The steps after it, too.
        for (int i = 0; i < 5; ++i) readingWith(*device, fault, {0, 0, 1});
      }
      expectZeroAfterTheFault();
    }
  }
}

TEST_F(DhdFaults, AskedTooSoonIsNoFaultAndTheForceIsTaken) {
  is("too_soon 1");
  const auto device = this->device();
  device->open();
  pushUntil(*device, {0, 1, 0}, 0.999);
  EXPECT_EQ(readingWith(*device, DeviceFault::none, {0, 1, 0}).fault, DeviceFault::none);
}

TEST_F(DhdFaults, MotorsThatCannotShowAllOfAForceAreNoFault) {
  is("saturated 1");
  const auto device = this->device();
  device->open();
  pushUntil(*device, {0, 3, 0}, 2.999);
  EXPECT_EQ(readingWith(*device, DeviceFault::none, {0, 3, 0}).fault, DeviceFault::none);
}

TEST_F(DhdFaults, BrakesHoldTheForceAtZeroUntilTheyAreLetGo) {
  is("brake 5");
  const auto device = this->device();
  device->open();
  readingWith(*device, DeviceFault::not_ready, {0, 1, 0});
  readingWith(*device, DeviceFault::none, {0, 1, 0});
  const auto enabled = logOf(What::enable);
  EXPECT_EQ(enabled.size(), 1U) << "brakes are for a person to let go";
}

TEST_F(DhdFaults, ItsButtonArrivesWhileTheBrakesHold) {
  is("brake 1000 buttons 1");
  const auto device = this->device();
  device->open();
  test::exchangeUntil(*device, {}, [](const DeviceReading& reading) {
    return reading.fault == DeviceFault::not_ready && reading.buttons == 0b100;
  });
}

TEST_F(DhdFaults, AForceThatAPersonSwitchedOffStaysOff) {
  for (const int why : {1, 2, 4, 5, 6}) {
    std::filesystem::remove(folder / "log");
    is("off " + std::to_string(why));
    const auto device = this->device();
    device->open();
    for (int i = 0; i < 50; ++i) readingWith(*device, DeviceFault::not_ready, {0, 1, 0});
    EXPECT_EQ(logOf(What::enable).size(), 1U) << why;
    expectZeroAfterTheFault();
  }
}

TEST_F(DhdFaults, AForceThatTheWatchdogEndedRisesAnewFromZero) {
  is("off 3");
  const auto device = this->device();
  device->open();
  readingWith(*device, DeviceFault::not_ready, {0, 2, 0});
  readingWith(*device, DeviceFault::none, {0, 2, 0});
  pushUntil(*device, {0, 2, 0}, 1.999);
  const auto all = log();
  std::size_t again = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].what == What::enable) again = i;
  }
  ASSERT_GT(again, 6U) << "it was switched on again";
  EXPECT_EQ(size(all[again - 1]), 0) << "before it is switched on";
  for (std::size_t i = again + 1; i < all.size(); ++i) {
    if (all[i].what != What::force) continue;
    constexpr double kRiseNPerS = 50, kRoundingN = 0.01;
    const double seconds = 1e-9 * static_cast<double>(all[i].time_ns - all[again].time_ns);
    EXPECT_LE(size(all[i]), kRiseNPerS * seconds + kRoundingN) << "it steps instead of rising";
  }
}

TEST_F(DhdFaults, PowerReadinessAndAPulledCableAreToldApart) {
  for (const int word : {0, 2, 3}) {  // Power, started, calibrated.
    is("word " + std::to_string(word));
    const auto device = this->device();
    device->open();
    readingWith(*device, DeviceFault::not_ready, {0, 1, 0});
  }
  is("word 1");
  const auto device = this->device();
  device->open();
  readingWith(*device, DeviceFault::disconnected, {0, 1, 0});
}

TEST_F(DhdFaults, ACutReachesTheLibraryFromAnotherThread) {
  const auto device = this->device();
  device->open();
  pushUntil(*device, {0, 1, 0}, 0.999);
  const auto stepping = logOf(What::force).back().thread;
  device->cutForce();
  while (true) {
    bool cut = false;
    for (const DhdCall& call : logOf(What::force)) {
      cut = cut || (call.thread != stepping && size(call) == 0 && call.time_ns > 0 &&
                    call.thread != logOf(What::open).front().thread);
    }
    if (cut) break;
    sleepUntil(monotonicNs() + 1'000'000);
  }
  EXPECT_EQ(logOf(What::enable).size(), 1U) << "the arm is not dropped";
}

TEST_F(DhdFaults, ALibraryThatIsNotThereIsSaid) {
  // No place of this computer's own can have the file.
  set("RELIEVO_FORCE_DIMENSION_LIBRARY", folder / "libdhd.so.3");
  EXPECT_THAT(troubleOfScan(), HasSubstr("E321 Force Dimension's library was not found"));
  set("RELIEVO_FORCE_DIMENSION_LIBRARY", "libdhd.so.3");
  EXPECT_THAT(troubleOfScan(), HasSubstr("no absolute path: libdhd.so.3"));
}

TEST_F(DhdFaults, ALibraryThatSomebodyChoseGoesBeforeTheVariable) {
  set("RELIEVO_FORCE_DIMENSION_LIBRARY", folder / "libdhd.so.3");
  const fs::path library = folder / "their own.so";
  fs::copy_file(this->library("whole"), library);
  setMakersLibrary("force_dimension", library);
  EXPECT_EQ(troubleOfScan(), "");
  device()->open();  // The one that drives is told, too.
  setMakersLibrary("force_dimension", {});
  EXPECT_THAT(troubleOfScan(), HasSubstr("E321"));
}

TEST_F(DhdFaults, AFunctionThatIsMissingIsNamed) {
  useLibrary("without_force");
  EXPECT_THAT(troubleOfScan(), HasSubstr("no function dhdSetForce in "));
}

TEST_F(DhdFaults, ACopyWithoutALinkIsFoundInTheUsersFolder) {
  set("RELIEVO_FORCE_DIMENSION_LIBRARY", "");
  const fs::path libraries = folder / ".local/lib";
  fs::create_directories(libraries);
  const std::string home = ::getenv("HOME") == nullptr ? "" : ::getenv("HOME");
  set("HOME", folder);
  if (const std::string none = troubleOfScan(); none.empty()) {
    set("HOME", home);
    GTEST_SKIP() << "this computer has the maker's library";
  }
  EXPECT_THAT(troubleOfScan(), HasSubstr("libdhd.so.3, libdrd.so.3"));
  fs::copy_file(library("whole"), libraries / "libdhd.so.3.17.6");
  const ScannedPlugin plugin = scanPlugin(fs::path(FORCE_DIMENSION));
  set("HOME", home);
  ASSERT_FALSE(plugin.trouble);
  ASSERT_EQ(plugin.devices.size(), 1U);
  EXPECT_EQ(plugin.devices[0].id, "device.0");
  EXPECT_EQ(plugin.devices[0].name, "Force Dimension device 1");
}

TEST_F(DhdFaults, NoDeviceIsNoTrouble) {
  is("devices 0");
  EXPECT_EQ(troubleOfScan(), "");
  EXPECT_TRUE(scanPlugin(fs::path(FORCE_DIMENSION)).devices.empty());
  EXPECT_THAT(refusal(), HasSubstr("it is not plugged in"));
}

}  // namespace
}  // namespace relievo::foreign
