// SPDX-License-Identifier: BSD-3-Clause
// Items of version 1: fewer models than those of version 2, and no return in their contexts.
#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "core/io/formats/scalar.h"
#include "core/io/las/laz_fields.h"
#include "core/io/las/laz_stream_item.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

/// The middle of the three numbers that came last.
class MedianOfThree {
 public:
  std::uint32_t value() const noexcept {
    const auto [a, b, c] = last_;
    return static_cast<std::uint32_t>(std::max(std::min(a, b), std::min(std::max(a, b), c)));
  }
  void add(std::uint32_t number) noexcept {
    last_[oldest_] = static_cast<std::int32_t>(number);
    oldest_ = (oldest_ + 1) % 3;
  }

 private:
  std::array<std::int32_t, 3> last_{};
  std::size_t oldest_ = 0;
};

class Point10 : public StreamItem {
 public:
  explicit Point10(const char* first) { std::memcpy(last_.data(), first, last_.size()); }

  void decode(ArithmeticDecoder& decoder, char* item) override {
    const unsigned k = decodePlace(decoder);
    const unsigned changed = decoder.symbol(changed_);
    if ((changed & 32U) != 0) decodeNumber(decoder, greys_, 12);
    if ((changed & 16U) != 0) decodeByte(decoder, returns_, 14);
    if ((changed & 8U) != 0) decodeByte(decoder, classes_, 15);
    if ((changed & 4U) != 0) {
      last_[16] = static_cast<char>(angles_.decode(decoder, byteAt(16), k < 3 ? 1 : 0));
    }
    if ((changed & 2U) != 0) decodeByte(decoder, users_, 17);
    if ((changed & 1U) != 0) decodeNumber(decoder, sources_, 18);
    std::memcpy(item, last_.data(), last_.size());
  }

 private:
  unsigned byteAt(std::size_t at) const { return static_cast<unsigned char>(last_[at]); }

  /// @return  how many bits the steps along x and y took
  unsigned decodePlace(ArithmeticDecoder& decoder) {
    constexpr unsigned kMostContext = 19;
    const auto add = [this](std::size_t at, std::uint32_t step) {
      storeLittle(&last_[at], loadAs<std::uint32_t>(&last_[at], ByteOrder::little) + step);
    };
    const std::uint32_t x_step = x_steps_.decode(decoder, x_median_.value(), 0);
    const unsigned x_bits = x_steps_.lastBits();
    const std::uint32_t y_step =
        y_steps_.decode(decoder, y_median_.value(), std::min(x_bits, kMostContext));
    const unsigned bits = (x_bits + y_steps_.lastBits()) / 2;
    add(0, x_step);
    add(4, y_step);
    const auto height = loadAs<std::uint32_t>(&last_[8], ByteOrder::little);
    storeLittle(&last_[8], heights_.decode(decoder, height, std::min(bits, kMostContext)));
    x_median_.add(x_step);
    y_median_.add(y_step);
    return bits;
  }
  void decodeNumber(ArithmeticDecoder& decoder, IntegerModel& model, std::size_t at) {
    const auto last = loadAs<std::uint16_t>(&last_[at], ByteOrder::little);
    storeLittle(&last_[at], static_cast<std::uint16_t>(model.decode(decoder, last, 0)));
  }
  void decodeByte(ArithmeticDecoder& decoder, LazBytes& models, std::size_t at) {
    last_[at] = static_cast<char>(models.decode(decoder, byteAt(at)));
  }

  std::array<char, 20> last_{};
  MedianOfThree x_median_, y_median_;
  SymbolModel changed_{64};
  LazBytes returns_{256}, classes_{256}, users_{256};
  IntegerModel x_steps_{32, 1}, y_steps_{32, 20}, heights_{32, 20};
  IntegerModel greys_{16, 1}, angles_{8, 2}, sources_{16, 1};
};

/// Times by multiples of the last step.
class Time10 : public StreamItem {
 public:
  explicit Time10(const char* first) : time_(loadAs<std::uint64_t>(first, ByteOrder::little)) {}

