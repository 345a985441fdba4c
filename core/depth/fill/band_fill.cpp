// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/band_fill.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>
#include <utility>

#include "core/base/failure.h"
#include "core/base/plain_bytes.h"
#include "core/base/threads.h"
#include "core/depth/fill/lowest_values.h"
#include "core/depth/layers/hidden_points.h"

namespace relievo {
namespace {

// Push-pull layers from this one on are kept whole (a 64th of the cells); the finer ones are made
// anew for each band. A band must begin at a multiple of 2^kPull and needs as many rows around.
constexpr int kPull = 3;
constexpr int kPullRows = 1 << kPull;

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

Mask measuredOf(const float* depths, std::size_t count) {
  Mask mask(count);
  for (std::size_t i = 0; i < count; ++i) mask[i] = depths[i] == depths[i] ? 1 : 0;
  return mask;
}

/// Layers 1 ... kPull of a band, pulled only.
std::vector<PushPullLayer> pulledLayers(std::span<const float> depths, const Mask& known,
                                        GridSize size) {
  std::vector<PushPullLayer> layers;
  layers.push_back(pulledFrom(depths, known, size));
  while (static_cast<int>(layers.size()) < kPull) layers.push_back(pulled(layers.back()));
  return layers;
}

PushPullLayer rowsOfLayer(const PushPullLayer& layer, int first, int rows) {
  const auto start = static_cast<std::ptrdiff_t>(layer.size.index({.col = 0, .row = first}));
  const auto end = start + static_cast<std::ptrdiff_t>(rows) * layer.size.cols;
  return {.size = {.cols = layer.size.cols, .rows = rows},
          .values = {layer.values.begin() + start, layer.values.begin() + end},
          .weights = {layer.weights.begin() + start, layer.weights.begin() + end}};
}

}  // namespace

BandFill::Band BandFill::bandOf(int number, int margin, int align) const noexcept {
  Band band;
  band.first = number * options_.rows;
  band.rows = std::min(options_.rows, frame_.size.rows - band.first);
  const int from = std::max(0, band.first - margin);
  band.from = from / align * align;
  const int to = band.first + band.rows + margin;
  band.to = std::min(frame_.size.rows, (to + align - 1) / align * align);
  return band;
}

int BandFill::bandCount() const noexcept {
  return (frame_.size.rows + options_.rows - 1) / options_.rows;
}

GridSize BandFill::sizeOf(const Band& band) const noexcept {
  return {.cols = frame_.size.cols, .rows = band.to - band.from};
}

std::size_t BandFill::cellsOf(const Band& band) const noexcept {
  return static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(frame_.size.cols);
}

std::size_t BandFill::startOf(const Band& band) const noexcept {
  return frame_.size.index({.col = 0, .row = band.first - band.from});
}

std::vector<float> BandFill::readDepths(const Band& band) const {
  std::vector<float> depths(sizeOf(band).count());
  given_.front.read(band.from, band.to - band.from, depths.data());
  if (dropped_) {
    const Mask dropped = dropped_->bytes(band.from, band.to - band.from);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      depths[i] = dropped[i] != 0 ? kNothing : depths[i];
    }
  }
  return depths;
}

BandFill::Depths BandFill::depthsOf(const Band& band) const {
  Depths depths;
  if (dropped_) {
    depths.read = readDepths(band);
    depths.at = depths.read.data();
  } else {
    depths.at = given_.front.rows(band.from, band.to - band.from, frame_.size, depths.read);
  }
  return depths;
}

BandFill::BandFill(BandDepths depths, const GridFrame& frame, const FillSource& source,
                   const HoleChoice& choice, const BandOptions& options, const Task& task)
    : given_(std::move(depths)),
      processes_(options.processes != nullptr ? *options.processes : alone_),
      frame_(frame),
      source_(source),
      choice_(choice),
      options_(options),
      threads_(threadCount(options.threads)),
      measured_(frame.size),
      empty_(frame.size) {
  markMeasured(task);
  const bool looks_for_gaps = source_.has_sampling_gaps && !source_.gaps_are_known;
  // A back can hide all gaps: then no cell is empty, and the radius is 0.
  int radius = looks_for_gaps ? samplingGapRadius(measured_) : 0;
  if (looks_for_gaps && !given_.one_layer) {
    widenBands(seeThroughReach(radius + 1));
    dropSeenThroughBands(radius + 1, task);
    radius = samplingGapRadius(measured_);
  }
  if (source_.gaps_are_known) radius = kCrackRadius;
  options_.rows = options.rows;
  widenBands(2 * radius);
  findHoles(radius, task);
  options_.rows = options.rows;
  pullAll(task);
  if (choice_.rule == HoleRule::membrane) layMembranes(task);
}

