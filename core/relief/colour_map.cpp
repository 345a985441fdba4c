// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/colour_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace relievo {
namespace {

std::uint8_t byteOf(double value_255) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value_255, 0.0, 255.0)));
}

/// A Catmull-Rom cubic through colours at even steps. Beyond the ends it goes on straight.
template <std::size_t N>
Rgb8 cubicThrough(const std::array<Rgb8, N>& colours, double t) {
  constexpr std::size_t kSteps = N - 1;
  const double x = t * kSteps;
  const std::size_t i = std::min(static_cast<std::size_t>(x), kSteps - 1);
  const double u = x - static_cast<double>(i);
  Rgb8 made{};
  for (std::size_t channel = 0; channel < made.size(); ++channel) {
    const double b = colours[i][channel];
    const double c = colours[i + 1][channel];
    const double a = i > 0 ? colours[i - 1][channel] : 2 * b - c;
    const double d = i + 2 <= kSteps ? colours[i + 2][channel] : 2 * c - b;
    made[channel] =
        byteOf(b + 0.5 * u * (c - a + u * (2 * a - 5 * b + 4 * c - d + u * (3 * (b - c) + d - a))));
  }
  return made;
}

// The colours were fitted to the published maps by least squares, then rounded.
Rgb8 viridis(double t) {
  constexpr std::array<Rgb8, 25> kColours{
      {{68, 1, 84},    {71, 17, 99},   {72, 31, 113},  {71, 45, 123},  {68, 58, 131},
       {64, 70, 136},  {59, 82, 139},  {53, 93, 141},  {49, 104, 142}, {44, 114, 142},
       {40, 124, 142}, {36, 134, 142}, {33, 144, 140}, {30, 154, 138}, {32, 164, 134},
       {39, 174, 128}, {53, 183, 121}, {71, 192, 110}, {93, 201, 99},  {117, 208, 84},
       {143, 214, 68}, {171, 220, 50}, {199, 224, 32}, {227, 228, 24}, {253, 231, 37}}};
  return cubicThrough(kColours, t);
}

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
  return cubicThrough(kColours, t);
}

struct Knot {
  double entry = 0;  ///< Of 256.
  Rgb8 rgb{};
};

/// Straight between colours at uneven steps: where it leaves the gamut the published map bends
/// sharply, which no cubic follows.
Rgb8 cividis(double t) {
  constexpr std::array<Knot, 14> kKnots{{{0, {0, 34, 78}},
                                         {17, {0, 46, 108}},
                                         {23, {1, 50, 113}},
                                         {26, {12, 52, 112}},
                                         {32, {26, 56, 111}},
                                         {47, {49, 67, 109}},
                                         {83, {85, 92, 109}},
                                         {130, {126, 125, 120}},
                                         {162, {157, 149, 118}},
                                         {195, {191, 176, 107}},
                                         {224, {222, 201, 88}},
                                         {241, {241, 217, 69}},
                                         {251, {253, 227, 52}},
                                         {255, {254, 232, 56}}}};
  const double entry = 255 * t;
  const auto after = std::find_if(kKnots.begin() + 1, kKnots.end() - 1,
                                  [entry](const Knot& knot) { return knot.entry >= entry; });
  const Knot& low = *std::prev(after);
  const double part = (entry - low.entry) / (after->entry - low.entry);
  Rgb8 made{};
  for (std::size_t channel = 0; channel < made.size(); ++channel) {
    made[channel] = byteOf(std::lerp(static_cast<double>(low.rgb[channel]),
                                     static_cast<double>(after->rgb[channel]), part));
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
  const std::uint8_t grey = byteOf(255 * t);
  switch (map) {  // A map without a line here does not compile.
    case ColourMap::viridis:
      return viridis(t);
    case ColourMap::cividis:
      return cividis(t);
    case ColourMap::batlow:
      return batlow(t);
    case ColourMap::grey:
      break;
  }
  return {grey, grey, grey};
}

}  // namespace relievo
