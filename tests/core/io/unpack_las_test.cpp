// SPDX-License-Identifier: BSD-3-Clause
// LAZ and COPC through a program of the system. Debian 12 has none, so a script stands for it.
#include "core/io/unpack_las.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/point_stream.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// A compressed file as far as its header says so.
std::string packedAs(std::string bytes) {
  bytes[104] = static_cast<char>(bytes[104] | '\x80');
  return bytes;
}

class UnpackLas : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_.path() / "bin");
    std::filesystem::create_directories(folder_.path() / "tmp");
    old_path_ = std::getenv("PATH");
    ::setenv("PATH", (folder_.path() / "bin").c_str(), 1);
    ::setenv("TMPDIR", (folder_.path() / "tmp").c_str(), 1);
    packed_ = folder_.write("scan.laz", packedAs(lasFile({})));
    plain_ = folder_.write("plain.las", lasFile({}));
  }
  void TearDown() override {
    ::setenv("PATH", old_path_.c_str(), 1);
    ::unsetenv("TMPDIR");
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "tmp")) << "something was left behind";
  }

  void install(const std::string& name, const std::string& script) const {
    const auto file = folder_.write("bin/" + name, "#!/bin/sh\nPATH=" + old_path_ + "\n" + script);
    ::chmod(file.c_str(), 0755);
  }
  std::string quoted(const std::filesystem::path& file) const { return "'" + file.string() + "'"; }

  std::string refusal() const {
    return refusalOf([&] { importScan(packed_); }).words;
  }

  TemporaryFolder folder_;
  std::string old_path_;
  std::filesystem::path packed_, plain_;
};

TEST_F(UnpackLas, WithoutAProgramTheSentenceSaysWhatToInstall) {
  EXPECT_FALSE(findLasUnpacker().has_value());
  EXPECT_THAT(refusal(),
              HasSubstr("Cannot read scan.laz: it is a compressed LAS file (LAZ or COPC)"));
  EXPECT_THAT(refusal(), HasSubstr("Install laszip or pdal"));
}

TEST_F(UnpackLas, LaszipIsCalledWithBothNamesAndItsPointsAreRead) {
  install("laszip", "[ \"$1 $3\" = \"-i -o\" ] && [ \"$2\" = " + quoted(packed_) + " ] && cat " +
                        quoted(plain_) + " > \"$4\"");
  const Scan scan = importScan(packed_);
  EXPECT_EQ(scan.points.size(), 10U);
  EXPECT_EQ(scan.info.file, packed_);
  EXPECT_EQ(scan.info.format, "LAZ 1.2 point format 0");
  EXPECT_EQ(scan.point(9), (FilePoint{9, 4.5, 2.25}));
}

TEST_F(UnpackLas, PdalKeepsScaleAndProjection) {
  install("pdal", "[ \"$1 $4\" = \"translate --writers.las.forward=all\" ] && cat " +
                      quoted(plain_) + " > \"$3\"");
  EXPECT_EQ(importScan(packed_).points.size(), 10U);
  install("laszip", "exit 1");
  EXPECT_EQ(findLasUnpacker()->kind, LasUnpacker::Kind::laszip);  // It changes nothing at all.
}

TEST_F(UnpackLas, AProgramThatFailsIsQuotedAndNothingStays) {
  install("laszip", "echo half > \"$4\"\necho 'ERROR: chunk 7 is corrupt' >&2\nexit 3");
  EXPECT_THAT(refusal(), HasSubstr("laszip cannot unpack it (\"ERROR: chunk 7 is corrupt\")"));
  install("laszip", "exit 0");
  EXPECT_THAT(refusal(), HasSubstr("laszip cannot unpack it."));
  install("laszip", "kill -SEGV $$");
  EXPECT_THAT(refusal(), HasSubstr("laszip cannot unpack it"));
  install("laszip", "echo 'no LAS file' > \"$4\"");
  EXPECT_THAT(refusal(), HasSubstr("Cannot read scan.las"));
}

