// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/io/formats/scalar.h"
#include "core/message/message.h"

namespace relievo {

/// Packed points that cannot be unpacked; `why` is what the catalogue says of their block or list.
struct LazDamage : std::runtime_error {
  explicit LazDamage(Message of_catalogue)
      : std::runtime_error(englishText(of_catalogue)), why(std::move(of_catalogue)) {}
  Message why;
};

/// How likely each of n symbols is, learnt from those that came before. Numbers are 15-bit shares.
class SymbolModel {
 public:
  /// @param symbols  2 to 1024. Takes no memory before its first symbol.
  explicit SymbolModel(unsigned symbols = 256) noexcept
      : symbols_(static_cast<std::uint16_t>(symbols)) {}

 private:
  friend class ArithmeticDecoder;

  void begin();
  void update();

  struct Symbol {
    std::uint16_t sum;  ///< Shares of all symbols before this one.
    std::uint16_t count;
  };
  std::unique_ptr<Symbol[]> seen_;
  /// By place in a table: the largest symbol whose sum is at most (place << shift_).
  std::unique_ptr<std::uint16_t[]> firsts_;
  std::uint32_t total_ = 0;
  std::uint16_t symbols_, left_ = 0, cycle_ = 0, places_ = 0;
  std::uint8_t shift_ = 0;
};

/// The same of one bit.
class BitModel {
 private:
  friend class ArithmeticDecoder;

  void update();

  std::uint32_t zeros_ = 1, count_ = 2, zero_share_ = 4096, cycle_ = 4, left_ = 4;
};

/// An arithmetic decoder as LAZ files need it (Said, HPL-2004-76), over bytes in memory. Never
/// reads beyond them: whatever is missing is zero, and counted.
class ArithmeticDecoder {
 public:
  ArithmeticDecoder() = default;
  /// @throw LazDamage  no coder writes such a beginning
  explicit ArithmeticDecoder(std::string_view bytes);

  unsigned symbol(SymbolModel& model) {
    if (!model.seen_) model.begin();
    SymbolModel::Symbol* const seen = model.seen_.get();
    const std::uint32_t whole = length_;
    length_ >>= 15U;
    const std::uint32_t share = value_ / length_;
    // From the first symbol of its place in the table on; beyond the last there is a larger sum.
    unsigned low = model.firsts_[std::min<std::uint32_t>(share >> model.shift_, model.places_)];
    while (seen[low + 1U].sum <= share) ++low;
    const std::uint32_t start = seen[low].sum * length_;
    const std::uint32_t end = low + 1U == model.symbols_ ? whole : seen[low + 1U].sum * length_;
    value_ -= start;
    length_ = end - start;
    renormalise();
    ++seen[low].count;
    if (--model.left_ == 0) model.update();
    return low;
  }

  bool bit(BitModel& model) {
    const std::uint32_t zero = model.zero_share_ * (length_ >> 13U);
    const bool one = value_ >= zero;
    if (one) {
      value_ -= zero;
      length_ -= zero;
    } else {
      length_ = zero;
      ++model.zeros_;
    }
    renormalise();
    if (--model.left_ == 0) model.update();
    return one;
  }

  /// `count` bits that are all equally likely. @param count  1 to 32
  std::uint32_t raw(unsigned count) {
    if (count <= 19) return rawAtOnce(count);
    const std::uint32_t low = rawAtOnce(16);
    return low | rawAtOnce(count - 16) << 16U;
  }

  std::size_t unusedBytes() const noexcept { return static_cast<std::size_t>(end_ - at_); }
  /// Bytes that were asked for beyond the end.
  std::size_t missingBytes() const noexcept { return missing_; }

 private:
  std::uint32_t rawAtOnce(unsigned count) {
    length_ >>= count;
    // In damaged bytes the value may lie beyond the last number.
    const std::uint32_t number = std::min(value_ / length_, (1U << count) - 1U);
    value_ -= number * length_;
    if (value_ >= length_) value_ = length_ - 1;
    renormalise();
    return number;
  }

  /// Until the length has its upper byte. Without a branch where there are bytes enough: whether
  /// one is due is a coin's toss.
  void renormalise() {
    const auto count = static_cast<unsigned>(std::countl_zero(length_)) / 8;
    if (end_ - at_ < 4) return renormaliseAtEnd(count);
    const std::uint64_t both =
        std::uint64_t{value_} << 32U | loadAs<std::uint32_t>(at_, ByteOrder::big);
    value_ = static_cast<std::uint32_t>(both >> (32 - 8 * count));
    length_ <<= 8 * count;
    at_ += count;
  }
  void renormaliseAtEnd(unsigned count) {
    for (; count > 0; --count) {
      value_ = value_ << 8U | next();
      length_ <<= 8U;
    }
  }
  std::uint32_t next() {
    if (at_ != end_) return static_cast<unsigned char>(*at_++);
    ++missing_;
    return 0;
  }

  const char* at_ = nullptr;
  const char* end_ = nullptr;
  std::uint32_t value_ = 0, length_ = ~std::uint32_t{0};
  std::size_t missing_ = 0;
};

/// Whole numbers as their difference from a guess: its size in bits by a model, then its place
/// among those of that size.
class IntegerModel {
 public:
  /// @param bits  of the numbers, at most 32  @param contexts  sets of models for the size
  IntegerModel(unsigned bits, unsigned contexts);

  /// The next number, modulo 2^bits.
  std::uint32_t decode(ArithmeticDecoder& decoder, std::uint32_t guess, unsigned context);
  /// Bits of the last difference.
  unsigned lastBits() const noexcept { return last_bits_; }

 private:
  unsigned bits_, last_bits_ = 0;
  std::unique_ptr<SymbolModel[]> sizes_;   ///< Per context.
  std::unique_ptr<SymbolModel[]> places_;  ///< Of differences of 1, 2, ... bits.
  BitModel small_;                         ///< 0 or 1.
};

/// Follows the middle of the numbers that came last.
class RunningMedian {
 public:
  std::int32_t value() const noexcept { return sorted_[2]; }
  void add(std::int32_t number) noexcept;

 private:
  std::array<std::int32_t, 5> sorted_{};
  bool drops_largest_ = true;
};

}  // namespace relievo
