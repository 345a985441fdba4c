// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_values.h"
#include "core/message/catalogue.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace relievo {
namespace {

constexpr float kEightBits = 255;
constexpr float kSixteenBits = 65535;

bool isColour(const std::array<float, 3>& c) {
  return std::all_of(c.begin(), c.end(), [](float v) { return std::isfinite(v) && v >= 0; });
}

}  // namespace

void ColourScale::look(const std::array<float, 3>& colour) noexcept {
  if (!isColour(colour)) return;
  most_ = std::max({most_, colour[0], colour[1], colour[2]});
  fractions_ = fractions_ || std::any_of(colour.begin(), colour.end(),
                                         [](float v) { return v != std::floor(v); });
}

void ColourScale::join(const ColourScale& other) noexcept {
  most_ = std::max(most_, other.most_);
  fractions_ = fractions_ || other.fractions_;
}

bool ColourScale::isBeyond() const noexcept {
  return most_ > kSixteenBits;
}

int ColourScale::bits() const noexcept {
  if (most_ > kEightBits) return 16;
  return fractions_ ? 32 : 8;
}

Rgba ColourScale::operator()(const std::array<float, 3>& colour) const noexcept {
  if (!isColour(colour)) return {};
  const auto byte = [this](float v) {
    if (most_ > kEightBits) {
      return static_cast<std::uint8_t>(static_cast<std::uint32_t>(v) >> 8U);
    }
    return static_cast<std::uint8_t>(std::lround(most_ <= 1 ? v * kEightBits : v));
  };
  return {byte(colour[0]), byte(colour[1]), byte(colour[2]), 255};
}

void IntensityScale::look(float number) noexcept {
  if (!std::isfinite(number)) return;
  ++finite_;
  least_ = std::min(least_, number);
  most_ = std::max(most_, number);
  whole_ = whole_ && number == std::floor(number) && number >= 0 && number <= kSixteenBits;
}

void IntensityScale::join(const IntensityScale& other) noexcept {
  least_ = std::min(least_, other.least_);
  most_ = std::max(most_, other.most_);
  finite_ += other.finite_;
  whole_ = whole_ && other.whole_;
}

bool IntensityScale::isWords() const noexcept {
  return whole_ && most_ > 1;
}

std::pair<std::uint64_t, std::uint64_t> IntensityScale::middleRanks() const noexcept {
  const auto at = [this](double share) {
    return static_cast<std::uint64_t>(share * static_cast<double>(finite_ - 1));
  };
  return {at(0.001), at(0.999)};
}

/// As far beyond the middle as it is wide, but no farther than the numbers reach.
void IntensityScale::setMiddle(float low, float high) noexcept {
  const auto least = static_cast<double>(least_), most = static_cast<double>(most_);
  const double spread = static_cast<double>(high) - static_cast<double>(low);
  range_ = {least, most};
  if (!(spread > 0)) return;
  range_ = {std::max(least, static_cast<double>(low) - spread),
            std::min(most, static_cast<double>(high) + spread)};
}

std::uint16_t IntensityScale::operator()(float number) const noexcept {
  const double step = (range_.high - range_.low) / static_cast<double>(kSixteenBits);
  const double place =
      std::isfinite(number) ? (static_cast<double>(number) - range_.low) / step : 0;
  return static_cast<std::uint16_t>(
      std::lround(std::clamp(place, 0.0, static_cast<double>(kSixteenBits))));
}

std::vector<Rgba> settledColours(std::span<const std::array<float, 3>> stored, ColourFact& fact,
                                 std::vector<Message>& warnings) {
  ColourScale scale;
  for (const auto& colour : stored) scale.look(colour);
  if (scale.isBeyond()) warnings.push_back(said<MessageId::colours_beyond_words>());
  if (!scale.hasColours()) return {};
  fact.bits = scale.bits();
  std::vector<Rgba> colours;
  colours.reserve(stored.size());
  for (const auto& colour : stored) colours.push_back(scale(colour));
  return colours;
}

void settleByteColours(std::vector<Rgba>& colours, std::vector<Message>& warnings) {
  std::uint8_t most = 0;
  for (const Rgba& c : colours) {
    most = std::max({most, c[0], c[1], c[2]});
    if (most > 1) return;  // As good as always, among the first.
  }
  if (most == 0) {
    colours = {};
    return;
  }
  for (Rgba& c : colours) {
    for (std::size_t i = 0; i < 3; ++i) c[i] = c[i] != 0 ? 255 : 0;
  }
  warnings.push_back(said<MessageId::colours_zero_and_one>());
}

std::vector<std::uint16_t> settledIntensities(std::span<const float> stored,
                                              IntensityRange& range) {
  IntensityScale scale;
  for (const float number : stored) scale.look(number);
  if (!scale.hasIntensities()) return {};
  if (!scale.isWords()) {
    std::vector<float> finite;
    finite.reserve(stored.size());
    std::copy_if(stored.begin(), stored.end(), std::back_inserter(finite),
                 [](float number) { return std::isfinite(number); });
    const auto at = [&finite](std::uint64_t rank) {
      const auto place = finite.begin() + static_cast<std::ptrdiff_t>(rank);
      std::nth_element(finite.begin(), place, finite.end());
      return *place;
    };
    const auto [low, high] = scale.middleRanks();
    scale.setMiddle(at(low), at(high));
  }
  range = scale.range();
  std::vector<std::uint16_t> intensities;
  intensities.reserve(stored.size());
  for (const float number : stored) intensities.push_back(scale(number));
  return intensities;
}

}  // namespace relievo
