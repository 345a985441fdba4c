// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace relievo {

/// Of the frame around the window, on screens, in pictures and on paper: red, green, blue.
inline constexpr std::array<std::uint8_t, 3> kPink{0xff, 0x4f, 0xa3};

}  // namespace relievo
