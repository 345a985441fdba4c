// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/large_points.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "core/depth/rules/point_rule.h"
#include "core/io/file_check.h"
#include "core/message/catalogue.h"
#include "core/session/choices.h"
#include "core/session/closed_cloud.h"
#include "core/session/colours/cloud_colours.h"
#include "core/session/large/large_memory.h"
#include "core/session/loss_report.h"
#include "core/tiles/job/job_parts.h"
#include "core/tiles/tile_layout.h"

namespace relievo {
namespace {

PointSource sourceOf(const PointFiles& stream) {
  return {.count = stream.info().points,
          .read = [&stream](std::uint64_t first, std::span<FilePoint> block) {
            return stream.read(first, block);
          }};
}

/// The points in the view, from the lower corner of their box.
ViewBlocks blocksOf(const PointSource& source, const ViewFromFile& view_from_file,
                    const ViewMm& corner) {
  return [&source, view_from_file, corner](const auto& take) {
    std::vector<ViewMm> moved;
    forEachBlock(source, 0, source.count, [&](std::span<const FilePoint> block) {
      moved.clear();
      for (const FilePoint& p : block) moved.push_back(view_from_file(p) - corner);
      take(moved);
    });
  };
}

/// Decides in 3-D what is seen, as for clouds in memory.
void findFront(Placed& placed, const Scan& sample, const ViewFromFile& view_from_file,
               const Task& task) {
  const SourceBounds& bounds = placed.points.bounds;
  std::vector<ViewMm> seen;
  const ViewBox box{.min = {}, .max = bounds.max - bounds.min};
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    seen.push_back(view_from_file(sample.point(i)) - bounds.min);
  }
  placed.front = frontOf(blocksOf(placed.points.source, view_from_file, bounds.min), seen, box,
                         bounds.finite_points, task);
}

/// How fine a grid the points on the front carry, by a sample of them.
CellProposal cellsByFront(const FrontSurface& front, const Scan& sample,
                          const ViewFromFile& view_from_file, const SourceBounds& bounds) {
  std::vector<ViewMm> on_front;
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    const ViewMm p = view_from_file(sample.point(i)) - bounds.min;
    if (front.sideOf(p) == FrontSurface::Side::front) on_front.push_back(p);
  }
  const double share = static_cast<double>(on_front.size()) /
                       static_cast<double>(std::max<std::size_t>(sample.points.size(), 1));
  const double noise_mm =
      noiseOnFront(front, on_front.size(), [&](std::size_t i) { return on_front[i]; });
  return cellsOf(front, {.min = bounds.min, .max = bounds.max},
                 static_cast<std::uint64_t>(share * static_cast<double>(bounds.finite_points)),
                 noise_mm);
}

}  // namespace

Placed place(Surface& facts, const PointFiles& stream, const Scan& sample,
             const SurfaceOptions& options, const LargeMapOptions& large, const Task& task) {
  Placed placed;
  facts.info.bounds = sample.info.bounds;
  chooseUnit(facts, options);
  placed.rotation = chosenRotation(
      sample, options.view.value_or(ViewChoice{.name = "auto", .rotation = {}}), task);
  say(facts.messages, placed.rotation.note);
  const double mm = mmPer(facts.unit);
  const ViewFromFile turned = viewFromFile(placed.rotation.rotation, mm, 0, 0, 0);
  placed.points = sourceInUse(sourceOf(stream), sample, placed.rotation.rotation, turned, options,
                              large.threads, task);
  const SourceBounds& bounds = placed.points.bounds;
  facts.info.finite_points = bounds.finite_points;
  facts.info.bounds = bounds.file;
  const RotatedBounds box{.min = bounds.min, .max = bounds.max};
  findFront(placed, sample, turned, task);
  placed.frame = chooseFrame(
      facts, options, box,
      [&] {
        return placed.front ? cellsByFront(*placed.front, sample, turned, bounds)
                            : proposeCells(sample, placed.rotation.rotation, bounds.finite_points);
      },
      MapPlace::tiles);
  placed.lowest_mm = bounds.min.z;
  placed.range_mm = bounds.max.z - bounds.min.z;
  placed.view_from_file =
      viewFromFile(placed.rotation.rotation, mm, placed.frame.first_x_mm - bounds.min.x,
                   placed.frame.first_y_mm - bounds.min.y, -bounds.min.z);
  facts.view_name = placed.rotation.name;
  return placed;
}

