// SPDX-License-Identifier: BSD-3-Clause
// The driver through the real libusb, on a port that umockdev makes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/mock_usb.h"
#include "tests/haptics/device/falcon/faults.h"

namespace relievo::falcon {
namespace {

using emulator::EmulatorOptions;
using emulator::MockUsb;
using emulator::SharedFalcon;

constexpr std::int64_t kMs = 1'000'000;

/// Generous: correctness is tested here, not speed.
bool eventually(const std::function<bool()>& holds) {
  const std::int64_t give_up = monotonicNs() + 240'000 * kMs;
  while (!holds()) {
    if (monotonicNs() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

class FalconUsbTest : public ::testing::Test {
 protected:
  std::shared_ptr<SharedFalcon> plugged(EmulatorOptions options = {.firmware_loaded = true,
                                                                   .homed = true}) {
    auto falcon = std::make_shared<SharedFalcon>(options);
    usb_.plugIn(falcon);
    return falcon;
  }
  std::unique_ptr<FalconDevice> device() {
    return std::make_unique<FalconDevice>(std::make_unique<UsbBus>(),
                                          [] { return relievo::test::madeImage(); });
  }
  static bool becomes(FalconDevice& device, LinkState state) {
    return eventually([&] { return device.status().state == state; });
  }
  MockUsb usb_;
};

TEST_F(FalconUsbTest, IsSeenAndOpened) {
  EXPECT_TRUE(seenFalcons().empty());
  plugged();
  const std::vector<SeenFalcon> seen = seenFalcons();
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].speed_mbit, 12);
  EXPECT_EQ(seen[0].serial, "NV000001");
  EXPECT_EQ(seen[0].port, "1-1");
  UsbBus bus;
  const Opening opening = bus.open();
  EXPECT_EQ(opening.presence, Presence::present);
}

TEST_F(FalconUsbTest, OfTwoTheOneThatIsMeantIsOpened) {
  plugged();
  usb_.plugInAnother("NV000002");
  const std::vector<SeenFalcon> seen = seenFalcons();
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[1].serial, "NV000002");
  EXPECT_EQ(seen[1].port, "1-2");
  EXPECT_EQ(UsbBus().open().presence, Presence::several) << "neither was chosen";
  UsbBus bus({"NV000001", {}});
  const Opening opening = bus.open();
  ASSERT_EQ(opening.presence, Presence::present);
  EXPECT_EQ(opening.which.port, "1-1");
  EXPECT_EQ(UsbBus({"NV000003", {}}).open().presence, Presence::absent);
  usb_.unplug();
  const Opening gone = UsbBus({"NV000001", {}}).open();
  EXPECT_EQ(gone.presence, Presence::absent) << "and not the other one";
  EXPECT_EQ(gone.others, "NV000002 (USB 1-2)");
}

TEST_F(FalconUsbTest, PluggingAndPullingAreHeardWithoutOpening) {
  PlugWatch watch;
  EXPECT_FALSE(watch.changed());
  plugged();
  EXPECT_TRUE(eventually([&] { return watch.changed(); }));
  EXPECT_FALSE(watch.changed()) << "told once";
  usb_.unplug();
  EXPECT_TRUE(eventually([&] { return watch.changed(); }));
}

TEST_F(FalconUsbTest, UploadsWithoutABadChunkAndHomes) {
  const auto falcon = plugged({});
  const auto device = this->device();
  device->open();
  ASSERT_TRUE(becomes(*device, LinkState::homing)) << englishText(describe(device->status()));
  EXPECT_EQ(device->status().attempt, 1) << "no chunk was bad";
  falcon->with([](auto& f) {
    EXPECT_EQ(f.lastImage(), relievo::test::madeImage());
    f.body.hold({0, 0, 172});
  });
  // The arms find their places only while they are asked to.
  const auto asked = [&] { return falcon->with([](auto& f) { return f.commandCount(); }); };
  ASSERT_TRUE(eventually([&, before = asked()] { return asked() > before + 20; }));
  falcon->with([](auto& f) { f.body.hold({0, 0, 90}); });
  ASSERT_TRUE(becomes(*device, LinkState::pull_out));
  falcon->with([](auto& f) { f.body.hold({0, 0, 172}); });
  ASSERT_TRUE(becomes(*device, LinkState::ready));
}

TEST_F(FalconUsbTest, TenThousandFramesArriveAsTheyWereSent) {
  const auto falcon = plugged({.firmware_loaded = true, .homed = true, .latency_timer = false});
  UsbBus bus;
  const Opening opening = bus.open();
  ASSERT_EQ(opening.presence, Presence::present);
  Port& port = *opening.port;
  for (const BridgeRequest& request : {latencyTimer(1), kRunBaud, kPurge1, kPurge2}) {
    ASSERT_EQ(port.request(request), PortResult::ok);
  }
  falcon->with([](auto& f) { f.forgetCommands(); });
  ReportReader reader;
  constexpr int kFrames = 10'000;
  std::uint32_t random = 1;
  std::vector<std::array<std::int16_t, 3>> sent;
  for (int i = 0; i < kFrames; ++i) {
    Command command;
    for (std::int16_t& motor : command.motors) {
      random = random * 1664525U + 1013904223U;
      motor = static_cast<std::int16_t>(static_cast<int>(random >> 19U) - 4096);
      motor = std::max<std::int16_t>(motor, -4095);
    }
    sent.push_back(command.motors);
    ASSERT_EQ(port.write(encode(command)), PortResult::ok);
    bool answered = false;
    while (!answered) {
      std::array<std::uint8_t, 64> bytes{};
      const Port::Incoming in = port.read(bytes, monotonicNs() + 60'000 * kMs);
      ASSERT_EQ(in.result, PortResult::ok) << "frame " << i;
      for (std::size_t k = 0; k < in.bytes; ++k) answered |= reader.take(bytes[k]).has_value();
    }
  }
  EXPECT_EQ(reader.malformed(), 0U);
  EXPECT_EQ(port.lineErrors().framing + port.lineErrors().overruns, 0U);
  falcon->with([&](auto& f) {
    ASSERT_EQ(f.commands().size(), sent.size());
    EXPECT_EQ(f.badCommands(), 0);
    for (std::size_t i = 0; i < sent.size(); ++i) {
      for (std::size_t arm = 0; arm < 3; ++arm) {
        ASSERT_EQ(f.commands()[i].motors[arm], sent[i][arm]) << i;
      }
    }
  });
}

TEST_F(FalconUsbTest, TakesTheInterfaceFromTheKernelsDriverAndGivesItBack) {
  usb_.set({.kernel_driver = true});
  plugged();
  {
    UsbBus bus;
    EXPECT_EQ(bus.open().presence, Presence::present);
  }
  EXPECT_EQ(usb_.counts().detached, 1U);
  EXPECT_EQ(usb_.counts().attached, 1U);
}

TEST_F(FalconUsbTest, OneThatAnotherProgramUsesIsBusy) {
  usb_.set({.claimed_by_other = true});
  plugged();
  const auto device = this->device();
  try {
    device->open();
    FAIL() << "opened";
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.code, "E304");
  }
}

TEST_F(FalconUsbTest, UnpluggedWhileTouchingThenReplugged) {
  const auto falcon = plugged();
  const auto device = this->device();
  device->open();
  ASSERT_TRUE(becomes(*device, LinkState::ready)) << englishText(describe(device->status()));
  DeviceReading reading;
  const auto exchange = [&] {
    reading = device->exchange({0, 0, 2}, monotonicNs());
    return reading.fault;
  };
  ASSERT_TRUE(eventually([&] {
    exchange();
    return falcon->with([](auto& f) { return std::abs(f.body.force()[2]) > 0.5; });
  })) << englishText(describe(device->status()));
  usb_.unplug();
  ASSERT_TRUE(eventually([&] { return exchange() == DeviceFault::disconnected; }));
  ASSERT_TRUE(becomes(*device, LinkState::absent)) << englishText(describe(device->status()));
  const auto again = plugged({});
  ASSERT_TRUE(becomes(*device, LinkState::homing)) << englishText(describe(device->status()));
  const auto asked = [&] { return again->with([](auto& f) { return f.commandCount() > 20; }); };
  ASSERT_TRUE(eventually([&] {
    exchange();
    return asked();
  }));
  again->with([](auto& f) {
    EXPECT_TRUE(std::all_of(f.commands().begin(), f.commands().end(),
                            [](const auto& c) { return c.neutral(); }));
  });
}

class FalconUsbTroubleTest : public FalconUsbTest {
 protected:
  void exchange() {
    const DeviceFault fault = device_->exchange({0, 0, 2}, monotonicNs()).fault;
    if (fault != DeviceFault::none) told_ = fault;
  }
  template <class Condition>
  bool whileTouching(Condition holds) {
    return eventually([&] {
      exchange();
      return holds();
    });
  }
  bool touches() {
    return whileTouching([this] {
      return falcon_->with([](auto& f) { return std::abs(f.body.force()[2]) > 0.5; });
    });
  }
  bool homes() {
    for (const double z : {172.0, 90.0, 172.0}) {
      falcon_->with([z](auto& f) { f.body.hold({0, 0, z}); });
      const std::uint64_t asked = falcon_->with([](auto& f) { return f.commandCount(); });
      const auto passed = [&] {
        return falcon_->with([&](auto& f) { return f.commandCount() > asked + 20; });
      };
      if (!whileTouching(passed)) return false;
    }
    return whileTouching([this] { return device_->status().state == LinkState::ready; });
  }
  std::shared_ptr<SharedFalcon> falcon_ = plugged();
  std::unique_ptr<FalconDevice> device_ = device();
  DeviceFault told_ = DeviceFault::none;
};

class FalconUsbFaultTest : public FalconUsbTroubleTest,
                           public ::testing::WithParamInterface<test::Fault> {
 protected:
  void strike(const test::Fault& fault) {
    falcon_->with([&](auto& f) {
      f.forgetCommands();
      fault.strike(f);
    });
  }
  void mendAndTouch(const test::Fault& fault) {
    falcon_->with([&](auto& f) { fault.mend(f); });
    ASSERT_TRUE(touches());
  }
};

TEST_P(FalconUsbFaultTest, IsNoticedAndMendsWithoutARestart) {
  const test::Fault& fault = GetParam();
  device_->open();
  ASSERT_TRUE(becomes(*device_, LinkState::ready)) << englishText(describe(device_->status()));
  ASSERT_TRUE(touches());
  told_ = DeviceFault::none;
  const std::uint64_t before = fault.counted(device_->status());
  if (fault.told == DeviceFault::none) {
    // Of an answer that the driver fetches only when it is there nothing is late.
    const int tries = std::string(fault.name) == "LateAnswers" ? 20 : 1;
    bool neutral = false;
    for (int i = 0; i < tries && !neutral; ++i) {
      if (i > 0) mendAndTouch(fault);
      strike(fault);
      ASSERT_TRUE(whileTouching(
          [this] { return falcon_->with([](auto& f) { return f.commands().size() > 1; }); }));
      neutral = falcon_->with([](auto& f) { return test::nextCommandIsNeutral(f); });
    }
    EXPECT_TRUE(neutral);
  } else {
    strike(fault);
    ASSERT_TRUE(whileTouching([&] { return told_ == fault.told; }));
  }
  EXPECT_TRUE(whileTouching([&] { return fault.counted(device_->status()) > before; }));
  falcon_->with([&](auto& f) { fault.mend(f); });
  if (fault.homing_lost) {
    ASSERT_TRUE(becomes(*device_, LinkState::homing));
    ASSERT_TRUE(whileTouching(
        [this] { return falcon_->with([](auto& f) { return f.commands().size() > 20; }); }));
    falcon_->with([](auto& f) { EXPECT_TRUE(test::everyNextCommandIsNeutral(f)); });
    ASSERT_TRUE(homes());
  }
  EXPECT_TRUE(touches());
  EXPECT_EQ(falcon_->with([](auto& f) { return f.uploads(); }), 0);
}

/// The real bus and its port on a clock of the test's own: each answer comes a millisecond after
/// the one before, however late the machine was with it. Waits for each answer as long as it takes.
class SteppedBus : public Bus {
 public:
  /// [driver's thread] After each answer, before the driver sees it.
  std::function<void(std::int64_t now_ns)> every_ms;

