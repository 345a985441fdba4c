// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "haptics/rt/realtime.h"

namespace relievo {

/// Newest-value mailbox between one writer thread and one reader thread.
/// Wait-free on both sides; values live inside, so nobody allocates or frees. Intermediate
/// values may be skipped: use SpscRing where every item counts.
template <class T>
class TripleBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  TripleBuffer() = default;
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  /// [writer] Slot to fill; private to the writer until publish(). Its old content is unspecified.
  T& back() RELIEVO_REALTIME { return slots_[write_]; }
  /// [writer] Hands the slot over.
  void publish() RELIEVO_REALTIME {
    // acq_rel: our writes become visible, and the slot that comes back is no longer being read.
    write_ = shared_.exchange(write_ | kFresh, std::memory_order_acq_rel) & kIndex;
  }
  /// [writer] Both in one call.
  void write(const T& value) RELIEVO_REALTIME {
    back() = value;
    publish();
  }
  /// [reader] Takes the newest slot if there is one; returns whether the value changed.
  bool update() RELIEVO_REALTIME {
    // relaxed: only a hint; the exchange below orders the data.
    if ((shared_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    read_ = shared_.exchange(read_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  /// [reader] Valid until the next update().
  const T& front() const RELIEVO_REALTIME { return slots_[read_]; }

  /// Memory that a real-time thread wants locked.
  const void* data() const noexcept { return slots_.data(); }
  static constexpr std::size_t bytes() noexcept { return sizeof(std::array<T, 3>); }

 private:
  static constexpr std::uint32_t kIndex = 3, kFresh = 4;
  std::array<T, 3> slots_{};
  alignas(64) std::uint32_t write_ = 0;               // Writer only.
  alignas(64) std::uint32_t read_ = 1;                // Reader only.
  alignas(64) std::atomic<std::uint32_t> shared_{2};  // The slot nobody holds.
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
};

}  // namespace relievo
