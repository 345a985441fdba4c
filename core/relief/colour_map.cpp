// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/colour_map.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

std::uint8_t byteOf(double value_255) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value_255, 0.0, 255.0)));
}

template <std::size_t N>
double polynomial(const std::array<double, N>& c, double t) {
  double sum = 0;
  for (std::size_t i = N; i-- > 0;) sum = sum * t + c[i];
  return sum;
}

Rgb8 viridis(double t) {
  constexpr std::array<double, 7> kRed{0.2777273272, 0.1050930431, -0.3308618287, -4.6342304990,
                                       6.2282699363, 4.7763849977, -5.4354558559};
  constexpr std::array<double, 7> kGreen{0.0054073445,  1.4046135299,   0.2148475595, -5.7991009734,
                                         14.1799333668, -13.7451453777, 4.6458526122};
  constexpr std::array<double, 7> kBlue{0.3340998053,  1.3845901626,   0.0950951630, -19.3324409563,
                                        56.6905526007, -65.3530326334, 26.3124352496};
  return {byteOf(255 * polynomial(kRed, t)), byteOf(255 * polynomial(kGreen, t)),
          byteOf(255 * polynomial(kBlue, t))};
}

Rgb8 cividis(double t) {
  constexpr std::array<double, 6> kRed{-4.54, -35.34, 2381.73, -6402.7, 7024.72, -2710.57};
  constexpr std::array<double, 6> kGreen{32.49, 170.73, 52.82, -131.46, 176.58, -67.37};
  constexpr std::array<double, 6> kBlue{81.24, 442.36, -2482.43, 6167.24, -6614.94, 2475.67};
  return {byteOf(polynomial(kRed, t)), byteOf(polynomial(kGreen, t)), byteOf(polynomial(kBlue, t))};
}

/// A Catmull-Rom cubic through colours at even steps, which were fitted by least squares to the
/// published map and rounded. Beyond the ends it goes on straight.
Rgb8 batlow(double t) {
  constexpr std::array<Rgb8, 17> kColours{{{1, 25, 89},
                                           {13, 49, 93},
                                           {17, 67, 96},
                                           {22, 82, 98},
                                           {34, 96, 97},
                                           {53, 106, 89},
                                           {77, 115, 77},
                                           {102, 122, 63},
                                           {129, 130, 50},
                                           {160, 138, 43},
                                           {191, 144, 53},
                                           {219, 149, 76},
                                           {242, 157, 107},
                                           {252, 168, 145},
                                           {253, 180, 180},
                                           {252, 192, 214},
                                           {250, 204, 250}}};
  constexpr std::size_t kSteps = kColours.size() - 1;
  const double x = t * kSteps;
  const std::size_t i = std::min(static_cast<std::size_t>(x), kSteps - 1);
  const double u = x - static_cast<double>(i);
  Rgb8 made{};
  for (std::size_t channel = 0; channel < made.size(); ++channel) {
    const double b = kColours[i][channel];
    const double c = kColours[i + 1][channel];
    const double a = i > 0 ? kColours[i - 1][channel] : 2 * b - c;
    const double d = i + 2 <= kSteps ? kColours[i + 2][channel] : 2 * c - b;
    made[channel] =
        byteOf(b + 0.5 * u * (c - a + u * (2 * a - 5 * b + 4 * c - d + u * (3 * (b - c) + d - a))));
  }
  return made;
}

template <std::size_t N>
std::optional<std::size_t> place(const std::array<std::string_view, N>& names,
                                 std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

std::optional<ReliefKind> reliefKind(std::string_view name) {
  if (const auto i = place(kReliefKindNames, name)) return static_cast<ReliefKind>(*i);
  return std::nullopt;
}

std::optional<ColourMap> colourMap(std::string_view name) {
  if (const auto i = place(kColourMapNames, name)) return static_cast<ColourMap>(*i);
  return std::nullopt;
}

Rgb8 colourOf(ColourMap map, double t) {
  if (!std::isfinite(t)) return {128, 128, 128};
  t = std::clamp(t, 0.0, 1.0);
  if (map == ColourMap::viridis) return viridis(t);
  if (map == ColourMap::cividis) return cividis(t);
  if (map == ColourMap::batlow) return batlow(t);
  const std::uint8_t grey = byteOf(255 * t);
  return {grey, grey, grey};
}

}  // namespace relievo
