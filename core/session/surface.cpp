// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/surface.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/base/failure.h"
#include "core/depth/fill/losses.h"
#include "core/depth/rules/cell_size.h"
#include "core/depth/rules/point_rule.h"
#include "core/io/raster/raster.h"
#include "core/session/choices.h"
#include "core/session/closed_cloud.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/memory_guard.h"
#include "core/session/loss_report.h"
#include "core/session/source/missing_height.h"
#include "core/session/source/unit_guess.h"

namespace relievo {
namespace {

constexpr double kMostCells = 0x1p28;
constexpr double kMostCellsByTiles = 0x1p40;
constexpr double kMostSideByTiles = 0x1p23;  // So that tiles can be numbered.

class Stopwatch {
 public:
  /// Seconds since construction or the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// @throw ArgumentError  more than fit there
void requireCells(double cols, double rows, MapPlace place) {
  constexpr double kCounted = 9e18;  // What can be said of a grid of any size.
  const auto count = [&](double cells) {
    return static_cast<long long>(std::min(cells, kCounted));
  };
  if (place == MapPlace::memory && !(cols * rows <= kMostCells)) {
    throw failure<MessageId::too_many_cells>(count(cols), count(rows));
  }
  if (!(cols * rows <= kMostCellsByTiles) || !(std::max(cols, rows) <= kMostSideByTiles)) {
    throw failure<MessageId::too_many_cells_by_tiles>(count(cols), count(rows));
  }
}

}  // namespace

void say(std::vector<Message>& messages, std::optional<Message> message) {
  if (message) messages.push_back(*std::move(message));
}

void say(std::vector<Message>& messages, std::vector<Message> more) {
  std::move(more.begin(), more.end(), std::back_inserter(messages));
}

void chooseUnit(Surface& surface, const SurfaceOptions& options) {
  const UnitInUse unit = unitInUse(surface.info, options.unit, options.unit_source);
  surface.unit = unit.unit;
  surface.unit_source = unit.source;
  say(surface.messages, unitWords(surface.info, unit));
}

void sayScale(Surface& surface, const ScaleInUse& scale) {
  surface.raster_scale = scale;
  if (!scale.isOpen()) return;
  // It says all that the two say, and more.
  std::erase_if(surface.messages, [](const Message& message) {
    return message.id == MessageId::unit_assumed ||
           message.id == MessageId::unit_assumed_but_likelier ||
           message.id == MessageId::unit_guessed ||
           message.id == MessageId::raster_without_georeference;
  });
  say(surface.messages, scaleWords(scale));
}

/// Samples so that the first and last lie on the box; the map's lower left edge becomes (0, 0).
GridFrame chooseFrame(Surface& surface, const SurfaceOptions& options, const RotatedBounds& box,
                      const std::function<CellProposal()>& propose, MapPlace place) {
  const double width = box.max.x - box.min.x;
  const double height = box.max.y - box.min.y;
  const double side = std::max(width, height);
  if (!(side > 0) || !std::isfinite(side)) {
    throw failure<MessageId::all_on_one_spot>(surface.info.file.filename());
  }
  if (options.cells && options.spacing_mm) {
    throw failure<MessageId::cells_or_spacing>();
  }
  double spacing = 0;
  if (options.spacing_mm) {
    spacing = *options.spacing_mm;
    if (!(spacing > 0) || !std::isfinite(spacing)) {
      throw failure<MessageId::spacing_not_positive>();
    }
  } else {
    int cells = options.cells.value_or(0);
    if (!options.cells) {
      const CellProposal proposal = propose();
      cells = proposal.cells;
      surface.messages.push_back(said<MessageId::grid_chosen>(cells, proposal.reason));
    }
    if (cells < 2) throw failure<MessageId::too_few_cells>();
    spacing = side / (cells - 1);
  }
  // A map has two samples each way at least: fewer enclose no square that could be drawn or
  // touched.
  const double cols = std::max(2.0, std::floor(width / spacing + 0.5) + 1);
  const double rows = std::max(2.0, std::floor(height / spacing + 0.5) + 1);
  if (std::min(width, height) < 0.5 * spacing) {
    surface.messages.push_back(said<MessageId::points_on_one_line>());
  }
  requireCells(cols, rows, place);
  return {.size = {.cols = static_cast<int>(cols), .rows = static_cast<int>(rows)},
          .spacing_mm = spacing,
          .first_x_mm = 0.5 * spacing,
          .first_y_mm = 0.5 * spacing};
}

/// What the engine may choose from. @throw ArgumentError
std::optional<PointRule> requestedRule(const Scan& scan, const SurfaceOptions& options) {
  const bool any = options.engine == "cpu" && scan.triangles.empty();
  if (!any && options.rule && *options.rule != PointRule::front) {
    throw failure<MessageId::rule_for_clouds_only>();
  }
  return any ? options.rule : PointRule::front;
}

void sayRule(Surface& surface, const Scan& scan, const CapturedDepths& depths) {
  if (!scan.triangles.empty()) {
    surface.rule = "front-most triangle";
    return;
  }
  const Message rule = depths.rule.value_or(said<MessageId::rule_and_why>(
      said<MessageId::rule_of_depth_buffer>(), ruleMessage(PointRule::front)));
  surface.rule = englishText(rule);
  surface.messages.push_back(said<MessageId::heights_by_rule>(rule));
}

void sayDepthBuffer(Surface& surface) {
  const DepthBufferFormat& format = *surface.depth_buffer;
  const auto mm = [](double value) {
    return NumberArgument{.value = value,
                          .digits = 3,
                          .form = NumberArgument::Form::significant,
                          .unit = MessageUnit::millimetre};
  };
  const NumberArgument range = mm(format.rangeMm()), step = mm(format.stepMm()),
                       accuracy = mm(format.accuracyMm());
  surface.messages.push_back(
      format.is_float
          ? said<MessageId::float_depth_buffer_is_exact_to>(format.bits, range, step, accuracy)
          : said<MessageId::depth_buffer_is_exact_to>(format.bits, range, step, accuracy));
}

/// Holes and what could not be done about them.
void takeHoles(Surface& surface, std::vector<Hole> holes, const HoleChoice& choice) {
  surface.holes = std::move(holes);
  say(surface.not_done, holesLeft(surface.holes, choice));
}

ViewFromFile viewFromFile(const Rotation& r, double mm, double dx, double dy, double dz) {
  ViewFromFile view{.m = {mm * r[0], mm * r[1], mm * r[2], dx, mm * r[3], mm * r[4], mm * r[5], dy,
                          mm * r[6], mm * r[7], mm * r[8], dz, 0, 0, 0, 1}};
  for (double& value : view.m) value += 0.0;  // No negative zeros in reports and files.
  return view;
}

namespace {

void finish(Surface& surface, const SurfaceOptions& options, Stopwatch& watch, const Task& task) {
  task.report("Pyramid", 0.0);
  surface.pyramid = buildPyramid(surface.map, options.pyramid, task);
  surface.ladder = detailLadder(surface.map, surface.pyramid);
  surface.seconds.pyramid = watch.lap();
}

/// Adds the message about heights that were left out: on suspicion, or because the user said so.
void sayMissing(Surface& surface, const std::optional<double>& value) {
  if (surface.suspect_height) {
    surface.messages.push_back(suspectWords(*surface.suspect_height));
  } else if (surface.missing > 0) {
    surface.messages.push_back(missingWords(surface.missing, *value));
  }
}

/// Notes which points of the scan are not in the surface.
void takeLeftOut(Surface& surface, const ScanInUse& in_use, const std::optional<double>& missing) {
  surface.strays = in_use.strays();
  surface.missing = in_use.missing();
  sayMissing(surface, missing);
  say(surface.messages, strayWords(surface.strays));
}

/// The raster without the heights that stand for none; nothing: there are none.
std::optional<RasterMap> withoutMissing(const RasterMap& raster, Surface& surface,
                                        const SurfaceOptions& options) {
  if (!options.nodata) surface.suspect_height = suspectHeight(raster);
  const std::optional<double> value = missingHeight(options.nodata, surface.suspect_height);
  if (!value) return std::nullopt;
  RasterMap cleaned = raster;
  surface.missing = takeAsMissing(cleaned, *value);
  if (surface.missing == 0) return std::nullopt;
  sayMissing(surface, value);
  return cleaned;
}

/// Of the cells that have one. @pre one has
std::array<double, 2> heightsIn(const RasterMap& raster) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    if (!raster.valid[i]) continue;
    low = std::min(low, static_cast<double>(raster.values[i]));
    high = std::max(high, static_cast<double>(raster.values[i]));
  }
  return {low, high};
}

/// A raster from elsewhere: its samples stay, the lowest lies on the base plane.
/// @param low, high  as heightsIn
FilledMap fillForeign(const RasterMap& raster, const GridFrame& frame, const ScaleInUse& scale,
                      const std::array<double, 2>& low_high, const HoleChoice& choice,
                      const Task& task) {
  FrontDepths depths(frame.size.count(), std::numeric_limits<float>::quiet_NaN());
  // Relative to the lowest sample before float: 8000 m above sea keep their millimetres.
  const double lowest = scale.lowest(low_high[0], low_high[1]);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (!raster.valid[i]) continue;
    depths[i] =
        static_cast<float>((static_cast<double>(raster.values[i]) - lowest) * scale.height_mm);
  }
  FilledMap filled = fillDepths(
      std::move(depths), frame,
      {.has_sampling_gaps = false, .base_quantile = 0, .base_z_mm = scale.baseAbove(lowest)},
      choice, task);
  filled.base_z_mm += lowest * scale.height_mm;
  return filled;
}

