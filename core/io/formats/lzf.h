// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace relievo {

/// An LZF block, as compressed PCD files hold it, unpacked to exactly `size` bytes.
/// Empty if it holds another number of bytes, or none that can be unpacked.
std::vector<char> unpackLzf(std::string_view packed, std::size_t size);

}  // namespace relievo
