// SPDX-License-Identifier: BSD-3-Clause
// An HDF5 log is read back here with the library's own calls, as any other program would.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "haptics/record/replay.h"
#include "haptics/record/sample_log.h"
#include "haptics/record/stroke.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/record/size_limit.h"

namespace relievo {
namespace {

/// A name that is free: what stands there would stay until a log is whole.
std::filesystem::path temporary(const char* name) {
  const std::filesystem::path file = test::ownPath(name);
  std::filesystem::remove(file);
  return file;
}

std::vector<double> column(hid_t file, const std::string& name) {
  const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  EXPECT_GE(set, 0) << name;
  const hid_t space = H5Dget_space(set);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(set);
  return values;
}

std::string text(hid_t file, const char* name) {
  const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
  EXPECT_GE(set, 0) << name;
  const hid_t type = H5Dget_type(set);
  std::string value(H5Tget_size(type), '\0');
  H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data());
  H5Tclose(type);
  H5Dclose(set);
  return value;
}

std::string attribute(hid_t file, const char* object, const char* name) {
  const hid_t held = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(held, 0) << object << " " << name;
  const hid_t type = H5Aget_type(held);
  std::string value(H5Tget_size(type), '\0');
  H5Aread(held, type, value.data());
  H5Tclose(type);
  H5Aclose(held);
  return value;
}

TEST(Hdf5Log, KeepsEveryValueToTheLastBitWithUnitsSurfaceAndEvents) {
  const auto space =
      test::spaceOf(37, [](double x, double y) { return std::sin(x) + std::cos(y); }, 99, {2, 5});
  const std::filesystem::path file = temporary("log.h5");
  std::vector<HapticSample> samples;
  const auto log = openLog(file, "relievo log\nparameters {\"k\":0.5}\nunit mm", space.get());
  // More rows than a chunk, so that the sets grow several times.
  runStroke(*space, {}, {{{0.125, 5, 5, 4}, {10.1, 30, 20, -4}}},
            [&](const HapticSample& sample, double t_s) {
              log->write(sample, t_s, sample.tick % 5000 == 0 ? "a happening" : "");
              samples.push_back(sample);
            });
  log->close("loop ticks 5");
  EXPECT_EQ(log->rows(), samples.size());
  ASSERT_GT(samples.size(), 9000U);

  const hid_t held = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(held, 0);
  std::vector<std::vector<double>> columns;
  for (const LogColumn& c : kNumberColumns) {
    columns.push_back(column(held, "/log/" + std::string(c.name)));
    ASSERT_EQ(columns.back().size(), samples.size()) << c.name;
    EXPECT_EQ(attribute(held, ("/log/" + std::string(c.name)).c_str(), "unit"), c.unit);
  }
  for (std::size_t row = 0; row < samples.size(); ++row) {
    const TouchRow touched = touchRow(samples[row], columns[0][row]);
    for (std::size_t i = 1; i < kNumberColumns.size(); ++i) {
      ASSERT_EQ(columns[i][row], kNumberColumns[i].value(touched))
          << kNumberColumns[i].name << " " << row;
    }
  }
  EXPECT_EQ(text(held, "/parameters"), "{\"k\":0.5}");
  EXPECT_NE(text(held, "/provenance").find("unit mm"), std::string::npos);
  EXPECT_EQ(text(held, "/loop"), "loop ticks 5");
  const std::vector<double> depth = column(held, "/surface/depth");
  ASSERT_EQ(depth.size(), kWindowCount);
  EXPECT_EQ(depth[777], static_cast<double>(space->samples[777].height_mm));
  EXPECT_EQ(column(held, "/surface/origin").size(), kWindowCount);
  const hid_t events = H5Dopen2(held, "/events", H5P_DEFAULT);
  const hid_t count = H5Dget_space(events);
  EXPECT_EQ(H5Sget_simple_extent_npoints(count), 2);
  H5Sclose(count);
  H5Dclose(events);
  H5Fclose(held);
}

TEST(Hdf5Log, CarriesTheStateOfItsHeader) {
  const std::filesystem::path with = temporary("state.h5"), without = temporary("stateless.h5");
  openLog(with, "unit mm\nrelievo:state {\"a\":[1,2]}\nparameters {}")->close();
  openLog(without, "unit mm")->close();
  EXPECT_EQ(hdf5State(with), "{\"a\":[1,2]}");
  EXPECT_EQ(hdf5State(without), std::nullopt);
  const std::filesystem::path csv = temporary("state.csv");
  openLog(csv, "")->close();
  EXPECT_THROW(hdf5State(csv), FileError);
}

HapticSample sampleAt(std::uint64_t tick) {
  HapticSample sample;
  sample.tick = tick;
  // Values that do not become small by compression.
  sample.hip_view = {std::sin(1.0 + static_cast<double>(tick)), 1.0 / static_cast<double>(tick + 1),
                     std::cos(0.1 * static_cast<double>(tick))};
  return sample;
}

void write(SampleLog& log, std::uint64_t from, std::uint64_t to) {
  for (std::uint64_t tick = from; tick < to; ++tick) {
    log.write(sampleAt(tick), 0.001 * static_cast<double>(tick),
              tick % 1000 == 0 ? "happened at " + std::to_string(tick) : "");
  }
}

void expectRows(const LogTable& log, std::uint64_t count) {
  ASSERT_EQ(log.rows.size(), count);
  for (std::uint64_t tick = 0; tick < count; ++tick) {
    ASSERT_EQ(log.rows[tick], touchRow(sampleAt(tick), 0.001 * static_cast<double>(tick)));
  }
}

TEST(Hdf5Log, WhatALogHoldsOutlivesAProgramThatIsKilled) {
  const std::filesystem::path file = temporary("killed.h5"), left = temporary("left.h5");
  const auto log = openLog(file, "relievo log");
  write(*log, 0, 10'100);
  // What a kill leaves on the disk is the file as it is now.
  std::filesystem::copy_file(file, left, std::filesystem::copy_options::overwrite_existing);
  EXPECT_LT(std::filesystem::file_size(left), 2'000'000U) << "no room is left in it";
  const LogTable kept = readLog(left);
  expectRows(kept, 10'000);  // The chunk after them is not complete.
  ASSERT_EQ(kept.events.size(), 10U);
  EXPECT_EQ(kept.events[9].text, "happened at 9000");
  EXPECT_EQ(kept.events[9].tick, 9000U);
}

TEST(Hdf5Log, IsCompleteWhenItCannotGrow) {
  const std::filesystem::path file = temporary("full.h5");
  std::string said;
  std::uint64_t saved = 0;
  {
    const test::SizeLimit limit(5'000'000);
    const auto log = openLog(file, "relievo log\nunit mm");
    try {
      write(*log, 0, 1'000'000);
    } catch (const WriteError& error) {
      said = error.what();
      EXPECT_EQ(error.code, "E401");
    }
    saved = log->rows();
    log->write(sampleAt(0), 0);  // Does nothing any more.
    log->close("loop ticks 1");
  }
  EXPECT_EQ(said, "Recording stopped: disk full. " + std::to_string(saved) +
                      " samples are saved and complete in \"" + file.string() + "\".");
  EXPECT_GT(saved, 4096U);
  const LogTable kept = readLog(file);
  expectRows(kept, saved);
  EXPECT_EQ(kept.events.size(), (saved + 999) / 1000);
  EXPECT_NE(kept.header.find("unit mm"), std::string::npos);
  EXPECT_LE(std::filesystem::file_size(file), 5'000'000U);
}

/// What a recording of so many rows keeps where there is so much room.
struct Kept {
  bool begun = false;
  std::uint64_t rows = 0;
  std::string said;
};
Kept keptIn(rlim_t room_bytes, const std::filesystem::path& file, const HapticSpace& surface,
            std::uint64_t rows) {
  std::filesystem::remove(file);
  const test::SizeLimit limit(room_bytes);
  Kept kept;
  std::unique_ptr<SampleLog> log;
  try {
    log = openLog(file, "relievo log\nunit mm", &surface);
    kept.begun = true;
    write(*log, 0, rows);
    log->close("loop ticks 1");
  } catch (const WriteError& error) {
    EXPECT_EQ(error.code, "E401");
    kept.said = error.what();
  }
  if (log) kept.rows = log->rows();
  return kept;
}

TEST(Hdf5Log, KeepsWhatFitsWhateverRoomThereIs) {
  const std::filesystem::path file = temporary("sweep.h5");
  const auto surface = test::spaceOf(
      37, [](double, double) { return 1.0; }, 1);
  constexpr std::uint64_t kRows = 170'000;
  ASSERT_EQ(keptIn(RLIM_INFINITY, file, *surface, kRows).rows, kRows);
  const std::uintmax_t whole_bytes = std::filesystem::file_size(file);
  std::uint64_t before = 0;
  for (const rlim_t room :
       {100'000, 160'000, 200'000, 280'000, 290'000, 300'000, 350'000, 400'000, 420'000, 500'000,
        700'000, 1'000'000, 1'020'000, 1'200'000, 2'000'000, 3'000'000, 4'500'000, 6'000'000}) {
    SCOPED_TRACE(room);
    const Kept kept = keptIn(room, file, *surface, kRows);
    EXPECT_GE(kept.rows, before) << "more room, fewer rows";
    before = kept.rows;
    EXPECT_EQ(kept.said.empty(), room >= whole_bytes) << kept.said;
    EXPECT_TRUE(kept.said.empty() || kept.said.find(file.string()) != std::string::npos)
        << kept.said;
    if (!kept.begun) {
      EXPECT_LT(room, 290'000U);
      EXPECT_NE(kept.said.find("disk full. Nothing was kept."), std::string::npos) << kept.said;
      EXPECT_FALSE(std::filesystem::exists(file)) << "a complete file or none";
      continue;
    }
    EXPECT_TRUE(kept.said.empty() || kept.said.find("disk full") != std::string::npos) << kept.said;
    EXPECT_NO_THROW(hdf5State(file)) << "a complete file, also without a row";
    const std::uintmax_t bytes = std::filesystem::file_size(file);
    EXPECT_LE(bytes, room);
    if (kept.rows == 0) continue;
    const LogTable log = readLog(file);
    expectRows(log, kept.rows);
    EXPECT_EQ(log.events.size(), (kept.rows + 999) / 1000);
    EXPECT_EQ(log.footer.empty(), kept.rows < kRows) << "nothing but rows";
    if (room < whole_bytes && kept.rows > 1000) {
      EXPECT_GT(bytes + 20'000, room) << "room was left";
    }
  }
  EXPECT_EQ(before, kRows) << "the whole sweep was short of room";
}

TEST(Hdf5Log, TakesNoMoreRoomThanItNeeds) {
  const std::filesystem::path file = temporary("small.h5");
  const auto log = openLog(file, "relievo log");
  write(*log, 0, 5000);
  log->close("loop ticks 5000");
  EXPECT_LT(std::filesystem::file_size(file), 1'000'000U);
  EXPECT_EQ(readLog(file).footer, "loop ticks 5000");
}

TEST(Hdf5Log, CutsALongEventBetweenCharacters) {
  const std::filesystem::path file = temporary("long.h5");
  const auto log = openLog(file, "relievo log");
  std::string umlauts;
  for (int i = 0; i < 200; ++i) umlauts += "\u00e4";
  log->write(sampleAt(0), 0, umlauts);
  log->close();
  EXPECT_EQ(readLog(file).events.at(0).text, umlauts.substr(0, 254));
}

TEST(Hdf5Log, RefusesAPlaceThatCannotBeWritten) {
  try {
    openLog("/nowhere/at/all.h5", "");
    FAIL();
  } catch (const WriteError& error) {
    EXPECT_EQ(error.code, "E401");
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all.h5"), std::string::npos);
  }
}

TEST(Hdf5Log, TheEndingChoosesTheFormat) {
  const std::filesystem::path csv = temporary("chosen.csv");
  openLog(csv, "")->close();
  EXPECT_LE(H5Fis_hdf5(csv.c_str()), 0);
  const std::filesystem::path h5 = temporary("chosen.hdf5");
  openLog(h5, "")->close();
  EXPECT_GT(H5Fis_hdf5(h5.c_str()), 0);
}

TEST(Hdf5Log, ASizeThatTheFileCannotHoldIsGivenNoMemory) {
  const std::filesystem::path file = temporary("claims.h5");
  const auto log = openLog(file, "relievo log", nullptr);
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    HapticSample sample;
    sample.tick = tick;
    log->write(sample, 0.001 * static_cast<double>(tick), "");
  }
  log->close("loop ticks 1000");
  EXPECT_EQ(readLog(file).rows.size(), 1000U);
  // 800 GB, and more numbers than a vector can ever have.
  for (const hsize_t rows : {hsize_t{100'000'000'000}, hsize_t{1} << 62U}) {
    const hid_t held = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t set = H5Dopen2(held, "log/tick", H5P_DEFAULT);
    ASSERT_GE(H5Dset_extent(set, &rows), 0);
    H5Dclose(set);
    H5Fclose(held);
    EXPECT_THROW(readLog(file), FileError);
  }
}

}  // namespace
}  // namespace relievo