TEST_F(UnpackLas, CancelEndsTheProgramAndAllItStarted) {
  const auto running = folder_.path() / "running";
  install("laszip", "echo part > \"$4\"\nsleep 600 &\necho $! > " + quoted(running) + "\nmv " +
                        quoted(running) + " " + quoted(running.string() + ".now") + "\nwait");
  std::stop_source stop;
  std::atomic<bool> cancelled{false};
  std::jthread import([&] {
    try {
      importScan(packed_, {}, {.stop = stop.get_token(), .progress = {}});
    } catch (const Cancelled&) {
      cancelled = true;
    }
  });
  while (!std::filesystem::exists(running.string() + ".now")) std::this_thread::yield();
  stop.request_stop();
  import.join();
  EXPECT_TRUE(cancelled);
  pid_t sleeper = 0;
  std::ifstream(running.string() + ".now") >> sleeper;
  ASSERT_GT(sleeper, 0);
  // It was killed, which takes the system a moment; its parent is gone, so somebody else reaps it.
  const auto ended = [sleeper] {
    std::ifstream stat("/proc/" + std::to_string(sleeper) + "/stat");
    std::string word;
    std::string state;
    return !(stat >> word >> word >> state) || state == "Z" || state == "X";
  };
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!ended() && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
  EXPECT_TRUE(ended());
}

TEST_F(UnpackLas, APointStreamReadsWhatWasUnpackedAndRemovesIt) {
  ASSERT_TRUE(PointStream::canStream(packed_));
  EXPECT_TRUE(PointStream::isPacked(packed_));
  EXPECT_FALSE(PointStream::isPacked(plain_));
  EXPECT_THAT(refusalOf([&] { const PointStream stream(packed_); }).words,
              HasSubstr("Install laszip or pdal"));
  install("laszip", "cat " + quoted(plain_) + " > \"$4\"");
  const PointStream stream(packed_);
  EXPECT_EQ(stream.info().format, "LAZ 1.2 point format 0");
  EXPECT_EQ(stream.info().file, packed_);
  ASSERT_EQ(stream.info().points, 10U);
  std::vector<FilePoint> block(3);
  ASSERT_EQ(stream.read(7, block), 3U);
  EXPECT_EQ(block[2], (FilePoint{9, 4.5, 2.25}));
}

TEST_F(UnpackLas, APointStreamStopsTheProgramWhenAsked) {
  const auto running = folder_.path() / "running";
  install("laszip", "echo part > \"$4\"\n: > " + quoted(running) + "\nsleep 600");
  std::stop_source stop;
  std::atomic<bool> cancelled{false};
  std::jthread open([&] {
    try {
      const PointStream stream(packed_, {}, {.stop = stop.get_token(), .progress = {}});
    } catch (const Cancelled&) {
      cancelled = true;
    }
  });
  while (!std::filesystem::exists(running)) std::this_thread::yield();
  stop.request_stop();
  open.join();
  EXPECT_TRUE(cancelled);
}

/// More than the head that is looked at when a stream is opened: points i, i/2, i/4.
Las longFile() {
  constexpr std::uint32_t kPoints = 200'000;
  Las las;
  las.count = kPoints;
  las.promised = las.legacy_promised = kPoints;
  return las;
}

