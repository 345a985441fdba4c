// SPDX-License-Identifier: BSD-3-Clause
// The child's side of prepare().
#include "core/prepare/worker.h"

#include <fcntl.h>
#include <sys/prctl.h>
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
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/lines.h"
#include "core/io/worker_process.h"
#include "core/prepare/execute.h"
#include "core/prepare/transport.h"

namespace relievo {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kAddressSpaceIsOurs = false;  // Sanitizers reserve terabytes of it.
#else
constexpr bool kAddressSpaceIsOurs = true;
#endif

constexpr int kArgumentCount = 4;

void limit(__rlimit_resource resource, std::uint64_t amount) {
  rlimit wanted{};
  if (::getrlimit(resource, &wanted) != 0) return;
  wanted.rlim_cur = std::min<rlim_t>(amount, wanted.rlim_max);
  ::setrlimit(resource, &wanted);
}

/// The job is mapped, so its size comes on top of what the steps may allocate.
void setLimits(std::uint64_t max_memory_bytes, double max_cpu_s) {
  if (kAddressSpaceIsOurs) limit(RLIMIT_AS, max_memory_bytes + jobBytes(kInputFd));
  ::signal(SIGXFSZ, SIG_IGN);
  limit(RLIMIT_FSIZE, max_memory_bytes);
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(max_cpu_s)));
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

bool isWorkersPlace() {
  struct stat facts {};
  return ::fstat(kProgressFd, &facts) == 0 && S_ISFIFO(facts.st_mode) &&
         ::fstat(kAnswerFd, &facts) == 0 && S_ISREG(facts.st_mode) &&
         ::fstat(kInputFd, &facts) == 0 && S_ISREG(facts.st_mode);
}

PrepareRefusal tooLarge(std::uint64_t max_memory_bytes) {
  return {"The scans cannot be prepared: a step needs more than " +
          grouped(max_memory_bytes >> 20U) +
          " MB of memory. Nothing was changed. Crop or thin them first, or allow more (--memory)."};
}

void workAndAnswer(std::uint64_t max_memory_bytes, const AlignFunction& align) {
  try {
    const auto received = receiveJob(kInputFd);
    if (!received) throw Error("The scans did not arrive whole. Nothing was changed. Try again.");
    ProgressPipe pipe;
    Task task;
    task.progress = [&pipe](std::string_view step, double fraction) { pipe(step, fraction); };
    sendPrepareAnswer(kAnswerFd, execute(received->job, align, task));
  } catch (const Error& error) {
    sendPrepareAnswer(kAnswerFd, PrepareRefusal{error.what()});
  } catch (const std::bad_alloc&) {
    sendPrepareAnswer(kAnswerFd, tooLarge(max_memory_bytes));
  } catch (const std::length_error&) {
    sendPrepareAnswer(kAnswerFd, tooLarge(max_memory_bytes));
  } catch (const std::exception& error) {
    sendPrepareAnswer(kAnswerFd,
                      PrepareRefusal{"The scans cannot be prepared: a library gave up (" +
                                     std::string(error.what()) + "). Nothing was changed."});
  }
}

}  // namespace

int runPrepareWorker(int argc, char** argv, const AlignFunction& align) {
  const bool called = argc == kArgumentCount && std::string_view(argv[1]) == kPrepareArgument;
  const auto memory = called ? parseWhole<std::uint64_t>(argv[2]) : std::nullopt;
  const auto cpu = called ? parseNumber(argv[3]) : std::nullopt;
  if (!memory || !cpu || !(*cpu > 0) || !isWorkersPlace()) {
    std::fputs("relievo-prepare is started by relievo of the same version, not by hand.\n", stderr);
    return 1;
  }
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() == 1) return 1;  // The parent was gone before the line above.
  std::setlocale(LC_ALL, "C");
  try {
    setLimits(*memory, *cpu);
    workAndAnswer(*memory, align);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace relievo
