// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measure.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/failure.h"
#include "core/measure/area_result.h"
#include "core/measure/gap_rim.h"

namespace relievo {
namespace {

Cell nearest(const GridFrame& f, PlaceMm p) {
  return {.col = static_cast<int>(std::lround((p.x - f.first_x_mm) / f.spacing_mm)),
          .row = static_cast<int>(std::lround((p.y - f.first_y_mm) / f.spacing_mm))};
}

/// Bilinear over those of the four samples around that are on the object.
double heightAt(const MapPart& map, PlaceMm p) {
  const GridFrame& f = map.frame();
  const double u = std::clamp((p.x - f.first_x_mm) / f.spacing_mm, 0.0, f.size.cols - 1.0);
  const double v = std::clamp((p.y - f.first_y_mm) / f.spacing_mm, 0.0, f.size.rows - 1.0);
  const int col = std::min(static_cast<int>(u), std::max(f.size.cols - 2, 0));
  const int row = std::min(static_cast<int>(v), std::max(f.size.rows - 2, 0));
  double sum = 0;
  double weights = 0;
  for (int dr = 0; dr <= 1; ++dr) {
    for (int dc = 0; dc <= 1; ++dc) {
      const Cell cell{.col = col + dc, .row = row + dr};
      if (!f.size.contains(cell) || map.origin(cell) == CellStatus::outside) continue;
      const double weight =
          (dc == 1 ? u - col : 1 - (u - col)) * (dr == 1 ? v - row : 1 - (v - row));
      sum += weight * static_cast<double>(map.heightMm(cell));
      weights += weight;
    }
  }
  return sum / weights;  // The nearest sample, which is on the object, has at least a quarter.
}

double halfRange(const MapPart& map, Cell at) {
  float low = map.heightMm(at);
  float high = low;
  for (int dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      const Cell cell{.col = at.col + dc, .row = at.row + dr};
      if (!map.frame().size.contains(cell) || map.origin(cell) == CellStatus::outside) continue;
      low = std::min(low, map.heightMm(cell));
      high = std::max(high, map.heightMm(cell));
    }
  }
  return 0.5 * static_cast<double>(high - low);
}

using Function = std::function<double(const std::vector<ViewMm>&)>;

double angleDeg(const std::vector<ViewMm>& p) {
  const ViewMm a = p[0] - p[1];
  const ViewMm b = p[2] - p[1];
  const double lengths = norm(a) * norm(b);
  if (!(lengths > 0)) throw failure<MessageId::angle_of_one_point>();
  return std::acos(std::clamp(dot(a, b) / lengths, -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// f and the sum of what each coordinate's own uncertainty does to it.
Quantity propagated(std::string_view title, std::string_view unit, const Function& f,
                    const std::vector<SurfacePoint>& points, double spacing_mm) {
  std::vector<ViewMm> at;
  at.reserve(points.size());
  for (const SurfacePoint& p : points) at.push_back(p.at);
  const double value = f(at);
  double uncertainty = 0;
  const auto add = [&](double& coordinate, double by) {
    const double before = coordinate;
    double most = 0;
    for (const double sign : {-1.0, 1.0}) {
      coordinate = before + sign * by;
      most = std::max(most, std::abs(f(at) - value));
    }
    coordinate = before;
    uncertainty += most;
  };
  for (std::size_t i = 0; i < at.size(); ++i) {
    add(at[i].x, 0.5 * spacing_mm);
    add(at[i].y, 0.5 * spacing_mm);
    add(at[i].z, points[i].height_uncertainty_mm);
  }
  return {.title = title, .value = value, .uncertainty = uncertainty, .unit = unit};
}

double notMeasured(const std::vector<SurfacePoint>& points) {
  const auto count = std::count_if(points.begin(), points.end(), [](const SurfacePoint& p) {
    return p.origin != CellStatus::measured;
  });
  return points.empty() ? 0 : static_cast<double>(count) / static_cast<double>(points.size());
}

double lineLengthMm(const std::vector<PlaceMm>& places) {
  double length = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    length += std::hypot(places[i].x - places[i - 1].x, places[i].y - places[i - 1].y);
  }
  return length;
}

/// The parts of a leg from 0 to 1, both included, that may be on the map: the rest is passed over,
/// however far the places are.
struct PartOfLeg {
  double from = 0, to = 1;
};
std::optional<PartOfLeg> partOnMap(const GridFrame& frame, PlaceMm a, PlaceMm b) {
  PartOfLeg part;
  const double s = frame.spacing_mm;
  const auto cut = [&part](double at, double step, double low, double high) {
    if (step == 0) return at >= low && at <= high;
    const double one = (low - at) / step;
    const double other = (high - at) / step;
    part.from = std::max(part.from, std::min(one, other));
    part.to = std::min(part.to, std::max(one, other));
    return part.from <= part.to;
  };
  const bool meets = cut(a.x, b.x - a.x, frame.xMm(0) - s, frame.xMm(frame.size.cols - 1) + s) &&
                     cut(a.y, b.y - a.y, frame.yMm(0) - s, frame.yMm(frame.size.rows - 1) + s);
  if (!meets) return std::nullopt;
  return part;
}

void readProfile(const MapCells& map, const Measurement& m, Reading& reading) {
  const std::vector<ProfileRow> rows = profile(map, m.places);
  if (rows.size() < 2) throw failure<MessageId::profile_off_the_object>();
  std::vector<SurfacePoint> points;
  double low = rows.front().point.at.z;
  double high = low;
  double on_map = 0;
  double surface = 0;
  double surface_off = 0;
  std::vector<ViewMm> path;
  std::vector<double> off_mm;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    points.push_back(rows[i].point);
    path.push_back(rows[i].point.at);
    off_mm.push_back(rows[i].point.height_error_mm);
    low = std::min(low, rows[i].point.at.z);
    high = std::max(high, rows[i].point.at.z);
    if (!rows[i].joined) continue;
    on_map += rows[i].along_mm - rows[i - 1].along_mm;
    const SurfacePoint& a = rows[i - 1].point;
    const SurfacePoint& b = rows[i].point;
    const double across = std::hypot(b.at.x - a.at.x, b.at.y - a.at.y);
    const double climbed = std::abs(b.at.z - a.at.z);
    surface += std::hypot(across, climbed);
    surface_off += std::hypot(across, climbed + a.height_error_mm + b.height_error_mm) -
                   std::hypot(across, climbed);
  }
  double lowest_off = 0;
  double highest_off = 0;
  for (const SurfacePoint& p : points) {
    if (p.at.z == low) lowest_off = std::max(lowest_off, p.height_uncertainty_mm);
    if (p.at.z == high) highest_off = std::max(highest_off, p.height_uncertainty_mm);
  }
  const double s = map.frame().spacing_mm;
  const double asked = lineLengthMm(m.places);
  surface_off += wallsOff(path, off_mm, false);
  // Half a cell more or less at each end, as steep as the line is there.
  surface_off += 0.5 * std::max(s, norm(points[1].at - points[0].at)) +
                 0.5 * std::max(s, norm(points.back().at - points[points.size() - 2].at));
  reading.quantities = {
      {.title = "length", .value = asked, .uncertainty = s, .unit = "mm"},
      {.title = "height range",
       .value = high - low,
       .uncertainty = lowest_off + highest_off,
       .unit = "mm"},
      {.title = "along the surface", .value = surface, .uncertainty = surface_off, .unit = "mm"},
      {.title = "length on the map", .value = on_map, .uncertainty = s, .unit = "mm"}};
  const double outside = asked > 0 ? std::clamp(1 - (on_map + s) / asked, 0.0, 1.0) : 0;
  reading.not_measured = outside + (1 - outside) * notMeasured(points);
}

void readArea(const MapCells& map, const Measurement& m, Reading& reading) {
  if (const auto message = outlineRefusal(m.places)) throw ArgumentError(*message);
  const AreaResult piece = areaResultOf(map, m.places, m.plane_mm);
  reading.quantities = {{.title = "area in the view",
                         .value = piece.area_mm2,
                         .uncertainty = piece.area_off_mm2,
                         .unit = "mm\u00b2"},
                        {.title = "volume above the plane",
                         .value = piece.volume_mm3,
                         .uncertainty = piece.volume_off_mm3,
                         .unit = "mm\u00b3"},
                        {.title = "area of the surface",
                         .value = piece.surface_mm2,
                         .uncertainty = piece.surface_off_mm2,
                         .unit = "mm\u00b2"}};
  reading.not_measured = piece.not_measured;
}

/// To the micrometre, without zeros that say nothing.
NumberArgument shown(double mm) {
  return {.value = mm, .digits = 3, .form = NumberArgument::Form::trimmed};
}

void readSection(const MapCells& map, const Measurement& m, Reading& reading) {
  reading.curves = section(map, planeOf(m));
  if (reading.curves.empty()) {
    if (m.name.empty()) throw failure<MessageId::plane_cuts_nothing>();
    throw failure<MessageId::named_plane_cuts_nothing>(m.name);
  }
  Quantity length{.title = "length of the cut", .unit = "mm"};
  double points = 0;
  for (const SectionCurve& curve : reading.curves) {
    length.value += curve.length_mm;
    length.uncertainty += curve.length_off_mm;
    points += static_cast<double>(curve.points.size());
    reading.not_measured += curve.not_measured * static_cast<double>(curve.points.size());
  }
  reading.not_measured /= points;
  reading.quantities = {length};
}

}  // namespace

std::optional<MeasureKind> measureKind(std::string_view name) {
  const auto* const found = std::find(kMeasureKindNames.begin(), kMeasureKindNames.end(), name);
  if (found == kMeasureKindNames.end()) return std::nullopt;
  return static_cast<MeasureKind>(found - kMeasureKindNames.begin());
}

int placesNeeded(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::point:
    case MeasureKind::section:
      return 1;
    case MeasureKind::distance:
    case MeasureKind::depth:
    case MeasureKind::profile:
      return 2;
    case MeasureKind::angle:
    case MeasureKind::area:
      return 3;
  }
  return 1;
}

