// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/message/message.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo::test {

/// What a file must come to: a number of points, or a refusal that holds these words.
struct Case {
  std::string file;
  std::string content;
  int points = -1;
  std::string refusal;
};

inline Case loads(const std::string& file, const std::string& content, int points) {
  return {file, content, points, {}};
}
inline Case refused(const std::string& file, const std::string& content, const std::string& words) {
  return {file, content, -1, words};
}

/// Writes each file and imports it.
class FileCases : public ::testing::Test {
 protected:
  void check(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      SCOPED_TRACE(c.file);
      const std::filesystem::path file = folder_.write(c.file, c.content);
      try {
        const Scan scan = importScan(file);
        EXPECT_EQ(static_cast<int>(scan.info.points), c.points) << "wanted: " << c.refusal;
        for (const auto& triangle : scan.triangles) {
          for (const std::uint32_t corner : triangle) EXPECT_LT(corner, scan.points.size());
        }
      } catch (const FileError& error) {
        EXPECT_EQ(c.points, -1) << error.what();
        ASSERT_TRUE(error.message) << "no sentence of the catalogue: " << error.what();
        EXPECT_EQ(englishText(*error.message), error.what());
        EXPECT_THAT(error.what(), ::testing::HasSubstr(c.refusal));
        EXPECT_THAT(error.what(), ::testing::HasSubstr(c.file));
        EXPECT_THAT(error.what(), ::testing::Not(::testing::HasSubstr("broke down")));
        const std::string_view words = error.what();
        EXPECT_TRUE(std::none_of(words.begin(), words.end(), [](char letter) {
          return static_cast<unsigned char>(letter) < 32;
        })) << words;
      }
    }
  }

  TemporaryFolder folder_;
};

}  // namespace relievo::test
