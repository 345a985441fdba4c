// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/cloud/scan.h"

namespace relievo {

/// What the numbers of a file's colours mean: 0 ... 1, 0 ... 255 or 0 ... 65535, by the largest of
/// all, because single points of a 16-bit file may be dark.
class ColourScale {
 public:
  /// To be shown every colour, in any order.
  void look(const std::array<float, 3>& colour) noexcept;
  /// Takes over what another has seen.
  void join(const ColourScale& other) noexcept;

  bool hasColours() const noexcept { return most_ > 0 && !isBeyond(); }
  float most() const noexcept { return most_; }  ///< The largest number.
  bool isBeyond() const noexcept;                ///< Of 16 bits: means nothing known.
  int bits() const noexcept;                     ///< As ColourFact::bits.
  /// @pre hasColours() @return  alpha 0 for NaN, infinite and negative numbers
  Rgba operator()(const std::array<float, 3>& colour) const noexcept;

 private:
  float most_ = 0;
  bool fractions_ = false;
};

/// What the numbers of a file's intensities mean.
class IntensityScale {
 public:
  /// To be shown every number, in any order.
  void look(float number) noexcept;
  void join(const IntensityScale& other) noexcept;

  /// All the same says nothing.
  bool hasIntensities() const noexcept { return least_ < most_; }
  std::uint64_t finite() const noexcept { return finite_; }
  /// Whole numbers of 16 bits, not only 0 and 1? They stay as they are; others need `setMiddle`.
  bool isWords() const noexcept;
  /// Which of the finite numbers in order, from 0, setMiddle asks for.
  std::pair<std::uint64_t, std::uint64_t> middleRanks() const noexcept;
  /// Where all lie but for one in a thousand at either end.
  void setMiddle(float low, float high) noexcept;

  IntensityRange range() const noexcept { return range_; }  ///< What 0 and 65535 stand for.
  std::uint16_t operator()(float number) const noexcept;

 private:
  float least_ = std::numeric_limits<float>::infinity(), most_ = -least_;
  std::uint64_t finite_ = 0;
  bool whole_ = true;
  IntensityRange range_{0, 65535};
};

/// Colours as numbers of a file that may mean 0 ... 1, 0 ... 255 or 0 ... 65535: decided once, by
/// the largest of all, because single points of a 16-bit file may be dark.
/// 16 bits become 8 by a shift: LAS and others store 8 bits times 256, and dividing by 257 would
/// make a 254 of a 255. NaN, infinite and negative numbers are no colour (alpha 0).
/// @param fact  its `bits` are set to what was found
/// @return  empty if no point has a colour: all are 0, or beyond 65535
std::vector<Rgba> settledColours(std::span<const std::array<float, 3>> stored, ColourFact& fact,
                                 std::vector<Message>& warnings);

/// The same of 8-bit numbers. Programs that cast 0 ... 1 to whole numbers write nothing but 0 and
/// 1; these are spread over the range, and a warning says so. Empties the list if all are 0.
void settleByteColours(std::vector<Rgba>& colours, std::vector<Message>& warnings);

/// Intensities as whole numbers. Formats promise ranges that their writers do not keep, so the
/// range is that of the numbers, without stray ones. Whole numbers of 16 bits stay as they are. NaN
/// and infinite ones become the lowest.
/// @param range  what 0 and 65535 stand for
/// @return  empty if all are the same: that says nothing
std::vector<std::uint16_t> settledIntensities(std::span<const float> stored, IntensityRange& range);

}  // namespace relievo
