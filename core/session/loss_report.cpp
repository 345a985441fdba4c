// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/loss_report.h"

#include <numeric>

#include "core/depth/rules/point_rule.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr double kHiddenWorthSaying = 0.1;
constexpr double kLeastShare = 0.001;  // Nobody reads "0.00747 %".

}  // namespace

Message percentWords(double share) {
  if (share > 0 && share < kLeastShare) return said<MessageId::share_tiny>();
  return said<MessageId::share_in_percent>(
      NumberArgument{.value = 100 * share, .digits = 3, .form = NumberArgument::Form::significant});
}

std::vector<Message> lossReport(const DepthLosses& losses, std::size_t seen_through,
                                const std::array<double, kOriginCount>& shares) {
  std::vector<Message> words;
  if (losses.hidden_share >= kHiddenWorthSaying) {
    words.push_back(said<MessageId::much_is_hidden>(percentWords(losses.hidden_share)));
  }
  if (losses.outliers > 0) {
    words.push_back(said<MessageId::outliers_left_out>(losses.outliers));
  }
  if (seen_through > 0) words.push_back(said<MessageId::back_seen_through>(seen_through));
  const double measured = shares[static_cast<std::size_t>(CellStatus::measured)];
  const double made_up = shares[static_cast<std::size_t>(CellStatus::interpolated)];
  if (made_up > measured) {
    words.push_back(said<MessageId::most_is_interpolated>(percentWords(measured)));
  }
  return words;
}

std::optional<Message> mixedLayerWords(PointRule chosen, const HiddenSurface& hidden,
                                       const OriginCounts& cells) {
  constexpr double kMixedWorthSaying = 0.01;
  if (!mixesLayers(chosen)) return std::nullopt;
  const std::size_t outside = cells[static_cast<std::size_t>(CellStatus::outside)];
  const std::size_t inside = std::accumulate(cells.begin(), cells.end(), std::size_t{0}) - outside;
  const double share =
      inside > 0 ? static_cast<double>(hidden.cells) / static_cast<double>(inside) : 0;
  if (share < kMixedWorthSaying) return std::nullopt;
  return said<MessageId::layers_are_mixed>(percentWords(share));
}

}  // namespace relievo
