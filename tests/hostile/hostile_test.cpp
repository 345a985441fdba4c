// SPDX-License-Identifier: BSD-3-Clause
// Hostile files of every format, each with 5 s and 1 GB: none may kill, hang, take more memory, be
// accepted wrongly, or be refused without a sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"
#include "core/io/raster/raster.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/hostile/hostile_files.h"

namespace relievo {
namespace {

using namespace test;

constexpr std::uint64_t kMemory = 1ULL << 30U;
constexpr double kSeconds = 5;

/// Asks to stop after so many seconds, unless it ends before.
class Deadline {
 public:
  explicit Deadline(double seconds)
      : thread_([this, seconds](const std::stop_token& ended) {
          std::unique_lock lock(mutex_);
          const auto time = std::chrono::duration<double>(seconds);
          wake_.wait_for(lock, ended, time, [] { return false; });
          if (!ended.stop_requested()) late_.request_stop();
        }) {}
  std::stop_token token() const { return late_.get_token(); }

 private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::stop_source late_;
  std::jthread thread_;
};

struct Seen {
  std::optional<ScanInfo> info;
  std::string refusal;
};

Seen open(const std::filesystem::path& file) {
  ImportOptions options;
  options.max_memory_bytes = kMemory;
  options.max_cpu_s = kSeconds;
  // Waiting for a busy machine is no hang: the limit that counts is on processor time.
  const Deadline deadline(60);
  const Task task{.stop = deadline.token(), .progress = {}};
  try {
    if (inputFacts(file).kind == InputKind::raster)
      return {importRaster(file, options, task).info, {}};
    return {importScan(file, options, task).info, {}};
  } catch (const FileError& error) {
    return {std::nullopt, error.what()};
  }
}

void expectSentence(const std::string& words, const std::string& name) {
  EXPECT_THAT(words, ::testing::StartsWith("Cannot read " + name));
  EXPECT_THAT(words, ::testing::EndsWith("."));
  EXPECT_THAT(words, ::testing::Not(::testing::HasSubstr("broke down")));
  EXPECT_THAT(words, ::testing::Not(::testing::HasSubstr("gave up")));
  EXPECT_THAT(words, ::testing::Not(::testing::HasSubstr("processor time")));
  for (const char c : words) EXPECT_GE(static_cast<unsigned char>(c), 32) << words;
}

void expectAsWanted(const HostileFile& wanted, const std::filesystem::path& file) {
  SCOPED_TRACE(wanted.name);
  Seen seen;
  ASSERT_NO_THROW(seen = open(file));
  if (!seen.info) {
    EXPECT_NE(wanted.outcome, Outcome::loads) << seen.refusal;
    expectSentence(seen.refusal, wanted.name);
    return;
  }
  EXPECT_NE(wanted.outcome, Outcome::refused)
      << "was accepted with " << seen.info->points << " points";
  if (wanted.outcome != Outcome::loads) return;
  EXPECT_EQ(seen.info->points, wanted.points);
  EXPECT_EQ(seen.info->finite_points, wanted.finite);
}

TEST(Hostile, GoodFilesAreGood) {
  const TemporaryFolder folder;
  for (const HostileFile& file : goodFiles()) {
    expectAsWanted(file, folder.write(file.name, file.bytes));
  }
}

TEST(Hostile, EveryFileLoadsRightOrIsRefusedWithASentence) {
  const TemporaryFolder folder;
  std::set<std::string> names;
  for (const HostileFile& file : hostileFiles()) {
    EXPECT_TRUE(names.insert(file.name).second) << file.name << " comes twice";
    expectAsWanted(file, folder.write(file.name, file.bytes));
  }
  std::printf("%zu hostile files\n", names.size());
  EXPECT_GE(names.size(), 150U);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  rusage largest{};
  ::getrusage(RUSAGE_CHILDREN, &largest);
  EXPECT_LT(static_cast<std::uint64_t>(largest.ru_maxrss) * 1024, kMemory);
#endif
}

TEST(Hostile, WhatIsNoFileIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const std::filesystem::path& place = folder.path();
  std::filesystem::create_directory(place / "folder.ply");
  std::filesystem::create_symlink("circle.ply", place / "circle.ply");
  std::filesystem::create_symlink("nowhere", place / "dangling.las");
  ASSERT_EQ(::mkfifo((place / "pipe.xyz").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", place / "zero.e57");
  for (const char* const name :
       {"folder.ply", "circle.ply", "dangling.las", "pipe.xyz", "zero.e57", "missing.obj"}) {
    expectAsWanted({name, {}, Outcome::refused, 0, 0}, place / name);
  }
  const auto secret = folder.write("secret.pcd", "x");
  ::chmod(secret.c_str(), 0);
  if (::geteuid() != 0) expectAsWanted({"secret.pcd", {}, Outcome::refused, 0, 0}, secret);
}

}  // namespace
}  // namespace relievo
