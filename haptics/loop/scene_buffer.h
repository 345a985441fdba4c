// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

#include "haptics/rt/realtime.h"

namespace relievo {

/// Newest-value mailbox like TripleBuffer whose reader keeps the value before as well: while one
/// surface turns into the next the loop needs both. Wait-free on both sides.
template <class T>
class SceneBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  SceneBuffer() = default;
  SceneBuffer(const SceneBuffer&) = delete;
  SceneBuffer& operator=(const SceneBuffer&) = delete;

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
  /// [reader] Takes the newest slot if there is one: front() becomes previous(), and what was
  /// previous() goes back to the writer. @return whether the value changed
  bool update() RELIEVO_REALTIME {
    // relaxed: only a hint; the exchange below orders the data.
    if ((shared_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    const std::uint32_t newest = shared_.exchange(previous_, std::memory_order_acq_rel) & kIndex;
    previous_ = read_;
    read_ = newest;
    return true;
  }
  /// [reader] Valid until the next update().
  const T& front() const RELIEVO_REALTIME { return slots_[read_]; }
  /// [reader] What front() was before the last update(). Valid until the next one.
  const T& previous() const RELIEVO_REALTIME { return slots_[previous_]; }

 private:
  static constexpr std::uint32_t kIndex = 3, kFresh = 4;
  std::array<T, 4> slots_{};
  alignas(64) std::uint32_t write_ = 0;  // Writer only.
  alignas(64) std::uint32_t read_ = 1;   // Reader only, with the next.
  std::uint32_t previous_ = 2;
  alignas(64) std::atomic<std::uint32_t> shared_{3};  // The slot nobody holds.
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
};

}  // namespace relievo
