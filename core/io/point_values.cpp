// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_values.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

constexpr float kEightBits = 255;
constexpr float kSixteenBits = 65535;

bool isColour(const std::array<float, 3>& c) {
  return std::all_of(c.begin(), c.end(), [](float v) { return std::isfinite(v) && v >= 0; });
}

/// How a stored number becomes one of 0 ... 255.
enum class ColourForm { unit, bytes, words };

std::uint8_t byteOf(float v, ColourForm form) {
  if (form == ColourForm::words) {
    return static_cast<std::uint8_t>(static_cast<std::uint32_t>(v) >> 8U);
  }
  return static_cast<std::uint8_t>(std::lround(form == ColourForm::unit ? v * kEightBits : v));
}

/// Where intensities lie but for one in a thousand at either end, and as far beyond as the rest of
/// them reaches without a gap wider than that.
IntensityRange rangeOf(std::vector<float> finite) {
  const auto at = [&finite](double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(finite.size() - 1));
    std::nth_element(finite.begin(), finite.begin() + place, finite.end());
    return static_cast<double>(finite[static_cast<std::size_t>(place)]);
  };
  const double low = at(0.001), high = at(0.999);
  const double least = at(0), most = at(1);
  const double spread = high - low;
  if (!(spread > 0)) return {least, most};
  return {std::max(least, low - spread), std::min(most, high + spread)};
}

}  // namespace

std::vector<Rgba> settledColours(std::span<const std::array<float, 3>> stored, ColourFact& fact,
                                 std::vector<std::string>& warnings) {
  float most = 0;
  bool fractions = false;
  for (const auto& c : stored) {
    if (!isColour(c)) continue;
    most = std::max({most, c[0], c[1], c[2]});
    fractions =
        fractions || std::any_of(c.begin(), c.end(), [](float v) { return v != std::floor(v); });
  }
  if (most > kSixteenBits) {
    warnings.emplace_back(
        "Its colours hold numbers beyond 65535, which mean nothing known; they were left out.");
    return {};
  }
  if (most == 0) return {};
  const ColourForm form = most <= 1            ? ColourForm::unit
                          : most <= kEightBits ? ColourForm::bytes
                                               : ColourForm::words;
  fact.bits = form == ColourForm::words ? 16 : fractions ? 32 : 8;
  std::vector<Rgba> colours;
  colours.reserve(stored.size());
  for (const auto& c : stored) {
    if (!isColour(c)) {
      colours.push_back({});
    } else {
      colours.push_back({byteOf(c[0], form), byteOf(c[1], form), byteOf(c[2], form), 255});
    }
  }
  return colours;
}

void settleByteColours(std::vector<Rgba>& colours, std::vector<std::string>& warnings) {
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
  warnings.emplace_back(
      "Its colours hold nothing but 0 and 1; they were taken as none and all of red, green, blue.");
}

std::vector<std::uint16_t> settledIntensities(std::span<const float> stored,
                                              IntensityRange& range) {
  std::vector<float> finite;
  finite.reserve(stored.size());
  bool whole = true;
  for (const float v : stored) {
    if (!std::isfinite(v)) continue;
    finite.push_back(v);
    whole = whole && v == std::floor(v) && v >= 0 && v <= kSixteenBits;
  }
  if (finite.empty()) return {};
  const auto [least, most] = std::minmax_element(finite.begin(), finite.end());
  if (*least == *most) return {};
  // As they are, unless they would all become 0 and 1.
  const bool as_they_are = whole && *most > 1;
  range = as_they_are ? IntensityRange{0, kSixteenBits} : rangeOf(std::move(finite));
  const double step = (range.high - range.low) / static_cast<double>(kSixteenBits);
  std::vector<std::uint16_t> intensities;
  intensities.reserve(stored.size());
  for (const float v : stored) {
    const double number = std::isfinite(v) ? (static_cast<double>(v) - range.low) / step : 0;
    intensities.push_back(static_cast<std::uint16_t>(
        std::lround(std::clamp(number, 0.0, static_cast<double>(kSixteenBits)))));
  }
  return intensities;
}

}  // namespace relievo
