// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>

namespace relievo::test {

/// The same to the bit, also NaN. @param a, b  vectors of what has no padding
template <class List>
bool sameBytes(const List& a, const List& b) {
  return a.size() == b.size() &&
         (a.empty() ||
          std::memcmp(a.data(), b.data(), a.size() * sizeof(typename List::value_type)) == 0);
}

}  // namespace relievo::test
