// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace relievo {
namespace {

constexpr std::uintptr_t kLargePage = std::uintptr_t{2} << 20;

}  // namespace

void wishLargePages(void* begin, std::size_t bytes) {
  const auto from = (reinterpret_cast<std::uintptr_t>(begin) + kLargePage - 1) & ~(kLargePage - 1);
  const auto to = (reinterpret_cast<std::uintptr_t>(begin) + bytes) & ~(kLargePage - 1);
  if (to <= from) return;
  // A refusal (no such pages in this kernel) costs time only.
  static_cast<void>(madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE));
}

}  // namespace relievo
