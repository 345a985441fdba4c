// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/large_pages.h"

namespace relievo {

/// For arrays of numbers that are written from end to end right after they are made: leaves the
/// numbers of LargeArray(n) and resize(n) unset, and asks for large pages under them.
template <class T>
struct LargeAllocator {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_default_constructible_v<T>);
  using value_type = T;

  LargeAllocator() = default;
  template <class U>
  explicit LargeAllocator(const LargeAllocator<U>& /*other*/) noexcept {}

  T* allocate(std::size_t count) {
    T* const begin = std::allocator<T>().allocate(count);
    wishLargePages(begin, count * sizeof(T));
    return begin;
  }
  void deallocate(T* begin, std::size_t count) { std::allocator<T>().deallocate(begin, count); }
  void construct(T* at) noexcept { ::new (static_cast<void*>(at)) T; }
  template <class... Values>
  void construct(T* at, Values&&... values) {
    ::new (static_cast<void*>(at)) T(std::forward<Values>(values)...);
  }
  template <class U>
  bool operator==(const LargeAllocator<U>& /*other*/) const noexcept {
    return true;
  }
};

template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

}  // namespace relievo
