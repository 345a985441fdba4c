// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/task.h"
#include "core/file/owned_fd.h"
#include "core/io/import.h"
#include "core/io/worker/spawn.h"

namespace relievo {

// What parent and child agree on.
inline constexpr const char* kWorkerArgument = "import-" RELIEVO_VERSION_STRING;
inline constexpr int kProgressFd = 3;            ///< Lines "fraction step", or "ready N".
inline constexpr int kAnswerFd = 4;              ///< scan_transport.h
inline constexpr int kInputFd = 5;               ///< What a worker without a file works on.
inline constexpr int kFirstChannelFd = 5;        ///< Of a stream (stream_protocol.h).
inline constexpr int kWorkerArgumentCount = 13;  ///< And those of ImportAsk::more.
/// So many points of the answer are where they belong, and stay as they are if it is a scan.
inline constexpr std::string_view kReadyWord = "ready";

/// What the worker is to answer with: its third argument.
enum class ImportKind : char {
  scan = 's',
  input = 'i',  ///< The scan, or of a file that is none its InputFacts.
  raster = 'r',
  raster_rows = 'R',
  facts = 'f',       ///< InputFacts.
  tiff_heads = 't',  ///< Of the file, and of those that `more` names.
  state = 'e',       ///< embeddedState.
  points = 'p',      ///< PointStream.
  pixels = 'x',      ///< StoredPixels; of the program with GDAL.
};

/// Which program reads: `own` starts in a few milliseconds, because it loads none of the large
/// libraries; `pcl` has PCL, `libraries` GDAL.
enum class ImportProgram { own, pcl, libraries };

/// Where that program is, seen from the folder of the running one.
/// @throw FileError  nowhere it should be; there is no other way to read
std::filesystem::path importProgram(ImportProgram program, const std::filesystem::path& folder);

/// A worker that is handed its input as an open file, not by name.
struct WorkerStart {
  std::string program;                 ///< Its name alone; it lies where the import programs do.
  std::vector<std::string> arguments;  ///< After its name.
  int input = -1;                      ///< Ours; kInputFd in the child.
  std::string does = "The scans cannot be prepared:";  ///< What is not possible without it.
  std::vector<std::string> more_environment = {};      ///< Beyond workerEnvironment.
};

/// What an import program is asked for.
struct ImportAsk {
  ImportProgram program = ImportProgram::own;
  std::filesystem::path file;
  ImportKind kind = ImportKind::scan;
  ImportOptions options = {};
  /// Where the answer is a file without a name; empty: it is in memory.
  std::filesystem::path answer_folder = {};
  std::vector<std::string> more = {};
  std::vector<FdForChild> fds = {};  ///< From kFirstChannelFd on.
};

/// How the child came to its end.
struct WorkerEnd {
  bool exited = false;     ///< Else a signal killed it.
  int number = 0;          ///< Exit status or signal.
  std::string last_words;  ///< Last printable line it wrote.
};

/// An import worker: its standard output and error are caught, its memory file and progress pipe
/// open. Killed and reaped by the destructor, if still running.
class WorkerProcess {
 public:
  /// @throw FileError  the program is missing, or the system refuses a further process
  explicit WorkerProcess(const ImportAsk& ask);
  /// Its answer is in memory. @throw FileError  as above
  explicit WorkerProcess(const WorkerStart& start);
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Told how many points are ready, while the child goes on; never fewer than before.
  using TakeReady = std::function<void(std::uint64_t points)>;

  /// Passes progress on until the child has ended. Looks at the stop token every 50 ms.
  /// @throw Cancelled  after the child was killed and reaped
  WorkerEnd wait(const Task& task, const TakeReady& take_ready = {});

  /// The same until there is something to read from `fd`, or its other end is closed.
  /// @throw Cancelled  after the child was killed and reaped
  void waitFor(int fd, const Task& task);

  int answerFd() const noexcept { return answer_.get(); }

 private:
  void start(const std::filesystem::path& executable, std::vector<std::string> arguments,
             OwnedFd child_answer, const std::vector<FdForChild>& more,
             std::vector<std::string> more_environment = {});
  void drain(const Task& task);
  void passProgress(const Task& task);

  OwnedFd answer_, progress_, words_;  ///< Our ends.
  ChildProcess child_;
  std::string progress_text_, words_text_;
  std::uint64_t ready_points_ = 0;  ///< As the child says.
};

}  // namespace relievo