  void decode(ArithmeticDecoder& decoder, char* item) override {
    step_ == 0 ? decodeFirstStep(decoder) : decodeStep(decoder);
    storeLittle(item, time_);
  }

 private:
  /// Symbols of a step: multiples of the last one, a time of its own, the same time again.
  static constexpr unsigned kMostTimes = 509, kJump = 510, kSymbols = 512;

  void decodeFirstStep(ArithmeticDecoder& decoder) {
    enum Symbol : unsigned { kSameTime, kStep, kAnyTime };
    const unsigned symbol = decoder.symbol(first_steps_);
    if (symbol == kStep) {
      step_ = static_cast<std::int32_t>(numbers_.decode(decoder, 0, 0));
      advance(step_);
    } else if (symbol == kAnyTime) {
      jump(decoder);
    }
  }

  void decodeStep(ArithmeticDecoder& decoder) {
    const unsigned times = decoder.symbol(steps_);
    if (times == kJump) return jump(decoder);
    if (times > kJump) return;
    const unsigned context = times == 0 ? 2 : times == 1 ? 1 : times < 10 ? 3 : times < 50 ? 4 : 5;
    const std::uint32_t guess = times == 0 ? static_cast<std::uint32_t>(step_ / 4)
                                           : times * static_cast<std::uint32_t>(step_);
    const auto step = static_cast<std::int32_t>(numbers_.decode(decoder, guess, context));
    if (times == 1) {
      step_ = step;
      far_steps_ = 0;
    } else if (times == 0 || times == kMostTimes) {
      constexpr int kFarInARow = 3;
      if (++far_steps_ > kFarInARow) {
        step_ = step;
        far_steps_ = 0;
      }
    }
    advance(step);
  }

  void advance(std::int32_t step) { time_ += static_cast<std::uint64_t>(std::int64_t{step}); }
  void jump(ArithmeticDecoder& decoder) {
    const std::uint64_t low = decoder.raw(32);
    time_ = std::uint64_t{decoder.raw(32)} << 32U | low;
  }

  std::uint64_t time_;
  std::int32_t step_ = 0;
  int far_steps_ = 0;  ///< In a row.
  SymbolModel first_steps_{3}, steps_{kSymbols};
  IntegerModel numbers_{32, 6};
};

/// Bytes by their difference; of colours only those that a symbol names.
class Bytes10 : public StreamItem {
 public:
  enum class Named { all, by_a_symbol };

  Bytes10(const char* first, std::size_t count, Named named)
      : last_(first, first + count), named_(named), numbers_(8, static_cast<unsigned>(count)) {}

  void decode(ArithmeticDecoder& decoder, char* item) override {
    const unsigned changed = named_ == Named::all ? ~0U : decoder.symbol(changed_);
    for (unsigned i = 0; i < last_.size(); ++i) {
      if (named_ == Named::by_a_symbol && (changed >> i & 1U) == 0) continue;
      last_[i] =
          static_cast<char>(numbers_.decode(decoder, static_cast<unsigned char>(last_[i]), i));
    }
    std::memcpy(item, last_.data(), last_.size());
  }

 private:
  std::vector<char> last_;
  Named named_;
  SymbolModel changed_{64};
  IntegerModel numbers_;
};

}  // namespace

std::unique_ptr<StreamItem> firstVersionItem(const LazItem& item, const char* first) {
  switch (item.kind) {
    case LazItemKind::point10:
      return std::make_unique<Point10>(first);
    case LazItemKind::time:
      return std::make_unique<Time10>(first);
    case LazItemKind::colour10:
      return std::make_unique<Bytes10>(first, item.bytes, Bytes10::Named::by_a_symbol);
    case LazItemKind::bytes:
      return std::make_unique<Bytes10>(first, item.bytes, Bytes10::Named::all);
    default:
      throw LazDamage(said<MessageId::laz_mixed_fields>());
  }
}

}  // namespace relievo
