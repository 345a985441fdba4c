// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace relievo {

/// Asks the system for large pages (2 MiB) under memory that is about to be written once from end
/// to end: with small ones a third of the time of such a pass is spent on first touching its pages.
/// Only a wish: where it is not granted, nothing changes. Small blocks are left alone.
void wishLargePages(void* begin, std::size_t bytes);

/// Room for `count` elements, with that wish.
template <class List>
void reserveLarge(List& list, std::size_t count) {
  list.reserve(count);
  wishLargePages(list.data(), list.capacity() * sizeof(typename List::value_type));
}

}  // namespace relievo
