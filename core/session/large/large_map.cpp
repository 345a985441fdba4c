// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/large_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/failure.h"
#include "core/base/plain_bytes.h"
#include "core/depth/fill/band_fill.h"
#include "core/depth/fill/losses.h"
#include "core/depth/fill/membrane.h"
#include "core/depth/rules/point_rule.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/file_check.h"
#include "core/io/input_facts.h"
#include "core/io/point_files.h"
#include "core/io/raster/raster_rows.h"
#include "core/io/scan_builder.h"
#include "core/session/choices.h"
#include "core/session/closed_cloud.h"
#include "core/session/colours/cloud_colours.h"
#include "core/session/large/large_colours.h"
#include "core/session/large/large_memory.h"
#include "core/session/large/large_points.h"
#include "core/session/large/ready_rows.h"
#include "core/session/loss_report.h"
#include "core/session/source/missing_height.h"
#include "core/session/source/raster_in_use.h"
#include "core/session/source/source_in_use.h"
#include "core/tiles/colours/colour_files.h"
#include "core/tiles/job/job_parts.h"
#include "core/tiles/level_files.h"
#include "core/tiles/points/scatter.h"
#include "core/tiles/tile_layout.h"

namespace relievo {
namespace {

constexpr std::uint64_t kFirstSample = 250'000;
constexpr std::uint64_t kSecondSample = 2'000'000;
constexpr int kFirstViewCells = 400;
constexpr int kSecondViewCells = 800;

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// @throw FileError  it is none, or triangles would be lost
void requireStreamable(const std::filesystem::path& file, const InputFacts& facts) {
  if (!facts.in_blocks) throw failure<MessageId::not_read_in_blocks>(shownName(file));
  if (facts.has_faces) throw failure<MessageId::mesh_in_blocks>(shownName(file));
}

/// About `wanted` points in short runs at even distances: scans are often stored line by line, and
/// single points would each cost a page of the disk.
std::vector<PointRange> evenRuns(const PointFiles& stream, std::uint64_t wanted) {
  constexpr std::uint64_t kRun = 256;
  const std::uint64_t count = stream.info().points;
  const std::uint64_t runs = std::max<std::uint64_t>(1, wanted / kRun);
  std::vector<PointRange> ranges;
  std::uint64_t next = 0;  // Overlapping runs in small files are read once.
  for (std::uint64_t i = 0; i < runs && next < count; ++i) {
    const std::uint64_t start = std::max(next, count / runs * i + count % runs * i / runs);
    next = std::min(start + kRun, count);
    ranges.push_back({start, next - start});
  }
  return ranges;
}

/// Points for a look, as soon as they can be had: packed files cost where they are opened.
std::vector<PointRange> firstRuns(const PointFiles& stream, std::uint64_t wanted) {
  const std::vector<PointRange> cheap = stream.cheapSample(wanted);
  return cheap.empty() ? evenRuns(stream, wanted) : cheap;
}

Scan sampleOf(const PointFiles& stream, const std::vector<PointRange>& ranges, const Task& task) {
  constexpr std::uint64_t kAtOnce = 16384;
  ScanBuilder builder(stream.info().file, std::numeric_limits<std::uint64_t>::max());
  std::vector<FilePoint> block(kAtOnce);
  // Short runs are asked for together.
  std::vector<PointRange> together;
  std::size_t points = 0;
  const auto take = [&] {
    task.check();
    const std::span<FilePoint> found = std::span(block).first(std::exchange(points, 0));
    stream.read(together, found);
    together.clear();
    for (const FilePoint& p : found) builder.addPoint(p.x, p.y, p.z);
  };
  for (const PointRange& range : ranges) {
    for (std::uint64_t done = 0; done < range.count;) {
      const std::uint64_t part = std::min(range.count - done, kAtOnce - points);
      together.push_back({range.first + done, part});
      points += static_cast<std::size_t>(part);
      done += part;
      if (points == kAtOnce) take();
    }
  }
  take();
  ScanInfo info = stream.info();
  Scan scan = builder.finish();
  info.bounds = scan.info.bounds;
  info.finite_points = scan.info.finite_points;
  scan.info = info;
  if (scan.points.empty()) {
    throw failure<MessageId::sample_not_finite>(shownName(info.file));
  }
  return scan;
}

Surface viewOf(const Scan& sample, SurfaceOptions options, int most_cells, const Task& task) {
  const double share = static_cast<double>(sample.points.size()) /
                       static_cast<double>(std::max<std::uint64_t>(sample.info.points, 1));
  // As fine as its points carry, and never finer than what is asked for.
  const int cells = std::min(
      most_cells, static_cast<int>(std::sqrt(static_cast<double>(sample.points.size()) / 2)));
  options.cells = std::min(options.cells.value_or(cells), std::max(cells, 24));
  options.spacing_mm.reset();
  options.engine = "cpu";
  Surface surface = makeSurface(sample, options, rasterize, task);
  surface.messages.push_back(
      said<MessageId::first_view_of_some_points>(static_cast<int>(std::ceil(100 * share))));
  return surface;
}

/// Counts what the report says of the finest level.
class FinestLevel {
 public:
  void add(const float* heights_mm, const CellStatus* origins, int cols) {
    for (int i = 0; i < cols; ++i) {
      ++counts_[static_cast<std::size_t>(origins[i])];
      if (origins[i] == CellStatus::outside) continue;
      low_ = std::min(low_, heights_mm[i]);
      high_ = std::max(high_, heights_mm[i]);
    }
  }
  const OriginCounts& counts() const { return counts_; }
  void into(LargeMap& map) const {
    std::size_t all = 0;
    for (const std::size_t count : counts_) all += count;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      map.shares[i] = static_cast<double>(counts_[i]) / static_cast<double>(all);
    }
    if (low_ <= high_) map.heights = {.min_mm = low_, .max_mm = high_};
  }

