// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/stored_colours.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>

namespace relievo {
namespace {

// Of 32 bits: the highest says that nearly all comes from the scan. If it does, 24 bits of colour
// and 7 of grey lie below. If not, bits 28 to 30 say which of the forms below the others have.
constexpr std::uint32_t kWhole = 1U << 31U;
constexpr unsigned kFormAt = 28;
constexpr std::uint32_t kColourAlone = 0;  // And no bit at all: neither.
constexpr std::uint32_t kGreyAlone = 1;
constexpr std::uint32_t kFirstShare = 2;
constexpr std::array<std::uint8_t, 6> kShares{1, 26, 64, 96, kBetweenAlpha, 160};
constexpr int kLeastWhole = 208;  // As far from 255 as from the highest share.

constexpr std::array<std::uint8_t, 8> kAloneAlphas{1, 26, 64, 96, kBetweenAlpha, 160, 208, 255};

template <std::size_t Count>
std::uint32_t nearest(const std::array<std::uint8_t, Count>& levels, std::uint8_t alpha) {
  const auto found = std::min_element(levels.begin(), levels.end(), [alpha](auto a, auto b) {
    return std::abs(a - alpha) < std::abs(b - alpha);
  });
  return static_cast<std::uint32_t>(found - levels.begin());
}

constexpr std::uint32_t sevenBits(std::uint8_t byte) {
  return (byte * 127U + 127U) / 255U;
}
constexpr std::uint8_t byteOf(std::uint32_t seven) {
  return static_cast<std::uint8_t>((seven * 255U + 63U) / 127U);
}

std::uint32_t threeBytes(const Rgba& c) {
  return c[0] | static_cast<std::uint32_t>(c[1]) << 8U | static_cast<std::uint32_t>(c[2]) << 16U;
}

std::uint32_t packed(const Rgba& colour, const GreyAlpha& grey) {
  const std::uint8_t alpha = colour[3];
  if (alpha == 0 && grey[1] == 0) return 0;
  if (alpha == 0) {
    return kGreyAlone << kFormAt | static_cast<std::uint32_t>(grey[1]) << 8U | grey[0];
  }
  if (grey[1] == 0) {  // The marking bit keeps a black one apart from none.
    return kColourAlone << kFormAt | 1U << 27U | nearest(kAloneAlphas, alpha) << 24U |
           threeBytes(colour);
  }
  if (alpha >= kLeastWhole) return kWhole | sevenBits(grey[0]) << 24U | threeBytes(colour);
  return (kFirstShare + nearest(kShares, alpha)) << kFormAt | sevenBits(grey[0]) << 21U |
         sevenBits(colour[2]) << 14U | sevenBits(colour[1]) << 7U | sevenBits(colour[0]);
}

std::uint8_t low(std::uint32_t bits, unsigned at) {
  return static_cast<std::uint8_t>(bits >> at);
}
std::uint8_t sevenAt(std::uint32_t bits, unsigned at) {
  return byteOf((bits >> at) & 0x7FU);
}

Rgba colourIn(std::uint32_t bits) {
  if ((bits & kWhole) != 0) return {low(bits, 0), low(bits, 8), low(bits, 16), kStoredAlpha};
  const std::uint32_t form = bits >> kFormAt;
  if (form == kGreyAlone || bits == 0) return {};
  if (form == kColourAlone) {
    return {low(bits, 0), low(bits, 8), low(bits, 16), kAloneAlphas[(bits >> 24U) & 7U]};
  }
  return {sevenAt(bits, 0), sevenAt(bits, 7), sevenAt(bits, 14), kShares[form - kFirstShare]};
}

GreyAlpha greyIn(std::uint32_t bits) {
  if ((bits & kWhole) != 0) return {sevenAt(bits, 24), kStoredAlpha};
  const std::uint32_t form = bits >> kFormAt;
  if (form == kColourAlone) return {};
  if (form == kGreyAlone) return {low(bits, 0), low(bits, 8)};
  return {sevenAt(bits, 21), kShares[form - kFirstShare]};
}

}  // namespace

StoredColours::StoredColours(const GridColours& colours) {
  if (colours.intensities.empty()) {
    colours_ = colours.colours;
  } else if (colours.colours.empty()) {
    intensities_ = colours.intensities;
  } else {
    both_.reserve(colours.colours.size());
    for (std::size_t i = 0; i < colours.colours.size(); ++i) {
      both_.push_back(packed(colours.colours[i], colours.intensities[i]));
    }
  }
}

std::size_t StoredColours::bytes() const noexcept {
  return colours_.size() * sizeof(Rgba) + intensities_.size() * sizeof(GreyAlpha) +
         both_.size() * sizeof(std::uint32_t);
}

Rgba StoredColours::colour(std::size_t sample) const noexcept {
  return both_.empty() ? colours_[sample] : colourIn(both_[sample]);
}

GreyAlpha StoredColours::intensity(std::size_t sample) const noexcept {
  return both_.empty() ? intensities_[sample] : greyIn(both_[sample]);
}

void StoredColours::read(std::size_t first, std::span<Rgba> out) const noexcept {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = colour(first + i);
}

void StoredColours::read(std::size_t first, std::span<GreyAlpha> out) const noexcept {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = intensity(first + i);
}

GridColours StoredColours::all() const {
  GridColours all{.colours = colours_, .intensities = intensities_};
  all.colours.reserve(all.colours.size() + both_.size());
  all.intensities.reserve(all.intensities.size() + both_.size());
  for (const std::uint32_t bits : both_) {
    all.colours.push_back(colourIn(bits));
    all.intensities.push_back(greyIn(bits));
  }
  return all;
}

std::pair<Rgba, GreyAlpha> asStored(const Rgba& colour, const GreyAlpha& intensity) noexcept {
  const std::uint32_t bits = packed(colour, intensity);
  return {colourIn(bits), greyIn(bits)};
}

void makeStorable(GridColours& colours) {
  if (colours.colours.empty() || colours.intensities.empty()) return;
  for (std::size_t i = 0; i < colours.colours.size(); ++i) {
    std::tie(colours.colours[i], colours.intensities[i]) =
        asStored(colours.colours[i], colours.intensities[i]);
  }
}

}  // namespace relievo
