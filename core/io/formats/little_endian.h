// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/io/formats/scalar.h"

namespace relievo {

/// A whole number of two bytes, as LAS, 3DS and E57 store it. @pre at + 2 <= bytes.size()
inline std::uint16_t u16At(std::string_view bytes, std::size_t at) noexcept {
  return loadAs<std::uint16_t>(bytes.data() + at, ByteOrder::little);
}

}  // namespace relievo
