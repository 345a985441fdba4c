// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/coin_lettering.h"

#include <array>
#include <numbers>
#include <string_view>

namespace relievo::samples {
namespace {

constexpr std::string_view kInscription = "RELIEVO*TOUCH THE PAST*MMXXVI*";

// Letters on a grid 4 wide and 6 high: pairs of digits are points, a space lifts the pen.
struct Glyph {
  char letter;
  std::string_view strokes;
};
constexpr std::array<Glyph, 16> kFont{{
    {'R', "0006364544430333 2340"},
    {'E', "40000646 0333"},
    {'L', "060040"},
    {'I', "2026"},
    {'V', "062046"},
    {'O', "1001051636454130 1030"},
    {'T', "0646 2026"},
    {'U', "0601103041 4146"},
    {'C', "4536160501103041"},
    {'H', "0006 0333 3343 4046"},
    {'P', "0006364544330333 3303"},
    {'A', "002640 1232"},
    {'S', "01103041423304051636 3645"},
    {'M', "0006234640"},
    {'X', "0046 0640"},
    {'*', "2224 1333"},
}};

std::string_view strokesOf(char letter) {
  for (const Glyph& glyph : kFont) {
    if (glyph.letter == letter) return glyph.strokes;
  }
  return {};
}

/// Bends the grid of one letter around the coin.
struct Placement {
  double angle = 0;  ///< Of the letter's left edge, radians, growing counter-clockwise.
  double unit_mm = 0;
  double radius_mm = 0;

  Point2 at(char col, char row) const {
    const double middle_mm = radius_mm + 3 * unit_mm;
    const double a = angle - (col - '0') * unit_mm / middle_mm;
    const double r = radius_mm + (row - '0') * unit_mm;
    return {r * std::cos(a), r * std::sin(a)};
  }
};

void addLetter(std::vector<Stroke>& strokes, std::string_view pen, const Placement& place) {
  std::size_t i = 0;
  while (i + 3 < pen.size()) {
    if (pen[i] == ' ') {
      ++i;
    } else if (pen[i + 2] == ' ') {
      i += 3;
    } else {
      strokes.push_back({place.at(pen[i], pen[i + 1]), place.at(pen[i + 2], pen[i + 3])});
      i += 2;
    }
  }
}

}  // namespace

std::vector<Stroke> coinLettering(double radius_mm, double height_mm) {
  std::vector<Stroke> strokes;
  const double step = 2 * std::numbers::pi / static_cast<double>(kInscription.size());
  for (std::size_t i = 0; i < kInscription.size(); ++i) {
    const double angle = std::numbers::pi - static_cast<double>(i) * step;
    addLetter(strokes, strokesOf(kInscription[i]), {angle, height_mm / 6, radius_mm});
  }
  return strokes;
}

}  // namespace relievo::samples
