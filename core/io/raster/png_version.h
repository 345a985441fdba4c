// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// Of the libpng that this process has loaded.
std::string pngVersion();

}  // namespace relievo
