// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace relievo {

/// Reads so many bytes, however many calls that takes. [any thread; waits for the other end]
/// @return  false if the other end is closed, or cannot be read
bool readWhole(int fd, void* out, std::size_t bytes);

}  // namespace relievo
