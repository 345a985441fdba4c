// SPDX-License-Identifier: BSD-3-Clause
// The child's side of importScan.
#include "core/io/import_worker.h"

#include <clocale>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/import.h"
#include "core/io/lines.h"
#include "core/io/read_scan.h"
#include "core/io/scan_transport.h"
#include "core/io/worker_child.h"
#include "core/io/worker_process.h"
#include "core/io/worker_sandbox.h"

namespace relievo {
namespace {

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

void setLimits(const WorkerArguments& arguments) {
  const ImportOptions& options = arguments.options;
  ChildLimits limits{.allocated_bytes = options.max_memory_bytes,
                     .mapped_bytes = checkedFileSize(arguments.file),
                     .answer_bytes = options.max_memory_bytes,
                     .cpu_s = options.max_cpu_s};
  if (arguments.kind == ImportKind::raster_rows) limits.answer_bytes.reset();
  setChildLimits(limits);
}

WorkerRefusal tooLarge(const WorkerArguments& arguments) {
  return {"Cannot read " + shownName(arguments.file) + ": it needs more than " +
              grouped(arguments.options.max_memory_bytes >> 20) +
              " MB of memory. Thin it out or cut it into parts first.",
          ""};
}

/// The limit on files is the worker's own, or comes from outside and is smaller.
WorkerRefusal tooLong(const WorkerArguments& arguments, const AnswerTooLong& answer) {
  if (answer.mostBytes() >= arguments.options.max_memory_bytes) return tooLarge(arguments);
  return {"Cannot read " + shownName(arguments.file) +
              ": what it holds is passed on as a file, and files may have no more than " +
              grouped(answer.mostBytes() >> 10) +
              " kB here (ulimit -f). Allow larger ones and try again.",
          ""};
}

void readAndAnswer(const WorkerArguments& arguments, const WorkerLibraries& libraries) {
  try {
    setLimits(arguments);
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
    sendAnswer(kAnswerFd, WorkerRefusal{error.what(), error.code,
                                        error.message ? messageBytes(*error.message) : ""});
  } catch (const AnswerTooLong& answer) {
    sendAnswer(kAnswerFd, tooLong(arguments, answer));
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
  if (!arguments || !hasWorkersPlace({kAnswerFd})) {
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
