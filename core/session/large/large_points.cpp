// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/large_points.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <limits>
#include <shared_mutex>
#include <string>
#include <thread>
#include <utility>

#include "core/base/failure.h"
#include "core/base/plain_bytes.h"
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
                              large.threads, task, large.processes);
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

  /// Puts all points into tiles; several processes do it together.
  void sort(const Task& task) {
    if (store_) return;
    store_.emplace(placed_.frame.size,
                   TileStoreOptions{.merges = merges_,
                                    .memory_bytes = plan_.points_bytes,
                                    .spill_folder = spillFolder(large_),
                                    .sum_unit_mm = sumUnit(points_, placed_.range_mm),
                                    .edge_cells = kRuleReach,
                                    .threads = large_.threads});
    const FrontSurface* front = placed_.front ? &*placed_.front : nullptr;
    if (job_ == nullptr) {
      left_out_ = scatterIntoTiles(placed_.points.source, placed_.view_from_file, placed_.frame,
                                   *store_, task, front);
      return;
    }
    known_ = {};
    left_out_ =
        scatterByParts(placed_.points.source, placed_.view_from_file, placed_.frame, *store_, *job_,
                       large_.job.part_points, known_, task, front, large_.processes);
  }

  PointDecisions decide(const Task& task) {
    sort(task);
    PointDecisions decided{.rule = {}, .left_out = left_out_};
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
      sort(task);
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

  /// Those of `rows` that this process makes: for each about as much work. @pre sorted
  std::vector<int> ownOf(const std::vector<int>& rows) const {
    const TileLayout layout{placed_.frame.size};
    std::vector<double> before{0};  // Work, in points.
    for (const int y : rows) {
      constexpr double kOfTile = 0.3 * kTileSide * kTileSide;
      double work = 0;
      for (int x = 0; x < layout.across(); ++x) {
        work += kOfTile + static_cast<double>(store_->pointsIn(y * layout.across() + x));
      }
      before.push_back(before.back() + work);
    }
    std::vector<int> own;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double middle = (before[i] + before[i + 1]) / 2 / before.back();
      const int rank = static_cast<int>(middle * large_.processes->ranks());
      if (rank == large_.processes->rank()) own.push_back(rows[i]);
    }
    return own;
  }

 private:
  const Placed& placed_;
  const SurfaceOptions& options_;
  const LargeMapOptions& large_;
  const MemoryPlan& plan_;
  JobFolder* job_;
  bool merges_;
  std::uint64_t points_;
  std::optional<TileStore> store_;
  LeftOut left_out_;
  std::optional<DepthMaker> maker_;
  KnownParts known_;
};

/// What follows from all points: as it was left, else decided by the first process.
PointDecisions decisionsFor(GriddedPoints& points, JobFolder* job, Exchange& processes,
                            const Task& task) {
  std::optional<PointDecisions> known =
      job != nullptr && processes.isFirst() ? loadDecisions(*job) : std::nullopt;
  const std::string told = processes.share(known ? bytesOfDecisions(*known) : "").front();
  if (!told.empty()) return *decisionsFrom(told);
  points.sort(task);
  std::string mine;
  if (processes.isFirst()) {
    const PointDecisions decided = points.decide(task);
    if (job != nullptr) keepDecisions(*job, decided);
    mine = bytesOfDecisions(decided);
  }
  return *decisionsFrom(processes.share(mine).front());
}

/// Rows of tiles with the heights that the points alone have.
class RowsMaker {
 public:
  RowsMaker(GriddedPoints& points, PointRule rule, GridSize size, JobFolder* job)
      : points_(points), rule_(rule), size_(size), job_(job) {}

  int count() const { return TileLayout{size_}.down(); }
  int known() const noexcept { return known_; }

  /// As it was left.
  std::optional<DepthRows> left(int tile_row) {
    std::optional<DepthRows> rows =
        job_ != nullptr ? loadRows(*job_, tile_row, size_) : std::optional<DepthRows>();
    known_ += rows ? 1 : 0;
    return rows;
  }
  const DepthRows& make(int tile_row, const Task& task) {
    task.check();
    const DepthRows& rows = points_.row(tile_row, rule_, task);
    if (job_ != nullptr) keepRows(*job_, tile_row, rows);
    return rows;
  }

