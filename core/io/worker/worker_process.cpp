// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/worker_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/file/own_program.h"
#include "core/file/unnamed_file.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/number_text.h"
#include "core/io/worker/worker_sandbox.h"

namespace relievo {
namespace {

constexpr int kPollMs = 50;
constexpr std::size_t kWordsKept = 4096;

OwnedFd answerFile(const std::filesystem::path& folder) {
  if (folder.empty()) return OwnedFd(raised(::memfd_create("relievo-import", MFD_CLOEXEC)));
  const OwnedFd file = unnamedFile(folder);
  if (file.get() < 0) {
    throw failure<MessageId::heights_not_kept>(printable(folder.string()), std::strerror(errno));
  }
  return OwnedFd(raised(::fcntl(file.get(), F_DUPFD_CLOEXEC, 0)));
}

/// "1 3 "; "-" for all, because an argument may not be empty.
std::string partsText(const std::vector<int>& parts) {
  std::string text;
  for (const int part : parts) text += std::to_string(part) + " ";
  return text.empty() ? "-" : text;
}

/// @param does  what is not possible without it
std::filesystem::path workerProgram(const std::filesystem::path& name, const std::string& does,
                                    const std::filesystem::path& folder) {
  if (std::filesystem::path found = programSeenFrom(folder, name); !found.empty()) return found;
  throw FileError(does + " the program " + name.string() +
                  ", which does it, is not where it was installed with relievo (" +
                  printable(placeOfPrograms(folder).string()) + "). Install relievo again.");
}

}  // namespace

std::filesystem::path importProgram(ImportProgram program, const std::filesystem::path& folder) {
  constexpr std::array<const char*, 3> kNames{"relievo-import", "relievo-import-pcl",
                                              "relievo-import-libraries"};
  return workerProgram(kNames[static_cast<std::size_t>(program)], "Files cannot be read:", folder);
}

WorkerProcess::WorkerProcess(const ImportAsk& ask) {
  const ImportOptions& options = ask.options;
  std::vector<std::string> arguments{
      kWorkerArgument,
      std::filesystem::absolute(ask.file).string(),
      std::string(1, static_cast<char>(ask.kind)),
      options.accept_incomplete ? "1" : "0",
      std::to_string(options.max_points),
      std::to_string(options.max_memory_bytes),
      roundTripText(std::array{options.max_cpu_s}),
      options.scan.keep_withheld ? "1" : "0",
      std::to_string(static_cast<int>(options.scan.reader)),
      partsText(options.scan.parts),
      std::to_string(options.scan.every),
      options.free_bytes ? std::to_string(*options.free_bytes) : "-"};
  arguments.insert(arguments.end(), ask.more.begin(), ask.more.end());
  start(importProgram(ask.program, ownFolder("Files cannot be read:")), std::move(arguments),
        answerFile(ask.answer_folder), ask.fds);
}

WorkerProcess::WorkerProcess(const WorkerStart& how) {
  OwnedFd child_input(raised(::fcntl(how.input, F_DUPFD_CLOEXEC, 0)));
  const FdForChild input{child_input.get(), kInputFd};
  start(workerProgram(how.program, how.does, ownFolder(how.does)), how.arguments, answerFile({}),
        {input}, how.more_environment);
}

void WorkerProcess::start(const std::filesystem::path& executable,
                          std::vector<std::string> arguments, OwnedFd child_answer,
                          const std::vector<FdForChild>& more,
                          std::vector<std::string> more_environment) {
  answer_.reset(raised(::fcntl(child_answer.get(), F_DUPFD_CLOEXEC, 0)));
  OwnedFd child_progress;
  OwnedFd child_words;
  makePipe(progress_, child_progress);
  makePipe(words_, child_words);
  arguments.insert(arguments.begin(), executable.filename().string());
  std::vector<FdForChild> fds{{child_words.get(), 1},
                              {child_words.get(), 2},
                              {child_progress.get(), kProgressFd},
                              {child_answer.get(), kAnswerFd}};
  fds.insert(fds.end(), more.begin(), more.end());
  child_.start({.program = executable,
                .arguments = std::move(arguments),
                .more_environment = std::move(more_environment),
                .environment = workerEnvironment(),
                .fds = std::move(fds)});
}

void WorkerProcess::passProgress(const Task& task) {
  for (std::size_t end = progress_text_.find('\n'); end != std::string::npos;
       end = progress_text_.find('\n')) {
    std::string_view step = std::string_view(progress_text_).substr(0, end);
    const std::string_view word = takeWord(step);
    if (word == kReadyWord) {
      ready_points_ = std::max(parseWhole<std::uint64_t>(trimmed(step)).value_or(0), ready_points_);
    } else if (const auto fraction = parseNumber(word)) {
      task.report(trimmed(step), std::clamp(*fraction, 0.0, 1.0));
    }
    progress_text_.erase(0, end + 1);
  }
  if (progress_text_.size() > kWordsKept) progress_text_.clear();
}

void WorkerProcess::drain(const Task& task) {
  if (progress_.get() >= 0 && !readAvailable(progress_.get(), progress_text_)) progress_.reset();
  if (words_.get() >= 0 && !readAvailable(words_.get(), words_text_)) words_.reset();
  if (words_text_.size() > kWordsKept) words_text_.erase(0, words_text_.size() - kWordsKept);
  passProgress(task);
}

void WorkerProcess::waitFor(int fd, const Task& task) {
  for (;;) {
    if (task.stop.stop_requested()) {
      child_.kill();
      task.check();
    }
    std::array<pollfd, 3> sources{pollfd{fd, POLLIN, 0}, pollfd{progress_.get(), POLLIN, 0},
                                  pollfd{words_.get(), POLLIN, 0}};
    ::poll(sources.data(), sources.size(), kPollMs);
    drain(task);
    if (sources[0].revents != 0) return;
  }
}

WorkerEnd WorkerProcess::wait(const Task& task, const TakeReady& take_ready) {
  while (!child_.reap(false)) {
    if (task.stop.stop_requested()) {
      child_.kill();
      task.check();
    }
    std::array<pollfd, 3> sources{pollfd{child_.endFd(), POLLIN, 0},
                                  pollfd{progress_.get(), POLLIN, 0},
                                  pollfd{words_.get(), POLLIN, 0}};
    // Once both are closed the child is about to end: where nothing tells that it has, a short nap
    // between looks.
    const bool closing = progress_.get() < 0 && words_.get() < 0 && child_.endFd() < 0;
    ::poll(sources.data(), sources.size(), closing ? 2 : kPollMs);
    drain(task);
    if (take_ready && ready_points_ > 0) take_ready(ready_points_);
  }
  drain(task);
  WorkerEnd end;
  end.exited = child_.exited();
  end.number = child_.number();
  end.last_words = lastPrintableLine(words_text_);
  return end;
}

}  // namespace relievo
