// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/prepare/recipe.h"

namespace relievo {

/// Does the step keep a point at this place? File coordinates. [any thread]
bool keeps(const CropBox& step, const FilePoint& p) noexcept;
/// Points on the outline may count either way.
bool keeps(const CropOutline& step, const FilePoint& p) noexcept;

/// Does the step keep points of this LAS class?
bool keeps(const Classes& step, std::uint8_t class_of_point) noexcept;

/// Does the step keep points of this return? @param packed  as Scan::returns
bool keeps(const Returns& step, std::uint8_t packed) noexcept;

}  // namespace relievo
