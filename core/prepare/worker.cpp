// SPDX-License-Identifier: BSD-3-Clause
// The child's side of prepare().
#include "core/prepare/worker.h"

#include <clocale>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/worker/worker_child.h"
#include "core/io/worker/worker_process.h"
#include "core/io/worker/worker_sandbox.h"
#include "core/prepare/execute.h"
#include "core/prepare/transport.h"

namespace relievo {
namespace {

constexpr int kArgumentCount = 4;

PrepareRefusal tooLarge(std::uint64_t max_memory_bytes) {
  return {said<MessageId::prepare_needs_memory>(CountArgument::grouped(max_memory_bytes >> 20U))};
}

void workAndAnswer(std::uint64_t max_memory_bytes, const AlignFunction& align) {
  try {
    const auto received = receiveJob(kInputFd);
    if (!received) throw Error(said<MessageId::scans_did_not_arrive>());
    ProgressPipe pipe;
    Task task;
    task.progress = [&pipe](std::string_view step, double fraction) { pipe(step, fraction); };
    sendPrepareAnswer(kAnswerFd, execute(received->job, align, task));
  } catch (const Error& error) {
    sendPrepareAnswer(kAnswerFd, PrepareRefusal{messageOf(error)});
  } catch (const std::bad_alloc&) {
    sendPrepareAnswer(kAnswerFd, tooLarge(max_memory_bytes));
  } catch (const std::length_error&) {
    sendPrepareAnswer(kAnswerFd, tooLarge(max_memory_bytes));
  } catch (const std::exception& error) {
    sendPrepareAnswer(kAnswerFd,
                      PrepareRefusal{said<MessageId::prepare_library_gave_up>(error.what())});
  }
}

}  // namespace

int runPrepareWorker(int argc, char** argv, const AlignFunction& align) {
  const bool called = argc == kArgumentCount && std::string_view(argv[1]) == kPrepareArgument;
  const auto memory = called ? parseWhole<std::uint64_t>(argv[2]) : std::nullopt;
  const auto cpu = called ? parseNumber(argv[3]) : std::nullopt;
  if (!memory || !cpu || !(*cpu > 0) || !hasWorkersPlace({kAnswerFd, kInputFd})) {
    std::fputs("relievo-prepare is started by relievo of the same version, not by hand.\n", stderr);
    return 1;
  }
  if (!dieWithParent()) return 1;
  if (!enterWorkerSandbox(kInputFd)) {
    // Seen only if the work breaks down, as its last words: limits and process still stand.
    std::fputs("The kernel offers no seccomp filter; the scans were prepared without one.\n",
               stderr);
  }
  std::setlocale(LC_ALL, "C");
  try {
    setChildLimits({.allocated_bytes = *memory,
                    .mapped_bytes = jobBytes(kInputFd),
                    .answer_bytes = *memory,
                    .cpu_s = *cpu});
    workAndAnswer(*memory, align);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace relievo