/// In memory bands may be as high as pays for so many rows around them; elsewhere their height is
/// that of what is kept.
void BandFill::widenBands(int around) {
  if (given_.front.all != nullptr) {
    options_.rows = std::max(options_.rows, 4 * around / kPullRows * kPullRows);
  }
}

void BandFill::forBands(const Step& step, const Task& task, const MakeBand& make,
                        const TakeBand& take) {
  const std::pair<int, int> part = processes_.partOf(bandCount());
  const int first = part.first;
  const int end = part.second;
  std::vector<std::string> made(static_cast<std::size_t>(threads_));
  std::string mine;
  orderedPipeline(
      end - first, threads_,
      [&](int place, int number) {
        task.check();
        made[static_cast<std::size_t>(place)] = make(first + number);
      },
      [&](int place, int number) {
        task.check();  // Whoever stops the work hears of no other step.
        task.report(step.words, step.from + (step.to - step.from) * number / (end - first));
        const std::string& found = made[static_cast<std::size_t>(place)];
        if (processes_.isAlone()) {
          take(number, found);
        } else {
          const std::uint64_t size = found.size();
          mine.append(plainBytes(size)).append(found);
        }
      });
  task.check();
  if (processes_.isAlone()) return;
  const std::vector<std::string> told = processes_.share(mine);
  int number = 0;
  for (const std::string& one : told) {
    std::string_view rest = one;
    while (!rest.empty()) {
      std::uint64_t size = 0;
      PlainBytes(rest).take(size);
      take(number++, rest.substr(sizeof(size), size));
      rest.remove_prefix(sizeof(size) + size);
    }
  }
}

void BandFill::markMeasured(const Task& task) {
  forBands(
      {.words = "Looking for gaps", .from = 0, .to = 0.5}, task,
      [&](int number) {
        const Band band = bandOf(number, 0, 1);
        const Depths depths = depthsOf(band);
        return packedRows(measuredOf(depths.at, cellsOf(band)), frame_.size.cols);
      },
      [&](int number, std::string_view found) {
        measured_.setPacked(bandOf(number, 0, 1).first, found);
      });
}

void BandFill::dropSeenThroughBands(int radius, const Task& task) {
  BitRows all(frame_.size);
  forBands(
      {.words = "Looking through gaps"}, task,
      [&](int number) {
        const Band band = bandOf(number, seeThroughReach(radius), 1);
        FrontDepths depths = readDepths(band);
        GridFrame frame = frame_;
        frame.size = sizeOf(band);
        const std::size_t dropped = dropSeenThrough(depths, frame, radius, task, 1);
        std::uint64_t points = 0;
        std::string bits;
        if (dropped > 0) {  // Maybe around only.
          Mask mask = measured_.bytes(band.first, band.rows);
          const float* const left = depths.data() + startOf(band);
          for (std::size_t i = 0; i < mask.size(); ++i) {
            mask[i] = static_cast<std::uint8_t>(mask[i] & (left[i] == left[i] ? 0 : 1));
          }
          points = pointsOf(mask, band);
          bits = packedRows(mask, frame_.size.cols);
        }
        return std::string(plainBytes(points)).append(bits);
      },
      [&](int number, std::string_view found) {
        std::uint64_t points = 0;
        PlainBytes(found).take(points);
        seen_through_points_ += points;
        found.remove_prefix(sizeof(points));
        seen_through_ += onesIn(found);
        all.setPacked(bandOf(number, 0, 1).first, found);
      });
  if (seen_through_ == 0) return;
  measured_.clear(all);
  dropped_ = std::move(all);
}

std::uint64_t BandFill::pointsOf(const Mask& cells, const Band& band) const {
  if (!given_.points || std::find(cells.begin(), cells.end(), 1) == cells.end()) return 0;
  std::vector<float> points(cells.size());
  given_.points(band.first, band.rows, points.data());
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != 0) all += static_cast<std::uint64_t>(points[i]);
  }
  return all;
}

/// @throw ArgumentError  E102
void BandFill::requireRoom() const {
  if (empty_.bytes() + plates_.bytes() > options_.memory_bytes) {
    throw failure<MessageId::map_areas_too_ragged>();
  }
}

