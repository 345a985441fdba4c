// SPDX-License-Identifier: BSD-3-Clause
// The log: what is written can be read back to the last bit, also when the disk is full.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "core/base/error.h"
#include "core/recording/log_note.h"
#include "haptics/record/events.h"
#include "haptics/record/log/log_writer.h"
#include "haptics/record/recorder.h"
#include "haptics/record/replay.h"
#include "haptics/record/sample_drain.h"
#include "haptics/record/stroke.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/record/size_limit.h"

namespace relievo {
namespace {

using test::spaceOf;

std::filesystem::path temporary(const char* name) {
  return test::ownPath(name);
}

std::string contents(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> splitAt(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::stringstream in(line);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

using Row = std::map<std::string, std::string>;
std::vector<Row> rowsOf(const std::filesystem::path& file) {
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (const std::string& line : splitAt(contents(file), '\n')) {
    if (line.starts_with('#')) continue;
    const std::vector<std::string> values = splitAt(line, ',');
    if (names.empty()) {
      names = values;
      continue;
    }
    EXPECT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < std::min(values.size(), names.size()); ++i)
      row[names[i]] = values[i];
    rows.push_back(row);
  }
  return rows;
}
double number(const Row& row, const char* name) {
  return std::stod(row.at(name));
}

TEST(Log, ReadsBackEveryValueAndItsForceIsStiffnessTimesDistance) {
  const auto space =
      spaceOf(37, [](double x, double y) { return std::sin(x) + std::cos(y); }, 99, {2, 5});
  std::vector<HapticSample> samples;
  const std::filesystem::path file = temporary("log.csv");
  LogWriter log(file, "relievo recording, schema 1\ninput \"relief.ply\"");
  runStroke(*space, {}, {{{0.125, 5, 5, 4}, {0.6, 30, 20, -4}}},
            [&](const HapticSample& sample, double t_s) {
              samples.push_back(sample);
              log.write(sample, t_s);
            });
  log.close();
  EXPECT_TRUE(
      contents(file).starts_with("# relievo recording, schema 1\n# input \"relief.ply\"\n"));
  const std::vector<Row> rows = rowsOf(file);
  ASSERT_EQ(rows.size(), samples.size());
  EXPECT_EQ(log.rows(), samples.size());
  int in_contact = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const HapticSample& s = samples[i];
    EXPECT_EQ(number(row, "t_s"), 0.125 + static_cast<double>(i) / 1000);
    EXPECT_EQ(number(row, "tick"), static_cast<double>(i));
    EXPECT_EQ(number(row, "hip_x_mm"), s.hip_view.x);
    EXPECT_EQ(number(row, "proxy_z_mm"), s.proxy_view.z);
    EXPECT_EQ(number(row, "dev_hip_y_mm"), s.hip.y);
    EXPECT_EQ(number(row, "nz"), s.normal.z);
    EXPECT_EQ(number(row, "k_Npm"), 500);
    EXPECT_EQ(row.at("detail"), "2");
    EXPECT_EQ(row.at("region_id"), "99");
    EXPECT_EQ(row.at("origin"), "0");
    EXPECT_EQ(row.at("buttons"), "0");
    EXPECT_EQ(row.at("event"), "\"\"");
    const bool contact = row.at("contact") == "1";
    in_contact += contact ? 1 : 0;
    for (const char* axis : {"x", "y", "z"}) {
      const std::string a = axis;
      const double d = number(row, ("dev_proxy_" + a + "_mm").c_str()) -
                       number(row, ("dev_hip_" + a + "_mm").c_str());
      const double f = number(row, ("f_" + a + "_N").c_str());
      EXPECT_NEAR(f, contact ? 0.5 * d : 0, 1e-9 * std::abs(0.5 * d));
    }
  }
  EXPECT_GT(in_contact, 100);
}

TEST(Log, QuotesEventsAndKeepsThemOnOneLine) {
  std::string row;
  appendLogRow(row, {}, "he said \"no\"\nand left");
  EXPECT_NE(row.find(",\"he said \"\"no\"\" and left\","), std::string::npos);
  EXPECT_EQ(std::count(row.begin(), row.end(), '\n'), 1);
  EXPECT_EQ(row.back(), '\n');
}

TEST(Log, SaysWhereItCannotBeWritten) {
  try {
    LogWriter log("/nowhere/at/all.csv");
    FAIL();
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all.csv"), std::string::npos);
  }
}

TEST(Log, SaysThatTheDiskIsFullAndThatNothingIsSaved) {
  if (::access("/dev/full", W_OK) != 0) GTEST_SKIP() << "this system has no /dev/full";
  LogWriter log("/dev/full");
  log.write({}, 0);
  try {
    log.close();
    FAIL();
  } catch (const WriteError& error) {
    EXPECT_EQ(error.code, "E401");
    EXPECT_NE(std::string(error.what()).find("disk full. 0 samples"), std::string::npos)
        << error.what();
  }
}

TEST(Log, KeepsWholeRowsWhenItCannotGrow) {
  const std::filesystem::path file = temporary("full.csv");
  std::string said;
  std::uint64_t saved = 0;
  {
    const test::SizeLimit limit(100'001);
    LogWriter log(file, "one\ntwo");
    HapticSample sample;
    try {
      for (int i = 0; i < 5000; ++i) {
        sample.tick = static_cast<std::uint64_t>(i);
        sample.hip_view = {0.1 * i, 0.3 * i, 1.0 / (1 + i)};
        log.write(sample, 0.001 * i);
      }
      log.close();
    } catch (const WriteError& error) {
      said = error.what();
      EXPECT_EQ(error.code, "E401");
    }
    saved = log.rows();
    log.write(sample, 1);  // Does nothing any more.
    log.close();
  }
  ASSERT_FALSE(said.empty());
  const std::string text = contents(file);
  EXPECT_EQ(text.back(), '\n') << "ends with a whole row";
  EXPECT_LE(text.size(), 100'001U);
  EXPECT_GT(text.size(), 99'000U);
  const std::vector<Row> rows = rowsOf(file);
  EXPECT_EQ(rows.size(), saved);
  EXPECT_NE(said.find(std::to_string(saved) + " samples"), std::string::npos) << said;
  EXPECT_EQ(number(rows.back(), "tick"), static_cast<double>(saved - 1)) << "none is missing";
}

HapticSample sampleAt(std::uint64_t tick) {
  HapticSample sample;
  sample.tick = tick;
  sample.time_ns = static_cast<std::int64_t>(tick) * 1'000'000;
  return sample;
}

TEST(Recorder, NamesDroppedSamplesFaultsAndNewWindows) {
  const std::filesystem::path file = temporary("recording.csv");
  Recorder recorder;
  recorder.start(file, "header");
  EXPECT_TRUE(recorder.running());
  EXPECT_THROW(recorder.start(file, ""), Error);
  std::vector<HapticSample> batch{sampleAt(5), sampleAt(6), sampleAt(10), sampleAt(11)};
  batch[3].fault = DeviceFault::timeout;
  batch[3].window_id = 4;
  recorder.take(batch);
  EXPECT_EQ(recorder.samples(), 4U);
  EXPECT_FALSE(recorder.ended());
  recorder.stop();
  recorder.take({});
  const auto end = recorder.ended();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->samples, 4U);
  EXPECT_TRUE(end->error.empty());
  EXPECT_FALSE(recorder.running());
  const std::vector<Row> rows = rowsOf(file);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].at("event"), "\"window 0 of detail 1; stiffness 0 N/m; forces off\"");
  EXPECT_EQ(number(rows[0], "t_s"), 0);
  EXPECT_EQ(rows[2].at("event"), "\"3 samples dropped before this one\"");
  EXPECT_EQ(rows[3].at("event"),
            "\"new window: window 4 of detail 1; the device did not answer in time\"");
}

TEST(Recorder, WritesANoteIntoARowOfItsOwnOrAtTheEnd) {
  for (const char* name : {"noted.csv", "noted.h5"}) {
    const std::filesystem::path file = temporary(name);
    Recorder recorder;
    EXPECT_FALSE(recorder.note(noteEvent(5, "too early")));
    recorder.start(file, "header");
    EXPECT_TRUE(recorder.note(noteEvent(5, "a \"crack\", here\nand on")));
    std::vector<HapticSample> batch{sampleAt(5), sampleAt(6), sampleAt(7)};
    batch[1].window_id = batch[2].window_id = 4;
    recorder.take(batch);  // The first two rows have happenings of their own.
    EXPECT_TRUE(recorder.note(noteEvent(7, "last")));
    recorder.stop("loop ticks 3\n");
    recorder.take({});
    ASSERT_TRUE(recorder.ended()) << name;
    const LogTable log = readLog(file);
    ASSERT_EQ(log.events.size(), 3U) << name;
    EXPECT_EQ(log.events[1].text, "new window: window 4 of detail 1");
    EXPECT_EQ(log.events[2].tick, 7U);
    EXPECT_EQ(log.events[2].text, "note at tick 5: a \"crack\", here and on");
    EXPECT_EQ((log.header + log.footer).find("too early"), std::string::npos);
    EXPECT_NE((log.header + log.footer).find("note at tick 7: last"), std::string::npos) << name;
  }
}

TEST(Events, ANoteIsReadBackWithItsTick) {
  const auto note = noteIn(noteEvent(12, "a \"b\", c: d; e"));
  ASSERT_TRUE(note);
  EXPECT_EQ(note->tick, 12U);
  EXPECT_EQ(note->text, "a \"b\", c: d; e");
  EXPECT_EQ(noteEvent(1, "two\nlines"), "note at tick 1: two lines");
  EXPECT_FALSE(noteIn("new window: window 4 of detail 1"));
  EXPECT_FALSE(noteIn("note at tick x: y"));
}

TEST(Recorder, EndsWithAWordWhenTheDiskIsFull) {
  const std::filesystem::path file = temporary("full.csv");
  std::filesystem::remove(file);
  const test::SizeLimit limit(10'000);  // The header and some rows.
  Recorder recorder;
  recorder.start(file, "");
  std::vector<HapticSample> batch;
  for (std::uint64_t i = 0; i < 2000; ++i) batch.push_back(sampleAt(i));
  recorder.take(batch);
  const auto end = recorder.ended();
  ASSERT_TRUE(end);
  EXPECT_NE(end->error.find("disk full"), std::string::npos);
  recorder.stop();
  recorder.take(batch);
  EXPECT_FALSE(recorder.ended()) << "once";
}

TEST(SampleDrain, HandsOverEverySampleInOrderToAllSinks) {
  SampleRing ring;
  std::vector<std::uint64_t> first, second;
  const auto into = [](std::vector<std::uint64_t>& list) {
    return [&list](std::span<const HapticSample> batch) {
      for (const HapticSample& sample : batch) list.push_back(sample.tick);
    };
  };
  {
    const SampleDrain drain(ring, {into(first), into(second)});
    for (std::uint64_t i = 0; i < 5000; ++i) EXPECT_TRUE(ring.push(sampleAt(i)));
  }  // Delivers what is left.
  ASSERT_EQ(first.size(), 5000U);
  for (std::uint64_t i = 0; i < 5000; ++i) ASSERT_EQ(first[i], i);
  EXPECT_EQ(first, second);
}

TEST(SampleDrain, DeliversWhatWaitsAsSoonAsItIsUrgentAgain) {
  SampleRing ring;
  std::atomic<std::uint64_t> rounds = 0, taken = 0;
  SampleDrain drain(ring, {[&](std::span<const HapticSample> batch) {
                      ++rounds;
                      taken += batch.size();
                    }});
  const auto after = [&](std::uint64_t more) {
    const std::uint64_t from = rounds;
    while (rounds < from + more) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  drain.setUrgent(false);
  after(2);  // From here on it takes its time.
  const auto begun = std::chrono::steady_clock::now();
  after(4);
  EXPECT_GE(std::chrono::steady_clock::now() - begun, std::chrono::milliseconds(3 * 125))
      << "four rounds of an eighth of a second each, of which the first has begun";
  for (std::uint64_t i = 0; i < 100; ++i) EXPECT_TRUE(ring.push(sampleAt(i)));
  drain.setUrgent(true);
  while (taken < 100) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  after(3);
  EXPECT_EQ(taken, 100U) << "each once";
}

std::string wholeText(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Log, ARecordingsLoopStandsBeforeItsRows) {
  const auto file = test::ownPath("loop.csv");
  const auto write = [&](LogKind kind, const std::string& footer) {
    const auto log = openLog(file, "unit mm", nullptr, kind);
    log->write({}, 0);
    log->write({}, 0.001);
    log->close(footer);
    return wholeText(file);
  };
  const std::string footer = "loop ticks 2\nwork us <=0.5:2";
  const std::string text = write(LogKind::recording, footer);
  const std::size_t columns = text.find("\nt_s,tick");
  EXPECT_LT(text.find("\n# loop ticks 2\n# work us <=0.5:2"), columns);
  EXPECT_EQ(text.find("not ended"), std::string::npos);
  EXPECT_EQ(readLog(file).rows.size(), 2U);
  EXPECT_NE(readLog(file).header.find("loop ticks 2\n"), std::string::npos);
  const std::string stroke = write(LogKind::stroke, footer);
  EXPECT_GT(stroke.find("\n# loop ticks 2"), stroke.find("\nt_s,tick"));
  const std::string large = write(LogKind::recording, std::string(5000, 'x'));
  EXPECT_GT(large.find("# xxx"), large.find("\nt_s,tick")) << "no room in the header";
  EXPECT_EQ(readLog(file).rows.size(), 2U);
}

}  // namespace
}  // namespace relievo
