// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/worker_child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "core/io/worker/worker_process.h"

namespace relievo {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kAddressSpaceIsOurs = false;
#else
constexpr bool kAddressSpaceIsOurs = true;
#endif

constexpr std::chrono::milliseconds kBetweenLines{20};

void limit(__rlimit_resource resource, std::uint64_t amount) {
  rlimit wanted{};
  if (::getrlimit(resource, &wanted) != 0) return;
  wanted.rlim_cur = std::min<rlim_t>(amount, wanted.rlim_max);
  ::setrlimit(resource, &wanted);
}

bool isKind(int fd, mode_t kind) {
  struct stat facts {};
  return ::fstat(fd, &facts) == 0 && (facts.st_mode & S_IFMT) == kind;
}

}  // namespace

void setChildLimits(const ChildLimits& limits) {
  if (kAddressSpaceIsOurs) limit(RLIMIT_AS, limits.allocated_bytes + limits.mapped_bytes);
  // An answer in memory counts as well; writing beyond is an error, not a signal.
  ::signal(SIGXFSZ, SIG_IGN);
  if (limits.answer_bytes) limit(RLIMIT_FSIZE, *limits.answer_bytes);
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(limits.cpu_s)));
  limit(RLIMIT_CORE, 0);
}

ProgressPipe::ProgressPipe() {
  ::fcntl(kProgressFd, F_SETFL, O_NONBLOCK);
}

void ProgressPipe::operator()(std::string_view step, double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (step == last_step_ && now - last_ < kBetweenLines) return;
  last_ = now;
  last_step_ = step;
  const std::string line = std::to_string(fraction) + " " + std::string(step) + "\n";
  [[maybe_unused]] const ssize_t written = ::write(kProgressFd, line.data(), line.size());
}

void ProgressPipe::ready(std::uint64_t points) const {
  const std::string line = std::string(kReadyWord) + " " + std::to_string(points) + "\n";
  [[maybe_unused]] const ssize_t written = ::write(kProgressFd, line.data(), line.size());
}

bool hasWorkersPlace(std::initializer_list<int> files) {
  return isKind(kProgressFd, S_IFIFO) &&
         std::all_of(files.begin(), files.end(), [](int fd) { return isKind(fd, S_IFREG); });
}

}  // namespace relievo