void BandFill::findHoles(int radius, const Task& task) {
  forBands(
      {.words = "Looking for gaps", .from = 0.5, .to = 1}, task,
      [&](int number) {
        const Band band = bandOf(number, 2 * radius, 1);
        const GridSize size = sizeOf(band);
        Mask mask = measured_.bytes(band.from, size.rows);
        if (source_.gaps_are_known && given_.between) {
          std::vector<float> read;
          const float* const between = given_.between.rows(band.from, size.rows, frame_.size, read);
          mask = withBetween(std::move(mask), {between, size.count()});
        }
        mask = closed(mask, size, radius, 1);
        return packedRows(std::span(mask).subspan(startOf(band), cellsOf(band)), size.cols);
      },
      [&](int, std::string_view found) {
        empty_.addRows(found);
        requireRoom();
      });
  empty_.join();
  enclosed_ = empty_.enclosed(frame_);
  for (Hole& hole : enclosed_.holes) hole.filled = isToBeFilled(hole, choice_);
}

/// Is there a cell whose height comes from those around it?
bool BandFill::needsPull() const noexcept {
  if (frame_.size.count() - empty_.emptyCells() > measured_.count()) return true;
  return choice_.rule == HoleRule::interpolate &&
         std::any_of(enclosed_.holes.begin(), enclosed_.holes.end(),
                     [](const Hole& hole) { return hole.filled; });
}

void BandFill::pullAll(const Task& task) {
  const bool pulls = needsPull();
  const GridSize size = frame_.size;
  LowestValues lowest(measured_.count(), source_.base_quantile);
  PushPullLayer coarse;
  coarse.size = {.cols = (size.cols + kPullRows - 1) / kPullRows,
                 .rows = (size.rows + kPullRows - 1) / kPullRows};
  if (pulls || !source_.base_z_mm) {
    forBands(
        {.words = "Filling gaps", .from = 0, .to = 0.5}, task,
        [&](int number) {
          const Band band = bandOf(number, 0, 1);
          Depths depths = depthsOf(band);
          if (!source_.base_z_mm) lowest.add({depths.at, cellsOf(band)});
          if (!pulls) return std::string();
          std::vector<float> values =
              depths.read.empty() ? readDepths(band) : std::move(depths.read);
          addBetween(band, values);
          const PushPullLayer top =
              pulledLayers(values, measuredOf(values.data(), values.size()), sizeOf(band)).back();
          return std::string(plainBytes(top.values)).append(plainBytes(top.weights));
        },
        [&](int, std::string_view found) {
          const std::size_t count = found.size() / 2 / sizeof(float);
          PlainBytes bytes(found);
          std::vector<float> values;
          std::vector<float> weights;
          bytes.take(values, count);
          bytes.take(weights, count);
          coarse.values.insert(coarse.values.end(), values.begin(), values.end());
          coarse.weights.insert(coarse.weights.end(), weights.begin(), weights.end());
        });
  }
  base_z_mm_ = source_.base_z_mm ? *source_.base_z_mm : lowest.quantile(processes_);
  if (!pulls) return;
  std::vector<PushPullLayer> layers;
  layers.push_back(std::move(coarse));
  while (layers.back().size.cols > 1 || layers.back().size.rows > 1) {
    task.check();
    layers.push_back(pulled(layers.back()));
  }
  for (std::size_t l = layers.size() - 1; l-- > 0;) {
    task.check();
    pushInto(layers[l], layers[l + 1]);
  }
  coarse_ = std::move(layers[0]);
}

void BandFill::layMembranes(const Task& task) {
  plates_ = Plates(empty_, enclosed_, frame_.size);
  if (plates_.empty()) return;
  requireRoom();
  forBands(
      {.words = "Filling holes", .from = 0, .to = 0.5}, task,
      [&](int number) {
        const Band own = bandOf(number, 0, 1);
        std::vector<Plates::RimCell> cells = plates_.rimCells(own.first, own.first + own.rows);
        if (cells.empty()) return std::string();
        const Band band = bandOf(number, 2 * kPullRows, kPullRows);
        const std::vector<float> depths = completed(band, task);
        const std::size_t before = frame_.size.index({.col = 0, .row = band.from});
        for (Plates::RimCell& one : cells) one.z_mm = depths[one.cell - before];
        return std::string(plainBytes(cells));
      },
      [&](int, std::string_view found) {
        plates_.add(found);
        requireRoom();
      });
  // One at a time where memory is counted.
  plates_.solve(processes_, given_.front.all != nullptr ? threads_ : 1, task);
}