TEST_F(UnpackLas, APointStreamReadsTheFirstPointsWhileTheLastAreUnpacked) {
  packed_ = folder_.write("scan.laz", packedAs(lasFile(longFile())));
  plain_ = folder_.write("plain.las", lasFile(longFile()));
  const auto go_on = folder_.path() / "go_on";
  install("laszip", "head -c 1500000 " + quoted(plain_) + " > \"$4\"\nwhile [ ! -e " +
                        quoted(go_on) + " ]; do sleep 0.01; done\ntail -c +1500001 " +
                        quoted(plain_) + " >> \"$4\"");
  const PointStream stream(packed_);
  ASSERT_EQ(stream.info().points, 200'000U);
  std::vector<FilePoint> block(3);
  ASSERT_EQ(stream.read(7, block), 3U);
  EXPECT_EQ(block[2], (FilePoint{9, 4.5, 2.25}));
  EXPECT_FALSE(std::filesystem::exists(go_on)) << "nobody told it to go on";
  std::jthread later([&] { std::ofstream(go_on) << "now"; });
  ASSERT_EQ(stream.read(199'997, block), 3U);
  EXPECT_EQ(block[2], (FilePoint{199'999, 99'999.5, 49'999.75}));
}

TEST_F(UnpackLas, AProgramThatFailsAfterTheFirstPointsIsQuotedToEveryReader) {
  packed_ = folder_.write("scan.laz", packedAs(lasFile(longFile())));
  plain_ = folder_.write("plain.las", lasFile(longFile()));
  install("laszip", "head -c 1500000 " + quoted(plain_) +
                        " > \"$4\"\necho 'ERROR: chunk 7 is corrupt' >&2\nexit 3");
  const PointStream stream(packed_);
  std::vector<FilePoint> block(3);
  EXPECT_EQ(stream.read(7, block), 3U);
  for (int reader = 0; reader < 2; ++reader) {
    EXPECT_THAT(refusalOf([&] { stream.read(199'997, block); }).words,
                HasSubstr("laszip cannot unpack it (\"ERROR: chunk 7 is corrupt\")"));
  }
  install("laszip", "head -c 1500000 " + quoted(plain_) + " > \"$4\"");
  const PointStream shorter(packed_);
  EXPECT_THAT(refusalOf([&] { shorter.read(199'997, block); }).words,
              HasSubstr("unpacked it has fewer points than its header says"));
  const PointStream accepted(packed_, {.accept_incomplete = true});
  EXPECT_LT(accepted.info().points, 200'000U);
  EXPECT_GT(accepted.info().points, 1000U);
}

TEST_F(UnpackLas, StoppingEndsAReaderThatWaits) {
  packed_ = folder_.write("scan.laz", packedAs(lasFile(longFile())));
  plain_ = folder_.write("plain.las", lasFile(longFile()));
  install("laszip", "head -c 1500000 " + quoted(plain_) + " > \"$4\"\nsleep 600");
  std::stop_source stop;
  const PointStream stream(packed_, {}, {.stop = stop.get_token(), .progress = {}});
  std::jthread later([&] { stop.request_stop(); });
  std::vector<FilePoint> block(3);
  EXPECT_THROW(stream.read(199'997, block), Cancelled);
}

TEST_F(UnpackLas, ProgressCountsFromThePackedFilesHeader) {
  packed_ = folder_.write("scan.laz", packedAs(lasFile(longFile())));
  plain_ = folder_.write("plain.las", lasFile(longFile()));
  const auto go_on = folder_.path() / "go_on";
  const auto half = std::filesystem::file_size(plain_) / 2;
  install("laszip", "head -c " + std::to_string(half) + " " + quoted(plain_) +
                        " > \"$4\"\nwhile [ ! -e " + quoted(go_on) +
                        " ]; do sleep 0.01; done\ncat " + quoted(plain_) + " > \"$4\"");
  double seen = 0;
  const Task task{.stop = {}, .progress = [&](std::string_view step, double fraction) {
                    if (step != "unpacking" || fraction < 0.4) return;
                    if (seen == 0) seen = fraction;
                    std::ofstream(go_on) << "now";
                  }};
  importScan(packed_, {}, task);
  EXPECT_NEAR(seen, 0.5, 1e-3);
}

TEST_F(UnpackLas, APointStreamOfWhatIsNoLasIsRefused) {
  install("laszip", "echo 'no LAS file' > \"$4\"");
  EXPECT_THAT(refusalOf([&] { const PointStream stream(packed_); }).words,
              HasSubstr("Cannot read scan.laz: what it was unpacked to is no LAS file."));
}

TEST_F(UnpackLas, RelativeFoldersOfPathAreNotTrusted) {
  install("laszip", "exit 0");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path() / "bin");
  ::setenv("PATH", ".:", 1);
  EXPECT_FALSE(findLasUnpacker().has_value());
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace relievo
