// SPDX-License-Identifier: BSD-3-Clause
// The other direction of core/io/las/laz_arithmetic.h and laz_fields.h, for tests: written from the
// description of the format, without the program's models, so that a fault in them is seen.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace relievo::test {

/// Counts of symbols; shares are looked up one after the other.
struct CoderModel {
  explicit CoderModel(std::size_t count = 256) : symbols(count) {}

  void begin() {
    counts.assign(symbols, 1);
    total = 0;
    cycle = symbols;
    update();
    cycle = left = (symbols + 6) / 2;
  }
  void update() {
    total += cycle;
    if (total > 32768) {
      total = 0;
      for (std::uint64_t& count : counts) total += count = (count + 1) / 2;
    }
    sums.assign(1, 0);
    std::uint64_t before = 0;
    for (const std::uint64_t count : counts) {
      before += count;
      sums.push_back((2147483648U / total * before) >> 16U);
    }
    cycle = std::min(cycle * 5 / 4, 8 * (symbols + 6));
    left = cycle;
  }
  void learn(std::size_t symbol) {
    ++counts[symbol];
    if (--left == 0) update();
  }

  std::size_t symbols;
  std::vector<std::uint64_t> counts, sums;
  std::uint64_t total = 0, cycle = 0, left = 0;
};

struct CoderBit {
  std::uint64_t zeros = 1, all = 2, share = 4096, cycle = 4, left = 4;

  void learn(bool one) {
    if (!one) ++zeros;
    if (--left != 0) return;
    all += cycle;
    if (all > 8192) {
      all = (all + 1) / 2;
      zeros = (zeros + 1) / 2;
      if (zeros == all) ++all;
    }
    share = (2147483648U / all * zeros) >> 18U;
    cycle = left = std::min<std::uint64_t>(64, cycle * 5 / 4);
  }
};

class ArithmeticCoder {
 public:
  void symbol(CoderModel& model, std::size_t symbol) {
    if (model.counts.empty()) model.begin();
    used_ = true;
    const std::uint32_t whole = length_;
    length_ >>= 15U;
    const auto start = static_cast<std::uint32_t>(model.sums[symbol] * length_);
    const bool is_last = symbol + 1 == model.symbols;
    const auto end = is_last ? whole : static_cast<std::uint32_t>(model.sums[symbol + 1] * length_);
    add(start);
    length_ = end - start;
    renormalise();
    model.learn(symbol);
  }
  void bit(CoderBit& model, bool one) {
    const auto zero = static_cast<std::uint32_t>(model.share * (length_ >> 13U));
    if (one) add(zero);
    length_ = one ? length_ - zero : zero;
    renormalise();
    model.learn(one);
  }
  void raw(std::uint32_t number, unsigned count) {
    if (count > 19) {
      raw(number & 0xFFFFU, 16);
      number >>= 16U;
      count -= 16;
    }
    length_ >>= count;
    add(number * length_);
    renormalise();
  }
  /// All bytes; nothing if there was no symbol.
  std::string finish() {
    if (!used_) return {};
    const bool is_long = length_ > 2U << 24U;
    add(is_long ? 1U << 24U : 1U << 23U);
    length_ = is_long ? 1U << 23U : 1U << 15U;
    renormalise();
    bytes_.append(is_long ? 3 : 2, '\0');  // The decoder is so many bytes ahead.
    return bytes_;
  }
  /// The same where streams are never left out.
  std::string finishAlways() {
    used_ = true;
    return finish();
  }

 private:
  void add(std::uint32_t amount) {
    const std::uint32_t before = base_;
    base_ += amount;
    if (base_ >= before) return;
    auto at = bytes_.rbegin();  // Carry.
    for (; *at == '\xFF'; ++at) *at = '\0';
    *at = static_cast<char>(*at + 1);
  }
  void renormalise() {
    for (; length_ < 1U << 24U; length_ <<= 8U, base_ <<= 8U) {
      bytes_ += static_cast<char>(base_ >> 24U);
    }
  }

  std::string bytes_;
  std::uint32_t base_ = 0, length_ = ~std::uint32_t{0};
  bool used_ = false;
};

class IntegerCoder {
 public:
  IntegerCoder(unsigned bits, std::size_t contexts)
      : bits_(bits), sizes_(contexts, CoderModel(bits + 1)) {
    for (unsigned k = 0; k <= bits; ++k) places_.emplace_back(std::size_t{1} << std::min(k, 8U));
  }
  void code(ArithmeticCoder& coder, std::uint32_t guess, std::uint32_t number,
            std::size_t context) {
    // The difference as a signed number of so many bits.
    const unsigned rest = 32 - bits_;
    std::int64_t c = static_cast<std::int32_t>((number - guess) << rest) >> rest;
    k_ = 0;
    for (std::int64_t c1 = c <= 0 ? -c : c - 1; c1 != 0; c1 >>= 1) ++k_;
    coder.symbol(sizes_[context], k_);
    if (k_ == 0) {
      coder.bit(small_, c == 1);
    } else if (k_ < 32) {
      c += c < 0 ? (std::int64_t{1} << k_) - 1 : -1;
      const unsigned low = k_ > 8 ? k_ - 8 : 0;
      coder.symbol(places_[k_], static_cast<std::size_t>(c >> low));
      if (low > 0) coder.raw(static_cast<std::uint32_t>(c & ((std::int64_t{1} << low) - 1)), low);
    }
  }
  unsigned k() const { return k_; }

 private:
  unsigned bits_, k_ = 0;
  std::vector<CoderModel> sizes_, places_;
  CoderBit small_;
};

