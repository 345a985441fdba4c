// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

// What every child process of ours does for itself, whatever its work is.

/// Most that a child may take of each; more is bad_alloc, an error of write(), or its end.
struct ChildLimits {
  std::uint64_t allocated_bytes = 0;
  std::uint64_t mapped_bytes = 0;  ///< Of the file or job it reads: on top of the others.
  std::optional<std::uint64_t> answer_bytes;  ///< Nothing: an answer of any size.
  double cpu_s = 0;
};

/// From here on and for good; no core file either. Sanitizers reserve terabytes of addresses, so
/// that builds with one do not limit memory.
void setChildLimits(const ChildLimits& limits);

/// Writes progress lines for the parent, at most every 20 ms. A full pipe loses lines rather than
/// wait. One thread at a time.
class ProgressPipe {
 public:
  /// The pipe at kProgressFd.
  ProgressPipe();
  void operator()(std::string_view step, double fraction);
  /// At once: so many points of the answer are ready.
  void ready(std::uint64_t points) const;

 private:
  std::chrono::steady_clock::time_point last_;
  std::string last_step_;
};

/// A pipe for progress at its descriptor, and files at all others that are named: a child that
/// somebody starts by hand has none.
bool hasWorkersPlace(std::initializer_list<int> files);

}  // namespace relievo
