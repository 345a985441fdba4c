// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/rule_choice.h"

#include <cmath>
#include <utility>

#include "core/base/bands.h"
#include "core/depth/layers/outliers.h"
#include "core/depth/rules/local_fit.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr double kEnoughToAverage = 4;          // Points a cell.
constexpr double kMostLayeredShare = 0.05;      // Outliers and walls put that many cells apart.
constexpr float kOnSample = 0.02F;              // Cells; points this near lie on their samples.
constexpr std::size_t kSampledCells = 100'000;  // Enough to choose a rule and to know the noise.
constexpr int kSampleHalo = LocalFit::kWidest + kOutlierReach;

using CellSpan = std::span<const PlacedPoint>;

bool hasPointAround(const RowPoints& rows, int col, int row) {
  const int first_col = std::max(col - 1, 0);
  const int end_col = std::min(col + 2, rows.cols);
  for (int r = std::max(row - 1, rows.first_row); r < std::min(row + 2, rows.end_row); ++r) {
    if (rows.count(first_col, end_col, r) > 0) return true;
  }
  return false;
}

/// Rows that are looked at before the rule is known: all of a small grid, else every n-th unit.
std::vector<RowRange> sampledRows(GridSize size) {
  const int rows_at_once = rowsAtOnce(size);
  const int units = (size.rows + rows_at_once - 1) / rows_at_once;
  const std::size_t cells_of_unit =
      static_cast<std::size_t>(rows_at_once) * static_cast<std::size_t>(size.cols);
  const int step = std::max(1, units / static_cast<int>(kSampledCells / cells_of_unit + 1));
  std::vector<RowRange> ranges;
  for (int unit = step / 2; unit < units; unit += step) {
    const int first = unit * rows_at_once;
    ranges.push_back({.first = first, .end = std::min(first + rows_at_once, size.rows)});
  }
  return ranges;
}

template <MessageId id>
Message densityWords(const SampleCounts& found) {
  return said<id>(NumberArgument{.value = found.pointsPerCell(), .digits = 1});
}

}  // namespace

void SampleCounts::add(const RowSample& sample, double spacing_mm) {
  const auto& [range, rows] = sample;
  const auto apart = static_cast<float>(kOtherLayerCells * spacing_mm);
  for (int row = range.first; row < range.end; ++row) {
    for (int col = 0; col < rows.cols; ++col) {
      const CellSpan cell = rows.of(col, col + 1, row);
      inside += hasPointAround(rows, col, row) ? 1 : 0;
      if (cell.empty()) continue;
      const auto [low, high] =
          std::minmax_element(cell.begin(), cell.end(),
                              [](const PlacedPoint& a, const PlacedPoint& b) { return a.z < b.z; });
      points += cell.size();
      ++occupied;
      layered += high->z - low->z > apart ? 1 : 0;
      off_samples += std::max(std::abs(cell[0].du), std::abs(cell[0].dv)) > kOnSample ? 1 : 0;
    }
  }
}

double SampleCounts::pointsPerCell() const noexcept {
  return inside == 0 ? 0 : static_cast<double>(points) / static_cast<double>(inside);
}

int rowsAtOnce(GridSize size) {
  return std::clamp(131'072 / std::max(size.cols, 1), 16, 64);
}

std::vector<RowRange> rowsOfSamples(GridSize size) {
  std::vector<RowRange> ranges = sampledRows(size);
  for (RowRange& range : ranges) range = widened(range, kSampleHalo);
  return ranges;
}

std::vector<RowSample> samplesOf(const CellPoints& points, const GridFrame& frame, int threads,
                                 const Task& task) {
  std::vector<RowSample> samples;
  for (const RowRange& range : sampledRows(frame.size)) samples.push_back({range, {}});
  parallelFor(static_cast<int>(samples.size()), threads, [&](int first, int end) {
    for (int k = first; k < end; ++k) {
      task.check();
      RowSample& sample = samples[static_cast<std::size_t>(k)];
      sample = sampleOf(points, widened(sample.range, kSampleHalo), frame);
    }
  });
  return samples;
}

RowSample sampleOf(const CellPoints& points, RowRange range, const GridFrame& frame) {
  RowSample sample{.range = widened(range, -kSampleHalo), .rows = {}};
  points.rows(range.first, range.end, sample.rows);
  dropOutliers(sample.rows, frame.spacing_mm, {});
  return sample;
}

RuleProposal proposeRule(const std::vector<RowSample>& samples, const GridFrame& frame, int threads,
                         const Task& task) {
  std::vector<SampleCounts> counts(samples.size());
  parallelFor(static_cast<int>(samples.size()), threads, [&](int first, int end) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
      task.check();
      counts[i].add(samples[i], frame.spacing_mm);
    }
  });
  SampleCounts found;
  for (const SampleCounts& part : counts) {
    found.points += part.points;
    found.inside += part.inside;
    found.occupied += part.occupied;
    found.layered += part.layered;
    found.off_samples += part.off_samples;
  }
  return proposeRule(found);
}

RuleProposal proposeRule(const SampleCounts& found) {
  RuleProposal proposal{.rule = PointRule::front,
                        .reason = densityWords<MessageId::rule_by_density>(found)};
  if (found.occupied == 0) return proposal;
  const auto cells = static_cast<double>(found.occupied);
  const double density = found.pointsPerCell();
  if (density < 1.01 && static_cast<double>(found.off_samples) < 0.01 * cells) {
    proposal.reason = said<MessageId::rule_one_point_each>();
  } else if (static_cast<double>(found.layered) > kMostLayeredShare * cells) {
    proposal.rule = PointRule::top_mean;
    proposal.reason = densityWords<MessageId::rule_by_layers>(found);
  } else {
    proposal.rule = density < kEnoughToAverage ? PointRule::quadratic : PointRule::median;
    if (density >= kEnoughToAverage) {
      proposal.reason = densityWords<MessageId::rule_by_one_layer>(found);
    }
  }
  return proposal;
}

double pointNoise(const std::vector<RowSample>& samples, const GridFrame& frame, int threads,
                  const Task& task) {
  std::vector<double> noises(samples.size());
  parallelFor(static_cast<int>(samples.size()), threads, [&](int first, int end) {
    for (int k = first; k < end; ++k) {
      task.check();
      const auto i = static_cast<std::size_t>(k);
      noises[i] = noiseOf(samples[i], frame.spacing_mm);
    }
  });
  return middleNoise(std::move(noises));
}

double noiseOf(const RowSample& sample, double spacing_mm) {
  return noiseOf(sample.rows, sample.range.first, sample.range.end, spacing_mm);
}

double middleNoise(std::vector<double> noises) {
  std::sort(noises.begin(), noises.end());
  return noises.empty() ? 0 : noises[noises.size() / 2];
}

RuleProposal proposeRule(const DepthRequest& request, const Task& task) {
  const CellPoints points(request, rowsOfSamples(request.frame.size), task);
  const int threads = threadsFor(points.count(), request.threads);
  return proposeRule(samplesOf(points, request.frame, threads, task), request.frame, threads, task);
}

double pointNoise(const DepthRequest& request, const Task& task) {
  const CellPoints points(request, rowsOfSamples(request.frame.size), task);
  const int threads = threadsFor(points.count(), request.threads);
  const std::vector<RowSample> samples = samplesOf(points, request.frame, threads, task);
  return pointNoise(samples, request.frame, threads, task);
}

}  // namespace relievo
