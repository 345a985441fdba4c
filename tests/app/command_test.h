// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/app/command.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo::test {

inline const std::string kReliefF = RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply";
inline const std::string kFlatStroke = RELIEVO_SOURCE_DIR "/data/strokes/flat.csv";
inline const std::string kCurvedStroke = RELIEVO_SOURCE_DIR "/data/strokes/curved.csv";

/// Words of a command line, and more of them.
inline std::vector<std::string> joined(std::vector<std::string> words,
                                       const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// What `--report json` of a command that succeeded says.
inline nlohmann::json reportOf(const CommandResult& result) {
  EXPECT_EQ(result.exit_code, 0) << result.err;
  nlohmann::json report = nlohmann::json::parse(result.out, nullptr, false);
  EXPECT_FALSE(report.is_discarded()) << result.out;
  return report;
}

inline std::string bytesOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A test that runs the built program, in a folder of its own.
class CommandTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, std::string_view text) const {
    return folder_.write(name, text).string();
  }
  /// A plane z = 5 + x/10 as text, 101 x 101 points, 1 mm apart.
  std::string plane() const {
    std::ostringstream text;
    for (int y = 0; y <= 100; ++y) {
      for (int x = 0; x <= 100; ++x) text << x << ' ' << y << ' ' << 5 + x / 10.0 << '\n';
    }
    return write("plane.xyz", text.str());
  }

  TemporaryFolder folder_;
};

}  // namespace relievo::test
