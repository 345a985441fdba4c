// SPDX-License-Identifier: BSD-3-Clause
// The child's side of importScan.
#include "core/io/worker/import_worker.h"

#include <clocale>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/pcd_header.h"
#include "core/io/formats/ply_header.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"
#include "core/io/las/las_header.h"
#include "core/io/las/las_unit.h"
#include "core/io/raster/embedded_state.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/read_scan.h"
#include "core/io/reader_choice.h"
#include "core/io/worker/facts_text.h"
#include "core/io/worker/scan_transport.h"
#include "core/io/worker/stream_worker.h"
#include "core/io/worker/worker_child.h"
#include "core/io/worker/worker_process.h"
#include "core/io/worker/worker_sandbox.h"

namespace relievo {
namespace {

/// What can be refused by the first bytes is refused here.
/// @return  the program that reads the rest
ImportProgram precheck(const std::filesystem::path& file, ReaderChoice choice) {
  const std::uint64_t size = checkedFileSize(file);
  const std::string head = readHead(file, kMaxHeaderBytes);
  const FoundFormat found = findFormat(std::string_view(head).substr(0, kSniffedBytes), file, size);
  checkReadableAsScan(found, file);
  std::string why_not;
  if (found.format == FileFormat::ply) {
    why_not = whyNotPcl(parsePlyHeader(head, file));
  } else if (found.format == FileFormat::pcd) {
    why_not = whyNotPcl(parsePcdHeader(head, file));
  } else {
    why_not = whyNotPcl(found.format);
  }
  if (usesPcl(choice, why_not, file)) {
    // PLY needs a small part of PCL, which this program has.
    return found.format == FileFormat::ply ? ImportProgram::own : ImportProgram::pcl;
  }
  // Its pictures need GDAL.
  const bool may_have_pictures =
      found.format == FileFormat::obj && head.find("mtllib ") != std::string::npos;
  return may_have_pictures ? ImportProgram::libraries : ImportProgram::own;
}

/// Of LAS files, whose readers cannot look it up.
std::optional<LasSystem> systemWithoutUnit(const std::filesystem::path& file,
                                           const ScanInfo& info) {
  const bool is_las = info.format.starts_with("LAS") || info.format.starts_with("LAZ");
  if (!is_las || info.unit) return std::nullopt;
  const std::string head = readHead(file, kLasHeadBytes);
  return lasSystem(head, parseLasHeader(head, file));
}

struct WorkerArguments {
  std::filesystem::path file;
  ImportKind kind = ImportKind::scan;
  ImportOptions options;
  std::vector<std::string> more;  ///< ImportAsk::more.
  StreamSetup stream;             ///< Of a stream.
  int last_fd = kAnswerFd;
};

std::optional<WorkerArguments> parseArguments(int argc, char** argv) {
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
  const auto every = parseWhole<std::uint64_t>(argv[11]);
  if (!every || *every < 1) return std::nullopt;
  arguments.options.scan.every = *every;
  if (std::string_view(argv[12]) != "-") {
    arguments.options.free_bytes = parseWhole<std::uint64_t>(argv[12]);
    if (!arguments.options.free_bytes) return std::nullopt;
  }
  arguments.more.assign(argv + kWorkerArgumentCount, argv + argc);
  if (arguments.kind != ImportKind::points) return arguments;
  const auto stream = streamSetupOf(arguments.more);
  if (!stream) return std::nullopt;
  arguments.stream = *stream;
  arguments.last_fd = kFirstChannelFd + stream->channels;  // That of the slices.
  return arguments;
}

/// What is only asked about is not mapped.
std::uint64_t mappedBytes(const WorkerArguments& arguments) {
  const bool is_mapped = arguments.kind != ImportKind::facts;
  return is_mapped ? checkedFileSize(arguments.file) : 0;
}

void setLimits(const WorkerArguments& arguments) {
  const ImportOptions& options = arguments.options;
  ChildLimits limits{.allocated_bytes = options.max_memory_bytes,
                     .mapped_bytes = mappedBytes(arguments),
                     .answer_bytes = options.max_memory_bytes,
                     .cpu_s = options.max_cpu_s};
  if (arguments.kind == ImportKind::raster_rows) limits.answer_bytes.reset();
  setChildLimits(limits);
}

/// What the parent is told of an error, as which it is thrown there once more.
WorkerRefusal refusalOf(const Error& error) {
  return {error.what(), error.code, error.message ? messageBytes(*error.message) : ""};
}

template <class... Reason>
WorkerRefusal cannotRead(const WorkerArguments& arguments, Reason&&... reason) {
  return refusalOf(failure<MessageId::cannot_read>(
      shownName(arguments.file),
      WordsArgument::sentences(std::vector<Message>{std::forward<Reason>(reason)...})));
}

WorkerRefusal tooLarge(const WorkerArguments& arguments) {
  return cannotRead(arguments, said<MessageId::refused_memory>(CountArgument::grouped(
                                   arguments.options.max_memory_bytes >> 20)));
}

/// The limit on files is the worker's own, or comes from outside and is smaller.
WorkerRefusal tooLong(const WorkerArguments& arguments, const AnswerTooLong& answer) {
  if (answer.mostBytes() >= arguments.options.max_memory_bytes) return tooLarge(arguments);
  return cannotRead(arguments, said<MessageId::refused_file_limit>(
                                   CountArgument::grouped(answer.mostBytes() >> 10)));
}

/// What the parent is told of the exception in flight.
WorkerRefusal refusalInFlight(const WorkerArguments& arguments) {
  try {
    throw;
  } catch (const ArgumentError& error) {
    return {error.what(), kMisuse};
  } catch (const Error& error) {
    return refusalOf(error);
  } catch (const AnswerTooLong& answer) {
    return tooLong(arguments, answer);
  } catch (const std::bad_alloc&) {
    return tooLarge(arguments);
  } catch (const std::length_error&) {
    return tooLarge(arguments);
  } catch (const std::exception& error) {
    return cannotRead(arguments, said<MessageId::refused_reader_gave_up>(printable(error.what())),
                      said<MessageId::advice_damaged_export>());
  }
}

void answerWithScan(const WorkerArguments& arguments, const WorkerLibraries& libraries,
                    const ProgressPipe& pipe, const Task& task) {
  // The program that starts soonest looks first, and says which one reads.
  if (libraries.looks_first) {
    const ImportProgram reads = precheck(arguments.file, arguments.options.scan.reader);
    if (reads != ImportProgram::own) return sendAnswer(kAnswerFd, OtherProgram{reads});
  }
  PointsAnswer points(kAnswerFd, [&pipe](std::uint64_t ready) { pipe.ready(ready); });
  Scan scan = readScanHere(arguments.file, arguments.options, task, libraries.read, &points);
  const auto system = systemWithoutUnit(arguments.file, scan.info);
  if (!system) return points.finish(scan);
  sendAnswer(kAnswerFd, ScanOfSystem{.scan = std::move(scan), .system = *system});
}

std::optional<InputFacts> factsOf(const std::filesystem::path& file) {
  try {
    return inputFactsHere(file);
  } catch (const FileError&) {  // Whoever opens it says why not.
    return std::nullopt;
  }
}

void answerWithInput(const WorkerArguments& arguments, const WorkerLibraries& libraries,
                     const ProgressPipe& pipe, const Task& task) {
  if (libraries.looks_first) {
    const std::optional<InputFacts> facts = factsOf(arguments.file);
    if (!facts || facts->kind != InputKind::scan) {
      return sendAnswer(kAnswerFd, textOf(std::vector{facts}));
    }
  }
  answerWithScan(arguments, libraries, pipe, task);
}

void answerWithFacts(const WorkerArguments& arguments) {
  std::vector<std::optional<InputFacts>> facts{factsOf(arguments.file)};
  for (const std::string& file : arguments.more) facts.push_back(factsOf(file));
  sendAnswer(kAnswerFd, textOf(facts));
}

void answerWithTiffHeads(const WorkerArguments& arguments) {
  std::vector<std::optional<TiffHead>> heads{readTiffHead(arguments.file)};
  for (const std::string& file : arguments.more) heads.push_back(readTiffHead(file));
  sendAnswer(kAnswerFd, textOf(heads));
}

void answer(const WorkerArguments& arguments, const WorkerLibraries& libraries) {
  setLimits(arguments);
  ProgressPipe pipe;
  Task task;
  task.progress = [&pipe](std::string_view step, double fraction) { pipe(step, fraction); };
  switch (arguments.kind) {
    case ImportKind::scan:
      return answerWithScan(arguments, libraries, pipe, task);
    case ImportKind::input:
      return answerWithInput(arguments, libraries, pipe, task);
    case ImportKind::facts:
      return answerWithFacts(arguments);
    case ImportKind::state:
      return sendAnswer(kAnswerFd, textOf(embeddedStateHere(arguments.file)));
    case ImportKind::tiff_heads:
      return answerWithTiffHeads(arguments);
    case ImportKind::points:
      return servePoints(arguments.file, arguments.options, arguments.stream, task,
                         [&arguments] { return refusalInFlight(arguments); });
    case ImportKind::pixels:
      if (libraries.read_pixels == nullptr) break;
      return sendAnswer(kAnswerFd, textOf(libraries.read_pixels(arguments.file)));
    case ImportKind::raster:
    case ImportKind::raster_rows:
      break;
  }
  if (arguments.kind == ImportKind::pixels || libraries.read_raster == nullptr) {
    throwReadError(arguments.file, said<MessageId::refused_no_rasters_here>());
  }
  RasterAnswer rows(kAnswerFd);
  rows.finish(libraries.read_raster(arguments.file, rows.sink(), task));
}

void readAndAnswer(const WorkerArguments& arguments, const WorkerLibraries& libraries) {
  try {
    answer(arguments, libraries);
  } catch (...) {
    sendAnswer(kAnswerFd, refusalInFlight(arguments));
  }
}

}  // namespace

int runImportWorker(int argc, char** argv, const WorkerLibraries& libraries) {
  const bool called = argc >= kWorkerArgumentCount && std::string_view(argv[1]) == kWorkerArgument;
  const auto arguments = called ? parseArguments(argc, argv) : std::nullopt;
  if (!arguments || !hasWorkersPlace({kAnswerFd})) {
    std::fputs("The import worker is started by relievo of the same version, not by hand.\n",
               stderr);
    return 1;
  }
  if (!dieWithParent()) return 1;
  if (!enterWorkerSandbox(arguments->last_fd)) {
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
