// SPDX-License-Identifier: BSD-3-Clause
// The child's side of importScan.
#include "core/io/import_worker.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <clocale>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/import.h"
#include "core/io/lines.h"
#include "core/io/read_scan.h"
#include "core/io/scan_transport.h"
#include "core/io/worker_process.h"
#include "core/io/worker_sandbox.h"

namespace relievo {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kAddressSpaceIsOurs = false;  // Sanitizers reserve terabytes of it.
#else
constexpr bool kAddressSpaceIsOurs = true;
#endif

void limit(__rlimit_resource resource, std::uint64_t amount) {
  rlimit wanted{};
  if (::getrlimit(resource, &wanted) != 0) return;
  wanted.rlim_cur = std::min<rlim_t>(amount, wanted.rlim_max);
  ::setrlimit(resource, &wanted);
}

/// The file is mapped, so its size comes on top of what the reader may allocate.
void setLimits(const ImportOptions& options, ImportKind kind, std::uint64_t file_size) {
  if (kAddressSpaceIsOurs) limit(RLIMIT_AS, options.max_memory_bytes + file_size);
  // An answer in memory counts as well; writing beyond is an error, not a signal.
  ::signal(SIGXFSZ, SIG_IGN);
  if (kind != ImportKind::raster_rows) limit(RLIMIT_FSIZE, options.max_memory_bytes);
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(options.max_cpu_s)));
  limit(RLIMIT_CORE, 0);
}

/// Writes progress lines, at most every 20 ms. A full pipe loses lines rather than wait.
class ProgressPipe {
 public:
  ProgressPipe() { ::fcntl(kProgressFd, F_SETFL, O_NONBLOCK); }

  void operator()(std::string_view step, double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (step == last_step_ && now - last_ < std::chrono::milliseconds(20)) return;
    last_ = now;
    last_step_ = step;
    const std::string line = std::to_string(fraction) + " " + std::string(step) + "\n";
    [[maybe_unused]] const ssize_t written = ::write(kProgressFd, line.data(), line.size());
  }

 private:
  std::chrono::steady_clock::time_point last_;
  std::string last_step_;
};

struct WorkerArguments {
  std::filesystem::path file;
  ImportKind kind = ImportKind::scan;
  ImportOptions options;
};

std::optional<WorkerArguments> parseArguments(char** argv) {
  WorkerArguments arguments;
  arguments.file = argv[2];
  const auto max_points = parseWhole<std::uint64_t>(argv[5]);
  const auto max_memory = parseWhole<std::uint64_t>(argv[6]);
  const auto max_cpu = parseNumber(argv[7]);
  if (!max_points || !max_memory || !max_cpu || !(*max_cpu > 0)) return std::nullopt;
  arguments.kind = static_cast<ImportKind>(argv[3][0]);
  arguments.options.accept_incomplete = std::string_view(argv[4]) == "1";
  arguments.options.max_points = *max_points;
  arguments.options.max_memory_bytes = *max_memory;
  arguments.options.max_cpu_s = *max_cpu;
  arguments.options.scan.keep_withheld = std::string_view(argv[8]) == "1";
  const auto reader = parseWhole<int>(argv[9]);
  if (!reader || *reader < 0 || *reader > static_cast<int>(ReaderChoice::own)) return std::nullopt;
  arguments.options.scan.reader = static_cast<ReaderChoice>(*reader);
  std::string_view parts = argv[10];
  for (std::string_view word = takeWord(parts); !word.empty() && word != "-";
       word = takeWord(parts)) {
    const auto part = parseWhole<int>(word);
    if (!part) return std::nullopt;
    arguments.options.scan.parts.push_back(*part);
  }
  return arguments;
}

bool isWorkersPlace() {
  struct stat facts {};
  return ::fstat(kProgressFd, &facts) == 0 && S_ISFIFO(facts.st_mode) &&
         ::fstat(kAnswerFd, &facts) == 0 && S_ISREG(facts.st_mode);
}

WorkerRefusal tooLarge(const WorkerArguments& arguments) {
  return {"Cannot read " + shownName(arguments.file) + ": it needs more than " +
              grouped(arguments.options.max_memory_bytes >> 20) +
              " MB of memory. Thin it out or cut it into parts first.",
          ""};
}

void readAndAnswer(const WorkerArguments& arguments, const WorkerLibraries& libraries) {
  try {
    setLimits(arguments.options, arguments.kind, checkedFileSize(arguments.file));
    ProgressPipe pipe;
    Task task;
    task.progress = [&pipe](std::string_view step, double fraction) { pipe(step, fraction); };
    if (arguments.kind == ImportKind::scan) {
      sendAnswer(kAnswerFd, readScanHere(arguments.file, arguments.options, task, libraries.read));
    } else if (libraries.read_raster != nullptr) {
      RasterAnswer answer(kAnswerFd);
      answer.finish(libraries.read_raster(arguments.file, answer.sink(), task));
    } else {
      refuseScan(arguments.file, "this import program reads no rasters. Install relievo again.");
    }
  } catch (const Error& error) {
    sendAnswer(kAnswerFd, WorkerRefusal{error.what(), error.code});
  } catch (const std::bad_alloc&) {
    sendAnswer(kAnswerFd, tooLarge(arguments));
  } catch (const std::length_error&) {
    sendAnswer(kAnswerFd, tooLarge(arguments));
  } catch (const std::exception& error) {
    sendAnswer(kAnswerFd,
               WorkerRefusal{"Cannot read " + shownName(arguments.file) + ": its reader gave up (" +
                                 error.what() + "). The file is damaged; export it again.",
                             ""});
  }
}

}  // namespace

int runImportWorker(int argc, char** argv, const WorkerLibraries& libraries) {
  const bool called = argc == kWorkerArgumentCount && std::string_view(argv[1]) == kWorkerArgument;
  const auto arguments = called ? parseArguments(argv) : std::nullopt;
  if (!arguments || !isWorkersPlace()) {
    std::fputs("The import worker is started by relievo of the same version, not by hand.\n",
               stderr);
    return 1;
  }
  if (!dieWithParent()) return 1;
  if (!enterWorkerSandbox(kAnswerFd)) {
    // Seen only if the reader breaks down, as its last words: limits and process still stand.
    std::fputs("The kernel offers no seccomp filter; the file was read without one.\n", stderr);
  }
  std::setlocale(LC_ALL, "C");
  try {
    readAndAnswer(*arguments, libraries);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace relievo
