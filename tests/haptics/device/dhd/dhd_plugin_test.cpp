// SPDX-License-Identifier: BSD-3-Clause
// Devices of Force Dimension by the plug-in and a stand-in for their maker's library: axes, limits,
// order of calls, conformance, and what a killed program leaves.
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "haptics/device/foreign/ask_host.h"
#include "haptics/device_catalog.h"
#include "tests/haptics/device/dhd/dhd_fixture.h"

namespace relievo::foreign {
namespace {

using test::DhdCall;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using What = DhdCall::What;

class DhdPlugin : public test::DhdTest {};

struct Axis {
  const char* library;  // The library's axis, which points as relievo's.
  DeviceMm relievo;
};
// Towards the person, right, up.
constexpr std::array<Axis, 3> kAxes{{{"x", {0, 0, 1}}, {"y", {1, 0, 0}}, {"z", {0, 1, 0}}}};

TEST_F(DhdPlugin, SixPlacesEndOnTheRightAxisWithTheRightSign) {
  for (const Axis& axis : kAxes) {
    for (const double mm : {10.0, -10.0}) {
      is(std::string(axis.library) + " " + std::to_string(static_cast<int>(1000 * mm)));
      const auto device = this->device();
      device->open();
      const DeviceReading reading = readingWith(*device, DeviceFault::none);
      EXPECT_NEAR(norm(reading.position - mm * axis.relievo), 0, 1e-9)
          << axis.library << " " << mm << " came as " << reading.position.x << ", "
          << reading.position.y << ", " << reading.position.z;
    }
  }
}

TEST_F(DhdPlugin, SixForcesEndOnTheRightAxisWithTheRightSign) {
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    for (const double newton : {1.0, -1.0}) {
      std::filesystem::remove(folder / "log");
      const auto device = this->device();
      device->open();
      const DeviceMm& to = kAxes[axis].relievo;
      pushUntil(*device, {newton * to.x, newton * to.y, newton * to.z}, 0.999);
      for (const DhdCall& call : logOf(What::force)) {
        if (size(call) < 0.999) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_NEAR(call.given[i], i == axis ? newton : 0, 1e-3) << kAxes[axis].library;
        }
      }
    }
  }
}

TEST_F(DhdPlugin, IsOpenedAndClosedInTheOrderThatKeepsTheArm) {
  {
    const auto device = this->device();
    device->open();
    pushUntil(*device, {0, 1, 0}, 0.999);
    device->close();
  }
  const auto all = log();
  std::vector<std::pair<What, double>> first;
  for (std::size_t i = 0; i < 6 && i < all.size(); ++i) {
    first.emplace_back(all[i].what, all[i].given[0]);
  }
  EXPECT_THAT(first,
              ElementsAre(Pair(What::open, 0), Pair(What::watchdog, 160), Pair(What::most_force, 6),
                          Pair(What::gravity, 1), Pair(What::enable, 1), Pair(What::force, 0)));
  ASSERT_GE(all.size(), 9U);
  const auto* const end = all.data() + all.size();
  EXPECT_EQ(end[-1].what, What::close);
  EXPECT_EQ(end[-2].what, What::enable);
  EXPECT_EQ(end[-2].given[0], 0);
  EXPECT_EQ(end[-3].what, What::force);
  EXPECT_EQ(size(end[-3]), 0) << "no force is left when it closes";
  EXPECT_EQ(end[-3].thread, end[-1].thread) << "by closing itself, whatever the last step did";
}

struct Known {
  int type;
  double stiffness_n_per_mm, right_mm, up_mm, towards_mm;
};

TEST_F(DhdPlugin, EachTypeHasItsLimits) {
  const std::vector<Known> all{
      {33, 2.5, 50, 40, 35},  {34, 2.5, 50, 40, 35},  {36, 2.5, 50, 40, 35},
      {35, 2.5, 50, 40, 35},  {37, 2.5, 50, 40, 35},  {63, 2.5, 100, 80, 70},
      {206, 2.0, 50, 40, 35}, {104, 2.0, 50, 40, 35}, {105, 2.0, 50, 40, 35},
      {203, 4.0, 75, 60, 55}, {131, 4.0, 75, 60, 55}, {132, 4.0, 75, 60, 55},
      {108, 4.0, 75, 60, 55}, {109, 4.0, 75, 60, 55}};
  for (const Known& known : all) {
    is("type " + std::to_string(known.type));
    const auto device = this->device();
    device->open();
    const DeviceInfo& info = device->info();
    EXPECT_EQ(info.max_force_n, 6) << known.type;
    EXPECT_EQ(info.max_stiffness_n_per_mm, known.stiffness_n_per_mm) << known.type;
    EXPECT_EQ(info.workspace.half_extent, (DeviceMm{known.right_mm, known.up_mm, known.towards_mm}))
        << known.type;
  }
}

TEST_F(DhdPlugin, TheFalconAndBareControllersAreRefused) {
  is("type 60");
  EXPECT_THAT(refusal(), HasSubstr("it is a Novint Falcon; choose it as falcon"));
  for (const char* const type : {"81", "82", "91"}) {
    is(std::string("type ") + type);
    EXPECT_THAT(refusal(), HasSubstr("it is a controller"));
  }
  is("type 64");
  EXPECT_THAT(refusal(), HasSubstr("type 64"));
  const auto all = log();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.back().what, What::close) << "what was opened is closed";
}