 private:
  OriginCounts counts_{};
  float low_ = std::numeric_limits<float>::infinity();
  float high_ = -std::numeric_limits<float>::infinity();
};

void copyFacts(const Surface& from, LargeMap& to) {
  to.info = from.info;
  to.unit = from.unit;
  to.unit_source = from.unit_source;
  to.view_name = from.view_name;
  to.messages = from.messages;
}

/// Depths of all cells by rows, and what was seen while they were made.
struct DepthSource {
  BandDepths depths;
  GridFrame frame;
  FillSource fill;
  std::optional<HiddenSurface> hidden = std::nullopt;  ///< Of the points in the tiles.
  const FrontSurface* front = nullptr;                 ///< Of a cloud that lies behind itself ...
  LeftOut left_out;                                    ///< ... and what is not on it.
  std::size_t outliers = 0;
  const StreamedValues* values = nullptr;  ///< What a cloud's points say beside; null: nothing ...
  std::function<bool(const FilePoint&)> keeps = {};  ///< ... and which of them take part.
};

void sayLosses(LargeMap& map, const DepthSource& source, const BandFill& fill,
               const OriginCounts& cells, const std::optional<PointRule>& chosen) {
  std::optional<HiddenSurface> hidden = source.hidden;
  if (hidden && source.front != nullptr) {
    addHidden(*source.front, static_cast<double>(source.left_out.hidden), cells, *hidden);
  }
  if (hidden) map.losses = lossesOf(*hidden, source.outliers, fill.seenThroughPoints(), cells);
  say(map.messages, lossReport(map.losses.value_or(DepthLosses{}), fill.seenThrough(), map.shares));
  if (source.hidden && chosen) {
    say(map.messages, mixedLayerWords(*chosen, *source.hidden, cells));
  }
}

/// From depths to files: what both kinds of input have in common.
/// @param view  gives the matrix for the base plane that was found
/// @param job   where finished parts lie; null: nowhere
void fillAndWrite(LargeMap& map, const DepthSource& source, const SurfaceOptions& options,
                  const LargeMapOptions& large, const MemoryPlan& plan, JobFolder* job,
                  const std::function<ViewFromFile(double base_z_mm)>& view, const Task& task) {
  const auto start = Clock::now();
  std::optional<JobBands> kept;
  if (job != nullptr) kept.emplace(*job);
  std::optional<BandFill> fill(std::in_place, source.depths, source.frame, source.fill,
                               options.holes,
                               BandOptions{.memory_bytes = plan.depths_bytes,
                                           .threads = large.threads,
                                           .rows = kTileSide,
                                           .processes = large.processes,
                                           .keeper = kept ? &*kept : nullptr},
                               task);
  TakenOver& taken_over = map.taken_over ? *map.taken_over : map.taken_over.emplace();
  if (!large.processes->isAlone()) taken_over.filled = fill->fillForOthers(task);
  map.seconds.fill = secondsSince(start);
  map.view_from_file = view(fill->baseZMm());
  map.holes = fill->holes();
  say(map.not_done, holesLeft(map.holes, options.holes));
  if (!large.processes->isFirst()) {
    map.frames = PyramidRows::frames(source.frame, options.pyramid);
    return;
  }
  std::optional<CloudColours> colours;
  if (source.values != nullptr) {
    colours.emplace(map, source.frame, *source.values, source.keeps, large, plan.values_bytes,
                    task);
  }
  const auto write_start = Clock::now();
  LevelFiles files(large.file, source.frame, options.pyramid);
  FinestLevel finest;
  fill->write(
      [&](int, const float* heights, const CellStatus* origins) {
        finest.add(heights, origins, source.frame.size.cols);
        files.add(heights, origins);
        if (colours) colours->add(heights, origins, task);
      },
      task);
  if (large.processes->isAlone()) taken_over.filled = fill->bandsThere();
  finest.into(map);
  sayLosses(map, source, *fill, finest.counts(), options.rule);
  map.frames = files.frames();
  map.seconds.pyramid = secondsSince(write_start);
  fill.reset();  // Its memory is for the colours.
  const auto colours_start = Clock::now();
  std::unique_ptr<ColourFiles> colour_files;
  if (colours) {
    colour_files = colours->write(map, options.pyramid.factor, task);
  }
  map.seconds.colours = secondsSince(colours_start);
  files.finish(map.view_from_file, large.state ? large.state(map) : std::string(),
               colour_files.get());
}

/// What is in memory beside the tiles as long as points are read: the surface in front, and what of
/// a packed file is unpacked, once for the places and once for what is stored beside them.
std::uint64_t heldBytes(const PointFiles& stream, const Placed& placed, int threads) {
  return (placed.front ? placed.front->bytes() : 0) +
         2 * static_cast<std::uint64_t>(stream.keptBytes(threads));
}

/// Free bytes where a folder is; nothing: not known.
std::optional<std::filesystem::space_info> spaceOf(const std::filesystem::path& folder) {
  std::error_code unknown;
  const auto space = std::filesystem::space(folder, unknown);
  return unknown ? std::nullopt : std::optional(space);
}

/// @param job  where finished parts lie, of a new one as much as all of them take; null: nowhere
void requireSpace(const GridFrame& frame, const SurfaceOptions& options,
                  const LargeMapOptions& large, std::optional<std::uint64_t> points,
                  const MemoryPlan& plan, const JobFolder* job) {
  const std::filesystem::path folder = spillFolder(large);
  const auto free = [](const auto& space) {
    return space ? std::optional<std::uint64_t>(space->available) : std::nullopt;
  };
  const auto space = spaceOf(folder);
  std::optional<std::uint64_t> to_spill = points;
  if (points && job != nullptr) to_spill = 0;  // They lie in the job's folder.
  std::uint64_t needed = diskBytes(PyramidRows::frames(frame, options.pyramid), to_spill, plan);
  if (job != nullptr && job->isNew()) {
    // Points as they are kept; heights, heights between and points of each cell; filled rows.
    constexpr std::uint64_t kCell = 3 * sizeof(float) + sizeof(float) + 1;
    const std::uint64_t kept = sizeof(CellPoint) * points.value_or(0) + kCell * frame.size.count();
    const auto of_job = spaceOf(large.job.folder);
    const bool is_same_disk = space && of_job && *space == *of_job;
    if (is_same_disk) needed += kept;
    requireDisk(frame, large.job.folder, kept, free(of_job));
  }
  requireDisk(frame, folder, needed, free(space));
}

/// What the largest hole that may get a membrane takes while it is solved.
std::uint64_t membraneBytes(const GridFrame& frame, const HoleChoice& holes) {
  if (holes.rule != HoleRule::membrane) return 0;
  const double cells = holes.max_area_mm2 / frame.spacing_mm / frame.spacing_mm;
  const auto most = static_cast<double>(std::min(kMostMembraneCells, frame.size.count()));
  return kMembraneCellBytes * static_cast<std::uint64_t>(std::clamp(cells, 0.0, most));
}

/// What the work may take, asked before it; and the options with the number of threads in them.
/// @param points, held  as diskBytes and planMemory @throw ArgumentError, WriteError
MemoryPlan planWork(const GridFrame& frame, const SurfaceOptions& options, LargeMapOptions& large,
                    std::optional<std::uint64_t> points, const JobFolder* job,
                    const std::function<std::uint64_t(int threads)>& held) {
  const std::uint64_t membranes = membraneBytes(frame, options.holes);
  const MemoryPlan plan =
      planMemory(frame, large, [&](int threads) { return membranes + (held ? held(threads) : 0); });
  large.threads = plan.threads;
  requireSpace(frame, options, large, points, plan, job);
  return plan;
}

/// Tells how far the heights are; null: nobody looks.
TakeDepthRows readyTeller(const Placed& placed, const Surface& sample,
                          const LargeMapOptions& large) {
  if (!large.on_ready) return {};
  const auto ready = std::make_shared<ReadyRows>(placed.frame, kSecondViewCells);
  ready->beginWith(sample, placed.view_from_file, placed.lowest_mm);
  return [ready, &large, told = Clock::now()](const DepthRows& rows) mutable {
    ready->add(rows);
    const bool is_whole = ready->now().rows == ready->now().whole.rows;
    if (!is_whole && secondsSince(told) < large.ready_every_s) return;
    told = Clock::now();
    large.on_ready(ready->now());
  };
}

/// Where finished parts lie; null: nowhere.
std::unique_ptr<JobFolder> folderFor(const LargeMapOptions& large) {
  if (large.job.folder.empty()) return nullptr;
  return std::make_unique<JobFolder>(large.job.folder, large.job.facts, large.processes);
}

/// The map is there; the folder goes.
void endWork(LargeMap& map, JobFolder* job, const LargeMapOptions& large) {
  if (job == nullptr) {
    map.taken_over.reset();
    return;
  }
  TakenOver& taken_over = map.taken_over ? *map.taken_over : map.taken_over.emplace();
  for (const std::string& one : large.processes->share(plainBytes(job->damaged()))) {
    int of_one = 0;
    PlainBytes(one).take(of_one);
    taken_over.damaged += of_one;
  }
  if (taken_over.damaged > 0) {
    map.messages.push_back(said<MessageId::damaged_work_made_anew>(taken_over.damaged));
  }
  if (large.processes->isFirst()) job->finish();
}

LargeMap fromPoints(const std::vector<std::filesystem::path>& inputs, const SurfaceOptions& options,
                    const LargeMapOptions& asked, const ImportOptions& import, const Task& task) {
  const auto start = Clock::now();
  if (options.engine != "cpu") {
    throw failure<MessageId::tiles_by_cpu_only>();
  }
  const std::unique_ptr<JobFolder> job = folderFor(asked);
  const PointFiles stream(inputs, import, task);
  LargeMap map;
  if (asked.on_view) {
    const Scan sample = sampleOf(stream, firstRuns(stream, kFirstSample), task);
    const Surface view = viewOf(sample, options, kFirstViewCells, task);
    map.first_view_s = secondsSince(start);
    asked.on_view(view);
  }
  Surface made;
  made.info = stream.info();
  made.messages = stream.info().warnings;
  Scan sample = sampleOf(stream, evenRuns(stream, kSecondSample), task);
  const std::optional<double> missing = missingHeight(options.nodata, suspectHeight(sample));
  const ScanInUse sample_in_use(sample, options.strays, missing, task);
  const Placed placed = place(made, stream, sample_in_use.scan(), options, asked, task);
  map.strays = placed.points.strays;
  map.missing = placed.points.missing;
  sayLeftOut(made, placed.points, options);
  LargeMapOptions large = asked;
  const bool merges = options.rule && isMergeable(*options.rule);
  const MemoryPlan plan =
      planWork(placed.frame, options, large, merges ? 0 : made.info.finite_points, job.get(),
               [&](int threads) { return heldBytes(stream, placed, threads); });
  TakeDepthRows on_rows;
  if (large.on_view) {
    const Surface view = viewOf(sample, options, kSecondViewCells, task);
    large.on_view(view);
    on_rows = readyTeller(placed, view, large);
  }
  sample = {};
  copyFacts(made, map);
  map.engine = "cpu";
  const StreamedValues values(inputs, import, large.threads, task);
  const bool with_values = takeValues(map, values, plan);
  if (with_values) requireFreeNames(PyramidRows::frames(placed.frame, options.pyramid), large.file);
  map.seconds.read = secondsSince(start);

  const auto grid_start = Clock::now();
  const auto depths =
      gridPoints(map, stream, placed, options, large, plan, job.get(), on_rows, task);
  // All heights are there: the points are not needed again.
  if (job && large.processes->isFirst()) job->remove("points");
  map.seconds.grid = secondsSince(grid_start);
  fillAndWrite(
      map,
      {.depths = depths->rows(),
       .frame = placed.frame,
       .fill = {.has_sampling_gaps = true, .gaps_are_known = placed.front.has_value()},
       .hidden = depths->hidden,
       .front = placed.front ? &*placed.front : nullptr,
       .left_out = depths->left_out,
       .outliers = depths->outliers,
       .values = with_values ? &values : nullptr,
       .keeps = placed.points.keeps},
      options, large, plan, job.get(),
      [&](double base_z_mm) {
        ViewFromFile view = placed.view_from_file;
        view.m[11] = -placed.lowest_mm - base_z_mm;
        return view;
      },
      task);
  endWork(map, job.get(), large);
  return map;
}

/// An own map's rows become levels as they are.
void writeOwnMap(LargeMap& map, const RasterRows& raster, const GridFrame& frame,
                 const SurfaceOptions& options, const LargeMapOptions& large, const Task& task) {
  const auto start = Clock::now();
  LevelFiles files(large.file, frame, options.pyramid);
  FinestLevel finest;
  std::vector<float> heights(static_cast<std::size_t>(frame.size.cols));
  std::vector<CellStatus> origins(heights.size());
  for (int row = 0; row < frame.size.rows; ++row) {
    if (row % 16 == 0) task.check();
    std::fill(origins.begin(), origins.end(), CellStatus::measured);
    raster.read(row, 1, heights.data(), origins.data());
    for (std::size_t col = 0; col < heights.size(); ++col) {
      if (std::isnan(heights[col])) origins[col] = CellStatus::outside;
      if (origins[col] == CellStatus::outside) heights[col] = 0;
    }
    finest.add(heights.data(), origins.data(), frame.size.cols);
    files.add(heights.data(), origins.data());
  }
  map.view_from_file = raster.head().view_from_file.value_or(ViewFromFile{});
  finest.into(map);
  map.frames = files.frames();
  files.finish(map.view_from_file, large.state ? large.state(map) : std::string());
  map.seconds.pyramid = secondsSince(start);
}

GridFrame frameOf(GridSize size, double spacing_mm) {
  return {.size = size,
          .spacing_mm = spacing_mm,
          .first_x_mm = 0.5 * spacing_mm,
          .first_y_mm = 0.5 * spacing_mm};
}

/// A raster from elsewhere: its samples stay, the lowest lies on the base plane.
void writeForeign(LargeMap& map, Surface& facts, const RasterRows& rows,
                  const SurfaceOptions& options, LargeMapOptions& large, JobFolder* job,
                  Clock::time_point start, const Task& task) {
  const RasterHead& raster = rows.head();
  if (options.view && options.view->name != "top" && options.view->name != "auto" &&
      options.view->name != kEarlierAutomatic) {
    throw failure<MessageId::raster_from_the_top_only>();
  }
  const RasterInUse in_use(rows, options.nodata, task);
  const ScaleInUse scale = scaleInUse(raster, facts.unit, facts.unit_source, options.raster,
                                      in_use.lowest(), in_use.highest());
  sayScale(facts, scale);
  copyFacts(facts, map);
  map.missing = in_use.missing();
  say(map.messages, in_use.messages());
  const GridFrame frame = frameOf(raster.size, scale.pixel_mm);
  const MemoryPlan plan = planWork(frame, options, large, std::nullopt, job, {});
  map.seconds.read = secondsSince(start);
  const double lowest = scale.lowest(in_use.lowest(), in_use.highest());
  fillAndWrite(
      map,
      {.depths = {.front = in_use.depths(scale.height_mm, lowest), .between = {}},
       .frame = frame,
       .fill = {.has_sampling_gaps = false,
                .base_quantile = 0,
                .base_z_mm = scale.baseAbove(lowest)},
       .left_out = {}},
      options, large, plan, job,
      [&](double base_z_mm) {
        const double mm = scale.pixel_mm / raster.pixel;
        ViewFromFile view = viewFromFile(
            *standardRotation("top"), mm, frame.first_x_mm - mm * raster.first.x,
            frame.first_y_mm - mm * raster.first.y, -(base_z_mm + lowest * scale.height_mm));
        view.m[kHeightScale] = scale.height_mm;
        return view;
      },
      task);
}

LargeMap fromRaster(const std::filesystem::path& file, const SurfaceOptions& options,
                    const LargeMapOptions& asked, const ImportOptions& import, const Task& task) {
  const auto start = Clock::now();
  LargeMapOptions large = asked;
  const std::unique_ptr<JobFolder> job = folderFor(large);
  const RasterRows rows = importRasterRows(file, spillFolder(large), import, task);
  const RasterHead& raster = rows.head();
  LargeMap map;
  Surface facts;
  facts.info = raster.info;
  facts.messages = raster.info.warnings;
  facts.view_name = raster.is_own_map ? "as stored" : "top";
  if (raster.is_own_map) {
    facts.unit_source = UnitSource::file;
    if (!rows.hasOrigins()) facts.messages.push_back(said<MessageId::map_without_origins>());
  } else {
    chooseUnit(facts, options);
  }
  if (raster.is_own_map && hasOwnColours(file)) {
    facts.messages.push_back(said<MessageId::colours_not_by_tiles>());
  }
  map.engine = raster.is_own_map ? "as stored" : "raster";
  map.rule = "as stored";
  if (!raster.is_own_map) {
    writeForeign(map, facts, rows, options, large, job.get(), start, task);
    endWork(map, job.get(), large);
    return map;
  }
  copyFacts(facts, map);
  GridFrame frame = frameOf(raster.size, raster.pixel);
  frame.first_x_mm = raster.first.x;
  frame.first_y_mm = raster.first.y;
  planWork(frame, options, large, std::nullopt, nullptr, {});
  map.seconds.read = secondsSince(start);
  if (large.processes->isFirst()) writeOwnMap(map, rows, frame, options, large, task);
  map.frames = PyramidRows::frames(frame, options.pyramid);
  endWork(map, job.get(), large);
  return map;
}

}  // namespace

