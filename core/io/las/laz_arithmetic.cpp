// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/las/laz_arithmetic.h"

#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint32_t kMostCounts = 1U << 15U;     ///< Of a SymbolModel, then all are halved.
constexpr std::uint32_t kMostBitCounts = 1U << 13U;  ///< Of a BitModel.
constexpr std::uint32_t kHalf = 1U << 31U;
constexpr unsigned kShareBits = 15;
constexpr unsigned kTableAbove = 4;        ///< Fewer symbols are found as soon without a table.
constexpr std::uint16_t kBeyond = 0xFFFF;  ///< Larger than any share.

/// Bits of the number of places of a model's table: as many as there are symbols, or some more.
unsigned placeBits(unsigned symbols) {
  return symbols <= kTableAbove ? 0 : static_cast<unsigned>(std::bit_width(symbols - 1));
}

}  // namespace

void SymbolModel::begin() {
  const unsigned bits = placeBits(symbols_);
  places_ = static_cast<std::uint16_t>(1U << bits);
  shift_ = static_cast<std::uint8_t>(kShareBits - bits);
  seen_ = std::make_unique<Symbol[]>(symbols_ + 1U);
  seen_[symbols_].sum = kBeyond;
  firsts_ = std::make_unique<std::uint16_t[]>(places_ + 1U);
  for (unsigned s = 0; s < symbols_; ++s) seen_[s].count = 1;
  total_ = 0;
  cycle_ = symbols_;
  update();
  cycle_ = left_ = static_cast<std::uint16_t>((symbols_ + 6U) / 2);
}

void SymbolModel::update() {
  total_ += cycle_;
  if (total_ > kMostCounts) {
    total_ = 0;
    for (unsigned s = 0; s < symbols_; ++s) {
      seen_[s].count = static_cast<std::uint16_t>((seen_[s].count + 1U) / 2);
      total_ += seen_[s].count;
    }
  }
  const std::uint32_t scale = kHalf / total_;
  std::uint32_t before = 0;
  for (unsigned s = 0; s < symbols_; ++s) {
    seen_[s].sum = static_cast<std::uint16_t>((scale * before) >> 16U);
    before += seen_[s].count;
  }
  unsigned first = 0;
  for (unsigned place = 0; place < places_ + 1U; ++place) {
    while (first + 1U < symbols_ && seen_[first + 1U].sum <= place << shift_) ++first;
    firsts_[place] = static_cast<std::uint16_t>(first);
  }
  cycle_ = static_cast<std::uint16_t>(std::min(5U * cycle_ / 4U, 8U * (symbols_ + 6U)));
  left_ = cycle_;
}

void BitModel::update() {
  count_ += cycle_;
  if (count_ > kMostBitCounts) {
    count_ = (count_ + 1) / 2;
    zeros_ = (zeros_ + 1) / 2;
    if (zeros_ == count_) ++count_;
  }
  zero_share_ = (kHalf / count_ * zeros_) >> 18U;
  cycle_ = std::min(5 * cycle_ / 4, 64U);
  left_ = cycle_;
}

ArithmeticDecoder::ArithmeticDecoder(std::string_view bytes)
    : at_(bytes.data()), end_(bytes.data() + bytes.size()) {
  for (int i = 0; i < 4; ++i) value_ = value_ << 8U | next();
  if (value_ == length_) throw LazDamage(said<MessageId::laz_no_coders_bytes>());
}

IntegerModel::IntegerModel(unsigned bits, unsigned contexts)
    : bits_(bits),
      sizes_(std::make_unique<SymbolModel[]>(contexts)),
      places_(std::make_unique<SymbolModel[]>(bits)) {
  std::generate_n(sizes_.get(), contexts, [bits] { return SymbolModel(bits + 1); });
  for (unsigned size = 1; size <= bits; ++size) {
    places_[size - 1] = SymbolModel(1U << std::min(size, 8U));
  }
}

std::uint32_t IntegerModel::decode(ArithmeticDecoder& decoder, std::uint32_t guess,
                                   unsigned context) {
  const unsigned size = decoder.symbol(sizes_[context]);
  last_bits_ = size;
  std::uint32_t difference = kHalf;
  if (size == 0) {
    difference = decoder.bit(small_) ? 1 : 0;
  } else if (size < 32) {
    difference = decoder.symbol(places_[size - 1]);
    if (size > 8) difference = difference << (size - 8) | decoder.raw(size - 8);
    // Of k bits are -(2^k - 1) to -2^(k-1) and 2^(k-1) + 1 to 2^k.
    if (difference >= 1U << (size - 1)) {
      ++difference;
    } else {
      difference -= (1U << size) - 1U;
    }
  }
  const std::uint32_t number = guess + difference;
  return bits_ == 32 ? number : number & ((1U << bits_) - 1U);
}

void RunningMedian::add(std::int32_t number) noexcept {
  const std::int32_t middle = sorted_[2];
  // The place that is given up moves to where the number belongs.
  if (drops_largest_) {
    std::size_t place = 4;
    for (; place > 0 && sorted_[place - 1] > number; --place) sorted_[place] = sorted_[place - 1];
    sorted_[place] = number;
    drops_largest_ = number < middle;
  } else {
    std::size_t place = 0;
    for (; place < 4 && sorted_[place + 1] < number; ++place) sorted_[place] = sorted_[place + 1];
    sorted_[place] = number;
    drops_largest_ = !(middle < number);
  }
}

}  // namespace relievo
