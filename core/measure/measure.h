// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vec3.h"
#include "core/measure/map_cells.h"
#include "core/measure/section.h"

namespace relievo {

enum class MeasureKind {
  point,     ///< One point: its place and height.
  distance,  ///< Two points: straight through the air.
  depth,     ///< Two points: the second's height above the first.
  angle,     ///< Three points: at the second one.
  profile,   ///< Two or more points: heights along the line.
  area,      ///< Three or more corners: the piece of surface among them, above a plane.
  section,   ///< The curves in which a plane cuts the whole surface.
};
inline constexpr std::array<std::string_view, 7> kMeasureKindNames{
    "point", "distance", "depth", "angle", "profile", "area", "section"};
inline constexpr std::string_view name(MeasureKind kind) noexcept {
  return kMeasureKindNames[static_cast<std::size_t>(kind)];
}
std::optional<MeasureKind> measureKind(std::string_view name);

struct PlaceMm {
  double x = 0, y = 0;  ///< View.
  friend bool operator==(const PlaceMm&, const PlaceMm&) = default;
};

/// What somebody measured: where, not what came out, so that it can be read again on another map.
/// A section keeps its plane and no places (docs/adr/0077).
struct Measurement {
  std::string name = {};
  MeasureKind kind = MeasureKind::point;
  std::vector<PlaceMm> places = {};
  double plane_mm = 0;  ///< Of `area`: heights count from here. Of `section`: PlaneMm::offset_mm.
  ViewMm normal{0, 0, 1};  ///< Of `section`'s plane.
  friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// How many places a kind needs at least, to be made: a section's plane is through one (level),
/// two (upright) or three.
int placesNeeded(MeasureKind kind);
/// And at most.
int placesAtMost(MeasureKind kind);
/// May more places follow? Of profile, area and section.
bool takesMore(MeasureKind kind);
/// Has it a plane that can be set? Of area and section.
bool hasPlane(MeasureKind kind);
/// @pre m.kind is section
inline PlaneMm planeOf(const Measurement& m) {
  return {.normal = m.normal, .offset_mm = m.plane_mm};
}

/// Places that cannot be the corners of one piece: why not, in one sentence; empty if they can.
/// Outlines of fewer than three places have no fault yet.
std::string outlineProblem(const std::vector<PlaceMm>& places);
/// Does the last side of an outline that is still open cross an earlier one?
bool lastSideCrosses(const std::vector<PlaceMm>& places);

/// A point of the map. Heights are bilinear between samples.
struct SurfacePoint {
  ViewMm at = {};
  /// Half the range of the 3 x 3 samples around, what the sample itself may be off
  /// (MapPart::heightErrorMm), and of an interpolated one how far the rim of its gap is (gapRimMm).
  double height_uncertainty_mm = 0;
  double height_error_mm = 0;               ///< What the sample itself may be off, alone.
  CellStatus origin = CellStatus::outside;  ///< Of the nearest sample.
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

/// What a measurement reads on a map. Uncertainties are bounds, in closed form
/// (docs/user/measure.md, docs/adr/0078): every place may be half a sample off in x and y, and as
/// far in height as its neighbours differ and its own height is uncertain; a piece's outline half a
/// sample.
struct Reading {
  std::vector<Quantity> quantities;  ///< The first is what was asked for.
  std::vector<SurfacePoint> points;  ///< One for each place.
  std::vector<SectionCurve> curves;  ///< Of a section, longest first.
  double not_measured = 0;           ///< Share of what was read that is not measured, [0, 1].
};
/// @throw ArgumentError  too few places, one that is not on the object, an outline that crosses
/// itself or has no area, or a plane that does not cut the surface
Reading read(const MapCells& map, const Measurement& measurement);

struct ProfileRow {
  double along_mm = 0;  ///< From the first place, in the view plane.
  SurfacePoint point;
  bool joined = false;  ///< The sample before it on the line is on the object, too.
};
/// One row per sample distance along the line, both ends included; rows off the object are left
/// out. @throw ArgumentError  fewer than two places
std::vector<ProfileRow> profile(const MapCells& map, const std::vector<PlaceMm>& places);

}  // namespace relievo