  Opening open() override {
    Opening opening = bus_.open();
    if (opening.port) opening.port = std::make_unique<SteppedPort>(*this, std::move(opening.port));
    return opening;
  }
  void waitForChange(std::int64_t until_ns) override {
    bus_.waitForChange(monotonicNs() + until_ns - now_ns_);
    now_ns_ = std::max(now_ns_, until_ns);
  }
  std::int64_t now() override { return now_ns_; }
  std::int64_t slept() override { return bus_.slept(); }

 private:
  class SteppedPort : public Port {
   public:
    SteppedPort(SteppedBus& bus, std::unique_ptr<Port> port) : bus_(bus), port_(std::move(port)) {}
    PortResult request(const BridgeRequest& request) override { return port_->request(request); }
    PortResult write(std::span<const std::uint8_t> bytes) override { return port_->write(bytes); }
    Incoming read(std::span<std::uint8_t> into, std::int64_t until_ns) override {
      const Incoming in = port_->read(into, monotonicNs() + 60'000 * kMs);
      bus_.now_ns_ = in.bytes > 0 ? bus_.now_ns_ + kMs : std::max(bus_.now_ns_, until_ns);
      if (in.bytes > 0) bus_.every_ms(bus_.now_ns_);
      return in;
    }
    void discardInput() override { port_->discardInput(); }
    bool clearToSend() const override { return port_->clearToSend(); }
    LineErrors lineErrors() const override { return port_->lineErrors(); }

   private:
    SteppedBus& bus_;
    std::unique_ptr<Port> port_;
  };

