// SPDX-License-Identifier: BSD-3-Clause
// The import itself: what is no file, limits, cancel, workers that die, other locales.
#include "core/io/import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <string>
#include <variant>
#include <vector>

#include "core/io/import_input.h"
#include "core/io/input_facts.h"
#include "core/io/worker/worker_process.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

const std::string kLe = "binary_little_endian";

Refusal refusal(const std::filesystem::path& file, const ImportOptions& options = {}) {
  return refusalOf([&] { importScan(file, options); });
}

TEST(Import, WhatIsNoFileIsRefusedAtOnce) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path() / "absent.ply").words, HasSubstr("no such file"));
  EXPECT_THAT(refusal(folder.path()).words, HasSubstr("folder"));
  EXPECT_THAT(refusal(folder.write("empty.ply", "")).words, HasSubstr("empty"));
  const std::filesystem::path pipe = folder.path() / "pipe.ply";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal(pipe).words, HasSubstr("pipe or device"));
  EXPECT_THROW(inputFacts(pipe), FileError);
  std::filesystem::create_symlink("loop.ply", folder.path() / "loop.ply");
  EXPECT_THAT(refusal(folder.path() / "loop.ply").words, HasSubstr("circle"));
}

TEST(Import, LinksAreFollowedAndOddNamesWork) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("Münze \"1\"\n; rm.xyz", textRows(3));
  EXPECT_EQ(importScan(file).points.size(), 3U);
  std::filesystem::create_symlink(file, folder.path() / "-link");
  EXPECT_EQ(importScan(folder.path() / "-link").points.size(), 3U);
}

TEST(Import, OneProcessSaysWhatAFileIsAndReadsItIfItIsAScan) {
  const TemporaryFolder folder;
  const auto text = folder.write("points.xyz", textRows(3));
  const auto obj =
      folder.write("mesh.obj", "mtllib mesh.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const auto& file : {text, obj}) {
    const auto found = importInput(file);
    ASSERT_TRUE(std::holds_alternative<Scan>(found)) << file;
    EXPECT_EQ(std::get<Scan>(found).points, importScan(file).points);
    EXPECT_EQ(std::get<Scan>(found).info.file, file);
  }
  const auto grid = folder.write(
      "grid.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n");
  const auto found = importInput(grid);
  ASSERT_TRUE(std::holds_alternative<InputFacts>(found));
  EXPECT_EQ(std::get<InputFacts>(found), inputFacts(grid));
  EXPECT_THROW(importInput(folder.path() / "absent.ply"), FileError);
  const auto broken = folder.write("broken.ply", "ply\nformat odd\n");
  EXPECT_EQ(refusalOf([&] { importInput(broken); }).words, refusal(broken).words);
}

TEST(Import, AFileWithoutPermissionIsRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("a.xyz", textRows(3));
  std::filesystem::permissions(file, std::filesystem::perms::none);
  EXPECT_THAT(refusal(file).words, HasSubstr("permissions"));
}

// ---- the programs that read ----------------------------------------------------------------

/// What `program` is linked with, one library a line; and that it says something when started by
/// hand.
std::string outputOf(const std::string& command) {
  std::string text;
  FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
  text += "status " + std::to_string(WEXITSTATUS(::pclose(pipe)));
  return text;
}

const std::filesystem::path kPrograms = std::filesystem::path(RELIEVO_BINARY_DIR) / "bin";

TEST(ImportPrograms, TheOneThatReadsMostFilesLoadsNoLargeLibrary) {
  const auto libraries = [](ImportProgram program) {
    return outputOf("ldd '" + importProgram(program, kPrograms).string() + "'");
  };
  const std::string own = libraries(ImportProgram::own);
  EXPECT_THAT(own, HasSubstr("libc.so"));
  for (const char* const large : {"libvtk", "libpcl", "libboost", "libgdal", "libQt5", "libGL"}) {
    // PCL's parser of PLY is small, and needs no other library.
    const std::string others = std::regex_replace(own, std::regex(".*libpcl_io_ply[.]so.*\n"), "");
    EXPECT_THAT(others, ::testing::Not(HasSubstr(large)));
  }
  const std::string pcl = libraries(ImportProgram::pcl);
  EXPECT_THAT(pcl, HasSubstr("libpcl_io"));
  EXPECT_THAT(pcl, ::testing::Not(HasSubstr("libgdal")));
  EXPECT_THAT(libraries(ImportProgram::libraries), HasSubstr("libgdal"));
}

