// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace relievo {

/// CRC-32C (Castagnoli), reflected, start and final value all ones: 0xE3069283 for "123456789".
std::uint32_t crc32c(std::string_view bytes) noexcept;

}  // namespace relievo
