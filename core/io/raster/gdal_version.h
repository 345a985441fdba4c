// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// Of the GDAL that this process has loaded: "3.6.2".
std::string gdalVersion();

}  // namespace relievo
