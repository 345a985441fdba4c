// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/las/laz_fields.h"

#include "core/io/las/laz_chunk.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr unsigned kFarPlus = 500, kFarMinus = 510;  ///< Symbols that multiply by 500 and by -10.
constexpr int kFarInARow = 3;
constexpr int kSwitches = 4;  ///< There are no more sequences to switch to.

/// Contexts of LazTime's numbers.
enum StepContext : unsigned {
  kFirst,
  kSame,
  kFew,
  kMany,
  kMost,
  kBack,
  kFarBack,
  kNone,
  kHighHalf
};

std::uint32_t clampedByte(int value) {
  return static_cast<std::uint32_t>(std::clamp(value, 0, 255));
}

}  // namespace

LazTime::LazTime(Unchanged unchanged, std::uint64_t first)
    : shift_(unchanged == Unchanged::said_here ? 1 : 0),
      first_steps_(5 + shift_),
      steps_(515 + shift_) {
  sequences_[0].time = first;
}

std::uint64_t LazTime::decode(ArithmeticDecoder& decoder) {
  for (int i = 0; i <= kSwitches; ++i) {
    const bool done = sequences_[last_].step == 0 ? decodeFirstStep(decoder) : decodeStep(decoder);
    if (done) return sequences_[last_].time;
  }
  throw LazDamage(said<MessageId::laz_times_without_end>());
}

bool LazTime::decodeFirstStep(ArithmeticDecoder& decoder) {
  const unsigned symbol = decoder.symbol(first_steps_);
  if (symbol < shift_) return true;
  if (symbol == shift_) {
    Sequence& now = sequences_[last_];
    now.step = static_cast<std::int32_t>(numbers_.decode(decoder, 0, kFirst));
    now.far_steps = 0;
    advance(static_cast<std::uint32_t>(now.step));
    return true;
  }
  if (symbol == shift_ + 1) {
    jump(decoder);
    return true;
  }
  last_ = (last_ + symbol - shift_ - 1) % 4;
  return false;
}

bool LazTime::decodeStep(ArithmeticDecoder& decoder) {
  Sequence& now = sequences_[last_];
  const auto step = static_cast<std::uint32_t>(now.step);
  const unsigned symbol = decoder.symbol(steps_);
  const auto number = [&](std::uint32_t guess, StepContext context) {
    return numbers_.decode(decoder, guess, context);
  };
  if (symbol == 1) {
    advance(number(step, kSame));
    now.far_steps = 0;
  } else if (symbol == 0) {
    advanceFar(number(0, kNone));
  } else if (symbol < 10) {
    advance(number(symbol * step, kFew));
  } else if (symbol < kFarPlus) {
    advance(number(symbol * step, kMany));
  } else if (symbol == kFarPlus) {
    advanceFar(number(kFarPlus * step, kMost));
  } else if (symbol < kFarMinus) {
    advance(number((kFarPlus - symbol) * step, kBack));
  } else if (symbol == kFarMinus) {
    advanceFar(number((kFarPlus - kFarMinus) * step, kFarBack));
  } else if (symbol < kFarMinus + 1 + shift_) {
    return true;
  } else if (symbol == kFarMinus + 1 + shift_) {
    jump(decoder);
  } else {
    last_ = (last_ + symbol - kFarMinus - 1 - shift_) % 4;
    return false;
  }
  return true;
}

void LazTime::advance(std::uint32_t step) {
  // Steps are signed numbers of 32 bits; times wrap in damaged files.
  sequences_[last_].time +=
      static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<std::int32_t>(step)));
}

void LazTime::advanceFar(std::uint32_t step) {
  advance(step);
  Sequence& now = sequences_[last_];
  if (++now.far_steps > kFarInARow) {
    now.step = static_cast<std::int32_t>(step);
    now.far_steps = 0;
  }
}

void LazTime::jump(ArithmeticDecoder& decoder) {
  const auto high_half = static_cast<std::uint32_t>(sequences_[last_].time >> 32U);
  newest_ = (newest_ + 1) % 4;
  const std::uint64_t high = numbers_.decode(decoder, high_half, kHighHalf);
  sequences_[newest_] = {.time = high << 32U | decoder.raw(32)};
  last_ = newest_;
}

