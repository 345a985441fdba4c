// SPDX-License-Identifier: BSD-3-Clause
// Counts what a plug-in allocates: the program's own malloc comes before the C library's, for
// libraries that are loaded later, too. Sanitizers have theirs.
#include <cstddef>

#include "haptics/device/foreign/host/check.h"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {
/// Of each thread alone: what a library does beside the one that steps is its own business. Of the
/// program itself, so that its first use allocates nothing.
constinit thread_local long allocated = 0;
}  // namespace

// NOLINTBEGIN(*-reserved-identifier,readability-identifier-naming): the C library's names.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);

void* malloc(std::size_t size) {
  ++allocated;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocated;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  ++allocated;
  return __libc_realloc(memory, size);
}
}
// NOLINTEND(*-reserved-identifier,readability-identifier-naming)

namespace relievo::foreign {
long allocations() noexcept {
  return allocated;
}
}  // namespace relievo::foreign

#else

namespace relievo::foreign {
long allocations() noexcept {
  return -1;
}
}  // namespace relievo::foreign

#endif