namespace {

void sayRule(LargeMap& map, const RuleProposal& rule, bool merges) {
  const Message words = ruleAndWhy(rule);
  map.rule = englishText(words);
  map.messages.push_back(said<MessageId::heights_by_rule>(words));
  if (merges) map.messages.push_back(said<MessageId::points_were_merged>());
}

/// A band of rows as the surface in front says.
DepthRows withFront(const FrontSurface& front, const GridFrame& frame, DepthRows rows) {
  rows.between.resize(rows.front.size(), std::numeric_limits<float>::quiet_NaN());
  addFront(front, frame,
           {.rows = {.first = rows.first_row, .end = rows.first_row + rows.rows},
            .depths = rows.front.data(),
            .between = rows.between.data(),
            .steep = rows.steep.empty() ? nullptr : rows.steep.data()});
  return rows;
}

}  // namespace

void sayLeftOut(Surface& facts, const SourceInUse& points, const SurfaceOptions& options) {
  if (points.suspect) {
    facts.messages.push_back(suspectWords(*points.suspect));
  } else if (points.missing > 0) {
    facts.messages.push_back(missingWords(points.missing, *options.nodata->value));
  }
  say(facts.messages, strayWords(points.strays));
}

namespace {

/// The points in tiles and the heights of their cells, made when they are asked for: with all rows
/// known from before, never.
class GriddedPoints {
 public:
  GriddedPoints(const PointFiles& stream, const Placed& placed, const SurfaceOptions& options,
                const LargeMapOptions& large, const MemoryPlan& plan, JobFolder* job)
      : placed_(placed),
        options_(options),
        large_(large),
        plan_(plan),
        job_(job),
        merges_(options.rule && isMergeable(*options.rule)),
        points_(stream.info().points) {}

  bool merges() const noexcept { return merges_; }
  const KnownParts& known() const noexcept { return known_; }
  std::uint64_t spilledBytes() const noexcept { return store_ ? store_->spilledBytes() : 0; }

  PointDecisions decide(const Task& task) {
    PointDecisions decided{.rule = {}, .left_out = sort(task)};
    if (options_.rule) {
      decided.rule = {.rule = *options_.rule, .reason = said<MessageId::rule_as_chosen>()};
      return decided;
    }
    store_->keepWithin(samplingBytes(plan_, placed_.frame, large_, samplePoints(*store_)));
    decided.rule = proposeRule(*store_, placed_.frame.spacing_mm, task);
    return decided;
  }

  const DepthRows& row(int tile_row, PointRule rule, const Task& task) {
    if (!maker_) {
      if (!store_) sort(task);
      GriddingRoom room;
      if (!merges_) {
        const GriddingMemory memory = griddingMemory(
            plan_, placed_.frame, large_, griddingNeeds(*store_, rule, amplePoints(plan_)));
        store_->keepWithin(memory.store_bytes);
        room = memory.room;
      }
      maker_.emplace(*store_, rule, placed_.frame.spacing_mm, room, task);
    }
    return maker_->row(tile_row, task);
  }

 private:
  LeftOut sort(const Task& task) {
    store_.emplace(placed_.frame.size,
                   TileStoreOptions{.merges = merges_,
                                    .memory_bytes = plan_.points_bytes,
                                    .spill_folder = spillFolder(large_),
                                    .sum_unit_mm = sumUnit(points_, placed_.range_mm),
                                    .edge_cells = kRuleReach,
                                    .threads = large_.threads});
    const FrontSurface* front = placed_.front ? &*placed_.front : nullptr;
    if (job_ == nullptr) {
      return scatterIntoTiles(placed_.points.source, placed_.view_from_file, placed_.frame, *store_,
                              task, front);
    }
    known_ = {};
    return scatterByParts(placed_.points.source, placed_.view_from_file, placed_.frame, *store_,
                          *job_, large_.job.part_points, known_, task, front);
  }

