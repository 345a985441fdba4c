// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/depth/colours/colours.h"

namespace relievo {

/// GridColours as they are kept for as long as a surface is open: at most four bytes a sample
/// (docs/adr/0108). Colours alone, and intensities alone, stay as they are. A sample with both has
/// its colour to the byte and 7 bits of grey where nearly all comes from the scan (alpha 208 and
/// more, which becomes 255), and elsewhere 7 bits a channel and one of a few alphas, the same for
/// both. Packing what was unpacked changes nothing.
class StoredColours {
 public:
  StoredColours() = default;
  explicit StoredColours(const GridColours& colours);

  bool hasColours() const noexcept { return !colours_.empty() || !both_.empty(); }
  bool hasIntensities() const noexcept { return !intensities_.empty() || !both_.empty(); }
  bool empty() const noexcept { return !hasColours() && !hasIntensities(); }
  std::size_t bytes() const noexcept;

  /// Of one sample. @pre the kind is there
  Rgba colour(std::size_t sample) const noexcept;
  GreyAlpha intensity(std::size_t sample) const noexcept;
  /// Of samples that follow each other. @pre likewise
  void read(std::size_t first, std::span<Rgba> out) const noexcept;
  void read(std::size_t first, std::span<GreyAlpha> out) const noexcept;
  GridColours all() const;

  friend bool operator==(const StoredColours&, const StoredColours&) = default;

 private:
  std::vector<Rgba> colours_;           ///< If there are colours only.
  std::vector<GreyAlpha> intensities_;  ///< If there are intensities only.
  std::vector<std::uint32_t> both_;
};

/// A sample with both, as it comes back from being stored. [any thread]
std::pair<Rgba, GreyAlpha> asStored(const Rgba& colour, const GreyAlpha& intensity) noexcept;

/// All samples likewise; changes nothing unless there are both. [any thread]
void makeStorable(GridColours& colours);

}  // namespace relievo