  /// All rows, made by the processes together or left from before, lowest first; they lie in the
  /// folder.
  std::vector<RowsHead> together(Exchange& processes, const Task& task);

 private:
  GriddedPoints& points_;
  PointRule rule_;
  GridSize size_;
  JobFolder* job_;
  int known_ = 0;
};

std::vector<RowsHead> RowsMaker::together(Exchange& processes, const Task& task) {
  const auto [first, end] = processes.partOf(count());
  std::vector<RowsHead> mine;
  std::vector<int> missing;
  for (int y = first; y < end; ++y) {
    task.check();
    if (const std::optional<DepthRows> rows = left(y)) {
      mine.push_back(headOf(*rows));
    } else {
      missing.push_back(y);
    }
  }
  std::vector<int> all_missing;
  for (const std::string& one : processes.share(plainBytes(missing))) {
    std::vector<int> of_one;
    PlainBytes(one).take(of_one, one.size() / sizeof(int));
    all_missing.insert(all_missing.end(), of_one.begin(), of_one.end());
  }
  if (!all_missing.empty()) {
    points_.sort(task);
    for (const int y : points_.ownOf(all_missing)) mine.push_back(headOf(make(y, task)));
  }
  std::vector<RowsHead> heads;
  for (const std::string& one : processes.share(plainBytes(mine))) {
    std::vector<RowsHead> of_one;
    PlainBytes(one).take(of_one, one.size() / sizeof(RowsHead));
    heads.insert(heads.end(), of_one.begin(), of_one.end());
  }
  known_ = count() - static_cast<int>(all_missing.size());
  std::sort(heads.begin(), heads.end(),
            [](const RowsHead& a, const RowsHead& b) { return a.first_row < b.first_row; });
  return heads;
}

}  // namespace

StoredDepths::StoredDepths(GridSize size, std::filesystem::path spill_folder)
    : size_(size),
      spill_folder_(std::move(spill_folder)),
      front_(size, 0, spill_folder_),
      steep_(size) {}

/// Where there are any; the first ones decide.
void StoredDepths::keepIn(std::unique_ptr<RowStore>& store, const DepthRows& rows,
                          const std::vector<float>& values) const {
  if (values.empty()) return;
  if (!store) store = std::make_unique<RowStore>(size_, 0, spill_folder_);
  store->write(rows.first_row, rows.rows, values.data());
}

void StoredDepths::keep(const DepthRows& rows) {
  front_.write(rows.first_row, rows.rows, rows.front.data());
  keepIn(between_, rows, rows.between);
  // What shows through gaps is looked for in clouds of several layers only.
  if (!one_layer) keepIn(points_, rows, rows.points);
  steep_.setRows(rows.first_row, rows.steep);
}

void StoredDepths::comeFrom(std::function<DepthRows(int tile_row)> row, bool has_between,
                            bool has_points) {
  row_ = std::move(row);
  is_here_.resize(static_cast<std::size_t>(TileLayout{size_}.down()));
  if (has_between) between_ = std::make_unique<RowStore>(size_, 0, spill_folder_);
  if (has_points && !one_layer) points_ = std::make_unique<RowStore>(size_, 0, spill_folder_);
}

void StoredDepths::require(int first_row, int rows) {
  for (int y = first_row / kTileSide; y * kTileSide < first_row + rows; ++y) {
    const auto is_here = [&] { return is_here_[static_cast<std::size_t>(y)]; };
    {
      const std::shared_lock many(asks_);
      if (is_here()) continue;
    }
    const DepthRows found = row_(y);  // Another thread may ask for it as well.
    const std::unique_lock one(asks_);
    if (is_here()) continue;
    keep(found);
    is_here_[static_cast<std::size_t>(y)] = true;
  }
}

RowsOf StoredDepths::of(const RowStore& store) {
  return [this, &store](int first, int rows, float* out) {
    if (!row_) {
      store.read(first, rows, out);
      return;
    }
    require(first, rows);
    const std::shared_lock many(asks_);
    store.read(first, rows, out);
  };
}

