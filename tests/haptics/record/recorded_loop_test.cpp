// SPDX-License-Identifier: BSD-3-Clause
// A recording that begins while the hand touches, with surface, options and window changed live.
#include "haptics/record/recorded_loop.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "haptics/device/virtual_hand.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/flight_record.h"
#include "haptics/record/log/named_json.h"
#include "haptics/record/recorder.h"
#include "haptics/record/sample_drain.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr std::size_t kScenes = 3;
constexpr const char* kBuild = "b1";

/// A loop without a thread, as the real one calls the core, that is recorded from tick 1500 on.
class Recorded {
 public:
  Recorded() {
    for (std::size_t i = 0; i < kScenes; ++i) {
      const double height = 0.5 + static_cast<double>(i);
      scenes_[i] = test::spaceOf(
          80, [=](double x, double y) { return height * std::sin(0.2 * x) * std::cos(0.25 * y); },
          10 + i, {static_cast<int>(i) + 1, 3}, SurfaceKind::crease_aware);
      scenes_[i]->scene_id = i + 1;
      lines_ += sceneLine({.id = i + 1,
                           .window_id = 10 + i,
                           .region = scenes_[i]->region,
                           .anchor = {},
                           .checksum = sceneChecksum(*scenes_[i])});
    }
    recorder_.beginAt(snapshots_, kBuild);
  }

  LogTable record(const std::filesystem::path& file, std::uint64_t first_change = 2500) {
    std::size_t now = 0, before = 0;
    HapticOptions options;
    options.force.forces_on = true;
    options.id = 1;
    lines_ += optionsLine(options);
    std::vector<HapticSample> batch;
    for (std::uint64_t tick = 0; tick < 6000; ++tick) {
      if (tick == first_change || tick == 4000) {
        before = std::exchange(now, now + 1);
      }
      if (tick == 3000 || tick == 4500) {
        options.proxy.static_friction = options.proxy.dynamic_friction += 0.1;
        options.force.strength = 0.8;
        ++options.id;
        lines_ += optionsLine(options);
      }
      if (tick == 4700 || tick == 4900) {  // Move mode for a while.
        options.detent = {.on = tick == 4700, .centre = {3, 0, 0}};
        ++options.id;
        lines_ += optionsLine(options);
      }
      if (tick == 1600 || tick == 2000) {  // Led for a while, twice; the second is another path.
        path_ = guidePath(std::vector<DeviceMm>{{20, 15, 0}, {-20, 15, 1}, {-20, -15, 2}}, true);
        path_.id = tick;
        path_.scene_id = scenes_[now]->scene_id;
        lines_ += guideLine(path_);
        options.guide.path = tick;
        ++options.id;
        lines_ += optionsLine(options);
      }
      if (tick == 3200 || tick == 3700) {  // Pulled back, and let go of.
        options.beacon = {
            .id = tick == 3200 ? 8U : 0U, .place = {-20, 5, 0}, .scene_id = scenes_[now]->scene_id};
        ++options.id;
        lines_ += optionsLine(options);
      }
      if (tick == 2700 || tick == 4100) {  // Felt patterns; the first one in the air.
        options.taps = {.id = tick, .pattern = FeltPattern::edge};
        ++options.id;
        lines_ += optionsLine(options);
      }
      if (tick == 1400) recorder_.start(file, "a recording");
      if (tick == 1500) {
        snapshots_.push({tick, core_, scenes_[now]->scene_id, scenes_[before]->scene_id, true});
      }
      DeviceReading reading;
      std::int64_t now_ns = 7'000'000'000 + static_cast<std::int64_t>(tick) * 1'000'000;
      if (tick >= 5000) now_ns += 60'000'000;  // The computer stood still.
      reading.time_ns = now_ns - 300'000;
      const double t = 0.001 * static_cast<double>(tick);
      reading.position = {12 * std::sin(2 * t), 9 * std::cos(1.3 * t), t < 1.2 ? 8 : -1.5};
      if (tick >= 5500 && tick < 5600) reading.fault = DeviceFault::timeout;
      HapticOptions with = options;
      if (tick == 1900) {  // The path that is named was not there.
        with.guide = {};
        with.id |= kPathlessBit;
      }
      batch.push_back(core_.tick(*scenes_[now], *scenes_[before], with, reading, now_ns, &path_));
      led_ticks += batch.back().guide != GuidePhase::off ? 1 : 0;
      pulled_ticks += batch.back().pulled_back ? 1 : 0;
      tapped_ticks += batch.back().tapped ? 1 : 0;
      if (batch.size() == 50) {
        recorder_.take(batch);
        batch.clear();
      }
    }
    recorder_.stop(lines_);
    recorder_.take({});
    EXPECT_TRUE(recorder_.ended().has_value());
    return readLog(file);
  }

