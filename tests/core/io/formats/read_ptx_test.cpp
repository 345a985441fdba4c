// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/core/io/file_cases.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/sample_files.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

const std::string kUnitMatrix = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
const std::string kScanner = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

std::string scanHead(int columns, int rows, const std::string& matrix = kUnitMatrix) {
  return std::to_string(columns) + "\n" + std::to_string(rows) + "\n" + kScanner + matrix;
}

/// Ten points (1 + i, i / 2, i / 4).
std::string points() {
  std::string text;
  for (int i = 0; i < 10; ++i) {
    text += std::to_string(1 + i) + " " + std::to_string(i / 2.0) + " " + std::to_string(i / 4.0) +
            " 0.5 10 20 30\n";
  }
  return text;
}

class ReadPtx : public FileCases {
 protected:
  Scan load(const std::string& content, const ImportOptions& options = {}) {
    return importScan(folder_.write("cloud.ptx", content), options);
  }
};

TEST_F(ReadPtx, PointsComeInFileOrder) {
  const Scan scan = load(scanHead(5, 2) + points());
  EXPECT_EQ(scan.info.format, "PTX");
  EXPECT_EQ(scan.info.unit, std::nullopt);
  EXPECT_TRUE(scan.info.warnings.empty());
  ASSERT_EQ(scan.points.size(), 10U);
  EXPECT_EQ(scan.point(3), (FilePoint{4, 1.5, 0.75}));
}

TEST_F(ReadPtx, EachScanIsTurnedAndMovedByItsOwnMatrix) {
  // Row vectors: (x, y, z, 1) times the matrix; x becomes y, y becomes -x.
  const std::string turned = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n600000.125 5400000.25 -7 1\n";
  const Scan scan = load(scanHead(2, 5, turned) + points() + scanHead(10, 1) + points());
  EXPECT_EQ(scan.info.points, 20U);
  ASSERT_EQ(scan.points.size(), 20U);
  EXPECT_EQ(*scan.info.bounds, (FileBounds{{1, 0, -7}, {600000.125, 5400010.25, 2.25}}));
}

TEST_F(ReadPtx, DirectionsWithoutReturnAreStoredButNotFinite) {
  const std::string moved = "1 0 0 0\n0 1 0 0\n0 0 1 0\n10 20 30 1\n";
  const Scan scan = load(scanHead(2, 2, moved) + "1 2 3 0.1\n0 0 0 0.5\n0.0 -0 0 0.5\n4 5 6 0.1\n");
  EXPECT_EQ(scan.info.points, 4U);
  EXPECT_EQ(scan.info.finite_points, 2U);
  EXPECT_EQ(*scan.info.bounds, (FileBounds{{11, 22, 33}, {14, 25, 36}}));
}

TEST_F(ReadPtx, ACutFileIsE101AndLoadsOnRequest) {
  const std::string whole = scanHead(5, 2) + points();
  const std::string cut = whole.substr(0, whole.size() - 45);  // Within the ninth row.
  const Refusal refusal = refusalOf([&] { load(cut); });
  EXPECT_EQ(refusal.code, "E101");
  EXPECT_THAT(refusal.words, HasSubstr("promises 10 points, file ends at 8"));
  ImportOptions options;
  options.accept_incomplete = true;
  EXPECT_EQ(load(cut, options).points.size(), 8U);
}

TEST_F(ReadPtx, OddFilesLoadOrAreRefused) {
  const std::string good = scanHead(5, 2) + points();
  const auto crlf = [](std::string text) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
      text.insert(at, "\r");
    }
    return text;
  };
  check({
      loads("good.txt", good, 10),
      loads("crlf.ptx", crlf(good), 10),
      loads("no_last_line_end.ptx", good.substr(0, good.size() - 1), 10),
      loads("blank_end.ptx", good + "\n\n  \n", 10),
      loads("empty_second_scan.ptx", good + scanHead(0, 7), 10),
      refused("counts_only.ptx", "2\n1\n", "promises 2 points, file ends at 0"),
      refused("cut_in_matrix.ptx", "2\n1\n" + kScanner + "1 0 0 0\n", "file ends at 0"),
      refused("cut_in_matrix_row.ptx", "2\n1\n" + kScanner + "1 0", "four numbers"),
      refused("cut_in_second_head.ptx", good + "5\n2\n0 0 0\n",
              "promises 20 points, file ends at 10"),
      refused("more_rows.ptx", good + "1 2 3 0.5\n", "number of columns"),
      refused("count_huge.ptx", "4000000000\n4000000000\n" + good.substr(4), "ends at 10"),
      refused("count_overflow.ptx", "18446744073709551615\n2\n" + good.substr(4), "can be"),
      refused("count_too_long.ptx", "99999999999999999999999\n2\n" + good.substr(4),
              "number of columns"),
      refused("zero.ptx", scanHead(0, 0), "0 points, none finite"),
      refused("no_return.ptx", scanHead(1, 2) + "0 0 0 0\n0 0 0 0\n", "2 points, none finite"),
      refused("matrix_words.ptx", scanHead(1, 1, "a b c d\n") + points(), "four numbers"),
      refused("matrix_short.ptx", scanHead(1, 1, "1 0 0\n") + points(), "four numbers"),
      refused("matrix_nan.ptx", scanHead(1, 1, "nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") + points(),
              "does not place a scan"),
      refused("matrix_zero.ptx", scanHead(1, 1, "0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 1\n") + points(),
              "does not place a scan"),
      refused("matrix_transposed.ptx",
              scanHead(1, 1, "1 0 0 5\n0 1 0 6\n0 0 1 7\n0 0 0 1\n") + points(),
              "does not place a scan"),
      refused("short_row.ptx", scanHead(1, 2) + "1 2\n3 4 5 0\n", "line 11"),
      refused("word_row.ptx", scanHead(1, 2) + "1 2 3 0\nx y z 0\n", "line 12"),
      refused("long_line.ptx", scanHead(1, 2) + "1 2 3 " + std::string(70000, '0') + "\n1 2 3\n",
              "64 kB"),
      loads("not_finite.ptx", scanHead(1, 2) + "nan 1 2 0\n1 2 3 0\n", 2),
  });
}

}  // namespace
}  // namespace relievo
