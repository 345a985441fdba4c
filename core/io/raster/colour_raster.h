// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/grid.h"
#include "core/depth/colours/colours.h"
#include "core/file/atomic_file.h"
#include "core/io/raster/raster.h"

namespace relievo {

// What lies beside a MAP.tif whose scan had colours or intensities.

std::filesystem::path colourFileOf(std::filesystem::path map_file);     ///< MAP.colour.tif
std::filesystem::path intensityFileOf(std::filesystem::path map_file);  ///< MAP.intensity.tif

/// Writes them beside a map just written: red, green, blue and alpha, or grey and alpha, eight bits
/// each and alpha not multiplied in, with the map's georeference and a checksum of its heights, so
/// that they are never taken for another map's. What the scan does not say is not written, and a
/// companion of an older map removed. @throw WriteError  also if a file that is not of this program
/// has such a name
/// @param set  MapFileOptions::set of the map
void writeColours(const OutputFile& map_file, const DepthMap& map, const GridColours& colours,
                  const std::string& set);

/// A map with its origins and colours, all of one set: they take their places together.
/// @throw as writeMap and writeColours
void writeMapWithColours(const OutputFile& map_file, const DepthMap& map,
                         const GridColours& colours, const MapFileOptions& options);

/// Of the heights; NaN: none.
std::uint64_t heightsChecksum(std::span<const float> heights_mm);

/// The worker sends a companion as a raster of its own: each row the colours as whole numbers
/// (red x 65536 + green x 256 + blue, or grey) and behind them the alphas. Its checksum stands in
/// RasterHead::projection, its set in RasterHead::set.
inline constexpr std::string_view kColourRasterFormat = "colours of a map's cells";
inline constexpr std::string_view kIntensityRasterFormat = "intensities of a map's cells";

}  // namespace relievo
