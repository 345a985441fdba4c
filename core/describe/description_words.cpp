// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "core/describe/describe.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr double kNearlyMirrored = 0.85;  // Correlation.
constexpr double kWorthSaying = 0.01;     // Of the surface not measured.
constexpr std::size_t kMostSpoken = 3;    // Areas by their places in one sentence.

NumberArgument millimetres(double mm, int digits = 1) {
  return {.value = std::abs(mm) < 0.5 * std::pow(10, -digits) ? 0 : mm,
          .digits = digits,
          .form = NumberArgument::Form::trimmed,
          .unit = MessageUnit::millimetre};
}

NumberArgument plain(double value, int digits) {
  return {.value = value, .digits = digits, .form = NumberArgument::Form::trimmed};
}

void sayAreas(const std::vector<RaisedArea>& areas, std::vector<Message>& said_so_far) {
  std::vector<RaisedArea> others;
  for (const RaisedArea& area : areas) {
    if (area.is_rim) {
      said_so_far.push_back(said<MessageId::described_rim>());
    } else {
      others.push_back(area);
    }
  }
  if (others.size() == 1) {
    const RaisedArea& a = others.front();
    said_so_far.push_back(
        said<MessageId::described_one_area>(messageOf(a.ninth), sayableShare(a.share),
                                            millimetres(a.width_mm), millimetres(a.height_mm)));
  }
  if (others.size() <= 1) return;
  std::vector<Message> places;
  for (const RaisedArea& area : others) places.push_back(messageOf(area.ninth));
  said_so_far.push_back(others.size() <= kMostSpoken
                            ? said<MessageId::described_areas>(others.size(), places)
                            : said<MessageId::described_many_areas>(others.size(), places));
  for (std::size_t i = 0; i < others.size(); ++i) {
    const RaisedArea& a = others[i];
    said_so_far.push_back(
        said<MessageId::described_area>(i + 1, messageOf(a.ninth), sayableShare(a.share),
                                        millimetres(a.width_mm), millimetres(a.height_mm)));
  }
}

void sayForm(const Description& d, std::vector<Message>& list) {
  if (d.mirrored_sides.value_or(0) >= kNearlyMirrored) {
    list.push_back(said<MessageId::described_mirrored_sides>(plain(*d.mirrored_sides, 2)));
  }
  if (d.mirrored_ends.value_or(0) >= kNearlyMirrored) {
    list.push_back(said<MessageId::described_mirrored_ends>(plain(*d.mirrored_ends, 2)));
  }
  const auto roughness = [&](Ninth n) {
    return millimetres(d.roughness_mm[static_cast<std::size_t>(n)], 3);
  };
  if (d.roughest) {
    list.push_back(
        said<MessageId::described_rough>(messageOf(*d.roughest), roughness(*d.roughest)));
  }
  if (d.smoothest) {
    list.push_back(
        said<MessageId::described_smooth>(messageOf(*d.smoothest), roughness(*d.smoothest)));
  }
}

void sayMeasured(const Description& d, std::vector<Message>& list) {
  if (d.not_measured == 0) {
    list.push_back(said<MessageId::described_all_measured>());
  } else if (d.not_measured >= kWorthSaying) {
    list.push_back(said<MessageId::described_not_measured>(plain(100 * d.not_measured, 1),
                                                           sayableShare(d.not_measured)));
  }
  if (d.largest_gap) list.push_back(said<MessageId::described_gap>(messageOf(*d.largest_gap)));
}

}  // namespace

std::vector<Message> sentencesOf(const Description& d) {
  std::vector<Message> list{said<MessageId::described_size>(
      millimetres(d.object.width_mm), millimetres(d.object.height_mm),
      sayableLength(d.object.width_mm), sayableLength(d.object.height_mm))};
  if (!d.has_heights) {
    list.push_back(said<MessageId::described_nothing>());
    return list;
  }
  const double span_mm = d.heights.max_mm - d.heights.min_mm;
  list.push_back(span_mm > 0
                     ? said<MessageId::described_heights>(
                           millimetres(d.heights.min_mm, 2), millimetres(d.heights.max_mm, 2),
                           millimetres(span_mm, 2), sayableLength(span_mm))
                     : said<MessageId::described_flat>());
  sayAreas(d.raised, list);
  if (d.highest) {
    list.push_back(said<MessageId::described_highest>(
        messageOf(d.highest->ninth), millimetres(d.highest->x_mm), millimetres(d.highest->y_mm),
        millimetres(d.highest->height_mm, 2)));
  }
  sayForm(d, list);
  sayMeasured(d, list);
  return list;
}

}  // namespace relievo
