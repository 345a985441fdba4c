// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/flight_record.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>

#include "haptics/record/events.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

std::vector<HapticSample> ticks(std::uint64_t from, std::uint64_t count) {
  std::vector<HapticSample> samples(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    samples[i].tick = from + i;
    samples[i].time_ns = static_cast<std::int64_t>(from + i) * 1'000'000;
  }
  return samples;
}

std::filesystem::path emptyFolder(const char* name) {
  const auto folder = test::ownPath(name);
  std::filesystem::remove_all(folder);
  return folder;
}

std::string contents(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(FlightRecord, WritesTheLastThirtySecondsWhenAFaultAppearsAndOncePerFault) {
  FlightRecord record(emptyFolder("flight"), "relievo flight record");
  record.take(ticks(0, 45'000));
  EXPECT_FALSE(record.written()) << "nothing without a fault";
  auto broken = ticks(45'000, 3);
  for (HapticSample& sample : broken) sample.fault = DeviceFault::disconnected;
  record.take(broken);
  const auto end = record.written();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->error, "");
  EXPECT_EQ(end->samples, 30'000U);
  EXPECT_FALSE(record.written()) << "the fault lasts, the file is there";
  const std::string text = contents(end->file);
  EXPECT_TRUE(text.starts_with("# relievo flight record\n"));
  EXPECT_NE(text.find("\n0,15001,"), std::string::npos) << "the oldest kept tick";
  EXPECT_NE(text.find(",45000,"), std::string::npos) << "the fault's own tick";
  EXPECT_NE(text.find("\"the device was unplugged\""), std::string::npos);
  record.take(ticks(45'003, 10));
  record.take(broken);
  const auto second = record.written();
  ASSERT_TRUE(second);
  EXPECT_NE(second->file, end->file) << "the first is not lost";
}

TEST(FlightRecord, OnlyTheNewestOfAllRunsStay) {
  const auto folder = emptyFolder("pruned");
  std::filesystem::create_directories(folder);
  const auto now = std::filesystem::file_time_type::clock::now();
  for (int i = 1; i <= 60; ++i) {
    const auto file = folder / ("flight-" + std::to_string(i) + ".csv");
    std::ofstream(file) << "old";
    std::filesystem::last_write_time(file, now - std::chrono::hours(1 + i));
  }
  std::ofstream(folder / "notes.txt") << "not ours";
  FlightRecord record(folder, "relievo flight record");
  auto broken = ticks(0, 3);
  for (HapticSample& sample : broken) sample.fault = DeviceFault::timeout;
  record.take(broken);
  const auto end = record.written();
  ASSERT_TRUE(end);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files += entry.path().extension() == ".csv" ? 1 : 0;
  }
  EXPECT_EQ(files, FlightRecord::kMostKept);
  EXPECT_TRUE(std::filesystem::exists(end->file));
  EXPECT_TRUE(std::filesystem::exists(folder / "flight-1.csv")) << "an hour old";
  EXPECT_FALSE(std::filesystem::exists(folder / "flight-60.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "notes.txt"));
}

TEST(FlightRecord, SaysWhyThereIsNone) {
  FlightRecord record("/proc/nowhere", "");
  auto broken = ticks(0, 1);
  broken[0].fault = DeviceFault::timeout;
  record.take(broken);
  const auto end = record.written();
  ASSERT_TRUE(end);
  EXPECT_NE(end->error.find("cannot be written"), std::string::npos) << end->error;
}

TEST(Events, NameWhatChangedBetweenTwoSamples) {
  HapticSample a, b;
  a.firm_stiffness_n_per_mm = b.firm_stiffness_n_per_mm = 0.8;
  b.tick = 1;
  EXPECT_EQ(eventBetween(a, b), "");
  b.tick = 4;
  b.time_ns = 62'500'000;
  b.resumed = true;
  b.window_id = 7;
  b.detail = 3;
  b.engaged = EngagePhase::rising;
  b.stiffness_n_per_mm = 0.3;  // On soft ground: not a change of its own.
  b.firm_stiffness_n_per_mm = 0.6;
  b.buttons = 0b100;
  b.softened = 1;
  b.fault = DeviceFault::timeout;
  EXPECT_EQ(eventBetween(a, b),
            "3 samples dropped before this one; resumed after 62.5 ms; new window: window 7 of "
            "detail 3; the device did not answer in time; forces rise; softened against swinging; "
            "stiffness 600 N/m; button 2 down");
  EXPECT_EQ(eventAtStart(b), "window 7 of detail 3; stiffness 600 N/m; forces rise");
}

TEST(Events, TellHowSamplesCame) {
  std::vector<HapticSample> samples(4);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    samples[i].tick_ns = 700;
  }
  samples[3].time_ns += 30'000'000;  // A pause of 30 ms.
  samples[3].late = samples[3].resumed = true;
  const std::string lines = sampleLines(samples);
  EXPECT_NE(lines.find("loop ticks 4, late 1, pauses 1, rate 90.9 Hz"), std::string::npos) << lines;
  EXPECT_NE(lines.find("beyond the period us <=20.0:2 "), std::string::npos) << lines;
  EXPECT_NE(lines.find("<=100000.0:1 "), std::string::npos) << lines;
  EXPECT_NE(lines.find("work us <=0.5:0 <=1.0:4 "), std::string::npos) << lines;
}

TEST(Events, TellHowTheLoopRan) {
  LoopStats stats;
  stats.ticks = 12;
  stats.rate_hz = 999.9;
  stats.delays[1] = 12;
  stats.audit.zero_demanded = 4;
  const std::string lines = loopLines(stats);
  EXPECT_NE(lines.find("loop ticks 12, late 0, pauses 0, watchdog cuts 0, rate 999.9 Hz"),
            std::string::npos)
      << lines;
  EXPECT_NE(lines.find("zero demanded 4, zero violations 0"), std::string::npos);
  EXPECT_NE(lines.find("wake-up us <=20.0:0 <=50.0:12 "), std::string::npos) << lines;
}

}  // namespace
}  // namespace relievo
