// SPDX-License-Identifier: BSD-3-Clause
// Items of version 1 (LASzip of 2010 and 2011) in the other direction, for tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "tests/core/io/laz_coder.h"

namespace relievo::test {

template <class T>
T numberOf(const char* at) {
  T number;
  std::memcpy(&number, at, sizeof(T));  // Tests run on little-endian machines.
  return number;
}
inline std::uint32_t byteAt(const char* at) {
  return static_cast<unsigned char>(*at);
}

class FirstPointCoder {
 public:
  void code(ArithmeticCoder& coder, const char* old, const char* now) {
    const auto step = [&](int at) {
      return numberOf<std::uint32_t>(now + at) - numberOf<std::uint32_t>(old + at);
    };
    dx_.code(coder, middle(x_steps_), step(0), 0);
    dy_.code(coder, middle(y_steps_), step(4), std::min(dx_.k(), 19U));
    const unsigned k = (dx_.k() + dy_.k()) / 2;
    z_.code(coder, numberOf<std::uint32_t>(old + 8), numberOf<std::uint32_t>(now + 8),
            std::min(k, 19U));
    x_steps_.push_back(static_cast<std::int32_t>(step(0)));
    y_steps_.push_back(static_cast<std::int32_t>(step(4)));
    const auto differs = [&](std::size_t at, std::size_t count) {
      return std::string_view(old + at, count) != std::string_view(now + at, count);
    };
    coder.symbol(changed_, (differs(12, 2) ? 32U : 0U) + (differs(14, 1) ? 16U : 0U) +
                               (differs(15, 1) ? 8U : 0U) + (differs(16, 1) ? 4U : 0U) +
                               (differs(17, 1) ? 2U : 0U) + (differs(18, 2) ? 1U : 0U));
    const auto number = [&](IntegerCoder& of, std::size_t at) {
      if (!differs(at, 2)) return;
      of.code(coder, numberOf<std::uint16_t>(old + at), numberOf<std::uint16_t>(now + at), 0);
    };
    const auto byte = [&](std::vector<CoderModel>& of, std::size_t at) {
      if (differs(at, 1)) coder.symbol(of[byteAt(old + at)], byteAt(now + at));
    };
    number(greys_, 12);
    byte(returns_, 14);
    byte(classes_, 15);
    if (differs(16, 1)) angles_.code(coder, byteAt(old + 16), byteAt(now + 16), k < 3 ? 1 : 0);
    byte(users_, 17);
    number(sources_, 18);
  }

 private:
  static std::uint32_t middle(const std::vector<std::int32_t>& steps) {
    std::vector<std::int32_t> last(steps.end() - 3, steps.end());
    std::sort(last.begin(), last.end());
    return static_cast<std::uint32_t>(last[1]);
  }
  std::vector<std::int32_t> x_steps_{0, 0, 0}, y_steps_{0, 0, 0};
  IntegerCoder dx_{32, 1}, dy_{32, 20}, z_{32, 20}, greys_{16, 1}, angles_{8, 2}, sources_{16, 1};
  CoderModel changed_{64};
  std::vector<CoderModel> returns_{256}, classes_{256}, users_{256};
};

class FirstTimeCoder {
 public:
  void code(ArithmeticCoder& coder, std::uint64_t old, std::uint64_t now) {
    const auto by = static_cast<std::int64_t>(now - old);
    const bool fits = by == static_cast<std::int32_t>(by);
    CoderModel& symbols = step_ == 0 ? first_ : steps_;
    if (by == 0) return coder.symbol(symbols, step_ == 0 ? 0 : 511);
    if (!fits) {
      coder.symbol(symbols, step_ == 0 ? 2 : 510);
      coder.raw(static_cast<std::uint32_t>(now), 32);
      return coder.raw(static_cast<std::uint32_t>(now >> 32U), 32);
    }
    if (step_ == 0) {
      coder.symbol(symbols, 1);
      numbers_.code(coder, 0, static_cast<std::uint32_t>(by), 0);
      step_ = static_cast<std::int32_t>(by);
      return;
    }
    const std::int64_t times = std::clamp<std::int64_t>(by / step_, 0, 509);
    coder.symbol(symbols, static_cast<std::size_t>(times));
    const std::int64_t guess = times == 0 ? step_ / 4 : times * step_;
    const std::size_t context = times == 0   ? 2
                                : times == 1 ? 1
                                : times < 10 ? 3
                                : times < 50 ? 4
                                             : 5;
    numbers_.code(coder, static_cast<std::uint32_t>(guess), static_cast<std::uint32_t>(by),
                  context);
    const bool is_far = times == 0 || times == 509;
    if (is_far) ++far_;
    if (times == 1 || (is_far && far_ > 3)) {
      step_ = static_cast<std::int32_t>(by);
      far_ = 0;
    }
  }

 private:
  CoderModel first_{3}, steps_{512};
  IntegerCoder numbers_{32, 6};
  std::int32_t step_ = 0;
  int far_ = 0;
};

/// Colours: bytes that changed are named.
class FirstColourCoder {
 public:
  void code(ArithmeticCoder& coder, const char* old, const char* now) {
    std::size_t changed = 0;
    for (std::size_t i = 0; i < 6; ++i) changed |= (old[i] != now[i] ? 1U : 0U) << i;
    coder.symbol(changed_, changed);
    for (std::size_t i = 0; i < 6; ++i) {
      if (old[i] != now[i]) bytes_.code(coder, byteAt(old + i), byteAt(now + i), i);
    }
  }

 private:
  CoderModel changed_{64};
  IntegerCoder bytes_{8, 6};
};

}  // namespace relievo::test