/// What the rule found between the points stands where gaps were closed, but for cells that had
/// points: in one that showed the back the rule found the back.
void BandFill::addBetween(const Band& band, std::vector<float>& depths) const {
  if (!given_.between) return;
  std::vector<float> read;
  const float* const between =
      given_.between.rows(band.from, band.to - band.from, frame_.size, read);
  Mask dropped;
  if (dropped_) dropped = dropped_->bytes(band.from, band.to - band.from);
  const auto take = [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const bool stays = depths[i] == depths[i] || (!dropped.empty() && dropped[i] != 0);
      depths[i] = stays ? depths[i] : between[i];
    }
  };
  for (int row = band.from; row < band.to; ++row) {
    const std::size_t start = frame_.size.index({.col = 0, .row = row - band.from});
    std::size_t col = 0;
    for (const EmptyRuns::Run& run : empty_.row(row)) {
      take(start + col, start + static_cast<std::size_t>(run.first_col));
      col = static_cast<std::size_t>(run.end_col);
    }
    take(start + col, start + static_cast<std::size_t>(frame_.size.cols));
  }
}

void BandFill::placeOrigins(const Band& band, CellStatus* origins) const {
  const Mask measured = measured_.bytes(band.first, band.rows);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    origins[i] = measured[i] != 0 ? CellStatus::measured : CellStatus::interpolated;
  }
  for (int row = band.first; row < band.first + band.rows; ++row) {
    CellStatus* const start = origins + frame_.size.index({.col = 0, .row = row - band.first});
    for (const EmptyRuns::Run& run : empty_.row(row)) {
      const std::ptrdiff_t hole = enclosed_.hole_of_area[run.area];
      const CellStatus origin =
          hole < 0 ? CellStatus::outside
                   : originOfHole(enclosed_.holes[static_cast<std::size_t>(hole)], choice_.rule);
      std::fill(start + run.first_col, start + run.end_col, origin);
    }
  }
}

void BandFill::markSteep(const Band& band, CellStatus* origins) const {
  // By the depths as given and by the rows beside; asked for cells that stay measured only.
  const Band around{.first = band.first,
                    .rows = band.rows,
                    .from = std::max(0, band.first - 1),
                    .to = std::min(frame_.size.rows, band.first + band.rows + 1)};
  std::vector<float> read;
  const float* const depths =
      given_.front.rows(around.from, around.to - around.from, frame_.size, read);
  Mask steep;
  if (given_.steep != nullptr) {
    steep = given_.steep->bytes(around.from, around.to - around.from);
  } else {
    steep.resize(sizeOf(around).count());
  }
  markSteepCells(depths, sizeOf(around), frame_.spacing_mm, steep);
  const std::uint8_t* const own = steep.data() + startOf(around);
  for (std::size_t i = 0; i < cellsOf(band); ++i) {
    origins[i] = origins[i] == CellStatus::measured && own[i] != 0 ? CellStatus::steep : origins[i];
  }
}

/// Cells without a height that are neither in a hole nor outside.
Mask BandFill::gapsOf(const Band& band, const Mask& known) const {
  Mask gaps(known.size());
  for (std::size_t i = 0; i < known.size(); ++i) gaps[i] = static_cast<std::uint8_t>(known[i] ^ 1U);
  for (int row = band.from; row < band.to; ++row) {
    const auto start = gaps.begin() + static_cast<std::ptrdiff_t>(
                                          frame_.size.index({.col = 0, .row = row - band.from}));
    for (const EmptyRuns::Run& run : empty_.row(row)) {
      std::fill(start + run.first_col, start + run.end_col, std::uint8_t{0});
    }
  }
  return gaps;
}

/// Depths of a band where every cell has one that gets one from those around it.
/// @param band  with 2 kPullRows around, from a multiple of kPullRows on; there they are off
std::vector<float> BandFill::completed(const Band& band, const Task& task) const {
  // Push-pull is off by one coarse row at a band's border; beyond it neighbours must be right.
  static_assert(kNeighbourRounds <= kPullRows);
  const GridSize size = sizeOf(band);
  std::vector<float> depths = readDepths(band);
  if (!coarse_) return depths;
  addBetween(band, depths);
  Mask known = measuredOf(depths.data(), depths.size());
  std::vector<PushPullLayer> layers = pulledLayers(depths, known, size);
  layers.back() = rowsOfLayer(*coarse_, band.from / kPullRows, layers.back().size.rows);
  task.check();
  for (std::size_t l = layers.size() - 1; l-- > 0;) pushInto(layers[l], layers[l + 1]);
  pushIntoUnknown(depths, known, size, layers[0]);
  task.check();
  const Mask gaps = gapsOf(band, known);
  keepWithinNeighbours(depths, std::move(known), gaps, size);
  return depths;
}

