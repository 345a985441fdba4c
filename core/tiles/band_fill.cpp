// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/band_fill.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "core/base/failure.h"
#include "core/depth/fill/mask.h"
#include "core/depth/fill/push_pull.h"
#include "core/depth/layers/hidden_points.h"
#include "core/tiles/job/plain_bytes.h"
#include "core/tiles/points/lowest_values.h"
#include "core/tiles/threads.h"
#include "core/tiles/tile_layout.h"

namespace relievo {
namespace {

// Push-pull layers from this one on are kept whole (a 64th of the cells); the finer ones are made
// anew for each band. A band must begin at a multiple of 2^kPull and needs as many rows around.
constexpr int kPull = 3;
constexpr int kPullRows = 1 << kPull;

bool isMeasured(float depth) {
  return !std::isnan(depth);
}

/// Eight cells to a byte.
std::string packed(std::span<const std::uint8_t> mask) {
  std::string bits((mask.size() + 7) / 8, '\0');
  for (std::size_t i = 0; i < mask.size(); ++i) {
    bits[i / 8] = static_cast<char>(static_cast<unsigned char>(bits[i / 8]) | mask[i] << i % 8);
  }
  return bits;
}

Mask unpacked(std::string_view bits, std::size_t cells) {
  Mask mask(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    mask[i] = static_cast<unsigned char>(bits[i / 8]) >> i % 8 & 1U;
  }
  return mask;
}

/// Layers 0 ... kPull of a band, pulled only.
std::vector<PushPullLayer> pulledLayers(const std::vector<float>& depths, GridSize size) {
  std::vector<PushPullLayer> layers(1);
  layers[0] = {.size = size, .values = depths, .weights = std::vector<float>(depths.size())};
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const bool known = isMeasured(depths[i]);
    layers[0].weights[i] = known ? 1.0F : 0.0F;
    if (!known) layers[0].values[i] = 0;
  }
  while (static_cast<int>(layers.size()) <= kPull) layers.push_back(pulled(layers.back()));
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

struct BandFill::CoarseLayer {
  PushPullLayer layer;
};

BandFill::Band BandFill::bandOf(int number, int margin, int align) const noexcept {
  Band band;
  band.first = number * kTileSide;
  band.rows = std::min(kTileSide, frame_.size.rows - band.first);
  const int from = std::max(0, band.first - margin);
  band.from = from / align * align;
  const int to = band.first + band.rows + margin;
  band.to = std::min(frame_.size.rows, (to + align - 1) / align * align);
  return band;
}

int BandFill::bandCount() const noexcept {
  return TileLayout{frame_.size}.down();
}

std::size_t BandFill::cellsOf(const Band& band) const noexcept {
  return static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(frame_.size.cols);
}

std::vector<float> BandFill::read(const RowsOf& rows, const Band& band) const {
  const int count = band.to - band.from;
  std::vector<float> values(static_cast<std::size_t>(count) *
                            static_cast<std::size_t>(frame_.size.cols));
  rows(band.from, count, values.data());
  return values;
}

BandFill::BandFill(BandDepths depths, const GridFrame& frame, const FillSource& source,
                   const HoleChoice& choice, const BandOptions& options, const Task& task)
    : given_(std::move(depths)),
      depths_(given_.front),
      processes_(options.processes != nullptr ? *options.processes : alone_),
      frame_(frame),
      source_(source),
      choice_(choice),
      options_(options),
      threads_(threadCount(options.threads)),
      measured_(frame.size),
      empty_(frame.size) {
  if (choice_.rule == HoleRule::membrane) {
    throw failure<MessageId::membranes_need_whole_map>();
  }
  markMeasured(task);
  const bool looks_for_gaps = source_.has_sampling_gaps && !source_.gaps_are_known;
  int radius = looks_for_gaps ? gapRadius() : 0;
  if (looks_for_gaps && !given_.one_layer) {
    dropSeenThroughBands(radius + 1, task);
    radius = gapRadius();
  }
  findHoles(source_.gaps_are_known ? kCrackRadius : radius, task);
  pullAll(task);
}

void BandFill::forBands(const Step& step, const Task& task, const MakeBand& make,
                        const TakeBand& take) {
  const auto [first, end] = processes_.partOf(bandCount());
  std::vector<std::string> made(static_cast<std::size_t>(threads_));
  std::string mine;
  orderedPipeline(
      end - first, threads_,
      [&](int place, int number) {
        task.check();
        made[static_cast<std::size_t>(place)] = make(first + number);
      },
      [&](int place, int number) {
        task.report(step.words, step.from + (step.to - step.from) * number / (end - first));
        const std::string& found = made[static_cast<std::size_t>(place)];
        if (processes_.isAlone()) {
          take(number, found);
        } else {
          const std::uint64_t size = found.size();
          mine.append(plainBytes(size)).append(found);
        }
      });
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
        const std::vector<float> depths = read(depths_, bandOf(number, 0, 1));
        Mask mask(depths.size());
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = isMeasured(depths[i]) ? 1 : 0;
        return packed(mask);
      },
      [&](int number, std::string_view found) {
        const Band band = bandOf(number, 0, 1);
        measured_.setRows(band.first, unpacked(found, cellsOf(band)));
      });
}