int placesAtMost(MeasureKind kind) {
  if (kind == MeasureKind::section) return 3;
  const bool any = kind == MeasureKind::profile || kind == MeasureKind::area;
  return any ? std::numeric_limits<int>::max() : placesNeeded(kind);
}

bool takesMore(MeasureKind kind) {
  return placesAtMost(kind) > placesNeeded(kind);
}

bool hasPlane(MeasureKind kind) {
  return kind == MeasureKind::area || kind == MeasureKind::section;
}

std::optional<SurfacePoint> surfacePoint(const MapCells& map, PlaceMm place) {
  if (!std::isfinite(place.x) || !std::isfinite(place.y)) return std::nullopt;
  const GridFrame& f = map.frame();
  const double left = f.first_x_mm - 0.5 * f.spacing_mm;
  const double bottom = f.first_y_mm - 0.5 * f.spacing_mm;
  if (place.x < left || place.y < bottom || place.x > left + f.size.cols * f.spacing_mm ||
      place.y > bottom + f.size.rows * f.spacing_mm) {
    return std::nullopt;
  }
  Cell cell = nearest(f, place);
  cell.col = std::clamp(cell.col, 0, f.size.cols - 1);
  cell.row = std::clamp(cell.row, 0, f.size.rows - 1);
  // The four samples around the place are among the nine around its nearest.
  const Cell first{.col = std::max(cell.col - 1, 0), .row = std::max(cell.row - 1, 0)};
  const MapPart part = map.part(first, {.cols = std::min(cell.col + 2, f.size.cols) - first.col,
                                        .rows = std::min(cell.row + 2, f.size.rows) - first.row});
  if (part.origin(cell) == CellStatus::outside) return std::nullopt;
  const double error = part.heightErrorMm(cell);
  const double made = part.origin(cell) == CellStatus::interpolated ? gapRimMm(map, cell) : 0;
  return SurfacePoint{.at = {place.x, place.y, heightAt(part, place)},
                      .height_uncertainty_mm = halfRange(part, cell) + error + made,
                      .height_error_mm = error,
                      .origin = part.origin(cell)};
}