  UsbBus bus_;
  std::int64_t now_ns_ = 1'000'000 * kMs;
};

/// As trouble_test has it, through libusb. Where a hand can have gone grows with the time that an
/// answer took: on the machine's clock a busy one would have its say in what is believed.
TEST_F(FalconUsbTest, AlteredNibblesAreNotBelieved) {
  const auto falcon = plugged({.firmware_loaded = true, .homed = true, .latency_timer = false});
  constexpr int kTouching = 300, kEvery = 20, kAltered = 200;
  int touching = 0, ticks = 0;
  DeviceMm place;
  double farthest_mm = 0, most_n = 0;
  DeviceFault told = DeviceFault::none;
  std::atomic<bool> done{false};
  auto bus = std::make_unique<SteppedBus>();
  SteppedBus& stepped = *bus;
  FalconDevice device(std::move(bus), [] { return relievo::test::madeImage(); });
  // The loop's tick, in step with the answers.
  stepped.every_ms = [&](std::int64_t now_ns) {
    const DeviceReading reading = device.exchange({0, 0, 2}, now_ns);
    const double force_n = falcon->with([](auto& f) { return std::abs(f.body.force()[2]); });
    if (done) return;
    if (touching < kTouching) {
      touching = force_n > 0.5 ? touching + 1 : 0;
      place = reading.position;
      return;
    }
    if (reading.fault != DeviceFault::none) told = reading.fault;
    farthest_mm = std::max(farthest_mm, norm(reading.position - place));
    most_n = std::max(most_n, force_n);
    if (ticks++ % kEvery == 0) falcon->with([](auto& f) { f.troubles.altered_nibbles = 1; });
    done = ticks == kEvery * kAltered;
  };
  device.open();
  ASSERT_TRUE(eventually([&] { return done.load(); })) << englishText(describe(device.status()));
  // The lowest three bits of a count are less than a hand trembles.
  EXPECT_LT(farthest_mm, 0.35);
  EXPECT_LT(most_n, 2.1);
  EXPECT_EQ(told, DeviceFault::none);
  EXPECT_TRUE(eventually([&] { return device.status().counts.held_poses > 100; }))
      << device.status().counts.held_poses;
}

/// Without the plug, which is the port's: UnpluggedWhileTouchingThenReplugged.
std::vector<test::Fault> faultsOfTheLine() {
  std::vector<test::Fault> faults(test::kFaults.begin(), test::kFaults.end());
  std::erase_if(faults, [](const auto& f) { return f.told == DeviceFault::disconnected; });
  return faults;
}
INSTANTIATE_TEST_SUITE_P(Faults, FalconUsbFaultTest, ::testing::ValuesIn(faultsOfTheLine()),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST_F(FalconUsbTest, ClosedWhileReadsFailTheMotorsAreAtZero) {
  for (const bool destroyed : {false, true}) {
    const auto falcon = plugged();
    auto device = this->device();
    device->open();
    ASSERT_TRUE(becomes(*device, LinkState::ready)) << englishText(describe(device->status()));
    ASSERT_TRUE(eventually([&] {
      device->exchange({0, 0, 2}, monotonicNs());
      return falcon->with([](auto& f) { return std::abs(f.body.force()[2]) > 0.5; });
    }));
    falcon->with([](auto& f) { f.troubles.failed_reads = test::kForEver; });
    if (destroyed) device.reset();
    if (device) device->close();
    falcon->with([](auto& f) {
      EXPECT_TRUE(f.commands().back().neutral());
      EXPECT_LT(std::abs(f.body.force()[2]), 1e-9);
    });
    usb_.unplug();
  }
}

TEST_F(FalconUsbTest, ReadsThatGoOnFailingAreNeverTriedInALoop) {
  const auto falcon = plugged();
  const auto device = this->device();
  device->open();
  ASSERT_TRUE(becomes(*device, LinkState::ready)) << englishText(describe(device->status()));
  falcon->with([](auto& f) { f.troubles.failed_reads = test::kForEver; });
  ASSERT_TRUE(eventually([&] { return device->status().failed_openings >= 5; }));
  const int failed_before = device->status().failed_openings;
  const std::uint64_t before = usb_.counts().submits;
  ASSERT_TRUE(eventually([&] { return device->status().failed_openings >= failed_before + 2; }));
  const std::uint64_t submits = usb_.counts().submits - before;
  // With one that goes on.
  const auto openings =
      static_cast<std::uint64_t>(device->status().failed_openings - failed_before) + 1;
  // Of each: two reads, nine requests, four frames, and reads that go with the frames.
  EXPECT_LT(submits, 30 * openings) << "of " << openings;
  EXPECT_EQ(device->status().unplugged, 0U);
  falcon->with([](auto& f) { f.troubles.failed_reads = 0; });
  EXPECT_TRUE(becomes(*device, LinkState::ready)) << "without a restart";
}

TEST_F(FalconUsbTest, AnOpenFalconThatNobodyAsksIsLeftInPeace) {
  const auto falcon = plugged();
  const auto device = this->device();
  device->open();
  ASSERT_TRUE(becomes(*device, LinkState::ready));
  ASSERT_TRUE(
      eventually([&] { return falcon->with([](auto& f) { return f.latencyMs(); }) == 255; }));
  const std::int64_t since_ns = monotonicNs();
  const std::uint64_t before = usb_.counts().submits;
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const std::uint64_t submits = usb_.counts().submits - before;
  const double seconds = 1e-9 * static_cast<double>(monotonicNs() - since_ns);  // One at least.
  EXPECT_LT(static_cast<double>(submits), 60 * seconds) << "frames and packets a second";
}

/// Signals by number.
std::vector<std::string> endings() {
  std::vector<std::string> all{"normal", "abort", "throw", "exit", "overflow", "overflow of a loop",
                               "spin"};
  for (int signal = 1; signal < _NSIG; ++signal) {
    const bool handled = signal != SIGKILL && signal != SIGSTOP;
    const bool harmless =
        signal == SIGCHLD || signal == SIGCONT || signal == SIGURG || signal == SIGWINCH;
    const bool between = signal > SIGSYS && signal != SIGRTMIN && signal != SIGRTMAX;
    if (handled && !harmless && !between) all.push_back(std::to_string(signal));
  }
  return all;
}

class FalconEndingTest : public FalconUsbTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(FalconEndingTest, LeavesTheMotorsAtZero) {
  const std::string ending = GetParam();
  const auto falcon = plugged();
  falcon->with([](auto& f) { f.body.hold({0, 0, 125}); });
  const std::string client = RELIEVO_BINARY_DIR "/tests/falcon_client";
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGPIPE, SIG_DFL);  // Whoever started us may ignore it.
    execl(client.c_str(), client.c_str(), "2", "100", ending.c_str(), nullptr);
    _exit(99);
  }
  int status = 0;
  constexpr std::array<int, 3> kHalts{SIGTSTP, SIGTTIN, SIGTTOU};
  const auto is = [&ending](int signal) { return ending == std::to_string(signal); };
  const bool halts = std::any_of(kHalts.begin(), kHalts.end(), is);
  const pid_t ended = waitpid(child, &status, halts ? WUNTRACED : 0);
  ASSERT_EQ(ended, child);
  constexpr int kNoPriority = 77;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNoPriority) {
    GTEST_SKIP() << "real-time priority is refused here";
  }
  if (halts) {
    EXPECT_TRUE(WIFSTOPPED(status));
  } else if (ending == "normal" || ending == "exit") {
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  } else {
    EXPECT_TRUE(WIFSIGNALED(status)) << status;
  }
  if (WIFSIGNALED(status)) {
    EXPECT_NE(WTERMSIG(status), SIGKILL);
    const bool by_number = std::isdigit(ending.front()) != 0;
    EXPECT_TRUE(!by_number || is(WTERMSIG(status))) << "what it would have done";
  }
  falcon->with([](auto& f) {
    ASSERT_FALSE(f.commands().empty());
    const bool pushed = std::any_of(f.commands().begin(), f.commands().end(),
                                    [](const auto& c) { return !c.neutral(); });
    EXPECT_TRUE(pushed) << "it did touch";
    EXPECT_TRUE(f.commands().back().neutral());
  });
  if (WIFSTOPPED(status)) {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
}
INSTANTIATE_TEST_SUITE_P(Endings, FalconEndingTest, ::testing::ValuesIn(endings()));

}  // namespace
}  // namespace relievo::falcon
