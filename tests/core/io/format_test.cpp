// SPDX-License-Identifier: BSD-3-Clause
// One table names the formats: who opens a file, and who is told that it cannot be opened, hears of
// the same ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "core/base/error.h"
#include "core/io/format.h"

namespace relievo {
namespace {

using ::testing::HasSubstr;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

TEST(FormatList, NamesScansAndNoRasters) {
  const std::string list = " " + scanFormatList(" ") + " ";
  for (const char* name : {"PLY", "PCD", "OBJ", "STL", "3DS", "LAS", "LAZ", "E57", "PTX", "XYZ"}) {
    EXPECT_THAT(list, HasSubstr(std::string(" ") + name + " "));
  }
  EXPECT_EQ(list.find("TIF"), std::string::npos) << list;
  EXPECT_EQ(list.find("PNG"), std::string::npos) << list;
}

TEST(FormatList, HasWhatIsOfferedButForRasters) {
  const std::string list = " " + lower(scanFormatList(" ")) + " ";
  for (const std::string_view ending : offeredEndings()) {
    const bool is_raster = ending.starts_with("tif");
    EXPECT_EQ(list.find(" " + std::string(ending) + " ") == std::string::npos, is_raster) << ending;
  }
}

TEST(FormatList, IsWhatARefusalOffers) {
  try {
    checkReadableAsScan({FileFormat::other, "a PDF document"}, "paper.pdf");
    FAIL() << "a PDF was taken for a scan";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("it is a PDF document"));
    EXPECT_THAT(error.what(), HasSubstr(scanFormatList()));
  }
}

}  // namespace
}  // namespace relievo