  int led_ticks = 0, pulled_ticks = 0, tapped_ticks = 0;
  /// Surfaces that the last replay asked for.
  mutable std::set<std::uint64_t> asked;

  ReplayResult replay(const LogTable& log) const {
    asked.clear();
    const auto loop = recordedLoop(log.footer);
    EXPECT_TRUE(loop.has_value());
    EXPECT_EQ(loop->build, kBuild);
    return replayLoop(
        *loop, log,
        [this](const RecordedScene& scene) -> const HapticSpace& {
          asked.insert(scene.id);
          EXPECT_EQ(sceneChecksum(*scenes_[scene.id - 1]), scene.checksum);
          return *scenes_[scene.id - 1];
        },
        [](const HapticSample&, double) {});
  }

 private:
  std::array<std::unique_ptr<HapticSpace>, kScenes> scenes_;
  SnapshotRing snapshots_;
  Recorder recorder_;
  HapticCore core_;
  GuidePath path_;
  std::string lines_;
};

std::filesystem::path temporary(const char* name) {
  return test::ownPath(name);
}

TEST(RecordedLoop, RepeatsLiveChangesToTheLastBitInEitherFormat) {
  for (const char* name : {"live.csv", "live.h5"}) {
    Recorded recorded;
    const LogTable log = recorded.record(temporary(name));
    EXPECT_EQ(log.rows.size(), 4500U) << "from the snapshot on";
    const ReplayResult result = recorded.replay(log);
    EXPECT_EQ(result.ticks, 4500U);
    EXPECT_EQ(result.different, 0U) << name << " " << (result.first ? result.first->column : "");
    EXPECT_GT(recorded.led_ticks, 300) << "and was led";
    EXPECT_GT(recorded.pulled_ticks, 200) << "and was pulled back";
    EXPECT_GT(recorded.tapped_ticks, 300) << "and felt patterns of taps";
  }
}

TEST(RecordedLoop, WithoutThePathThatLedItIsNotReplayed) {
  Recorded recorded;
  LogTable log = recorded.record(temporary("unled.csv"));
  const LogTable whole = log;
  const std::size_t at = log.footer.find("replay guide 1600 ");
  ASSERT_NE(at, std::string::npos);
  log.footer.erase(at, log.footer.find('\n', at) - at);
  EXPECT_THROW(recorded.replay(log), FileError);
  log = whole;
  const std::size_t corner = log.footer.find("[20.0,15.0,0.0", at);
  ASSERT_NE(corner, std::string::npos);
  log.footer[corner + 2] = '1';  // Altered: its checksum says so.
  EXPECT_THROW(recorded.replay(log), FileError);
}

TEST(RecordedLoop, AsksForTheSurfaceBeforeOnlyWhereItIsFelt) {
  // It begins at tick 1500. A surface that was gone long before may be of another map.
  Recorded long_before;
  const LogTable alone = long_before.record(temporary("alone.csv"), 300);
  EXPECT_EQ(long_before.replay(alone).different, 0U);
  EXPECT_EQ(long_before.asked, (std::set<std::uint64_t>{2, 3}));
  for (const std::uint64_t just_before : {1480U, 1500U}) {
    Recorded in_change;
    const LogTable both = in_change.record(temporary("both.csv"), just_before);
    EXPECT_EQ(in_change.replay(both).different, 0U);
    EXPECT_EQ(in_change.asked, (std::set<std::uint64_t>{1, 2, 3}));
  }
}

