// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace relievo {
namespace {

constexpr std::uintptr_t kLargePage = std::uintptr_t{2} << 20;

}  // namespace

void wishLargePages(void* begin, std::size_t bytes) {
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t before = (kLargePage - address % kLargePage) % kLargePage;
  if (bytes < before + kLargePage) return;
  // A refusal (no such pages in this kernel) costs time only.
  static_cast<void>(madvise(static_cast<char*>(begin) + before,
                            (bytes - before) / kLargePage * kLargePage, MADV_HUGEPAGE));
}

}  // namespace relievo