TEST(ImportPrograms, StartedByHandTheySaySo) {
  for (const ImportProgram program :
       {ImportProgram::own, ImportProgram::pcl, ImportProgram::libraries}) {
    const std::string file = importProgram(program, kPrograms).string();
    for (const std::string arguments : {"", " import-0 a.ply s 0 1 1 1"}) {
      EXPECT_EQ(outputOf("'" + file + "'" + arguments),
                "The import worker is started by relievo of the same version, not by hand.\n"
                "status 1");
    }
  }
}

TEST(ImportPrograms, AMissingOneIsASentence) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "bin");
  const Refusal refusal =
      refusalOf([&] { importProgram(ImportProgram::own, folder.path() / "bin"); });
  EXPECT_THAT(refusal.words, HasSubstr("relievo-import"));
  EXPECT_THAT(refusal.words, HasSubstr((folder.path() / "libexec" / "relievo").string()));
  EXPECT_THAT(refusal.words, ::testing::EndsWith("Install relievo again."));
}

// ---- limits, cancel, a worker that dies ----------------------------------------------------

TEST(Import, MorePointsThanTheLimitAreRefused) {
  const TemporaryFolder folder;
  ImportOptions five;
  five.max_points = 5;
  EXPECT_THAT(refusal(folder.write("a.xyz", textRows(10)), five).words, HasSubstr("limit"));
  EXPECT_THAT(
      refusal(folder.write("a.ply", plyHeader(kLe, "10") + binaryRows<float>(10)), five).words,
      HasSubstr("limit"));
  PcdWords binary;
  binary.data = "binary";
  EXPECT_THAT(refusal(folder.write("a.pcd", pcdHeader(binary) + binaryRows<float>(10)), five).words,
              HasSubstr("limit"));
  EXPECT_THAT(refusal(folder.write("a.stl", binaryStl(2, 2)), five).words, HasSubstr("limit"));
}

TEST(Import, AFileOfTooManyPointsIsRefusedBeforeTheyAreRead) {
  // Nearly all of it are holes of the file system; whoever read the points would need gigabytes.
  const TemporaryFolder folder;
  ImportOptions tight;
  tight.max_memory_bytes = std::uint64_t{256} << 20U;
  const auto ply = folder.write("site.ply", plyHeader(kLe, "80000000000"));
  std::filesystem::resize_file(ply, std::filesystem::file_size(ply) + 12 * 80'000'000'000ULL);
  EXPECT_THAT(refusal(ply, tight).words, HasSubstr("more than 200 000 000 points, the limit"));
  PcdWords words;
  words.data = "binary";
  words.points = "300000000";
  const auto pcd = folder.write("site.pcd", pcdHeader(words));
  std::filesystem::resize_file(pcd, std::filesystem::file_size(pcd) + 12 * 300'000'000ULL);
  EXPECT_THAT(refusal(pcd, tight).words, HasSubstr("more than 200 000 000 points, the limit"));
}

std::string manyRows() {
  std::string rows;
  const std::string block = textRows(1000);
  for (int i = 0; i < 1000; ++i) rows += block;
  return rows;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Import, MoreMemoryThanTheLimitIsRefused) {
  const TemporaryFolder folder;
  ImportOptions tight;
  tight.max_memory_bytes = 1 << 20;
  EXPECT_THAT(refusal(folder.write("a.xyz", manyRows()), tight).words, HasSubstr("memory"));
}
#endif

/// No child is left, not even as a zombie.
void expectNoChild() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(Import, CancelBeforeAndWhileReadingLeavesNoProcess) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("a.xyz", manyRows());
  for (const std::string step : {"opening", "reading points"}) {
    SCOPED_TRACE(step);
    std::stop_source source;
    Task task;
    task.stop = source.get_token();
    task.progress = [&](std::string_view now, double) {
      if (now == step) source.request_stop();
    };
    EXPECT_THROW(importScan(file, {}, task), Cancelled);
    EXPECT_TRUE(source.stop_requested());
    expectNoChild();
  }
}

