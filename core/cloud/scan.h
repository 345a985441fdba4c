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
#include "core/message/message.h"

namespace relievo {

/// Box around points, in file coordinates and the file's unit.
struct FileBounds {
  FilePoint min, max;
  friend bool operator==(const FileBounds&, const FileBounds&) = default;
};

/// Colour as files store it: sRGB, not linear. Alpha 255: stored; 0: this point has no colour.
using Rgba = std::array<std::uint8_t, 4>;

/// One of several scans in a file, or one of several files that were joined.
struct ScanPart {
  std::string name;
  std::uint64_t points = 0;            ///< Records stored, as in ScanInfo::points.
  std::optional<FilePoint> viewpoint;  ///< Where the scanner stood; turns normals outward.
};

/// What a file stores as colours of its points or faces.
struct ColourFact {
  std::string source;        ///< Where they stood: "red green blue", "rgb", "texture".
  int bits = 8;              ///< Of a stored channel that hold colour: 8 or 16; 32: float.
  std::uint64_t points = 0;  ///< Points loaded that have one; of a texture, corners of faces.
};

/// Which stored intensities the whole numbers of Scan::intensities stand for.
struct IntensityRange {
  double low = 0, high = 0;  ///< Of 0 and of 65535.
};

/// What a file says about itself; kept with every result made from it.
struct ScanInfo {
  std::filesystem::path file;
  std::string format;               ///< "PLY binary_little_endian", "PCD ascii", "STL binary", ...
  std::uint64_t points = 0;         ///< Records stored (STL: 3 per triangle; raster: cells).
  std::uint64_t finite_points = 0;  ///< Of these, finite and not left out: those in the scan.
  std::uint64_t faces = 0;          ///< Polygons stored.
  std::uint64_t dropped_faces = 0;  ///< Faces left out: index out of range, or a non-finite corner.
  std::optional<FileBounds> bounds;  ///< Over finite points, double; nothing if there are none.
  std::optional<LengthUnit> unit;    ///< If the file states one.
  double height_step = 0;  ///< Rasters of whole numbers: of their heights, file unit; 0: others.
  std::string reader;      ///< "PCL 1.13.0", "relievo": which library read the points.
  std::vector<ScanPart> parts;              ///< Empty: one.
  std::optional<ColourFact> colour;         ///< If the scan has colours.
  std::optional<IntensityRange> intensity;  ///< If the scan has intensities.
  std::uint64_t withheld = 0;    ///< LAS points marked "not to be used"; left out unless asked for.
  std::string reference_system;  ///< Of LAS: well-known text, "EPSG:n" or GeoTIFF keys; else empty.
  std::vector<Message> warnings;  ///< For people; each one sentence.
};

/// A picture on a mesh. Texels row by row from the top, sRGB.
struct Texture {
  std::uint32_t cols = 0, rows = 0;
  std::vector<Rgba> texels;
};

/// u to the right, v upward, of the three corners of a triangle; 0 ... 1 is the picture once.
using TextureCorners = std::array<std::array<float, 2>, 3>;
inline constexpr std::uint16_t kNoTexture = 0xFFFF;

/// The points of one object, and its triangles where the file has faces. Plain value.
/// Coordinates are the file's own (axes, unit), stored relative to `origin` in float, so that
/// georeferenced scans keep the file's resolution; the one conversion to millimetres and to the
/// view is `ViewFromFile` (core/depth).
struct Scan {
  ScanInfo info;
  FilePoint origin;                                     ///< Added to every point; double.
  std::vector<std::array<float, 3>> points;             ///< Finite; file units from `origin`.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Valid indices; empty for a cloud.

  // What the file says of each point: each list is empty, or as long as `points`.
  std::vector<Rgba> colours;
  std::vector<std::uint16_t> intensities;  ///< As info.intensity says.
  std::vector<std::uint8_t> classes;       ///< Of LAS.
  std::vector<std::uint8_t> returns;       ///< Of LAS: number of the return | returns of it << 4.
  std::vector<std::uint8_t> parts;         ///< Index into info.parts.

  // What it says of each triangle: empty, or as long as `triangles`.
  std::vector<TextureCorners> texture_corners;
  std::vector<std::uint16_t> texture_of;  ///< Index into `textures`, or kNoTexture.
  std::vector<Texture> textures;

  FilePoint point(std::size_t i) const noexcept {
    return {origin.x + static_cast<double>(points[i][0]),
            origin.y + static_cast<double>(points[i][1]),
            origin.z + static_cast<double>(points[i][2])};
  }
};

}  // namespace relievo