TEST_F(DhdPlugin, WithoutAWatchdogOfItsOwnItPushesLess) {
  const auto with = device();
  with->open();
  EXPECT_EQ(with->info().max_force_n, 6);
  useLibrary("without_watchdog");
  const auto without = device();
  without->open();
  EXPECT_EQ(without->info().max_force_n, kMostForceWithoutWatchdogN);
}

TEST_F(DhdPlugin, TheButtonThatEveryGripHasIsCentre) {
  const std::vector<std::pair<int, std::uint32_t>> masks{
      {0b0001, 0b0100}, {0b0010, 0b0001}, {0b0100, 0b1000}, {0b1000, 0b0010}, {0b10000, 0}};
  for (const auto& [mask, buttons] : masks) {
    is("buttons " + std::to_string(mask));
    const auto device = this->device();
    device->open();
    constexpr std::size_t kPressed = 60;  // Forces, after which it was asked again.
    DeviceReading reading;
    test::exchangeUntil(*device, {}, [&](const DeviceReading& read) {
      reading = read;
      return read.fault == DeviceFault::none && logOf(What::force).size() > kPressed;
    });
    EXPECT_EQ(reading.buttons & 0b1111U, buttons) << mask;
    std::filesystem::remove(folder / "log");
  }
}

TEST_F(DhdPlugin, AFarPlaceOfALongArmIsNoNonsenseAndThatOfNoneIs) {
  is("type 104 z 95000");  // Up.
  const auto device = this->device();
  device->open();
  EXPECT_NEAR(readingWith(*device, DeviceFault::none).position.y, 78, 1e-9);
  is("type 104 z 2000000");
  const auto other = this->device();
  other->open();
  readingWith(*other, DeviceFault::protocol);
}

TEST_F(DhdPlugin, IsOpenedByItsSerialNumber) {
  const auto device = this->device("serial.1234");
  device->open();
  readingWith(*device, DeviceFault::none);
  EXPECT_THAT(refusal("serial.77"), HasSubstr("the stand-in says why"));
  EXPECT_THAT(refusal("serial.x"), HasSubstr("no device of this name"));
}

TEST_F(DhdPlugin, ConformsAndPushesNoMoreThanItSays) {
  const auto results = checkPlugin(FORCE_DIMENSION, {.device = "device.0",
                                                     .newton = 1,
                                                     .seconds = 0.2,
                                                     .is_held = [] { return true; },
                                                     .patience = test::longPatience()});
  for (const CheckResult& result : results) {
    EXPECT_NE(result.verdict, Verdict::failed) << result.check.code << ": " << result.why;
  }
  EXPECT_EQ(results.back().verdict, Verdict::passed) << results.back().why;
  double most_n = 0;
  for (const DhdCall& call : logOf(What::force)) most_n = std::max(most_n, size(call));
  EXPECT_GT(most_n, 0.5);
  EXPECT_LE(most_n, 1 + 1e-9);
}

TEST(DeviceCatalog, SaysWhetherADeviceWasTriedOnHardware) {
  EXPECT_EQ(triedOnHardware("plugin:force_dimension/device.0"), "never");
  EXPECT_EQ(triedOnHardware("plugin:force_dimension.2/device.0"), std::nullopt)
      << "who made that plug-in may know";
  EXPECT_EQ(triedOnHardware("plugin"), std::nullopt);
  EXPECT_EQ(triedOnHardware("falcon:A1"), "never");
  EXPECT_EQ(triedOnHardware("mouse"), "") << "nobody can feel it";
}

/// By SIGKILL, so that it can send nothing itself.
TEST_F(DhdPlugin, AProgramThatIsKilledLeavesZeroAndNoHost) {
  ASSERT_EQ(::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0), 0);
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const std::string client = std::string(RELIEVO_BINARY_DIR) + "/tests/foreign_client";
  const pid_t program = ::fork();
  if (program == 0) {
    ::dup2(pipe[1], 1);
    ::execl(client.c_str(), client.c_str(), FORCE_DIMENSION, "device.0", nullptr);
    ::_exit(127);
  }
  ::close(pipe[1]);
  FILE* const said = ::fdopen(pipe[0], "r");
  int host = 0;
  ASSERT_EQ(std::fscanf(said, "%d", &host), 1);
  while (true) {
    const auto forces = logOf(What::force);
    if (!forces.empty() && size(forces.back()) > 2.999) break;
    sleepUntil(monotonicNs() + 1'000'000);
  }
  const std::int64_t killed_ns = monotonicNs();
  ASSERT_EQ(::kill(program, SIGKILL), 0);
  ::waitpid(program, nullptr, 0);
  ASSERT_EQ(::waitpid(host, nullptr, 0), host);
  std::fclose(said);
  const auto all = log();
  ASSERT_GE(all.size(), 3U);
  EXPECT_EQ(all.back().what, What::close);
  const auto forces = logOf(What::force);
  EXPECT_EQ(size(forces.back()), 0);
  std::int64_t last_push_ns = 0;
  for (const DhdCall& call : forces) {
    if (size(call) > 0) last_push_ns = call.time_ns;
  }
  // A figure for docs/adr/0180, no promise of a busy computer.
  std::printf("last force %.2f ms after the kill\n",
              1e-6 * static_cast<double>(last_push_ns - killed_ns));
}

}  // namespace
}  // namespace relievo::foreign