  const Placed& placed_;
  const SurfaceOptions& options_;
  const LargeMapOptions& large_;
  const MemoryPlan& plan_;
  JobFolder* job_;
  bool merges_;
  std::uint64_t points_;
  std::optional<TileStore> store_;
  std::optional<DepthMaker> maker_;
  KnownParts known_;
};

void sayTakenOver(LargeMap& map, const KnownParts& known, int rows, int all_rows, int damaged) {
  map.taken_over = {.points = known.points, .parts = known.parts, .rows = rows, .damaged = damaged};
  if (known.parts > 0 || rows > 0) {
    map.messages.push_back(said<MessageId::went_on_with_earlier_work>(
        CountArgument::grouped(known.points), rows, all_rows));
  }
  if (damaged > 0) {
    map.messages.push_back(said<MessageId::damaged_work_made_anew>(damaged));
  }
}

}  // namespace

std::unique_ptr<StoredDepths> gridPoints(LargeMap& map, const PointFiles& stream,
                                         const Placed& placed, const SurfaceOptions& options,
                                         const LargeMapOptions& large, const MemoryPlan& plan,
                                         JobFolder* job, const TakeDepthRows& on_rows,
                                         const Task& task) {
  GriddedPoints points(stream, placed, options, large, plan, job);
  const FrontSurface* front = placed.front ? &*placed.front : nullptr;
  std::optional<PointDecisions> decided = job != nullptr ? loadDecisions(*job) : std::nullopt;
  if (!decided) {
    decided = points.decide(task);
    if (job != nullptr) keepDecisions(*job, *decided);
  }
  const RuleProposal& rule = decided->rule;
  const LeftOut& left_out = decided->left_out;
  sayRule(map, rule, points.merges());
  // The store has its memory; depths go to the disk.
  const GridSize size = placed.frame.size;
  std::unique_ptr<StoredDepths> depths(new StoredDepths{.front = {size, 0, spillFolder(large)},
                                                        .between = {},
                                                        .points = {},
                                                        .steep = BitRows(size),
                                                        .hidden = {},
                                                        .left_out = {}});
  depths->one_layer = !options.rule && isForOneLayer(rule.rule);
  int known_rows = 0;
  const int tile_rows = TileLayout{size}.down();
  for (int y = 0; y < tile_rows; ++y) {
    task.check();
    std::optional<DepthRows> known =
        job != nullptr ? loadRows(*job, y, size) : std::optional<DepthRows>();
    known_rows += known ? 1 : 0;
    const DepthRows& found = known ? *known : points.row(y, rule.rule, task);
    if (job != nullptr && !known) keepRows(*job, y, found);
    const DepthRows seen = front != nullptr ? withFront(*front, placed.frame, found) : DepthRows{};
    const DepthRows& rows = front != nullptr ? seen : found;
    depths->front.write(rows.first_row, rows.rows, rows.front.data());
    StoredDepths::keep(depths->between, rows, rows.between, size, spillFolder(large));
    // What shows through gaps is looked for in clouds of several layers only.
    if (!depths->one_layer) {
      StoredDepths::keep(depths->points, rows, rows.points, size, spillFolder(large));
    }
    if (rows.hidden) depths->hidden = depths->hidden.value_or(HiddenSurface{}) + *rows.hidden;
    depths->outliers += rows.outliers;
    depths->steep.setRows(rows.first_row, rows.steep);
    if (on_rows) on_rows(rows);
  }
  map.spilled_bytes = points.spilledBytes();
  if (job != nullptr) sayTakenOver(map, points.known(), known_rows, tile_rows, job->damaged());
  depths->left_out = left_out;
  depths->outliers += left_out.strays;
  // Where points are merged as they come, what is behind was never put in.
  if (front != nullptr && points.merges()) {
    depths->hidden = HiddenSurface{.hidden = 0, .all = static_cast<double>(left_out.on_front)};
  }
  return depths;
}

}  // namespace relievo
