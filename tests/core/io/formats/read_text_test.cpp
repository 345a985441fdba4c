// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/io/import.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

struct TextCase {
  std::string what, content;
};

TEST(ReadText, TextInTheFormsThatProgramsWrite) {
  const TemporaryFolder folder;
  const std::vector<TextCase> cases{
      {"blanks", "1 2 3\n4.5 5 6\n"},
      {"tabs", "1\t2\t3\n4.5\t5\t6\n"},
      {"commas", "1,2,3\n4.5,5,6\n"},
      {"commas and blanks", "1, 2, 3\n4.5, 5, 6\n"},
      {"semicolons", "1;2;3\n4.5;5;6\n"},
      {"decimal commas", "1,0;2,0;3,0\n4,5;5,0;6,0\n"},
      {"decimal commas between blanks", "1,0 2,0 3,0\n4,5 5,0 6,0\n"},
      {"header", "x,y,z\n1,2,3\n4.5,5,6\n"},
      {"header with other order", "id;Z;Y;X\n1;3;2;1\n2;6;5;4.5\n"},
      {"quoted header", "\"X\",\"Y\",\"Z\",\"R\"\n1,2,3,9\n4.5,5,6,9\n"},
      {"header with units", "Z (m), X [m], Y_m, R\n3, 1, 2, 9\n6, 4.5, 5, 9\n"},
      {"header of surveyors", "Point;Northing;Easting;Elevation\n1;2;1;3\n2;5;4.5;6\n"},
      {"header of surveyors with blanks", "Northing Easting Height\n2 1 3\n5 4.5 6\n"},
      {"comments", "# made\n// X Y Z R\n1 2 3\n\n# middle\n4.5 5 6\n"},
      {"count line", "2\n1 2 3 -120\n4.5 5 6 -77\n"},
      {"colours and normals", "1 2 3 255 0 0 0 0 1\n4.5 5 6 255 0 0 0 0 1\n"},
      {"words at the end", "1 2 3 stone\n4.5 5 6 brick\n"},
      {"crlf", "1 2 3\r\n4.5 5 6\r\n"},
      {"cr", "1 2 3\r4.5 5 6\r"},
      {"byte order mark",
       "\xEF\xBB\xBF"
       "1 2 3\n4.5 5 6\n"},
      {"no last line end", "1 2 3\n4.5 5 6"},
      {"leading blanks and plus", "  1 +2 3e0\n  +4.5 5 6.\n"},
      {"exponents", "1e0 2E+0 0.3e1\n45e-1 5 6\n"},
  };
  for (const TextCase& c : cases) {
    SCOPED_TRACE(c.what);
    Scan scan;
    ASSERT_NO_THROW(scan = importScan(folder.write("a.txt", c.content)));
    ASSERT_EQ(scan.points.size(), 2U);
    EXPECT_EQ(scan.point(0), (FilePoint{1, 2, 3}));
    EXPECT_EQ(scan.point(1), (FilePoint{4.5, 5, 6}));
  }
}

TEST(ReadText, ThousandsSeparatorsAreRefusedWithTheirLine) {
  const TemporaryFolder folder;
  const auto why = [&](const std::string& content) {
    try {
      importScan(folder.write("a.xyz", content));
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  for (const char* content :
       {"1,234.5 2,345.25 12.5\n1,235.5 2,345.25 12.5\n", "1.234,5 2.345,25 12,5\n",
        "12.5 1,234,567.5 3\n", "999.5\t3,000.5\t-1,200.25\n"}) {
    EXPECT_NE(why(content).find("line 1 (\""), std::string::npos) << content << why(content);
    EXPECT_NE(why(content).find("by thousands"), std::string::npos) << content << why(content);
  }
  EXPECT_NE(why("X Y Z\n1,234.5 2,345.25 12.5\n").find("line 2"), std::string::npos);
  EXPECT_NE(why("1 2 3\n1,234.5 2,345.25 12.5\n").find("line 2"), std::string::npos);
  EXPECT_EQ(why("1,2,3,old stone wall\n4,5,6,new stone wall\n"), "read");
  EXPECT_EQ(why("1.5, 2.5, 3.5\n4.5, 5.5, 6.5\n"), "read");
}

TEST(ReadText, TextRowsWithoutAPositionAreCountedButNotPoints) {
  const TemporaryFolder folder;
  const Scan scan =
      importScan(folder.write("a.csv", "x,y,z\n1,2,3\n1,,3\nNaN,2,3\n1,2,\n-1.#IND,2,3\n4,5,6\n"));
  EXPECT_EQ(scan.info.points, 6U);
  EXPECT_EQ(scan.info.finite_points, 2U);
}

Refusal refusal(const std::filesystem::path& file) {
  return refusalOf([&] { importScan(file); });
}

TEST(ReadText, ABadTextRowIsNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.write("a.xyz", "x y z\n1 2 3\n4 five 6\n")).words,
              HasSubstr("line 3 (\"4 five 6\")"));
  EXPECT_THAT(refusal(folder.write("b.xyz", "1 2 3\n4 5\n")).words, HasSubstr("line 2"));
  EXPECT_THAT(refusal(folder.write("c.xyz", "1 2 3\nx y z\n4 5 6\n")).words, HasSubstr("line 2"));
}

}  // namespace
}  // namespace relievo
