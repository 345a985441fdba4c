// SPDX-License-Identifier: BSD-3-Clause
// A touch sounds while it goes on as its recording does afterwards, to the last sample, and as long
// after each tick as after every other; clocks that differ, loops that stand still and servers that
// are not there do no harm.
#include "haptics/sound/live_sound.h"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

#include "haptics/record/events.h"
#include "haptics/record/sample_log.h"
#include "haptics/sound/sound_out.h"
#include "tests/haptics/sound/sound_test.h"

namespace relievo::sound {
namespace {

constexpr std::int64_t kTickNs = 1'000'000, kBootNs = 77'000'000'123;
const HeardWindow kWindow{.id = 1, .region = {0, 0, 80, Level{0}}, .gain = 2, .heights = {0, 20}};

/// A hand that comes down, slides to the edge over filled ground, leaves and comes again, faster
/// each time; the device is lost for a moment.
HapticSample sampleAt(int tick) {
  HapticSample s;
  s.tick = static_cast<std::uint64_t>(tick);
  s.time_ns = kBootNs + tick * kTickNs;
  s.window_id = 1;
  const int turn = tick % 400;
  s.contact = turn >= 100;
  const double speed_mm_per_s = 20 + 0.1 * tick;
  s.hip = {0.3 * turn, 40, s.contact ? -1 : 0.001 * speed_mm_per_s * (100 - turn)};
  s.proxy = {0.3 * turn, 40, s.contact ? 0 : s.hip.z};
  s.proxy_view = {0.3 * turn, 40, 10 + 8 * std::sin(0.01 * tick)};
  s.hip_view = s.proxy_view;
  s.force = {0, 0, s.contact ? 1.5 : 0};
  s.detail = tick < 1800 ? 1 : 2;
  s.origin = turn > 200 && turn < 240 ? CellStatus::interpolated : CellStatus::measured;
  if (tick >= 1500 && tick < 1550) s.fault = DeviceFault::disconnected;
  return s;
}

/// Runs a loop and a server's clock beside each other: the server asks for frames in blocks, and
/// the loop has given the samples up to then.
class Stage {
 public:
  using Samples = std::function<HapticSample(int tick)>;
  explicit Stage(double frames_per_s = kSampleRateHz, Samples samples = sampleAt)
      : frames_per_s_(frames_per_s), samples_(std::move(samples)) {
    live_.setWindow(kWindow);
    live_.setVolume(100);
  }
  /// @param lives  whether the loop ticks at this number
  void play(
      double seconds, std::size_t block,
      const std::function<bool(int)>& lives = [](int) { return true; }) {
    while (static_cast<double>(frames_.size()) < seconds * frames_per_s_) {
      const double now_s = static_cast<double>(frames_.size()) / frames_per_s_;
      for (; 0.001 * tick_ <= now_s; ++tick_) {
        if (lives(tick_)) ring_.push(samples_(tick_));
      }
      frames_.resize(frames_.size() + block);
      live_.render(std::span<Frame>(frames_).last(block));
    }
  }
  HeardRing ring_;
  LiveSound live_{ring_};
  std::vector<Frame> frames_;

