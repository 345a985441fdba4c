// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"

namespace relievo {

/// A texture and its coarser versions, each half as wide and high, averaged in linear light: a
/// sample that stands for many texels is their mean and not one of them. Takes a third of the
/// texture's memory besides. The texture must outlive it.
class TextureLevels {
 public:
  /// A texture without texels, or with another number of them than it says, has no colours.
  /// [worker] @throw Cancelled
  TextureLevels(const Texture& texture, const Task& task);
  TextureLevels(TextureLevels&&) = default;
  TextureLevels& operator=(TextureLevels&&) = default;
  TextureLevels(const TextureLevels&) = delete;  // Its levels point into itself.
  TextureLevels& operator=(const TextureLevels&) = delete;
  ~TextureLevels() = default;

  std::uint32_t cols() const noexcept { return levels_.empty() ? 0 : levels_.front().cols; }
  std::uint32_t rows() const noexcept { return levels_.empty() ? 0 : levels_.front().rows; }

  /// Linear light (core/depth/colours/linear_light.h) at u to the right and v upward; the picture
  /// repeats.
  /// @param texels  of the finest level that one sample reaches over, along its longer side
  /// @return  nothing where the picture has none [any thread]
  std::optional<std::array<float, 3>> at(double u, double v, double texels) const;

 private:
  struct Level {
    std::uint32_t cols = 0, rows = 0;
    const Rgba* texels = nullptr;
  };

  std::vector<Level> levels_;
  std::vector<std::vector<Rgba>> coarser_;
};

}  // namespace relievo
