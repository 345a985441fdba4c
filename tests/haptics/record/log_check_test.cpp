// SPDX-License-Identifier: BSD-3-Clause
// Whatever is changed in a log, its checksums tell.
#include "core/recording/log_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/recording/log_checksum.h"
#include "haptics/record/replay.h"
#include "haptics/record/sample_log.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/record/size_limit.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using State = LogCheck::State;

constexpr const char* kHeader =
    "relievo log, schema 2\ndevice virtual (stroke)\nparameters {\"command\":[\"record\"]}\n"
    "relievo:state {\"input\":{\"sha256\":\"0123456789abcdef\"}}";
constexpr const char* kFooter = "loop ticks 900\nwork us <=0.5:2\nwindow 3 region 1,2,3,4\n";

HapticSample sampleAt(int i) {
  HapticSample sample;
  sample.tick = static_cast<std::uint64_t>(i);
  sample.hip_view = {std::sin(i), 1.0 / (i + 1), std::cos(0.1 * i)};
  sample.buttons = static_cast<std::uint32_t>(i / 100 % 4);
  sample.rate_hz = 999.5;
  sample.age_s = 0.0005;
  return sample;
}

class LogCheckTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("relievo_log_check_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path at(const std::string& name) const { return folder_ / name; }

  static void writeRows(SampleLog& log, int from, int to) {
    for (int i = from; i < to; ++i) {
      if (i == 333) log.keep("replay fault 333 timeout\n");
      log.write(sampleAt(i), i / 1000.0, i % 250 == 0 ? "happened at " + std::to_string(i) : "");
    }
  }
  /// 900 rows, a happening every 250, a line that a row needs, and how it ended.
  fs::path finished(const std::string& name, LogKind kind) const {
    const auto log = openLog(at(name), kHeader, space_.get(), kind);
    writeRows(*log, 0, 900);
    log->close(kFooter);
    return at(name);
  }
  /// The same, killed.
  fs::path killed(const std::string& name) const {
    const pid_t child = ::fork();
    if (child == 0) {
      const auto log = openLog(at(name), kHeader, space_.get(), LogKind::recording);
      writeRows(*log, 0, 900);
      ::raise(SIGKILL);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return at(name);
  }
  static std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void write(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  }
  std::size_t draw(std::size_t low, std::size_t high) {
    return std::uniform_int_distribution(low, high)(random_);
  }

  fs::path folder_;
  std::mt19937 random_{20261123};
  std::unique_ptr<HapticSpace> space_ = test::spaceOf(
      37, [](double x, double) { return std::sin(x); }, 1);
};

TEST_F(LogCheckTest, AFinishedLogIsWholeInEitherFormat) {
  for (const char* name : {"a.csv", "a.h5"}) {
    for (const LogKind kind : {LogKind::stroke, LogKind::recording}) {
      const LogCheck check = checkLog(finished(name, kind));
      EXPECT_EQ(check.state, State::whole) << name << ' ' << check.where;
      EXPECT_EQ(check.rows, 900U);
      const LogTable log = readLog(at(name));
      EXPECT_EQ(log.rows.size(), 900U);
      const std::string comments = log.header + log.footer;
      EXPECT_EQ(comments.find("sum "), std::string::npos) << "nothing of checksums is told on";
      EXPECT_EQ(comments.find("sha256,"), std::string::npos);
      EXPECT_THAT(comments, HasSubstr("loop ticks 900"));
    }
  }
  for (const std::string& footer : {std::string(), std::string(5000, 'x')}) {
    const auto log = openLog(at("b.csv"), kHeader, nullptr, LogKind::recording);
    writeRows(*log, 0, 10);
    log->close(footer);
    EXPECT_EQ(checkLog(at("b.csv")).state, State::whole) << footer.size();
  }
}

TEST_F(LogCheckTest, WhatAProgramThatIsKilledLeavesIsGoodUpToItsLastBlock) {
  for (const char* name : {"k.csv", "k.h5"}) {
    const LogCheck check = checkLog(killed(name));
    EXPECT_EQ(check.state, State::unfinished) << name << ' ' << check.where;
    EXPECT_GT(check.rows, 400U);
    EXPECT_EQ(check.rows, readLog(at(name)).rows.size());
  }
}

/// What can happen to a text, one at a time; each changes it.
using Change = std::function<std::string(std::string)>;

TEST_F(LogCheckTest, AThousandChangesOfACsvLogAreAllNoticed) {
  for (const LogKind kind : {LogKind::recording, LogKind::stroke}) {
    const std::string whole = bytesOf(finished("c.csv", kind));
    const std::size_t rows_at = whole.find("\nt_s,tick") + 1;
    const auto lineAt = [&](const std::string& text) {
      const std::size_t begin = text.rfind('\n', draw(rows_at, text.size() - 2)) + 1;
      return std::pair(begin, text.find('\n', begin) + 1);
    };
    const auto digitFrom = [&](std::string text, std::size_t from, std::size_t end) {
      const std::size_t digit = text.find_first_of("0123456789", draw(from, end - 1));
      if (digit == std::string::npos) return text + "7";
      text[digit] = text[digit] == '9' ? '0' : static_cast<char>(text[digit] + 1);
      return text;
    };
    /// Another value in a column of a row, as somebody would give it by hand.
    const auto field = [&](std::string text, std::size_t column, const std::string& value) {
      auto [begin, end] = lineAt(text);
      while (text[begin] == '#' || text[begin] == 't') std::tie(begin, end) = lineAt(text);
      for (std::size_t i = 0; i < column; ++i) begin = text.find(',', begin) + 1;
      return text.replace(begin, text.find_first_of(",\n", begin) - begin, value);
    };
    const std::vector<Change> changes{
        [&](std::string text) {
          text[draw(0, text.size() - 1)] ^= static_cast<char>(1U << draw(0, 7));
          return text;
        },
        [&](const std::string& text) { return digitFrom(text, rows_at, text.size()); },
        [&](const std::string& text) { return digitFrom(text, 0, rows_at); },
        [&](const std::string& text) { return field(text, 0, "0.12345"); },
        [&](const std::string& text) { return field(text, 21, "77"); },
        [&](const std::string& text) { return field(text, 22, "1001.25"); },
        [&](const std::string& text) { return field(text, 23, "\"forged\""); },
        [&](const std::string& text) { return field(text, 30, "0.25"); },
        [](std::string text) { return text.replace(text.find("virtual"), 7, "falcon"); },
        [](std::string text) { return text.erase(text.find("0123456789abcdef"), 16); },
        [&](const std::string& text) { return text.substr(0, lineAt(text).first); },
        [&](std::string text) {
          const auto [begin, end] = lineAt(text);
          return text.erase(begin, end - begin);
        },
        [&](std::string text) {
          const auto [begin, end] = lineAt(text);
          return text.insert(begin, text.substr(begin, end - begin));
        },
        [&](const std::string& text) { return text.substr(0, draw(rows_at, text.size() - 1)); },
        [&](std::string text) { return text.insert(draw(0, text.size()), std::string(1, '\n')); },
        [](const std::string& text) { return text + "# loop ticks 900\n"; },
        [](std::string text) { return text.erase(text.find("# checksums"), 17); },
    };
    int noticed = 0;
    constexpr int kChanges = 1000;
    for (int i = 0; i < kChanges; ++i) {
      const std::size_t which = draw(0, changes.size() - 1);
      const std::string other = changes[which](whole);
      ASSERT_NE(other, whole) << which;
      write(at("c.csv"), other);
      try {
        const LogCheck check = checkLog(at("c.csv"));
        EXPECT_EQ(check.state, State::changed) << "kind of change " << which << ", number " << i;
        EXPECT_FALSE(check.where.empty());
        noticed += check.state == State::changed ? 1 : 0;
      } catch (const FileError& error) {
        ADD_FAILURE() << error.what();
      }
    }
    EXPECT_EQ(noticed, kChanges);
    fs::remove(at("c.csv"));
  }
}

TEST_F(LogCheckTest, AThousandChangesOfAnHdf5LogAreAllNoticed) {
  const std::string whole = bytesOf(finished("c.h5", LogKind::recording));
  int noticed = 0;
  constexpr int kChanges = 1000;
  for (int i = 0; i < kChanges; ++i) {
    std::string other = whole;
    const std::size_t place = draw(0, whole.size() - 1);
    if (i % 10 == 0) {
      other.resize(place);
    } else if (i % 10 == 1) {
      other += "x";
    } else if (i % 10 == 2) {
      other[draw(0, kUserBlockBytes - 1)] ^= static_cast<char>(1U << draw(0, 7));
    } else {
      other[place] ^= static_cast<char>(1U << draw(0, 7));
    }
    write(at("c.h5"), other);
    try {
      noticed += checkLog(at("c.h5")).state == State::changed ? 1 : 0;
    } catch (const FileError&) {
      // So little is left that it is no log any more: told as that.
      ++noticed;
      EXPECT_LT(other.size(), 25U);
    }
  }
  EXPECT_EQ(noticed, kChanges);
}

/// One value of a data set, through the library as a program would change it.
template <class Value>
void alter(const fs::path& file, const char* set_name, hid_t type, std::size_t index,
           const std::function<void(Value&)>& change) {
  const hid_t held = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t set = H5Dopen2(held, set_name, H5P_DEFAULT);
  const hid_t space = H5Dget_space(set);
  std::vector<Value> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  ASSERT_LT(index, values.size());
  ASSERT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  change(values[index]);
  ASSERT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(held);
}

TEST_F(LogCheckTest, EveryColumnOfAnUnfinishedHdf5LogIsCovered) {
  const std::string left = bytesOf(killed("u.h5"));
  for (const LogColumn& column : kNumberColumns) {
    write(at("u.h5"), left);
    alter<double>(at("u.h5"), ("log/" + std::string(column.name)).c_str(), H5T_NATIVE_DOUBLE,
                  draw(0, 700), [](double& value) { value = std::nextafter(value, 1e9); });
    EXPECT_EQ(checkLog(at("u.h5")).state, State::changed) << column.name;
  }
  write(at("u.h5"), left);
  alter<float>(at("u.h5"), "surface/depth", H5T_NATIVE_FLOAT, 7, [](float& mm) { mm += 1; });
  EXPECT_EQ(checkLog(at("u.h5")).state, State::changed) << "the surface";
  for (const char* const word :
       {"virtual", "happened at 500", "replay fault", "0123456789abcdef"}) {
    // Compressed parts have no words; those are changed above by their values.
    std::string other = left;
    const std::size_t found = other.find(word);
    if (found == std::string::npos) continue;
    other[found] ^= 1;
    write(at("u.h5"), other);
    EXPECT_EQ(checkLog(at("u.h5")).state, State::changed) << word;
  }
}

TEST_F(LogCheckTest, AChangeOfAnUnfinishedCsvLogIsNoticedAndACutIsNot) {
  const std::string left = bytesOf(killed("u.csv"));
  const LogCheck before = checkLog(at("u.csv"));
  for (int i = 0; i < 300; ++i) {
    std::string other = left;
    other[draw(0, other.size() - 1)] ^= static_cast<char>(1U << draw(0, 7));
    write(at("u.csv"), other);
    EXPECT_EQ(checkLog(at("u.csv")).state, State::changed) << i;
  }
  // As a kill can leave it: within a row or a checksum.
  const std::size_t rows_at = left.find("\nt_s,tick");
  const std::size_t first_row = left.find('\n', left.find("\n# sum 0 ") + 1) + 1;
  ASSERT_GT(first_row, rows_at);
  for (int i = 0; i < 200; ++i) {
    const std::size_t cut = i == 0 ? left.size() - 10 : draw(first_row, left.size() - 1);
    write(at("u.csv"), left.substr(0, cut));
    const LogCheck check = checkLog(at("u.csv"));
    EXPECT_EQ(check.state, State::unfinished) << cut << ' ' << check.where;
    EXPECT_LT(check.rows, before.rows);
  }
}

TEST_F(LogCheckTest, TheEndOfAnotherLogIsNoticed) {
  const auto logOf = [&](const char* name, const std::string& device) {
    const auto log = openLog(at(name), "relievo log\ndevice " + device, nullptr, LogKind::stroke);
    for (int i = 0; i < 900; ++i) {
      HapticSample sample = sampleAt(i);
      sample.hip_view.y += device == "mouse" ? 1 : 0;
      log->write(sample, i / 1000.0);
    }
    log->close();
    return bytesOf(at(name));
  };
  const std::string mine = logOf("m.csv", "mouse"), other = logOf("f.csv", "virtual");
  // Whole blocks with their own checksums, and as many rows as before.
  const auto afterFirstBlock = [](const std::string& text) {
    return text.find('\n', text.find("\n# sum ") + 1) + 1;
  };
  write(at("m.csv"), mine.substr(0, afterFirstBlock(mine)) + other.substr(afterFirstBlock(other)));
  EXPECT_EQ(checkLog(at("m.csv")).state, State::changed);
}

TEST_F(LogCheckTest, LogsOfEarlierBuildsCarryNoChecksum) {
  std::string csv, line;
  std::ifstream in(finished("o.csv", LogKind::stroke));
  while (std::getline(in, line)) {
    if (!line.starts_with("# ") || !isChecksumLine(line.substr(2))) csv += line + '\n';
  }
  write(at("o.csv"), csv);
  // Without the block before it: where those of earlier builds begin.
  write(at("o.h5"), bytesOf(finished("new.h5", LogKind::stroke)).substr(kUserBlockBytes));
  for (const char* name : {"o.csv", "o.h5"}) {
    EXPECT_EQ(checkLog(at(name)).state, State::none) << name;
    EXPECT_EQ(readLog(at(name)).rows.size(), 900U);
  }
  write(at("no.csv"), "a,b\n1,2\n");
  write(at("no.h5"), "a,b\n1,2\n");
  EXPECT_THROW(checkLog(at("no.csv")), FileError);
  EXPECT_THROW(checkLog(at("no.h5")), FileError);
  EXPECT_THROW(checkLog(at("missing.csv")), FileError);
}

TEST_F(LogCheckTest, WhatAFullDiskLeftIsCoveredToItsLastRow) {
  for (const char* name : {"full.csv", "full.h5"}) {
    std::uint64_t saved = 0;
    {
      const test::SizeLimit limit(900'000);
      const auto log = openLog(at(name), kHeader, nullptr, LogKind::recording);
      EXPECT_THROW(writeRows(*log, 0, 100'000), WriteError);
      saved = log->rows();
    }
    const LogCheck check = checkLog(at(name));
    EXPECT_EQ(check.state, State::unfinished) << name << ' ' << check.where;
    EXPECT_EQ(check.rows, saved);
    EXPECT_EQ(readLog(at(name)).rows.size(), saved);
    EXPECT_GT(saved, 1000U);
  }
}

}  // namespace
}  // namespace relievo