void takeOwnMap(Surface& surface, const RasterMap& raster) {
  surface.unit = LengthUnit::mm;
  surface.unit_source = UnitSource::file;
  surface.view_from_file = raster.view_from_file.value_or(ViewFromFile{});
  surface.view_name = "as stored";
  surface.engine = "as stored";
  surface.rule = "as stored";
  DepthMap& map = surface.map;
  map.frame = {.size = raster.size,
               .spacing_mm = raster.pixel,
               .first_x_mm = raster.first.x,
               .first_y_mm = raster.first.y};
  map.heights_mm = raster.values;
  map.origins = raster.origins;
  if (map.origins.empty()) {
    map.origins.assign(raster.size.count(), CellStatus::measured);
    surface.messages.push_back(said<MessageId::map_without_origins>());
  }
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (raster.valid[i] && map.origins[i] != CellStatus::outside) continue;
    map.heights_mm[i] = 0;
    map.origins[i] = CellStatus::outside;
  }
}

void takeForeignRaster(Surface& surface, const RasterMap& raster, const SurfaceOptions& options,
                       const Task& task) {
  chooseUnit(surface, options);
  if (options.view && (options.view->turn_deg != std::array<double, 3>{} ||
                       (options.view->name != "top" && options.view->name != "auto" &&
                        options.view->name != kEarlierAutomatic))) {
    throw failure<MessageId::raster_from_the_top_only>();
  }
  const std::array<double, 2> heights = heightsIn(raster);
  const ScaleInUse scale =
      scaleInUse(raster, surface.unit, surface.unit_source, options.raster, heights[0], heights[1]);
  sayScale(surface, scale);
  const double mm = scale.pixel_mm / raster.pixel;
  const double spacing = scale.pixel_mm;
  const GridFrame frame{.size = raster.size,
                        .spacing_mm = spacing,
                        .first_x_mm = 0.5 * spacing,
                        .first_y_mm = 0.5 * spacing};
  FilledMap filled = fillForeign(raster, frame, scale, heights, options.holes, task);
  surface.view_name = "top";
  surface.engine = "raster";
  surface.rule = "as stored";
  surface.view_from_file =
      viewFromFile(*standardRotation("top"), mm, frame.first_x_mm - mm * raster.first.x,
                   frame.first_y_mm - mm * raster.first.y, -filled.base_z_mm);
  surface.view_from_file.m[kHeightScale] = scale.height_mm;
  surface.map = std::move(filled.map);
  takeHoles(surface, std::move(filled.holes), options.holes);
}

}  // namespace

