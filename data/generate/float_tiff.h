// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "data/generate/sample.h"

namespace relievo::samples {

/// The reference as a TIFF file: one float32 band, uncompressed, row 0 of the file at the largest
/// y, GeoTIFF scale and tie point (the samples are cell centres), nodata NaN. No other tags: the
/// unit is that of the cloud and stands in the image description.
std::string floatTiffBytes(const Reference& reference, const std::string& unit);

}  // namespace relievo::samples