int BandFill::gapRadius() const {
  const int side = occupancySide(measured_.count(), frame_.size);
  if (side == 0) return 0;
  const auto cols = static_cast<std::size_t>(frame_.size.cols);
  std::vector<double> shares;
  for (int row0 = 0; row0 + side <= frame_.size.rows; row0 += side) {
    const Mask mask = measured_.bytes(row0, side);
    for (std::size_t col0 = 0; col0 + static_cast<std::size_t>(side) <= cols;
         col0 += static_cast<std::size_t>(side)) {
      int ones = 0;
      for (std::size_t row = 0; row < static_cast<std::size_t>(side); ++row) {
        for (int col = 0; col < side; ++col) {
          ones += mask[row * cols + col0 + static_cast<std::size_t>(col)];
        }
      }
      if (ones > 0) shares.push_back(static_cast<double>(ones) / (side * side));
    }
  }
  return samplingGapRadius(std::move(shares), frame_.size);
}

void BandFill::dropSeenThroughBands(int radius, const Task& task) {
  dropped_.emplace(frame_.size);
  forBands(
      {.words = "Looking through gaps"}, task,
      [&](int number) {
        const Band band = bandOf(number, seeThroughReach(radius), 1);
        const FrontDepths before = read(depths_, band);
        FrontDepths depths = before;
        GridFrame frame = frame_;
        frame.size.rows = band.to - band.from;
        dropSeenThrough(depths, frame, radius, task);
        const std::size_t start = frame_.size.index({.col = 0, .row = band.first - band.from});
        Mask mask(cellsOf(band));
        for (std::size_t i = 0; i < mask.size(); ++i) {
          mask[i] = isMeasured(before[start + i]) && !isMeasured(depths[start + i]) ? 1 : 0;
        }
        const std::uint64_t points = pointsOf(mask, band);
        return std::string(plainBytes(points)).append(packed(mask));
      },
      [&](int number, std::string_view found) {
        const Band band = bandOf(number, 0, 1);
        std::uint64_t points = 0;
        PlainBytes(found).take(points);
        seen_through_points_ += points;
        takeSeenThrough(band, unpacked(found.substr(sizeof(points)), cellsOf(band)));
      });
  depths_ = [this](int first, int rows, float* out) {
    given_.front(first, rows, out);
    const Mask dropped = dropped_->bytes(first, rows);
    for (std::size_t i = 0; i < dropped.size(); ++i) {
      if (dropped[i] != 0) out[i] = std::numeric_limits<float>::quiet_NaN();
    }
  };
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

void BandFill::takeSeenThrough(const Band& band, const Mask& dropped) {
  dropped_->setRows(band.first, dropped);
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    if (dropped[i] == 0) continue;
    const auto cols = static_cast<std::size_t>(frame_.size.cols);
    measured_.clear(
        {.col = static_cast<int>(i % cols), .row = band.first + static_cast<int>(i / cols)});
    ++seen_through_;
  }
}

