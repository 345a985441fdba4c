// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of core/io that read rasters.
#include <gdal_priv.h>

#include <optional>

#include "core/io/raster/raster.h"

namespace relievo {

/// Reads a companion of a map that writeColours wrote, as colour_raster.h says; nothing if it is
/// none. @param head  with file, size, pixel and place @throw FileError, Cancelled
std::optional<RasterEnd> readColourRows(GDALDataset& dataset, RasterHead head,
                                        const RasterSink& sink, const Task& task);

}  // namespace relievo