Reading read(const MapCells& map, const Measurement& m) {
  Reading reading;
  if (m.kind == MeasureKind::section) {
    readSection(map, m, reading);
    return reading;
  }
  if (static_cast<int>(m.places.size()) < placesNeeded(m.kind)) {
    throw failure<MessageId::too_few_places>(name(m.kind), placesNeeded(m.kind));
  }
  for (const PlaceMm& place : m.places) {
    const auto point = surfacePoint(map, place);
    // A piece's corners and a profile's ends may lie beside the object.
    if (!point && !takesMore(m.kind)) {
      throw failure<MessageId::no_surface_at>(shown(place.x), shown(place.y));
    }
    reading.points.push_back(point.value_or(SurfacePoint{.at = {place.x, place.y, m.plane_mm}}));
  }
  reading.not_measured = notMeasured(reading.points);
  const double s = map.frame().spacing_mm;
  const auto distance = [](const std::vector<ViewMm>& p) { return norm(p[1] - p[0]); };
  const auto depth = [](const std::vector<ViewMm>& p) { return p[1].z - p[0].z; };
  switch (m.kind) {
    case MeasureKind::point:
      reading.quantities = {{.title = "height",
                             .value = reading.points[0].at.z,
                             .uncertainty = reading.points[0].height_uncertainty_mm,
                             .unit = "mm"}};
      break;
    case MeasureKind::distance:
      reading.quantities = {propagated("distance", "mm", distance, reading.points, s),
                            propagated("depth difference", "mm", depth, reading.points, s)};
      break;
    case MeasureKind::depth:
      reading.quantities = {propagated("depth difference", "mm", depth, reading.points, s),
                            propagated("distance", "mm", distance, reading.points, s)};
      break;
    case MeasureKind::angle:
      reading.quantities = {propagated("angle", "\u00b0", angleDeg, reading.points, s)};
      break;
    case MeasureKind::profile:
      readProfile(map, m, reading);
      break;
    case MeasureKind::area:
      readArea(map, m, reading);
      break;
    case MeasureKind::section:
      break;
  }
  return reading;
}

