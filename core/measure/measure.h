// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vec3.h"
#include "core/measure/map_cells.h"

namespace relievo {

enum class MeasureKind {
  point,     ///< One point: its place and height.
  distance,  ///< Two points: straight through the air.
  depth,     ///< Two points: the second's height above the first.
  angle,     ///< Three points: at the second one.
  profile,   ///< Two or more points: heights along the line.
  area,      ///< Three or more corners: the piece of surface among them, above a plane.
};
inline constexpr std::array<std::string_view, 6> kMeasureKindNames{"point", "distance", "depth",
                                                                   "angle", "profile",  "area"};
inline constexpr std::string_view name(MeasureKind kind) noexcept {
  return kMeasureKindNames[static_cast<std::size_t>(kind)];
}
std::optional<MeasureKind> measureKind(std::string_view name);

struct PlaceMm {
  double x = 0, y = 0;  ///< View.
  friend bool operator==(const PlaceMm&, const PlaceMm&) = default;
};

/// What somebody measured: where, not what came out, so that it can be read again on another map.
struct Measurement {
  std::string name = {};
  MeasureKind kind = MeasureKind::point;
  std::vector<PlaceMm> places = {};
  double plane_mm = 0;  ///< Of `area`: heights count from here.
  friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// How many places a kind needs at least.
int placesNeeded(MeasureKind kind);
/// May more places follow? Of profile and area.
bool takesMore(MeasureKind kind);

/// A point of the map. Heights are bilinear between samples.
struct SurfacePoint {
  ViewMm at = {};
  double height_uncertainty_mm = 0;  ///< Half the range of the 3 x 3 samples around.
  Origin origin = Origin::outside;   ///< Of the nearest sample.
};
/// Nothing beyond the map, or where the nearest sample is outside. This and all below:
/// @throw also what `map` throws when it reads
std::optional<SurfacePoint> surfacePoint(const MapCells& map, PlaceMm place);

/// A value and how far it may be off, both in `unit`.
struct Quantity {
  std::string_view title;  ///< "distance"
  double value = 0, uncertainty = 0;
  std::string_view unit;  ///< "mm", "\u00b0", "mm\u00b2", "mm\u00b3"
};

/// What a measurement reads on a map. Uncertainties are bounds: every place may be half a sample
/// off in x and y, and as far in height as its neighbours differ; a piece's outline half a sample.
struct Reading {
  std::vector<Quantity> quantities;  ///< The first is what was asked for.
  std::vector<SurfacePoint> points;  ///< One for each place.
  double not_measured = 0;           ///< Share of what was read that is not measured, [0, 1].
};
/// @throw ArgumentError  too few places, or one that is not on the object
Reading read(const MapCells& map, const Measurement& measurement);

struct ProfileRow {
  double along_mm = 0;  ///< From the first place, in the view plane.
  SurfacePoint point;
};
/// One row per sample distance along the line, both ends included; rows off the object are left
/// out. @throw ArgumentError  fewer than two places
std::vector<ProfileRow> profile(const MapCells& map, const std::vector<PlaceMm>& places);

}  // namespace relievo
