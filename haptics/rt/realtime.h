// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a function that runs in the haptic loop: it must not allocate, lock, do I/O, throw or log.
/// Expands to the compiler's attribute where there is one, so that a sanitizer can check the claim.
#if defined(__clang__) && defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::nonblocking)
#define RELIEVO_REALTIME noexcept [[clang::nonblocking]]
#endif
#endif
#ifndef RELIEVO_REALTIME
#define RELIEVO_REALTIME noexcept
#endif