void BandFill::pullAll(const Task& task) {
  LowestValues lowest(measured_.count(), source_.base_quantile);
  const GridSize size = frame_.size;
  const int coarse_cols = (size.cols + kPullRows - 1) / kPullRows;
  const int coarse_rows = (size.rows + kPullRows - 1) / kPullRows;
  PushPullLayer coarse{
      .size = {.cols = coarse_cols, .rows = coarse_rows}, .values = {}, .weights = {}};
  std::mutex adds_lowest;
  forBands(
      {.words = "Filling gaps", .from = 0, .to = 0.5}, task,
      [&](int number) {
        const Band band = bandOf(number, 0, 1);
        std::vector<float> depths = read(depths_, band);
        {
          const std::lock_guard one_at_a_time(adds_lowest);  // In any order: values are counted.
          lowest.add(depths);
        }
        addBetween(band, depths);
        const PushPullLayer top =
            pulledLayers(depths, {.cols = size.cols, .rows = band.rows}).back();
        return std::string(plainBytes(top.values)).append(plainBytes(top.weights));
      },
      [&](int, std::string_view found) {
        const std::size_t count = found.size() / 2 / sizeof(float);
        PlainBytes bytes(found);
        std::vector<float> values, weights;
        bytes.take(values, count);
        bytes.take(weights, count);
        coarse.values.insert(coarse.values.end(), values.begin(), values.end());
        coarse.weights.insert(coarse.weights.end(), weights.begin(), weights.end());
      });
  base_z_mm_ = source_.base_z_mm ? *source_.base_z_mm : lowest.quantile(processes_);
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
  coarse_ = std::make_shared<CoarseLayer>(CoarseLayer{std::move(layers[0])});
}

void BandFill::findHoles(int radius, const Task& task) {
  forBands(
      {.words = "Looking for gaps", .from = 0.5, .to = 1}, task,
      [&](int number) {
        const Band band = bandOf(number, 2 * radius, 1);
        const GridSize size{.cols = frame_.size.cols, .rows = band.to - band.from};
        Mask mask = measured_.bytes(band.from, size.rows);
        if (source_.gaps_are_known && given_.between) {
          mask = withBetween(std::move(mask), read(given_.between, band));
        }
        mask = closed(mask, size, radius);
        const std::size_t start = frame_.size.index({.col = 0, .row = band.first - band.from});
        return packed(std::span(mask).subspan(start, cellsOf(band)));
      },
      [&](int number, std::string_view found) {
        const Band band = bandOf(number, 0, 1);
        const Mask mask = unpacked(found, cellsOf(band));
        for (int row = 0; row < band.rows; ++row) {
          empty_.addRow(&mask[frame_.size.index({.col = 0, .row = row})]);
        }
        if (empty_.bytes() > options_.memory_bytes) {
          throw failure<MessageId::map_areas_too_ragged>();
        }
      });
  empty_.join();
  enclosed_ = empty_.enclosed(frame_);
  for (Hole& hole : enclosed_.holes) {
    hole.filled = isToBeFilled(hole, choice_);
  }
}

void BandFill::placeOrigins(const Band& band, std::vector<CellStatus>& origins) const {
  for (int row = band.first; row < band.first + band.rows; ++row) {
    const std::size_t start = frame_.size.index({.col = 0, .row = row - band.first});
    for (const EmptyRuns::Run& run : empty_.row(row)) {
      const std::ptrdiff_t hole = enclosed_.hole_of_area[run.area];
      const CellStatus origin =
          hole < 0 ? CellStatus::outside
                   : originOfHole(enclosed_.holes[static_cast<std::size_t>(hole)], choice_.rule);
      std::fill(origins.begin() + static_cast<std::ptrdiff_t>(start) + run.first_col,
                origins.begin() + static_cast<std::ptrdiff_t>(start) + run.end_col, origin);
    }
    for (int col = 0; col < frame_.size.cols; ++col) {
      if (measured_.at({.col = col, .row = row})) {
        origins[start + static_cast<std::size_t>(col)] = CellStatus::measured;
      }
    }
  }
}

