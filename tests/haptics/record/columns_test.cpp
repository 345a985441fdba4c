// SPDX-License-Identifier: BSD-3-Clause
// What each column of a log is, said once more and without the table: for CSV and HDF5.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/recording/force_curve.h"
#include "core/recording/log_check.h"
#include "core/recording/log_table.h"
#include "haptics/record/sample_log.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

struct Expected {
  std::string_view name, unit, csv;
  double value;
};
/// Of the sample below; every value is another one.
constexpr std::array<Expected, 31> kExpected{{
    {"t_s", "s", "0.125", 0.125},
    {"tick", "1", "1000000", 1000000},
    {"hip_x_mm", "mm", "2.5", 2.5},
    {"hip_y_mm", "mm", "-3.5", -3.5},
    {"hip_z_mm", "mm", "4.5", 4.5},
    {"proxy_x_mm", "mm", "5.5", 5.5},
    {"proxy_y_mm", "mm", "6.5", 6.5},
    {"proxy_z_mm", "mm", "7.5", 7.5},
    {"f_x_N", "N", "0.1", 0.1},
    {"f_y_N", "N", "-0.2", -0.2},
    {"f_z_N", "N", "1e-300", 1e-300},
    {"f_cmd_N", "N", "12.5", 12.5},
    {"clamp", "1", "1", 1},
    {"contact", "1", "0", 0},
    {"nx", "1", "0.25", 0.25},
    {"ny", "1", "0.375", 0.375},
    {"nz", "1", "0.875", 0.875},
    {"k_Npm", "N/m", "512.5", 512.5},
    {"detail", "1", "3", 3},
    {"region_id", "1", "4294967297", 4294967297},
    {"origin", "1", "2", 2},
    {"buttons", "1", "2147483649", 2147483649},
    {"rate_Hz", "Hz", "999.5", 999.5},
    {"event", "", "\"a \"\"knock\"\", here\"", 0},
    {"dev_hip_x_mm", "mm", "23.5", 23.5},
    {"dev_hip_y_mm", "mm", "24.5", 24.5},
    {"dev_hip_z_mm", "mm", "25.5", 25.5},
    {"dev_proxy_x_mm", "mm", "26.5", 26.5},
    {"dev_proxy_y_mm", "mm", "27.5", 27.5},
    {"dev_proxy_z_mm", "mm", "28.5", 28.5},
    {"age_s", "s", "0.0009765625", 0.0009765625},
}};
constexpr std::size_t kEvent = 23;

HapticSample sample() {
  HapticSample s;
  s.tick = 1'000'000;
  s.hip_view = {2.5, -3.5, 4.5};
  s.proxy_view = {5.5, 6.5, 7.5};
  s.force = {0.1, -0.2, 1e-300};
  s.f_cmd_n = 12.5;
  s.clamped = true;
  s.normal = {0.25, 0.375, 0.875};
  s.stiffness_n_per_mm = 0.5125;
  s.detail = 3;
  s.window_id = 4294967297;
  s.origin = CellStatus::base_plane;
  s.buttons = 2147483649;
  s.rate_hz = 999.5;
  s.hip = {23.5, 24.5, 25.5};
  s.proxy = {26.5, 27.5, 28.5};
  s.age_s = 0.0009765625;
  return s;
}

class Columns : public testing::Test {
 protected:
  fs::path written(const std::string& name) const {
    const fs::path file = folder_.path() / name;
    const auto log = openLog(file, "relievo log\nunit mm");
    log->write(sample(), 0.125, "a \"knock\", here");
    log->close("loop ticks 1");
    return file;
  }
  fs::path write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }
  /// A CSV log of these columns alone.
  fs::path only(const std::string& name, const std::vector<std::string_view>& columns) const {
    std::string names, values;
    for (const std::string_view column : columns) {
      for (const Expected& one : kExpected) {
        if (one.name != column) continue;
        names.append(names.empty() ? "" : ",").append(one.name);
        values.append(values.empty() ? "" : ",").append(one.csv);
      }
    }
    return write(name, names + "\n" + values + "\n");
  }
  test::TemporaryFolder folder_;
};

TEST_F(Columns, ACsvLogHasThemInTheirOrder) {
  std::string names, values;
  for (const Expected& column : kExpected) {
    names.append(names.empty() ? "" : ",").append(column.name);
    values.append(values.empty() ? "" : ",").append(column.csv);
  }
  std::ifstream in(written("a.csv"));
  std::string line;
  while (std::getline(in, line) && line.starts_with('#')) continue;
  EXPECT_EQ(line, names);
  std::getline(in, line);
  EXPECT_EQ(line, values);
}

TEST_F(Columns, AnHdf5LogHasEachWithItsUnit) {
  const hid_t file = H5Fopen(written("a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  for (const Expected& column : kExpected) {
    if (column.name == "event") continue;
    const hid_t set = H5Dopen2(file, ("/log/" + std::string(column.name)).c_str(), H5P_DEFAULT);
    ASSERT_GE(set, 0) << column.name;
    double value = 0;
    H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value);
    EXPECT_EQ(value, column.value) << column.name;
    const hid_t unit = H5Aopen(set, "unit", H5P_DEFAULT);
    const hid_t type = H5Aget_type(unit);
    std::string text(H5Tget_size(type), '\0');
    H5Aread(unit, type, text.data());
    EXPECT_EQ(text, column.unit) << column.name;
    H5Tclose(type);
    H5Aclose(unit);
    H5Dclose(set);
  }
  H5Fclose(file);
}

