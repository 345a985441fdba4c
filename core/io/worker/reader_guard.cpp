// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/reader_guard.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace relievo {
namespace {

std::atomic<bool>& isForbidden() noexcept {
  static std::atomic<bool> forbidden{false};
  return forbidden;
}

}  // namespace

void forbidReaders() noexcept {
  isForbidden().store(true);
}

void requireReadersAllowed(const char* reader) noexcept {
  if (!isForbidden().load(std::memory_order_relaxed)) return;
  std::fprintf(stderr, "relievo: the reader %s was called outside of the import programs.\n",
               reader);
  std::abort();
}

}  // namespace relievo