 private:
  double frames_per_s_;
  Samples samples_;
  int tick_ = 0;
};

TouchRecording recordingOfTicks(int from, int to, const Stage::Samples& at = sampleAt) {
  TouchRecording recording;
  recording.name = "log.csv";
  recording.windows.push_back({.id = 1, .region = kWindow.region, .gain = kWindow.gain});
  for (int i = from; i <= to; ++i) {
    const double t_s = 1e-9 * static_cast<double>((i - from) * kTickNs);
    recording.rows.push_back(touchRow(at(i), t_s));
    const std::string event = i == from ? eventAtStart(at(i)) : eventBetween(at(i - 1), at(i));
    if (!event.empty()) recording.events.push_back({t_s, event, false});
  }
  return recording;
}

SoundRequest asLive() {
  SoundRequest request;
  request.heights = kWindow.heights;
  return request;
}

std::vector<std::size_t> clicksIn(const std::vector<Frame>& frames) {
  std::vector<std::size_t> clicks;
  std::size_t silent = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (std::abs(frames[i].left) < 2e-3 && std::abs(frames[i].right) < 2e-3) {
      ++silent;
      continue;
    }
    if (silent > 1500) clicks.push_back(i);
    silent = 0;
  }
  return clicks;
}

TEST(LiveSound, ATouchSoundsWhileItGoesOnAsItsRecordingDoesAfterwards) {
  Stage stage;
  stage.play(3, 256);
  const TouchRecording recording = recordingOfTicks(0, 2990);
  RecordedSound::Summary heard;
  const std::vector<Frame> after = test::framesOf(RecordedSound(recording, asLive()), &heard);
  for (const Earcon earcon :
       {Earcon::contact, Earcon::edge, Earcon::not_measured, Earcon::finer, Earcon::problem}) {
    EXPECT_GT(heard.struck[static_cast<std::size_t>(earcon)], 0U) << static_cast<int>(earcon);
  }
  const auto silent = static_cast<std::size_t>(stage.live_.silentFrames());
  ASSERT_EQ(silent, 256U);
  std::size_t different = 0;
  double loudest = 0;
  const std::size_t count = 2990 * 48;
  ASSERT_GE(stage.frames_.size(), silent + count);
  for (std::size_t i = 0; i < count; ++i) {
    const Frame& live = stage.frames_[silent + i];
    different += live.left != after[i].left || live.right != after[i].right ? 1 : 0;
    loudest = std::max(loudest, std::abs(double{live.left}));
  }
  EXPECT_EQ(different, 0U);
  EXPECT_GT(loudest, 0.1) << "it was not silent";
  for (std::size_t i = 0; i < silent; ++i) EXPECT_EQ(stage.frames_[i].left, 0);
}

/// A hand that is led over hills from the first tick to the 1600th, waits at three corners, and
/// then touches what it was led along.
HapticSample ledAt(int tick) {
  HapticSample s = sampleAt(tick);
  s.fault = DeviceFault::none;
  s.origin = CellStatus::interpolated;
  s.contact = tick % 7 < 3 || tick >= 1600;  // It bounces along.
  s.guide_path = 9;
  if (tick >= 1600) {
    s.guide_end = GuideEnd::you_lead;
  } else {
    s.guide = tick % 500 < 100 ? GuidePhase::pausing : GuidePhase::leading;
  }
  return s;
}

TEST(LiveSound, AHandThatIsLedHearsHeightsAndCornersAndNothingOfTheSurface) {
  Stage stage(kSampleRateHz, ledAt);
  stage.play(2, 256);
  const TouchRecording recording = recordingOfTicks(0, 1990, ledAt);
  RecordedSound::Summary heard;
  const std::vector<Frame> after = test::framesOf(RecordedSound(recording, asLive()), &heard);
  const auto struck = [&](Earcon earcon) { return heard.struck[static_cast<std::size_t>(earcon)]; };
  EXPECT_EQ(struck(Earcon::corner), 3U) << "of the first no beginning was seen";
  EXPECT_EQ(struck(Earcon::contact), 1U) << "when the guide lets go";
  EXPECT_EQ(struck(Earcon::not_measured), 1U);
  const auto silent = static_cast<std::size_t>(stage.live_.silentFrames());
  std::size_t different = 0;
  for (std::size_t i = 0; i < 1990 * 48; ++i) {
    const Frame& live = stage.frames_[silent + i];
    different += live.left != after[i].left || live.right != after[i].right ? 1 : 0;
  }
  EXPECT_EQ(different, 0U) << "live as in the recording, to the last bit";
}

TEST(LiveSound, WhatLastsIsSilentWhileSomebodySpeaksAndComesBack) {
  const auto held = [](int tick) {
    HapticSample s = sampleAt(150);
    s.tick = static_cast<std::uint64_t>(tick);
    s.time_ns = kBootNs + tick * kTickNs;
    return s;
  };
  Stage stage(kSampleRateHz, held);
  stage.play(1, 256);
  const auto loudest = [&](double from_s, double to_s) {
    float most = 0;
    for (auto i = static_cast<std::size_t>(from_s * kSampleRateHz);
         i < static_cast<std::size_t>(to_s * kSampleRateHz); ++i) {
      most = std::max({most, std::abs(stage.frames_[i].left), std::abs(stage.frames_[i].right)});
    }
    return most;
  };
  EXPECT_GT(loudest(0.9, 1), 0.02F) << "the tone";
  stage.live_.setSpeech(true);
  stage.play(2, 256);
  EXPECT_EQ(loudest(1.05, 2), 0.0F) << "30 ms, and a block, later";
  stage.live_.setSpeech(false);
  stage.play(3, 256);
  EXPECT_GT(loudest(2.9, 3), 0.02F);
}

TEST(LiveSound, IsAsLongAfterEveryTickWhateverTheServerAsksFor) {
  for (const std::size_t block : {128, 256, 441, 700}) {
    Stage stage;
    stage.play(3, block);
    const std::vector<std::size_t> clicks = clicksIn(stage.frames_);
    ASSERT_EQ(clicks.size(), 8U) << block;
    for (std::size_t i = 0; i < clicks.size(); ++i) {
      const std::size_t tick = 100 + 400 * i;
      EXPECT_NEAR(static_cast<double>(clicks[i]), static_cast<double>(tick * 48 + block), 1)
          << block << ", click " << i;
    }
  }
}

TEST(LiveSound, ClocksThatDifferNeitherLoseAClickNorDelayIt) {
  // A hundred times worse than clocks are: 5 parts in a thousand, a minute long.
  for (const double hz : {0.995 * kSampleRateHz, 1.005 * kSampleRateHz}) {
    Stage stage(hz);
    stage.play(60, 256);
    const std::vector<std::size_t> clicks = clicksIn(stage.frames_);
    ASSERT_EQ(clicks.size(), 150U) << hz;
    for (std::size_t i = 0; i < clicks.size(); ++i) {
      const double tick_s = 0.1 + 0.4 * static_cast<double>(i);
      const double delay_ms = 1000 * (static_cast<double>(clicks[i]) / hz - tick_s);
      EXPECT_GE(delay_ms, -1);
      EXPECT_LE(delay_ms, 20) << "click " << i << " at " << hz << " Hz";
    }
  }
}

TEST(LiveSound, ALoopThatStandsStillFallsSilentAndSoundsAgain) {
  Stage stage;
  stage.play(4, 256, [](int tick) { return tick < 200 || tick > 2000; });  // In contact at 200.
  const std::vector<double> left = test::leftOf(stage.frames_);
  EXPECT_GT(test::rms(left, 0.15, 0.2), 0.01);
  EXPECT_LT(test::rms(left, 0.35, 1.9), 1e-4);
  EXPECT_GT(test::rms(left, 2.15, 2.2), 0.01);
}

TEST(LiveSound, VolumeGlidesAndZeroIsSilence) {
  Stage stage;
  stage.play(0.3, 256);
  stage.live_.setVolume(0);
  stage.play(1, 256);
  EXPECT_EQ(volumeGain(0), 0);
  EXPECT_EQ(volumeGain(100), 1);
  EXPECT_LT(volumeGain(40), volumeGain(60));
  EXPECT_EQ(volumeGain(400), 1);
  EXPECT_LT(test::rms(test::leftOf(stage.frames_), 0.6, 0.75), 1e-6);
}

TEST(LiveSound, ANoteIsHeardAsDone) {
  Stage stage;
  const auto in_the_air = [](int tick) { return tick < 50; };
  stage.play(0.5, 256, in_the_air);
  EXPECT_LT(test::rms(test::leftOf(stage.frames_), 0.1, 0.5), 1e-6);
  stage.live_.strike(Earcon::done);
  stage.play(1, 256, in_the_air);
  EXPECT_GT(test::rms(test::leftOf(stage.frames_), 0.51, 0.6), 0.05);
}

TEST(LiveSound, AProblemIsWhatSoundsAsOneInARecording) {
  const auto agrees = [](const HapticSample& before, const HapticSample& now, const char* what) {
    TouchRecording recording = recordingOfTicks(0, 2);
    recording.events = {{0.001, eventBetween(before, now), false}};
    RecordedSound::Summary heard;
    test::framesOf(RecordedSound(recording, asLive()), &heard);
    const bool in_recording = heard.struck[static_cast<std::size_t>(Earcon::problem)] > 0;
    EXPECT_EQ(beginsAProblem(before, now), in_recording) << what;
    return in_recording;
  };
  const HapticSample before = sampleAt(0);
  EXPECT_FALSE(agrees(before, sampleAt(1), "nothing"));
  HapticSample now = sampleAt(1);
  now.softened = 1;
  EXPECT_TRUE(agrees(before, now, "softened"));
  now = sampleAt(1);
  now.slow = {.rate_hz = 300, .asked_n_per_mm = 1, .held_n_per_mm = 0.5};
  EXPECT_TRUE(agrees(before, now, "slow"));
  EXPECT_FALSE(agrees(now, before, "fast again"));
  for (const StopReason reason : {StopReason::held, StopReason::window_silent}) {
    now = sampleAt(1);
    now.stopped = reason;
    agrees(before, now, "stopped");
  }
  for (int fault = 0; fault < 16; ++fault) {
    now = sampleAt(1);
    now.fault = static_cast<DeviceFault>(fault);
    if (describe(now.fault).empty()) continue;
    agrees(before, now, describe(now.fault).data());
  }
}

/// A socket at which nobody answers, or at which somebody is connected and silent.
class NoServer : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "relievo_sound_XXXXXX");
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    setenv("PULSE_SERVER", ("unix:" + socketName()).c_str(), 1);
    setenv("HOME", folder_.c_str(), 1);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string socketName() const { return folder_ / "native"; }

  std::filesystem::path folder_;
};

TEST_F(NoServer, IsSaidAndHarmless) {
  std::atomic<int> asked{0};
  const auto out = openSoundServer([&](std::span<Frame>) { ++asked; });
  for (int i = 0; i < 24000 && out->state() == SoundOut::State::opening; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(out->state(), SoundOut::State::gone);
  EXPECT_FALSE(out->problem().empty());
  EXPECT_EQ(asked, 0);
}

TEST_F(NoServer, AMuteOneCanBeLeft) {
  const int listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_GE(listener, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = socketName();
  ASSERT_LT(name.size(), sizeof(address.sun_path));
  std::memcpy(address.sun_path, name.c_str(), name.size());
  ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  ASSERT_EQ(listen(listener, 4), 0);
  {
    const auto out = openSoundServer([](std::span<Frame>) {});
    EXPECT_NE(out->state(), SoundOut::State::playing);
  }  // Returns.
  close(listener);
}

}  // namespace
}  // namespace relievo::sound
