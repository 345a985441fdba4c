// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <type_traits>

#include "haptics/rt/realtime.h"

namespace relievo {

/// Bounded queue between one producer and one consumer; no item is overwritten.
/// When full, push() drops the new item and counts it: the loop never waits for a consumer.
template <class T, std::size_t Capacity>
class SpscRing {
  static_assert(std::is_trivially_copyable_v<T> && std::has_single_bit(Capacity));

 public:
  SpscRing() = default;
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;

  /// [producer] false: full, the item was dropped and counted.
  bool push(const T& item) RELIEVO_REALTIME {
    const std::size_t head = head_.load(std::memory_order_relaxed);  // Ours: no one else writes it.
    // acquire: the consumer has finished reading the slot before we overwrite it.
    if (head - tail_.load(std::memory_order_acquire) == Capacity) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    items_[head % Capacity] = item;
    head_.store(head + 1, std::memory_order_release);  // The item is visible before the index.
    return true;
  }
  /// [consumer] false: empty.
  bool pop(T& item) RELIEVO_REALTIME {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);  // Ours.
    if (tail == head_.load(std::memory_order_acquire)) return false;
    item = items_[tail % Capacity];
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }
  /// [any thread] Items lost since construction.
  std::size_t dropped() const RELIEVO_REALTIME { return dropped_.load(std::memory_order_relaxed); }

  /// Memory that a real-time thread wants locked.
  const void* data() const noexcept { return items_.data(); }
  static constexpr std::size_t bytes() noexcept { return sizeof(std::array<T, Capacity>); }

 private:
  std::array<T, Capacity> items_{};
  alignas(64) std::atomic<std::size_t> head_{0};  // Written by the producer.
  alignas(64) std::atomic<std::size_t> tail_{0};  // Written by the consumer.
  alignas(64) std::atomic<std::size_t> dropped_{0};
};

}  // namespace relievo
