// SPDX-License-Identifier: BSD-3-Clause
// relievo-tiles as people of clusters start it: by mpirun, some processes on one machine; and what
// becomes of its work when one of them is killed.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::CommandResult;
using test::runRelievo;

std::string bytesOfFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// How often it stands there.
int timesIn(const std::string& text, const std::string& sentence) {
  int times = 0;
  for (std::size_t at = text.find(sentence); at != std::string::npos;
       at = text.find(sentence, at + 1)) {
    ++times;
  }
  return times;
}

class TilesByMpi : public test::CommandTest {
 protected:
  void SetUp() override {
    // For who is root in a container, with fewer cores than processes.
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    ::setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);
    ::setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
    ::setenv("OMPI_MCA_hwloc_base_binding_policy", "none", 1);
  }

  /// @param words  behind the file
  std::vector<std::string> wordsFor(const std::string& map, const std::string& cells = "1200") {
    return {test::kReliefF, "--unit", "mm", "--view",  "top",      "--cells", cells,
            "--memory",     "400",    "-o", path(map), "--report", "json"};
  }
  pid_t start(int ranks, const std::vector<std::string>& words) {
    std::vector<std::string> all{"mpirun", "-q", "-n", std::to_string(ranks),
                                 std::string(RELIEVO_BINARY_DIR) + "/bin/relievo-tiles"};
    all.insert(all.end(), words.begin(), words.end());
    const pid_t child = ::fork();
    if (child != 0) return child;
    std::vector<char*> argv;
    argv.reserve(all.size() + 1);
    for (std::string& word : all) argv.push_back(word.data());
    argv.push_back(nullptr);
    ::dup2(::open(path("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    ::dup2(::open(path("err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  CommandResult ended(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            .out = bytesOfFile(path("out")),
            .err = bytesOfFile(path("err"))};
  }
  CommandResult run(int ranks, std::vector<std::string> words, const std::string& job = {}) {
    if (!job.empty()) words.insert(words.end(), {"--job", path(job)});
    return ended(start(ranks, words));
  }
  std::string bytesOfMap(const std::string& map) {
    std::string all;
    const std::string stem = path(map);
    for (const char* level : {"", ".L1", ".L2", ".L3"}) {
      for (const char* end : {".tif", ".origin.tif"}) {
        const fs::path file = stem + level + end;
        EXPECT_TRUE(fs::exists(file)) << file;
        all += bytesOfFile(file);
      }
    }
    return all;
  }
  /// What a report says of the map, without where and how it was made.
  static json factsOf(const std::string& out) {
    json report = json::parse(out);
    for (const char* key :
         {"seconds", "processes", "exchanged_bytes", "spilled_bytes", "taken_over"}) {
      EXPECT_TRUE(report.contains(key)) << key;
      report.erase(key);
    }
    for (json& level : report["levels"]) level.erase("file");
    return report;
  }
  /// Processes of `parent` that are relievo-tiles.
  static std::vector<pid_t> tilesOf(pid_t parent) {
    std::vector<pid_t> found;
    std::ifstream in("/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) +
                     "/children");
    for (pid_t child = 0; in >> child;) {
      std::error_code gone;
      const fs::path program = fs::read_symlink("/proc/" + std::to_string(child) + "/exe", gone);
      if (program.filename() == "relievo-tiles") found.push_back(child);
    }
    return found;
  }
};

TEST_F(TilesByMpi, AreTheFilesAndTheReportOfRelievo) {
  std::vector<std::string> words = wordsFor("once.tif");
  words.insert(words.begin(), "depthmap");
  const CommandResult alone = runRelievo(words);
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(json::parse(alone.out)["processes"], 1);
  const std::string once = bytesOfMap("once");
  for (const int ranks : {1, 2, 3}) {
    SCOPED_TRACE(ranks);
    const CommandResult made = run(ranks, wordsFor("map.tif"), "job");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_TRUE(bytesOfMap("map") == once);
    EXPECT_EQ(factsOf(made.out), factsOf(alone.out));
    EXPECT_EQ(json::parse(made.out)["processes"], ranks);
    EXPECT_EQ(json::parse(made.out)["exchanged_bytes"] > 0, ranks > 1);
    EXPECT_EQ(timesIn(made.err, "Heights: "), 1) << "each sentence once: " << made.err;
    EXPECT_FALSE(fs::exists(path("job")));
  }
}

TEST_F(TilesByMpi, RefuseOnceAndEndAll) {
  const CommandResult no_folder = run(3, wordsFor("map.tif"));
  EXPECT_EQ(no_folder.exit_code, 1);
  EXPECT_EQ(timesIn(no_folder.err, "Give --memory and --job as well"), 1) << no_folder.err;
  std::vector<std::string> words = wordsFor("map.tif");
  words.front() = path("nowhere.las");
  const CommandResult no_file = run(3, words, "job");
  EXPECT_EQ(no_file.exit_code, 2);
  EXPECT_EQ(timesIn(no_file.err, "nowhere.las"), 1) << no_file.err;
  const CommandResult unknown = run(2, {"--nonsense"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_EQ(timesIn(unknown.err, "FILE is required"), 1) << unknown.err;
  // Only the first writes, and only it finds this out; the others do not wait for ever.
  fs::create_directories(path("map.L1.tif"));
  const CommandResult no_place = run(3, wordsFor("map.tif"), "job");
  EXPECT_EQ(no_place.exit_code, 3) << no_place.err;
  EXPECT_EQ(timesIn(no_place.err, "map.L1.tif"), 1) << no_place.err;
  EXPECT_FALSE(fs::exists(path("map.tif")));
}

TEST_F(TilesByMpi, GoOnAfterOneWasKilledOrAllWereStopped) {
  const std::vector<std::string> words = wordsFor("map.tif", "4000");
  ASSERT_EQ(run(1, wordsFor("once.tif", "4000"), "job").exit_code, 0);
  const std::string once = bytesOfMap("once");
  struct Fault {
    int signal, exit_code;  // The second is mpirun's own.
  };
  for (const Fault& fault : {Fault{SIGKILL, 137}, Fault{SIGTERM, 1}}) {
    SCOPED_TRACE(fault.signal);
    std::vector<std::string> with_job = words;
    with_job.insert(with_job.end(), {"--job", path("job")});
    const pid_t mpirun = start(3, with_job);
    std::error_code unknown;
    const auto is_there = [&] {
      return fs::exists(path("job/heights"), unknown) &&
             !fs::is_empty(path("job/heights"), unknown);
    };
    while (!is_there() && ::waitpid(mpirun, nullptr, WNOHANG) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (fault.signal == SIGKILL) {
      const std::vector<pid_t> tiles = tilesOf(mpirun);
      ASSERT_EQ(tiles.size(), 3U);
      ::kill(tiles[1], SIGKILL);
    } else {
      ::kill(mpirun, SIGTERM);
    }
    const CommandResult stopped = ended(mpirun);
    EXPECT_EQ(stopped.exit_code, fault.exit_code) << stopped.err;
    EXPECT_FALSE(fs::exists(path("map.tif")));
    const CommandResult made = run(2, words, "job");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_GT(json::parse(made.out)["taken_over"]["rows_of_tiles"], 0);
    EXPECT_EQ(json::parse(made.out)["taken_over"]["damaged"], 0);
    EXPECT_TRUE(bytesOfMap("map") == once);
    for (const auto& entry : fs::directory_iterator(path("."))) {
      if (entry.path().filename().string().starts_with("map")) fs::remove(entry.path());
    }
  }
}

}  // namespace
}  // namespace relievo
