// SPDX-License-Identifier: BSD-3-Clause
#include "core/describe/hand_place.h"

#include <array>
#include <cmath>

#include "core/describe/sayable.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

NumberArgument millimetres(double mm, int digits = 1) {
  const double finest = std::pow(10, -digits);
  return {.value = std::abs(mm) < 0.5 * finest ? 0 : mm,
          .digits = digits,
          .form = NumberArgument::Form::trimmed,
          .unit = MessageUnit::millimetre};
}

Message messageOf(CellStatus origin) {
  constexpr std::array<MessageId, kOriginCount> kWords{
      MessageId::origin_measured, MessageId::origin_interpolated, MessageId::origin_base_plane,
      MessageId::origin_steep, MessageId::origin_outside};
  return {kWords[static_cast<std::size_t>(origin)], {}};
}

bool isBeside(const HandPlace& p) {
  const double right = p.at.x - p.object.x_mm, up = p.at.y - p.object.y_mm;
  return right < 0 || up < 0 || right > p.object.width_mm || up > p.object.height_mm ||
         (p.touching && p.origin == CellStatus::outside);
}

Message whereOf(const HandPlace& p) {
  const Message ninth = messageOf(ninthOf(p.object, p.at.x, p.at.y));
  if (!p.touching) return said<MessageId::place_in_the_air>(ninth);
  constexpr double kGroundMm = 0.05;  // No tenth of a millimetre, which is what is shown.
  if (std::abs(p.at.z) < kGroundMm) {
    return said<MessageId::place_touching_ground>(ninth, millimetres(p.at.z));
  }
  return p.at.z > 0
             ? said<MessageId::place_touching>(ninth, millimetres(p.at.z), sayableLength(p.at.z))
             : said<MessageId::place_below_ground>(ninth, millimetres(p.at.z),
                                                   sayableLength(p.at.z));
}

}  // namespace

std::vector<Message> shortWords(const HandPlace& p) {
  std::vector<Message> words;
  if (isBeside(p)) {
    words.push_back(said<MessageId::place_beside>());
  } else {
    words.push_back(whereOf(p));
  }
  if (!p.name.empty()) words.push_back(said<MessageId::place_named>(p.name));
  const bool was_measured = p.origin == CellStatus::measured || p.origin == CellStatus::outside;
  if (p.touching && p.origin == CellStatus::steep) {
    words.push_back(said<MessageId::place_steep>());
  } else if (p.touching && !was_measured) {
    words.push_back(said<MessageId::place_not_measured>(messageOf(p.origin)));
  }
  return words;
}

std::vector<Message> longWords(const HandPlace& p) {
  std::vector<Message> words = shortWords(p);
  if (!isBeside(p)) {
    const double right_mm = p.at.x - p.object.x_mm, up_mm = p.at.y - p.object.y_mm;
    words.push_back(
        said<MessageId::place_from_left>(millimetres(right_mm), sayableLength(right_mm)));
    words.push_back(said<MessageId::place_from_bottom>(millimetres(up_mm), sayableLength(up_mm)));
    if (p.touching && p.origin == CellStatus::measured) {
      words.push_back(said<MessageId::place_measured>());
    }
  }
  for (Message& word : detailWords(p)) words.push_back(std::move(word));
  return words;
}

std::vector<Message> detailWords(const HandPlace& p) {
  return {
      said<MessageId::place_detail>(p.detail, p.details, millimetres(p.side_mm),
                                    sayableLength(p.side_mm)),
      said<MessageId::place_scale>(millimetres(p.object_mm_per_hand_mm, 3),
                                   sayableLength(10 * p.object_mm_per_hand_mm)),
      said<MessageId::place_resolution>(millimetres(p.spacing_mm, 3), sayableLength(p.spacing_mm))};
}

}  // namespace relievo
