// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/import_answer.h"

#include <csignal>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/read_scan.h"

namespace relievo {

void refuseEnd(const std::filesystem::path& file, const ImportOptions& options,
               const WorkerEnd& end) {
  if (!end.exited && end.number == SIGXCPU) {
    throwReadError(file, said<MessageId::refused_processor_time>(CountArgument::grouped(
                             static_cast<std::uint64_t>(options.max_cpu_s))));
  }
  if (!end.exited && end.number == SIGBUS) {
    throw failure<MessageId::file_became_shorter>(shownName(file));
  }
  if (!end.exited && end.number == SIGKILL) {
    throw failure<MessageId::import_stopped_by_system>(shownName(file));
  }
  if (end.last_words.empty()) throwReadError(file, said<MessageId::refused_reader_broke>());
  throwReadError(file, said<MessageId::refused_reader_broke_saying>(printable(end.last_words)));
}

void throwRefusal(const WorkerRefusal& refusal) {
  if (refusal.code == kMisuse) throw ArgumentError(refusal.message);
  if (const auto message = messageFromBytes(refusal.of_catalogue)) throw FileError(*message);
  throw FileError(refusal.message, refusal.code);
}

WorkerAnswer importAnswer(ImportAsk ask, const Task& task) {
  task.report("opening", 0);
  for (bool is_first = true;; is_first = false) {
    WorkerProcess worker(ask);
    PointsAhead ahead(worker.answerFd());
    const WorkerEnd end = worker.wait(task, [&](std::uint64_t ready) { ahead.take(ready, task); });
    task.check();
    WorkerAnswer answer;
    if (end.exited && end.number == 0) {
      answer = receiveAnswer(worker.answerFd(), task, std::move(ahead));
    }
    if (const auto* refusal = std::get_if<WorkerRefusal>(&answer)) throwRefusal(*refusal);
    const auto* other = std::get_if<OtherProgram>(&answer);
    if (std::holds_alternative<std::monostate>(answer) || (other != nullptr && !is_first)) {
      refuseEnd(ask.file, ask.options, end);
    }
    if (other == nullptr) return answer;
    ask.program = other->program;
  }
}

}  // namespace relievo
