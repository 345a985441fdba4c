// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Before a function whose loops gain from wide vectors: compiled for several processors, the best
/// one chosen when the program starts. With -ffp-contract=off all of them give the same bits. Not
/// under a sanitizer: the choice is made before that is ready.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RELIEVO_WIDE_VECTORS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define RELIEVO_WIDE_VECTORS
#endif
