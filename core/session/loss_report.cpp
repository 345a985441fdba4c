// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/loss_report.h"

#include <array>
#include <cstdio>
#include <numeric>

#include "core/depth/rules/point_rule.h"

namespace relievo {
namespace {

constexpr double kHiddenWorthSaying = 0.1;
constexpr double kLeastShare = 0.001;  // Nobody reads "0.00747 %".

}  // namespace

std::string percentText(double share) {
  if (share > 0 && share < kLeastShare) return "less than 0.1 %";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g %%", 100 * share);
  return text.data();
}

std::vector<std::string> lossReport(const DepthLosses& losses, std::size_t seen_through,
                                    const std::array<double, kOriginCount>& shares) {
  std::vector<std::string> words;
  if (losses.hidden_share >= kHiddenWorthSaying) {
    words.push_back("Seen from here " + percentText(losses.hidden_share) +
                    " of the scan is hidden and cannot be felt. Turn the object, or continue.");
  }
  if (losses.outliers > 0) {
    words.push_back(std::to_string(losses.outliers) +
                    " points far off all their neighbours were left out.");
  }
  if (seen_through > 0) {
    words.push_back(std::to_string(seen_through) +
                    " cells showed the object's back through gaps of its front; they were "
                    "interpolated instead.");
  }
  const double measured = shares[static_cast<std::size_t>(CellStatus::measured)];
  const double made_up = shares[static_cast<std::size_t>(CellStatus::interpolated)];
  if (made_up > measured) {
    words.push_back("Most cells are interpolated: " + percentText(measured) +
                    " of the map is measured. A coarser grid would rest on more.");
  }
  return words;
}

std::vector<std::string> mixedLayerWords(PointRule chosen, const HiddenSurface& hidden,
                                         const OriginCounts& cells) {
  constexpr double kMixedWorthSaying = 0.01;
  if (!mixesLayers(chosen)) return {};
  const std::size_t outside = cells[static_cast<std::size_t>(CellStatus::outside)];
  const std::size_t inside = std::accumulate(cells.begin(), cells.end(), std::size_t{0}) - outside;
  const double share =
      inside > 0 ? static_cast<double>(hidden.cells) / static_cast<double>(inside) : 0;
  if (share < kMixedWorthSaying) return {};
  return {
      "In " + percentText(share) +
      " of the cells the points lie in several layers, front and back, and the chosen height "
      "per cell makes one height of them. Choose the mean of the top layer (topmean) to keep them "
      "apart."};
}

}  // namespace relievo