std::vector<ProfileRow> profile(const MapCells& map, const std::vector<PlaceMm>& places) {
  if (places.size() < 2) throw failure<MessageId::profile_of_one_place>();
  std::vector<ProfileRow> rows;
  double before = 0;
  bool on_object = false;  // The end of the leg before.
  const double s = map.frame().spacing_mm;
  for (std::size_t leg = 0; leg + 1 < places.size(); ++leg) {
    const PlaceMm a = places[leg];
    const PlaceMm b = places[leg + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double steps = std::max(1.0, std::ceil(length / s - 1e-9));
    if (const auto part = partOnMap(map.frame(), a, b)) {
      // One sample more on each side: what is left out is off the map for certain.
      double i = std::max(leg == 0 ? 0.0 : 1.0, std::floor(part->from * steps) - 1);
      bool joined = i == 1 && on_object;
      for (; i <= std::min(steps, std::ceil(part->to * steps) + 1); ++i) {
        const double t = i / steps;
        const PlaceMm place{.x = a.x + t * (b.x - a.x), .y = a.y + t * (b.y - a.y)};
        const auto point = surfacePoint(map, place);
        if (point) {
          rows.push_back({.along_mm = before + t * length, .point = *point, .joined = joined});
        }
        joined = point.has_value();
      }
      on_object = joined && i > steps;
    } else {
      on_object = false;
    }
    before += length;
  }
  return rows;
}

}  // namespace relievo
