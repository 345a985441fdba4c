// SPDX-License-Identifier: BSD-3-Clause
#include "core/describe/sayable.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr double kExactly = 0.02, kRoughly = 0.08;  // Off, of the number that is said.

/// The nearest number from 10 to 100 that is easily said.
double sayableTens(double value) {
  return value <= 20 ? std::round(value) : 5 * std::round(value / 5);
}

/// The nearest sayable number, whatever its size.
double nearestSayable(double value) {
  if (value < 5) return std::max(0.5 * std::round(2 * value), 0.5);
  if (value <= 100) return value < 10 ? std::round(value) : sayableTens(value);
  const double tens = std::pow(10, std::floor(std::log10(value)) - 1);
  return tens * sayableTens(value / tens);
}

double twoDigits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return unit * std::round(value / unit);
}

template <MessageId whole, MessageId part>
Message numberOf(double value) {
  const double rounded = std::round(value);
  if (std::abs(value - rounded) < 1e-9) return said<whole>(static_cast<std::int64_t>(rounded));
  return said<part>(
      NumberArgument{.value = value, .digits = 3, .form = NumberArgument::Form::trimmed});
}

Message lengthOf(double value, double unit_mm) {
  if (unit_mm < 10) return numberOf<MessageId::sayable_mm, MessageId::sayable_part_mm>(value);
  if (unit_mm < 1000) return numberOf<MessageId::sayable_cm, MessageId::sayable_part_cm>(value);
  return numberOf<MessageId::sayable_m, MessageId::sayable_part_m>(value);
}

}  // namespace

SayableNumber sayableNumber(double value) {
  if (value <= 0) return {};
  const double said_value = nearestSayable(value);
  const double off = (value - said_value) / said_value;
  using enum SayableNumber::Nearness;
  if (std::abs(off) <= kExactly) return {said_value, exact};
  if (std::abs(off) <= kRoughly) return {said_value, off < 0 ? nearly : over};
  return {twoDigits(value), exact};
}

Message sayableLength(double mm) {
  const double length_mm = std::abs(mm);
  // "nearly 10 millimetres" is a centimetre.
  const double unit_mm = length_mm < 9.8 ? 1 : length_mm < 980 ? 10 : 1000;
  const SayableNumber number = sayableNumber(length_mm / unit_mm);
  const Message length = lengthOf(number.value, unit_mm);
  switch (number.nearness) {
    case SayableNumber::Nearness::nearly:
      return said<MessageId::sayable_nearly>(length);
    case SayableNumber::Nearness::over:
      return said<MessageId::sayable_over>(length);
    case SayableNumber::Nearness::exact:
      break;
  }
  return length;
}

Message sayableShare(double share) {
  struct Part {
    double share;
    MessageId words;
  };
  constexpr std::array<Part, 7> kParts{{{1.0 / 2, MessageId::share_half},
                                        {1.0 / 3, MessageId::share_third},
                                        {1.0 / 4, MessageId::share_quarter},
                                        {1.0 / 5, MessageId::share_fifth},
                                        {1.0 / 6, MessageId::share_sixth},
                                        {1.0 / 8, MessageId::share_eighth},
                                        {1.0 / 10, MessageId::share_tenth}}};
  const auto nearest = std::min_element(kParts.begin(), kParts.end(), [&](Part a, Part b) {
    return std::abs(share / a.share - 1) < std::abs(share / b.share - 1);
  });
  if (std::abs(share / nearest->share - 1) <= kRoughly) return {nearest->words, {}};
  return said<MessageId::share_percent>(NumberArgument{.value = std::round(100 * share)});
}

Ninth ninthOf(const RectMm& object, double x_mm, double y_mm) {
  const auto third = [](double part) {
    return static_cast<int>(std::clamp(std::floor(3 * part), 0.0, 2.0));
  };
  const int column = third((x_mm - object.x_mm) / object.width_mm);
  const int row_from_bottom = third((y_mm - object.y_mm) / object.height_mm);
  return static_cast<Ninth>(3 * (2 - row_from_bottom) + column);
}

Message messageOf(Ninth ninth) {
  constexpr std::array<MessageId, kNinths> kWords{
      MessageId::ninth_top_left,    MessageId::ninth_top_middle,    MessageId::ninth_top_right,
      MessageId::ninth_middle_left, MessageId::ninth_middle,        MessageId::ninth_middle_right,
      MessageId::ninth_bottom_left, MessageId::ninth_bottom_middle, MessageId::ninth_bottom_right};
  return {kWords[static_cast<std::size_t>(ninth)], {}};
}

}  // namespace relievo
