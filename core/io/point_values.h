// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/scan.h"

namespace relievo {

/// Colours as numbers of a file that may mean 0 ... 1, 0 ... 255 or 0 ... 65535: decided once, by
/// the largest of all, because single points of a 16-bit file may be dark.
/// 16 bits become 8 by a shift: LAS and others store 8 bits times 256, and dividing by 257 would
/// make a 254 of a 255. NaN, infinite and negative numbers are no colour (alpha 0).
/// @param fact  its `bits` are set to what was found
/// @return  empty if no point has a colour: all are 0, or beyond 65535
std::vector<Rgba> settledColours(std::span<const std::array<float, 3>> stored, ColourFact& fact,
                                 std::vector<std::string>& warnings);

/// The same of 8-bit numbers. Programs that cast 0 ... 1 to whole numbers write nothing but 0 and
/// 1; these are spread over the range, and a warning says so. Empties the list if all are 0.
void settleByteColours(std::vector<Rgba>& colours, std::vector<std::string>& warnings);

/// Intensities as whole numbers. Formats promise ranges that their writers do not keep, so the
/// range is that of the numbers, without stray ones. Whole numbers of 16 bits stay as they are. NaN
/// and infinite ones become the lowest.
/// @param range  what 0 and 65535 stand for
/// @return  empty if all are the same: that says nothing
std::vector<std::uint16_t> settledIntensities(std::span<const float> stored, IntensityRange& range);

}  // namespace relievo