TEST(Import, ProgressRisesToTheEnd) {
  const TemporaryFolder folder;
  std::vector<double> fractions;
  Task task;
  task.progress = [&](std::string_view step, double fraction) {
    EXPECT_FALSE(step.empty());
    fractions.push_back(fraction);
  };
  importScan(folder.write("a.xyz", manyRows()), {}, task);
  EXPECT_GE(fractions.size(), 2U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  expectNoChild();
}

pid_t onlyChild() {
  std::ifstream list("/proc/thread-self/children");
  pid_t pid = -1;
  list >> pid;
  return list ? pid : -1;
}

TEST(Import, AWorkerThatDiesIsASentence) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("a.xyz", manyRows());
  for (const int signal : {SIGSEGV, SIGABRT, SIGKILL, SIGXCPU, SIGBUS}) {
    SCOPED_TRACE(signal);
    bool killed = false;
    Task task;
    task.progress = [&](std::string_view step, double) {
      if (step != "reading points" || killed) return;
      const pid_t child = onlyChild();
      killed = child > 0 && ::kill(child, signal) == 0;
    };
    try {
      importScan(file, {}, task);
      if (!killed) GTEST_SKIP() << "the system does not list child processes";
      ADD_FAILURE() << "loaded";
    } catch (const FileError& error) {
      EXPECT_TRUE(killed) << error.what();
      EXPECT_THAT(error.what(), ::testing::StartsWith("Cannot read a.xyz: "));
    }
    expectNoChild();
  }
}

// ---- locale --------------------------------------------------------------------------------

/// German numbers in this process and, by the environment, offered to the worker.
class GermanNumbers {
 public:
  explicit GermanNumbers([[maybe_unused]] const TemporaryFolder& folder) {
    if (set()) return;
#if defined(__SANITIZE_ADDRESS__)
    return;  // The C library leaks a few bytes wherever LOCPATH is set.
#else
    // Not installed: made for this test where the sources of locales are.
    const std::string target = (folder.path() / "de_DE.UTF-8").string();
    const std::string command = "localedef -i de_DE -f UTF-8 '" + target + "' >/dev/null 2>&1";
    if (std::system(command.c_str()) != 0) return;
    ::setenv("LOCPATH", folder.path().c_str(), 1);
    set();
#endif
  }
  ~GermanNumbers() {
    std::setlocale(LC_ALL, "C");
    ::unsetenv("LC_ALL");
    ::unsetenv("LOCPATH");
  }
  GermanNumbers(const GermanNumbers&) = delete;
  GermanNumbers& operator=(const GermanNumbers&) = delete;

  bool on() const noexcept {
    return on_;
  }

 private:
  bool set() {
    ::setenv("LC_ALL", "de_DE.UTF-8", 1);
    on_ = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
    return on_;
  }
  bool on_ = false;
};

TEST(Import, AGermanLocaleChangesNothing) {
  const TemporaryFolder folder;
  const GermanNumbers german(folder);
  if (!german.on()) GTEST_SKIP() << "the locale de_DE.UTF-8 is neither installed nor makeable";
  ASSERT_STREQ(std::localeconv()->decimal_point, ",");
  PcdWords words;
  words.points = "2";
  const std::string rows = "0.999 0.5 0.25\n1.25 1.5 1.75\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.ply", plyHeader("ascii", "2") + rows},
      {"a.pcd", pcdHeader(words) + rows},
      {"a.obj", "v 0.999 0.5 0.25\nv 1.25 1.5 1.75\n"},
      {"a.xyz", rows},
      {"a.stl",
       "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0.999 0.5 0.25\nvertex 1.25 1.5 "
       "1.75\nvertex 1.25 0.5 0.25\nendloop\nendfacet\nendsolid s\n"},
  };
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const Scan scan = importScan(folder.write(name, content));
    EXPECT_NEAR(scan.info.bounds->min.x, 0.999, 1e-7);
    EXPECT_EQ(scan.info.bounds->max, (FilePoint{1.25, 1.5, 1.75}));
  }
}

}  // namespace
}  // namespace relievo