BandDepths StoredDepths::rows() {
  return {.front = of(front_),
          .between = between_ ? of(*between_) : RowsOf{},
          .steep = &steep_,
          .one_layer = one_layer,
          .points = points_ ? of(*points_) : RowsOf{}};
}

namespace {

/// Another process made them and said so. A network's file system may remember for a while that
/// they were not there.
DepthRows rowsOfOthers(JobFolder& job, int tile_row, GridSize size) {
  constexpr int kTries = 60;
  constexpr std::chrono::seconds kPause{1};
  for (int i = 0; i < kTries; ++i) {
    if (i > 0) std::this_thread::sleep_for(kPause);
    if (std::optional<DepthRows> rows = loadRows(job, tile_row, size)) return *std::move(rows);
  }
  throw failure<MessageId::spill_not_kept>(job.fileOf("heights"), std::strerror(EIO));
}

void sayTakenOver(LargeMap& map, const KnownParts& known, int rows, int all_rows) {
  map.taken_over = TakenOver{.points = known.points, .parts = known.parts, .rows = rows};
  if (known.parts > 0 || rows > 0) {
    map.messages.push_back(said<MessageId::went_on_with_earlier_work>(
        CountArgument::grouped(known.points), rows, all_rows));
  }
}

}  // namespace

std::unique_ptr<StoredDepths> gridPoints(LargeMap& map, const PointFiles& stream,
                                         const Placed& placed, const SurfaceOptions& options,
                                         const LargeMapOptions& large, const MemoryPlan& plan,
                                         JobFolder* job, const TakeDepthRows& on_rows,
                                         const Task& task) {
  Exchange& processes = *large.processes;
  const GridSize size = placed.frame.size;
  GriddedPoints points(stream, placed, options, large, plan, job);
  const PointDecisions decided = decisionsFor(points, job, processes, task);
  sayRule(map, decided.rule, points.merges());
  // The store has its memory; depths go to the disk.
  auto depths = std::make_unique<StoredDepths>(size, spillFolder(large));
  depths->one_layer = !options.rule && isForOneLayer(decided.rule.rule);
  const auto count = [&depths](const RowsHead& head) {
    if (const auto hidden = hiddenOf(head)) {
      depths->hidden = depths->hidden.value_or(HiddenSurface{}) + *hidden;
    }
    depths->outliers += head.outliers;
  };
  const FrontSurface* front = placed.front ? &*placed.front : nullptr;
  RowsMaker maker(points, decided.rule.rule, size, job);
  if (processes.isAlone()) {
    for (int y = 0; y < maker.count(); ++y) {
      task.check();
      const std::optional<DepthRows> left = maker.left(y);
      const DepthRows& found = left ? *left : maker.make(y, task);
      count(headOf(found));
      const DepthRows seen =
          front != nullptr ? withFront(*front, placed.frame, found) : DepthRows{};
      const DepthRows& rows = front != nullptr ? seen : found;
      depths->keep(rows);
      if (on_rows) on_rows(rows);
    }
  } else {
    bool has_between = front != nullptr, has_points = false;
    for (const RowsHead& head : maker.together(processes, task)) {
      count(head);
      has_between = has_between || head.has_between != 0;
      has_points = has_points || head.has_points != 0;
    }
    const auto from_folder = [front, frame = placed.frame, job](int tile_row) {
      DepthRows rows = rowsOfOthers(*job, tile_row, frame.size);
      return front != nullptr ? withFront(*front, frame, std::move(rows)) : rows;
    };
    depths->comeFrom(from_folder, has_between, has_points);
  }
  map.spilled_bytes = points.spilledBytes();
  if (job != nullptr) sayTakenOver(map, points.known(), maker.known(), maker.count());
  depths->left_out = decided.left_out;
  depths->outliers += decided.left_out.strays;
  // Where points are merged as they come, what is behind was never put in.
  if (front != nullptr && points.merges()) {
    depths->hidden =
        HiddenSurface{.hidden = 0, .all = static_cast<double>(decided.left_out.on_front)};
  }
  return depths;
}

}  // namespace relievo
