// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/unit.h"
#include "core/base/vec3.h"

namespace relievo {

/// Box around points, in file coordinates and the file's unit.
struct FileBounds {
  FilePoint min, max;
  friend bool operator==(const FileBounds&, const FileBounds&) = default;
};

/// What a file says about itself; kept with every result made from it.
struct ScanInfo {
  std::filesystem::path file;
  std::string format;               ///< "PLY binary_little_endian", "PCD ascii", "STL binary", ...
  std::uint64_t points = 0;         ///< Records stored (STL: 3 per triangle; raster: cells).
  std::uint64_t finite_points = 0;  ///< Of these, with three finite coordinates.
  std::uint64_t faces = 0;          ///< Polygons stored.
  std::uint64_t dropped_faces = 0;  ///< Faces left out: index out of range, or a non-finite corner.
  std::optional<FileBounds> bounds;  ///< Over finite points, double; nothing if there are none.
  std::optional<LengthUnit> unit;    ///< If the file states one.
  double height_step = 0;  ///< Rasters of whole numbers: of their heights, file unit; 0: others.
  std::vector<std::string> warnings;  ///< For people; each one sentence.
};

/// The points of one object, and its triangles where the file has faces. Plain value.
/// Coordinates are the file's own (axes, unit), stored relative to `origin` in float, so that
/// georeferenced scans keep the file's resolution; the one conversion to millimetres and to the
/// view is `ViewFromFile` (core/depth).
struct Scan {
  ScanInfo info;
  FilePoint origin;                                     ///< Added to every point; double.
  std::vector<std::array<float, 3>> points;             ///< Finite; file units from `origin`.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Valid indices; empty for a cloud.

  FilePoint point(std::size_t i) const noexcept {
    return {origin.x + static_cast<double>(points[i][0]),
            origin.y + static_cast<double>(points[i][1]),
            origin.z + static_cast<double>(points[i][2])};
  }
};

}  // namespace relievo