/// What the rule found between the points stands where gaps were closed, but for cells that showed
/// the back.
void BandFill::addBetween(const Band& band, std::vector<float>& depths) const {
  if (!given_.between) return;
  std::vector<float> between = read(given_.between, band);
  if (dropped_) {
    const Mask dropped = dropped_->bytes(band.from, band.to - band.from);
    for (std::size_t i = 0; i < dropped.size(); ++i) {
      if (dropped[i] != 0) between[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  for (int row = band.from; row < band.to; ++row) {
    const std::size_t start = frame_.size.index({.col = 0, .row = row - band.from});
    int col = 0;
    const auto take_until = [&](int end) {
      for (; col < end; ++col) {
        const std::size_t i = start + static_cast<std::size_t>(col);
        if (!isMeasured(depths[i])) depths[i] = between[i];
      }
    };
    for (const EmptyRuns::Run& run : empty_.row(row)) {
      take_until(run.first_col);
      col = run.end_col;
    }
    take_until(frame_.size.cols);
  }
}

void BandFill::markSteep(const Band& band, std::vector<CellStatus>& origins) const {
  // Judged by the depths as given and by the rows beside, as in fillDepths.
  const Band around{.first = band.first,
                    .rows = band.rows,
                    .from = std::max(0, band.first - 1),
                    .to = std::min(frame_.size.rows, band.first + band.rows + 1)};
  GridFrame frame = frame_;
  frame.size.rows = around.to - around.from;
  CapturedDepths depths(read(given_.front, around));
  if (given_.steep != nullptr) depths.steep = given_.steep->bytes(around.from, frame.size.rows);
  const Mask steep = steepCells(depths, measured_.bytes(around.from, frame.size.rows), frame);
  const std::size_t skipped = frame.size.index({.col = 0, .row = band.first - around.from});
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (origins[i] == CellStatus::measured && steep[skipped + i] != 0)
      origins[i] = CellStatus::steep;
  }
}

/// Cells without a height that are neither in a hole nor outside.
Mask BandFill::gapsOf(const Band& band, const Mask& known) const {
  Mask gaps(known.size());
  for (std::size_t i = 0; i < known.size(); ++i) gaps[i] = known[i] == 0 ? 1 : 0;
  for (int row = band.from; row < band.to; ++row) {
    const auto start = gaps.begin() + static_cast<std::ptrdiff_t>(
                                          frame_.size.index({.col = 0, .row = row - band.from}));
    for (const EmptyRuns::Run& run : empty_.row(row)) {
      std::fill(start + run.first_col, start + run.end_col, std::uint8_t{0});
    }
  }
  return gaps;
}

FilledBand BandFill::filledBand(int number) const {
  // Push-pull is off by one coarse row at a band's border; beyond it neighbours must be right.
  static_assert(kNeighbourRounds <= kPullRows);
  const Band band = bandOf(number, 2 * kPullRows, kPullRows);
  const GridSize size{.cols = frame_.size.cols, .rows = band.to - band.from};
  std::vector<float> depths = read(depths_, band);
  addBetween(band, depths);
  std::vector<PushPullLayer> layers = pulledLayers(depths, size);
  layers.back() = rowsOfLayer(coarse_->layer, band.from / kPullRows, layers.back().size.rows);
  for (std::size_t l = layers.size() - 1; l-- > 0;) pushInto(layers[l], layers[l + 1]);
  Mask known(depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i) known[i] = isMeasured(depths[i]) ? 1 : 0;
  keepWithinNeighbours(layers[0].values, known, gapsOf(band, known), size);

  const std::size_t count = cellsOf(band);
  FilledBand made;
  made.origins.assign(count, CellStatus::interpolated);
  placeOrigins(band, made.origins);
  markSteep(band, made.origins);
  made.heights_mm.assign(count, 0.0F);
  const float* filled = &layers[0].values[size.index({.col = 0, .row = band.first - band.from})];
  for (std::size_t i = 0; i < count; ++i) {
    if (made.origins[i] != CellStatus::base_plane && made.origins[i] != CellStatus::outside) {
      made.heights_mm[i] = static_cast<float>(static_cast<double>(filled[i]) - base_z_mm_);
    }
  }
  return made;
}

bool BandFill::isKept(int number, FilledBand& band) const {
  return options_.job != nullptr &&
         loadBand(*options_.job, number, cellsOf(bandOf(number, 0, 1)), band);
}

int BandFill::fillIntoFolder(const Task& task) {
  const auto [first, end] = processes_.partOf(bandCount());
  std::atomic<int> there = 0;
  orderedPipeline(
      end - first, threads_,
      [&](int, int number) {
        task.check();
        FilledBand band;
        if (isKept(first + number, band)) {
          ++there;
        } else {
          keepBand(*options_.job, first + number, filledBand(first + number));
        }
      },
      [&](int, int number) { task.report("Filling gaps", 0.5 + 0.5 * number / (end - first)); });
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
        band = filledBand(number);
        if (options_.job != nullptr) keepBand(*options_.job, number, band);
      },
      [&](int place, int number) {
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