Surface makeSurface(const Scan& whole, const SurfaceOptions& options, const DepthEngine& engine,
                    const Task& task) {
  Surface surface;
  surface.messages = whole.info.warnings;
  Stopwatch watch;
  if (!options.nodata) surface.suspect_height = suspectHeight(whole);
  const std::optional<double> missing = missingHeight(options.nodata, surface.suspect_height);
  ScanInUse in_use(whole, options.strays, missing, task);
  surface.info = in_use.scan().info;
  chooseUnit(surface, options);
  const NamedRotation view = chosenRotation(
      in_use.scan(), options.view.value_or(ViewChoice{.name = "auto", .rotation = {}}), task);
  say(surface.messages, view.note);
  surface.view_is_weak = view.is_weak;
  in_use.dropAlong(view.rotation, task);
  const Scan& scan = in_use.scan();
  takeLeftOut(surface, in_use, missing);
  const double mm = mmPer(surface.unit);
  const RotatedBounds box = rotatedBounds(scan, view.rotation, mm);
  const std::optional<ClosedCloud> closed = closedCloud(scan, view.rotation, mm, box, task);
  const Scan& shown = closed ? closed->visible : scan;
  const GridFrame frame = chooseFrame(surface, options, box, [&] {
    return closed ? cellsOf(closed->surface, box, shown.points.size(), closed->noise_mm)
                  : proposeCells(scan, view.rotation);
  });
  requireMemory(frame, availableBytes(),
                colourBytes(frame.size, hasColours(scan), hasIntensities(scan)));
  const double dx = frame.first_x_mm - box.min.x;
  const double dy = frame.first_y_mm - box.min.y;
  // Depths relative to the box's lowest z, so that float holds them well whatever the elevation.
  const DepthRequest request{.scan = shown,
                             .view_from_file = viewFromFile(view.rotation, mm, dx, dy, -box.min.z),
                             .frame = frame,
                             .rule = requestedRule(scan, options)};
  CapturedDepths depths = engine(request, task);
  sayRule(surface, scan, depths);
  if (closed) addFront(closed->surface, frame, depths);
  const HiddenSurface in_front =
      depths.hidden ? *depths.hidden : countHidden(request, depths.front, task);
  const std::size_t outliers = depths.outliers + (closed ? closed->strays : 0);
  surface.depth_buffer = depths.depth_buffer;
  surface.seconds.grid = watch.lap();

  task.report("Filling gaps", 0.0);
  FilledMap filled = fillDepths(
      std::move(depths), frame,
      {.has_sampling_gaps = scan.triangles.empty(), .gaps_are_known = closed.has_value()},
      options.holes, task);
  surface.seconds.fill = watch.lap();
  surface.view_name = view.name;
  surface.engine = options.engine;
  surface.view_from_file = viewFromFile(view.rotation, mm, dx, dy, -box.min.z - filled.base_z_mm);
  surface.map = std::move(filled.map);
  if (surface.depth_buffer) {
    surface.depth_buffer->near_z_mm -= filled.base_z_mm;
    surface.depth_buffer->far_z_mm -= filled.base_z_mm;
    sayDepthBuffer(surface);
  }
  surface.quality = std::move(filled.quality);
  HiddenSurface hidden = in_front;
  if (closed) {
    addHidden(closed->surface, static_cast<double>(closed->hidden), originCounts(surface.map),
              hidden);
  }
  surface.losses =
      lossesOf(hidden, outliers, filled.seen_through_points, originCounts(surface.map));
  say(surface.messages,
      lossReport(*surface.losses, filled.seen_through, originShares(surface.map)));
  if (scan.triangles.empty() && options.rule) {
    say(surface.messages, mixedLayerWords(*options.rule, in_front, originCounts(surface.map)));
  }
  takeHoles(surface, std::move(filled.holes), options.holes);
  finish(surface, options, watch, task);
  addColours(surface, scan, task);
  surface.seconds.colours = watch.lap();
  return surface;
}

Surface makeSurface(const RasterMap& raster, const SurfaceOptions& options, const Task& task) {
  Surface surface;
  surface.info = raster.info;
  surface.is_raster = true;
  surface.messages = raster.info.warnings;
  Stopwatch watch;
  if (raster.is_own_map) {
    takeOwnMap(surface, raster);
    if (options.holes.rule != HoleRule::base) {
      surface.not_done.push_back(said<MessageId::map_taken_as_it_is>());
    }
  } else {
    const std::optional<RasterMap> cleaned = withoutMissing(raster, surface, options);
    takeForeignRaster(surface, cleaned ? *cleaned : raster, options, task);
  }
  surface.seconds.grid = watch.lap();
  finish(surface, options, watch, task);
  addColours(surface, GridColours(raster.colours), task);
  surface.seconds.colours = watch.lap();
  return surface;
}

}  // namespace relievo
