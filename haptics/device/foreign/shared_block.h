// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "haptics/rt/realtime.h"

namespace relievo::foreign {

/// The newest value between one writer and one reader in two processes, neither of which trusts the
/// other: a sequence lock of words. Whatever the other side writes here, nobody waits, and nobody
/// leaves the block, as with an index of slots (TripleBuffer) that a broken process wrote.
/// Without fences, so that a thread sanitizer understands it.
template <class T>
class SharedBlock {
  static_assert(std::is_trivially_copyable_v<T>);
  using Word = std::atomic<std::uint64_t>;
  static_assert(Word::is_always_lock_free);

 public:
  /// [writer]
  void write(const T& value) RELIEVO_REALTIME {
    std::array<std::uint64_t, kWords> words{};
    std::memcpy(words.data(), &value, sizeof(T));
    const std::uint64_t before = sequence_.load(std::memory_order_relaxed) & ~std::uint64_t{1};
    sequence_.store(before + 1, std::memory_order_relaxed);
    // release: whoever sees one of these words sees the odd number above.
    for (std::size_t i = 0; i < kWords; ++i) words_[i].store(words[i], std::memory_order_release);
    sequence_.store(before + 2, std::memory_order_release);
  }
  /// [reader] @return false: nothing was written yet, or it is being written; `value` is as before
  bool read(T& value) const RELIEVO_REALTIME {
    constexpr int kTries = 4;
    for (int i = 0; i < kTries; ++i) {
      std::array<std::uint64_t, kWords> words{};
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      for (std::size_t k = 0; k < kWords; ++k) words[k] = words_[k].load(std::memory_order_acquire);
      const std::uint64_t after = sequence_.load(std::memory_order_relaxed);
      if (before != after || before == 0 || (before & 1U) != 0) continue;
      std::memcpy(static_cast<void*>(&value), words.data(), sizeof(T));
      return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;
  Word sequence_{0};
  std::array<Word, kWords> words_{};
};

}  // namespace relievo::foreign
