// SPDX-License-Identifier: BSD-3-Clause
// The one table of columns: each names another member of a row, and the pages say the same.
#include "core/recording/log_columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <string>

#include "core/recording/force_curve.h"
#include "core/recording/force_curves.h"

namespace relievo {
namespace {

TEST(LogColumns, EveryColumnHasANameOfItsOwnAndAMemberOfItsOwn) {
  std::set<std::string_view> names;
  for (const LogColumn& column : kLogColumns) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_EQ(column.value == nullptr, column.type == ColumnType::text) << column.name;
  }
  for (const LogColumn& column : kNumberColumns) {
    TouchRow row;
    const double other = column.value(row) == 0 ? 1 : 0;
    ASSERT_TRUE(column.set_value(row, other)) << column.name;
    for (const LogColumn& one : kNumberColumns) {
      const double wanted = one.name == column.name ? other : one.value(TouchRow{});
      EXPECT_EQ(one.value(row), wanted) << one.name << " after " << column.name;
    }
  }
}

TEST(LogColumns, AMemberIsUntouchedByAValueThatItCannotHave) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const LogColumn& column : kNumberColumns) {
    TouchRow row;
    if (column.type == ColumnType::real) {
      EXPECT_TRUE(column.set_value(row, kNan)) << "a replay compares it to the last bit";
      EXPECT_TRUE(std::isnan(column.value(row))) << column.name;
      continue;
    }
    for (const double value : {kNan, 0.5, -3e9, 1e300, std::numeric_limits<double>::infinity()}) {
      EXPECT_FALSE(column.set_value(row, value)) << column.name << " " << value;
    }
    EXPECT_EQ(row, TouchRow{}) << column.name;
  }
  TouchRow row;
  const auto set = [&](std::string_view name, double value) {
    for (const LogColumn& column : kNumberColumns) {
      if (column.name == name) return column.set_value(row, value);
    }
    return false;
  };
  EXPECT_TRUE(set("origin", 4));
  EXPECT_FALSE(set("origin", 5));
  EXPECT_TRUE(set("contact", 1));
  EXPECT_FALSE(set("contact", 2));
  EXPECT_TRUE(set("buttons", 4294967295.0));
  EXPECT_FALSE(set("buttons", 4294967296.0));
  EXPECT_TRUE(set("tick", 9007199254740992.0));
  EXPECT_FALSE(set("tick", 9007199254740994.0)) << "not every integer is exact there";
}

/// The plots show what recordings hold, in the unit of their strip.
TEST(ForceCurves, ShowColumnsOfRecordings) {
  TouchRow row;
  row.hip = {1, 2, 3};
  row.proxy = {4, 5, 6};
  row.force = {0, 3, -4};
  const ForcePoint point = forcePoint(row);
  std::set<std::string_view> names;
  int columns = 0;
  for (const ForceCurve& curve : kForceCurves) {
    EXPECT_TRUE(names.insert(curve.column).second) << curve.column;
    const std::string_view unit = curve.strip == ForceStrip::heights ? "mm" : "N";
    EXPECT_TRUE(curve.column.ends_with(unit)) << curve.column;
    for (const LogColumn& column : kLogColumns) {
      if (column.name != curve.column) continue;
      ++columns;
      EXPECT_EQ(column.unit, unit) << curve.column;
      EXPECT_EQ(point.*curve.value, column.value(row)) << curve.column;
    }
  }
  EXPECT_EQ(columns, 2) << "hand and proxy; the force is the norm of three columns";
  EXPECT_EQ(point.force_n, 5);
}

/// The table of docs/user/reference.md has the same rows in the same order.
TEST(LogColumns, TheReferenceListsThemAsTheyAre) {
  std::ifstream in(std::string(RELIEVO_SOURCE_DIR) + "/docs/user/reference.md");
  ASSERT_TRUE(in);
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(in, line) && line != "| Column | Unit | Holds |") continue;
  std::getline(in, line);  // The line below the titles.
  while (std::getline(in, line) && line.starts_with("| `")) rows.push_back(line);
  ASSERT_EQ(rows.size(), kLogColumns.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LogColumn& column = kLogColumns.at(i);
    const std::string unit(column.type == ColumnType::text ? "text" : column.unit);
    EXPECT_EQ(rows[i], "| `" + std::string(column.name) + "` | " + unit + " | " +
                           std::string(column.description) + " |");
  }
}

}  // namespace
}  // namespace relievo