TEST_F(Columns, BothFormatsComeBackAsTheSameRowsAndEvents) {
  const LogTable csv = readLog(written("a.csv")), h5 = readLog(written("a.h5"));
  ASSERT_EQ(csv.rows.size(), 1U);
  EXPECT_EQ(csv.rows, h5.rows);
  EXPECT_EQ(csv.events, h5.events);
  ASSERT_EQ(csv.events.size(), 1U);
  EXPECT_EQ(csv.events[0].text, "a \"knock\", here");
  EXPECT_EQ(csv.events[0].tick, 1'000'000U);
  const TouchRow& row = csv.rows[0];
  EXPECT_EQ(row, touchRow(sample(), 0.125));
  EXPECT_EQ(row.hip, (ViewMm{2.5, -3.5, 4.5}));
  EXPECT_EQ(row.proxy, (ViewMm{5.5, 6.5, 7.5}));
  EXPECT_EQ(row.force, (DeviceN{0.1, -0.2, 1e-300}));
  EXPECT_TRUE(row.clamped);
  EXPECT_FALSE(row.contact);
  EXPECT_EQ(row.origin, CellStatus::base_plane);
  EXPECT_EQ(row.window_id, 4294967297U);
  EXPECT_EQ(row.hand_hip, (DeviceMm{23.5, 24.5, 25.5}));
  EXPECT_EQ(row.hand_proxy, (DeviceMm{26.5, 27.5, 28.5}));
}

TEST_F(Columns, AnyOrderAndColumnsOfLaterBuildsAreRead) {
  std::string names = "mood", values = "\"good, they say\"";
  for (std::size_t i = kExpected.size(); i-- > 0;) {
    names.append(",").append(kExpected.at(i).name);
    values.append(",").append(kExpected.at(i).csv);
  }
  const fs::path file = write("later.csv", "# later\n" + names + "\r\n" + values + "\r\n");
  const LogTable log = readLog(file);
  EXPECT_EQ(log.rows.at(0), touchRow(sample(), 0.125));
  EXPECT_EQ(log.events.at(0).text, "a \"knock\", here");
}

/// The first builds had no age: what they recorded is shown, and is not taken for a replay.
TEST_F(Columns, ARecordingIsReadForWhatItsColumnsAreEnoughFor) {
  std::vector<std::string_view> columns;
  for (const Expected& one : kExpected) columns.push_back(one.name);
  columns.pop_back();
  const fs::path first = only("first.csv", columns);
  const LogTable shown = readLog(first, LogUse::show);
  EXPECT_EQ(shown.rows.at(0).proxy, (ViewMm{5.5, 6.5, 7.5}));
  EXPECT_EQ(shown.lacking, std::vector<std::string_view>{"age_s"});
  const auto said = [](const fs::path& file, LogUse use) -> std::string {
    try {
      readLog(file, use);
    } catch (const FileError& error) {
      return error.what();
    }
    return "read it";
  };
  EXPECT_EQ(said(first, LogUse::replay),
            "The log \"" + first.string() +
                "\" has other columns than this version's: it has no \"age_s\".");
  const fs::path plotted =
      only("plot.csv", {"t_s", "hip_z_mm", "proxy_z_mm", "f_x_N", "f_y_N", "f_z_N"});
  EXPECT_EQ(readForceCurve(plotted).at(0).proxy_z_mm, 7.5);
  EXPECT_NE(said(plotted, LogUse::show).find("it has no \"tick\""), std::string::npos);
  EXPECT_NE(said(only("no_z.csv", {"t_s", "hip_z_mm"}), LogUse::plot).find("\"proxy_z_mm\""),
            std::string::npos);
  EXPECT_NE(said(only("no_t.csv", {"tick", "hip_z_mm"}), LogUse::plot).find("is no recording"),
            std::string::npos);
}

TEST_F(Columns, AnHdf5RecordingIsReadForWhatItsColumnsAreEnoughFor) {
  const fs::path file = written("first.h5");
  const hid_t held = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(H5Ldelete(held, "/log/age_s", H5P_DEFAULT), 0);
  H5Fclose(held);
  const LogTable shown = readLog(file, LogUse::show);
  EXPECT_EQ(shown.rows.at(0).rate_hz, 999.5);
  EXPECT_EQ(shown.lacking, std::vector<std::string_view>{"age_s"});
  EXPECT_THROW(readLog(file, LogUse::replay), FileError);
}

TEST_F(Columns, AValueThatAColumnCannotHaveNamesItsRow) {
  const std::string text = [&] {
    std::stringstream all;
    all << std::ifstream(written("a.csv")).rdbuf();
    return all.str();
  }();
  const auto with = [&](std::size_t column, const std::string& value) {
    std::string other = text;
    std::size_t at = other.find("\n0.125,") + 1;
    for (std::size_t i = 0; i < column; ++i) at = other.find(',', at) + 1;
    other.replace(at, other.find_first_of(",\n", at) - at, value);
    return write("bad.csv", other);
  };
  for (std::size_t i = 0; i < kEvent; ++i) {
    try {
      readLog(with(i, "three"));
      ADD_FAILURE() << kExpected.at(i).name;
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("cannot be read: number 1."), std::string::npos);
    }
    EXPECT_THROW(readLog(with(i, "nan"), LogUse::plot), FileError) << kExpected.at(i).name;
  }
  EXPECT_NO_THROW(readLog(with(4, "nan"))) << "a replay compares it";
  EXPECT_THROW(readLog(with(20, "7")), FileError) << "no such origin";
}

}  // namespace
}  // namespace relievo