TEST(RecordedLoop, SeesASingleOtherBit) {
  Recorded recorded;
  LogTable log = recorded.record(temporary("bit.csv"));
  log.rows[2000].force.z = std::nextafter(log.rows[2000].force.z, 9);
  const ReplayResult result = recorded.replay(log);
  EXPECT_EQ(result.different, 1U);
  EXPECT_EQ(result.first->tick, 3500U);
  EXPECT_EQ(result.first->column, "f_z_N");
}

/// All threads at once: loop, drain with an HDF5 log and the flight record, and this one, which
/// starts, changes and stops.
TEST(RecordedLoop, ARunningLoopIsRecordedToHdf5AndRepeated) {
  const auto file = temporary("running.h5");
  const auto space = test::spaceOf(80, [](double x, double y) { return 0.02 * x * y / 80; });
  space->scene_id = 1;
  std::string lines = sceneLine({.id = 1,
                                 .window_id = 1,
                                 .region = space->region,
                                 .anchor = {},
                                 .checksum = sceneChecksum(*space)});
  auto hand = std::make_unique<VirtualHand>(VirtualHandOptions{});
  hand->placeAt({0, 0, -0.7});  // 0.3 mm deep: so little that the forces come on.
  HapticLoop loop(std::move(hand));
  HapticOptions options = withinDevice({}, loop.device());
  const auto setOptions = [&](bool on, std::uint64_t id) {
    options.force.forces_on = on;
    options.id = id;
    lines += optionsLine(options);
    loop.options().write(options);
  };
  loop.spaces().write(*space);
  setOptions(false, 1);
  Recorder recorder;
  recorder.beginAt(loop.snapshots(), kBuild);
  FlightRecord flight(temporary("flights"), "a flight");
  loop.start();
  {
    SampleDrain drain(loop.samples(),
                      {[&](std::span<const HapticSample> batch) { recorder.take(batch); },
                       [&](std::span<const HapticSample> batch) { flight.take(batch); }});
    const auto until = [](const auto& holds) {
      while (!holds()) sleepUntil(monotonicNs() + 1'000'000);
    };
    until([&] {
      loop.latest().update();
      return loop.latest().front().tick > 20;
    });
    recorder.start(file, "a recording");
    loop.wantSnapshot();
    until([&] { return recorder.samples() > 100; });
    setOptions(true, 2);
    until([&] { return recorder.samples() > 400; });
    recorder.stop(lines);
    until([&] { return recorder.ended().has_value(); });
    loop.stop();
  }
  const LogTable log = readLog(file);
  EXPECT_GT(log.rows.size(), 400U);
  const auto recorded = recordedLoop(log.footer);
  ASSERT_TRUE(recorded.has_value());
  const ReplayResult result = replayLoop(
      *recorded, log, [&](const RecordedScene&) -> const HapticSpace& { return *space; },
      [](const HapticSample&, double) {});
  EXPECT_EQ(result.different, 0U) << (result.first ? result.first->column : "");
}

TEST(RecordedLoop, SaysWhatCannotBeRepeated) {
  Recorded recorded;
  LogTable log = recorded.record(temporary("not.csv"));
  EXPECT_FALSE(recordedLoop("loop ticks 5\nwindow 3: region_mm 0 0 1\n"));
  LogTable gap = log;
  gap.rows.erase(gap.rows.begin() + 100);
  EXPECT_THROW(recorded.replay(gap), FileError);
  LogTable damaged = log;
  damaged.footer.replace(damaged.footer.find("replay options 2"), 16, "replay options 9");
  EXPECT_THROW(recorded.replay(damaged), FileError);
  LogTable broken = log;
  broken.footer.replace(broken.footer.find("replay core b1 ") + 30, 1, "x");
  EXPECT_THROW(recordedLoop(broken.footer), FileError);
  // Another digit is as good as the first one.
  for (const char* line : {"replay options 1 ", "replay core b1 "}) {
    LogTable altered = log;
    char& digit = altered.footer[altered.footer.find(line) + 60];
    digit = digit == '7' ? '8' : '7';
    EXPECT_THROW(recordedLoop(altered.footer), FileError) << line;
  }
}