LazColour LazColours::decode(ArithmeticDecoder& decoder, const LazColour& last) {
  const unsigned changed = decoder.symbol(changed_);
  // Bytes of `last` and of what comes: low and high of red, green and blue.
  std::array<std::uint32_t, 6> old{}, now{};
  for (std::size_t i = 0; i < 6; ++i) old[i] = last[i / 2] >> (8 * (i % 2)) & 0xFFU;
  const auto byte = [&](std::size_t i, std::uint32_t guess) {
    const bool is_stored = (changed >> i & 1U) != 0;
    return is_stored ? (guess + decoder.symbol(bytes_[i])) & 0xFFU : old[i];
  };
  const auto difference = [&](std::size_t i) {
    return static_cast<int>(now[i]) - static_cast<int>(old[i]);
  };
  for (const std::size_t red : {0U, 1U}) now[red] = byte(red, old[red]);
  const bool is_grey = (changed >> 6U & 1U) == 0;
  for (const std::size_t red : {0U, 1U}) {
    const std::size_t green = red + 2, blue = red + 4;
    if (is_grey) {
      now[green] = now[blue] = now[red];
      continue;
    }
    const int of_red = difference(red);
    now[green] = byte(green, clampedByte(static_cast<int>(old[green]) + of_red));
    const int of_both = (of_red + difference(green)) / 2;
    now[blue] = byte(blue, clampedByte(static_cast<int>(old[blue]) + of_both));
  }
  LazColour colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] = static_cast<std::uint16_t>(now[2 * i] | now[2 * i + 1] << 8U);
  }
  return colour;
}

std::uint16_t LazInfrared::decode(ArithmeticDecoder& decoder, std::uint16_t last) {
  const unsigned changed = decoder.symbol(changed_);
  std::uint32_t low = last & 0xFFU;
  std::uint32_t high = last >> 8U;
  if ((changed & 1U) != 0) low = (low + decoder.symbol(bytes_[0])) & 0xFFU;
  if ((changed & 2U) != 0) high = (high + decoder.symbol(bytes_[1])) & 0xFFU;
  return static_cast<std::uint16_t>(low | high << 8U);
}

void LazWaves::decode(ArithmeticDecoder& decoder, char* values) {
  enum Step : unsigned { kSamePlace, kBehindTheLast, kDistance, kAnywhere };
  constexpr std::size_t kPlaceAt = 1, kSizeAt = 9, kReturnAt = 13, kDirectionAt = 17;
  values[0] = static_cast<char>(decoder.symbol(descriptor_));
  auto place = loadAs<std::uint64_t>(values + kPlaceAt, ByteOrder::little);
  const auto size = loadAs<std::uint32_t>(values + kSizeAt, ByteOrder::little);
  last_step_ = decoder.symbol(steps_[last_step_]);
  if (last_step_ == kBehindTheLast) {
    place += size;
  } else if (last_step_ == kDistance) {
    last_distance_ = distances_.decode(decoder, last_distance_, 0);
    place += static_cast<std::uint64_t>(
        static_cast<std::int64_t>(static_cast<std::int32_t>(last_distance_)));
  } else if (last_step_ == kAnywhere) {
    const std::uint64_t low = decoder.raw(32);
    place = std::uint64_t{decoder.raw(32)} << 32U | low;
  }
  storeLittle(values + kPlaceAt, place);
  storeLittle(values + kSizeAt, sizes_.decode(decoder, size, 0));
  const auto follow = [&](IntegerModel& model, std::size_t at, unsigned context) {
    const auto last = loadAs<std::uint32_t>(values + at, ByteOrder::little);
    storeLittle(values + at, model.decode(decoder, last, context));
  };
  follow(returns_, kReturnAt, 0);
  for (unsigned axis = 0; axis < 3; ++axis) follow(directions_, kDirectionAt + 4 * axis, axis);
}

LazBytes::LazBytes(std::size_t earlier, unsigned symbols) {
  models_.reserve(earlier);
  for (std::size_t i = 0; i < earlier; ++i) models_.emplace_back(symbols);
}

}  // namespace relievo