/// Five numbers in order, of which the largest and the smallest take turns to go.
struct CoderMedian {
  std::vector<std::int32_t> sorted = std::vector<std::int32_t>(5, 0);
  bool high = true;

  std::uint32_t value() const { return static_cast<std::uint32_t>(sorted[2]); }
  void add(std::uint32_t by) {
    const auto x = static_cast<std::int32_t>(by);
    const std::int32_t middle = sorted[2];
    sorted.erase(high ? sorted.end() - 1 : sorted.begin());
    sorted.insert(std::lower_bound(sorted.begin(), sorted.end(), x), x);
    high = high ? x < middle : !(middle < x);
  }
};

class TimeCoder {
 public:
  /// @param f  1 where "unchanged" is a symbol of its own
  TimeCoder(std::size_t f, std::uint64_t first) : f_(f), first_(5 + f), steps_(515 + f) {
    t_[0] = first;
  }

  void code(ArithmeticCoder& coder, std::uint64_t time) {
    if (f_ == 1 && time == t_[last_]) {
      step_[last_] == 0 ? coder.symbol(first_, 0) : coder.symbol(steps_, 511);
      return;
    }
    const auto by = static_cast<std::int64_t>(time - t_[last_]);
    if (fits(by)) {
      step_[last_] == 0 ? codeFirst(coder, by) : codeStep(coder, by);
      t_[last_] = time;
      return;
    }
    for (std::size_t turn = 1; turn < 4; ++turn) {
      const std::size_t other = (last_ + turn) % 4;
      if (!fits(static_cast<std::int64_t>(time - t_[other]))) continue;
      step_[last_] == 0 ? coder.symbol(first_, f_ + 1 + turn)
                        : coder.symbol(steps_, 511 + f_ + turn);
      last_ = other;
      return code(coder, time);
    }
    step_[last_] == 0 ? coder.symbol(first_, f_ + 1) : coder.symbol(steps_, 511 + f_);
    newest_ = (newest_ + 1) % 4;
    numbers_.code(coder, high(t_[last_]), high(time), 8);
    coder.raw(static_cast<std::uint32_t>(time), 32);
    last_ = newest_;
    t_[last_] = time;
    step_[last_] = far_[last_] = 0;
  }

 private:
  static bool fits(std::int64_t by) {
    return by >= std::numeric_limits<std::int32_t>::min() &&
           by <= std::numeric_limits<std::int32_t>::max();
  }
  static std::uint32_t high(std::uint64_t time) { return static_cast<std::uint32_t>(time >> 32U); }

  void number(ArithmeticCoder& coder, std::int64_t factor, std::int64_t by, std::size_t context) {
    numbers_.code(coder, static_cast<std::uint32_t>(factor * step_[last_]),
                  static_cast<std::uint32_t>(by), context);
  }
  void codeFirst(ArithmeticCoder& coder, std::int64_t by) {
    coder.symbol(first_, f_);
    number(coder, 0, by, 0);
    step_[last_] = by;
    far_[last_] = 0;
  }
  void codeStep(ArithmeticCoder& coder, std::int64_t by) {
    const std::int64_t factor = by / step_[last_];
    const auto code = [&](std::size_t symbol, std::int64_t of, std::size_t context) {
      coder.symbol(steps_, symbol);
      number(coder, of, by, context);
    };
    const auto far = [&] {
      if (++far_[last_] <= 3) return;
      step_[last_] = by;
      far_[last_] = 0;
    };
    if (factor == 1) {
      code(1, 1, 1);
      far_[last_] = 0;
    } else if (factor == 0) {
      code(0, 0, 7);
      far();
    } else if (factor > 0 && factor < 10) {
      code(static_cast<std::size_t>(factor), factor, 2);
    } else if (factor > 0 && factor < 500) {
      code(static_cast<std::size_t>(factor), factor, 3);
    } else if (factor >= 500) {
      code(500, 500, 4);
      far();
    } else if (factor > -10) {
      code(static_cast<std::size_t>(500 - factor), factor, 5);
    } else {
      code(510, -10, 6);
      far();
    }
  }

  std::size_t f_;
  CoderModel first_, steps_;
  IntegerCoder numbers_{32, 9};
  std::array<std::uint64_t, 4> t_{};
  std::array<std::int64_t, 4> step_{}, far_{};
  std::size_t last_ = 0, newest_ = 0;
};

class ColourCoder {
 public:
  using Bytes = std::array<int, 6>;  ///< Low and high of red, green and blue.

  void code(ArithmeticCoder& coder, const Bytes& old, const Bytes& now) {
    std::size_t changed = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      if (old[i] != now[i]) changed |= std::size_t{1} << i;
    }
    const bool is_grey =
        now[2] == now[0] && now[4] == now[0] && now[3] == now[1] && now[5] == now[1];
    if (!is_grey) changed |= 64U;
    coder.symbol(changed_, changed);
    const auto byte = [&](std::size_t i, int guess) {
      if ((changed >> i & 1U) == 0) return;
      coder.symbol(bytes_[i], static_cast<std::size_t>((now[i] - guess) & 255));
    };
    byte(0, old[0]);
    byte(1, old[1]);
    for (std::size_t half = 0; half < 2 && !is_grey; ++half) {
      const int red = now[half] - old[half];
      byte(2 + half, std::clamp(old[2 + half] + red, 0, 255));
      const int both = (red + now[2 + half] - old[2 + half]) / 2;
      byte(4 + half, std::clamp(old[4 + half] + both, 0, 255));
    }
  }

 private:
  CoderModel changed_{128};
  std::array<CoderModel, 6> bytes_;
};

}  // namespace relievo::test