void BandFill::fillBand(int number, float* heights_mm, CellStatus* origins,
                        const Task& task) const {
  const Band own = bandOf(number, 0, 1);
  const std::size_t count = cellsOf(own);
  placeOrigins(own, origins);
  markSteep(own, origins);
  Depths depths;
  if (std::count(origins, origins + count, CellStatus::interpolated) == 0) {
    depths = depthsOf(own);
  } else {
    const Band band = bandOf(number, 2 * kPullRows, kPullRows);
    depths.read = completed(band, task);
    plates_.take(band.from, band.to - band.from, depths.read.data());
    depths.at = depths.read.data() + startOf(band);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool on_base = origins[i] == CellStatus::base_plane || origins[i] == CellStatus::outside;
    const double height = static_cast<double>(depths.at[i]) - base_z_mm_;
    heights_mm[i] = on_base ? 0.0F : static_cast<float>(height);
  }
}

void BandFill::fillInto(float* heights_mm, CellStatus* origins, const Task& task) const {
  orderedPipeline(
      bandCount(), threads_,
      [&](int, int number) {
        task.check();
        const std::size_t start = frame_.size.index({.col = 0, .row = bandOf(number, 0, 1).first});
        fillBand(number, heights_mm + start, origins + start, task);
      },
      [&](int, int number) {
        task.check();
        task.report("Filling gaps", 0.5 + 0.5 * number / bandCount());
      });
  task.check();
}

FilledBand BandFill::filledBand(int number, const Task& task) const {
  const std::size_t count = cellsOf(bandOf(number, 0, 1));
  FilledBand made{.heights_mm = std::vector<float>(count), .origins = {}};
  made.origins.resize(count);
  fillBand(number, made.heights_mm.data(), made.origins.data(), task);
  return made;
}

bool BandFill::isKept(int number, FilledBand& band) const {
  return options_.keeper != nullptr &&
         options_.keeper->load(number, cellsOf(bandOf(number, 0, 1)), band);
}

int BandFill::fillForOthers(const Task& task) {
  const std::pair<int, int> part = processes_.partOf(bandCount());
  const int first = part.first;
  const int end = part.second;
  std::atomic<int> there = 0;
  orderedPipeline(
      end - first, threads_,
      [&](int, int number) {
        task.check();
        FilledBand band;
        if (isKept(first + number, band)) {
          ++there;
        } else {
          options_.keeper->keep(first + number, filledBand(first + number, task));
        }
      },
      [&](int, int number) {
        task.check();
        task.report("Filling gaps", 0.5 + 0.5 * number / (end - first));
      });
  int all_there = 0;
  for (const std::string& one : processes_.share(plainBytes(there.load()))) {
    int of_one = 0;
    PlainBytes(one).take(of_one);
    all_there += of_one;
  }
  return all_there;
}

void BandFill::write(const TakeRow& take, const Task& task) {
  std::vector<FilledBand> bands(static_cast<std::size_t>(threads_));
  std::atomic<int> there = 0;
  orderedPipeline(
      bandCount(), threads_,
      [&](int place, int number) {
        task.check();
        FilledBand& band = bands[static_cast<std::size_t>(place)];
        if (isKept(number, band)) {
          ++there;
          return;
        }
        band = filledBand(number, task);
        if (options_.keeper != nullptr) options_.keeper->keep(number, band);
      },
      [&](int place, int number) {
        task.check();
        task.report("Writing levels", static_cast<double>(number) / bandCount());
        const FilledBand& filled = bands[static_cast<std::size_t>(place)];
        const Band band = bandOf(number, 0, 1);
        for (int row = 0; row < band.rows; ++row) {
          if (row % 16 == 0) task.check();
          const std::size_t start = frame_.size.index({.col = 0, .row = row});
          take(band.first + row, &filled.heights_mm[start], &filled.origins[start]);
        }
      });
  bands_there_ = there;
}

}  // namespace relievo