LargeMap makeLargeMap(const std::vector<std::filesystem::path>& inputs,
                      const SurfaceOptions& options, const LargeMapOptions& asked,
                      const ImportOptions& import, const Task& task) {
  Alone alone;
  LargeMapOptions large = asked;
  if (large.processes == nullptr) large.processes = &alone;
  if (!large.processes->isAlone() && large.job.folder.empty()) {
    throw failure<MessageId::processes_need_folder>();
  }
  if (!large.processes->isFirst()) large.on_view = {};  // Who looks sees the first's.
  // Of several each must be a cloud; of one it may be a raster.
  const bool are_several = inputs.size() > 1;
  bool is_raster = false;
  std::vector<std::optional<InputFacts>> known(inputs.size());
  if (are_several) known = inputFacts(inputs, task);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const InputFacts facts = known[i] ? *known[i] : inputFacts(inputs[i], task);
    is_raster = !are_several && facts.kind != InputKind::scan;
    if (!is_raster) requireStreamable(inputs[i], facts);
  }
  LargeMap map = is_raster ? fromRaster(inputs.front(), options, large, import, task)
                           : fromPoints(inputs, options, large, import, task);
  map.file = large.file;
  large.processes->finish();
  return map;
}

LargeMap makeLargeMap(const std::filesystem::path& file, const SurfaceOptions& options,
                      const LargeMapOptions& large, const ImportOptions& import, const Task& task) {
  return makeLargeMap(std::vector{file}, options, large, import, task);
}

Surface sampleSurface(const std::filesystem::path& file, const SurfaceOptions& options,
                      std::uint64_t points, const ImportOptions& import, const Task& task) {
  requireStreamable(file, inputFacts(file, task));
  const PointFiles stream({file}, import, task);
  return viewOf(sampleOf(stream, firstRuns(stream, points), task), options, kSecondViewCells, task);
}

}  // namespace relievo