/// What builds before these names wrote: bytes of the structures as they were in memory.
TEST(RecordedLoop, ThatIsAMemoryImageIsRefusedWithTheNameOfItsBuild) {
  try {
    recordedLoop("replay options 1 00ff00ff\nreplay core 12ab 5 00ff00ff00ff\n");
    FAIL() << "took it";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("it was made by build 12ab"), std::string::npos);
  }
}

TEST(RecordedLoop, OfALaterBuildIsReadAsFarAsThisOneKnowsIt) {
  HapticOptions options;
  options.force.strength = 0.3;
  std::string text = toJson(options);
  text.insert(text.find("\"strength\""), "\"warmth\":[1,{\"a\":null}],");
  text.erase(text.find("\"lift_n\""), text.find("\"limit_n\"") - text.find("\"lift_n\""));
  HapticOptions back;
  back.force.strength = 0.9;
  ASSERT_TRUE(fromJson(text, back)) << text;
  EXPECT_EQ(back.force.strength, 0.3);
  EXPECT_EQ(toJson(back), toJson(options)) << "what it does not say is as it begins";
}

TEST(RecordedLoop, LinesOfASurfaceSayAllThatItIsMadeFrom) {
  const RecordedScene scene{.id = 4,
                            .window_id = 77,
                            .region = {1.25, -2.5, 30.1, Level{2}},
                            .gain = 1.7,
                            .kind = SurfaceKind::spline,
                            .anchor = Anchor{{1, 2, 3}, {0.1, 0.2, -0.3}},
                            .textured = true,
                            .checksum = 0xfedcba9876543210ULL};
  const auto loop = recordedLoop(sceneLine(scene) + snapshotLine({}, 5, kBuild));
  ASSERT_TRUE(loop.has_value());
  const RecordedScene& back = loop->scenes.at(4);
  EXPECT_EQ(back.window_id, 77U);
  EXPECT_EQ(back.region, scene.region);
  EXPECT_EQ(back.gain, 1.7);
  EXPECT_EQ(back.kind, SurfaceKind::spline);
  EXPECT_TRUE(back.textured);
  EXPECT_EQ(back.checksum, scene.checksum);
  EXPECT_EQ(back.anchor->at, scene.anchor->at);
  EXPECT_EQ(loop->first_ns, 5);
}

TEST(RecordedLoop, TellsWhichMapAndWhichRasterOfFirmnessWhateverTheirNames) {
  RecordedScene scene;
  scene.id = 7;
  scene.anchor = Anchor{{1, 2, 3}, {4, 5, 6}};
  scene.checksum = 99;
  scene.map = 2;
  scene.firmness = "a1b2";
  const CoreSnapshot start{};
  const std::string name = "../my scans/firm 100 %\n\xc3\xa4.tif";
  const std::string state = R"({"file": "a b.ply", "of": "100 %"})";
  const auto loop = recordedLoop(sceneLine(scene) + firmnessLine("a1b2", name) + mapLine(2, state) +
                                 snapshotLine(start, 0, kBuild));
  ASSERT_TRUE(loop);
  const RecordedScene& read = loop->scenes.at(7);
  EXPECT_EQ(read.firmness, "a1b2");
  EXPECT_EQ(read.checksum, 99U);
  EXPECT_EQ(read.map, 2U);
  ASSERT_TRUE(read.anchor);
  EXPECT_EQ(read.anchor->at.z, 6);
  EXPECT_EQ(loop->files.firmness.at("a1b2"), name);
  EXPECT_EQ(loop->files.maps.at(2), state);
  scene.firmness.clear();
  const auto without = recordedLoop(sceneLine(scene) + snapshotLine(start, 0, kBuild));
  EXPECT_EQ(without->scenes.at(7).firmness, "");
  EXPECT_THROW(recordedLoop("replay firmness a1b2 firm%2\n" + snapshotLine(start, 0, kBuild)),
               FileError);
}

}  // namespace
}  // namespace relievo
