// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/cloud/scan.h"
#include "core/io/las/las_header.h"

namespace relievo {

inline constexpr std::size_t kLasHeadBytes = 1 << 20;  ///< Header and records that name a unit.

/// Finds the unit of the coordinates and their reference system in the variable length records
/// (GeoTIFF keys or well-known text) and puts them into `info`, with warnings about degrees and
/// about units that are not known here.
/// Records that are cut or make no sense say nothing.
/// @return  what heights are to be multiplied by, so that they are in the unit of x and y; 1 where
///          they are, or the records do not state both
double readLasUnit(std::string_view bytes, const LasHeader& header, ScanInfo& info);

/// The projected system that a file names instead of a unit.
struct LasSystem {
  int code = 0;                                          ///< EPSG.
  std::optional<LengthUnit> height_unit = std::nullopt;  ///< If the file states one.
  friend bool operator==(const LasSystem&, const LasSystem&) = default;
};
std::optional<LasSystem> lasSystem(std::string_view bytes, const LasHeader& header);

/// The factor of heights once `info.unit` is known from its registry, with a warning unless it is
/// 1.
double heightFactor(const LasSystem& system, ScanInfo& info);

}  // namespace relievo
