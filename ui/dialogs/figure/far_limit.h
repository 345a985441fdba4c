// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// Maps of countries have such heights, mm, and such scales.
inline constexpr double kFarMm = 1e9;

}  // namespace relievo
