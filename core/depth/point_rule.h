// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/depth/depth_request.h"

namespace relievo {

/// "front", "second", "topmean", "median" and "mean"; nothing for other words.
std::optional<PointRule> pointRule(std::string_view name);
/// In words, for people: "front-most point", "median of the points", ...
std::string_view describe(PointRule rule);

/// A rule and why, in words for people.
struct RuleProposal {
  PointRule rule = PointRule::front;
  std::string reason;  ///< "2.5 points per cell"
};

/// From the cells the points fall into: below 4 points a cell the front-most point (noise has
/// little to average); from 4 on the median if nearly all cells see one layer (coins, terrain),
/// else the mean of the top layer, so that an object's back does not mix with its front. [worker]
/// @throw Cancelled
RuleProposal proposeRule(const DepthRequest& request, const Task& task = {});

/// Height of every cell from its points by request.rule; NaN where there is none. The points' order
/// matters to no more than the last bits of a mean. [worker]
/// @throw Cancelled
FrontDepths scatterPoints(const DepthRequest& request, const Task& task = {});

}  // namespace relievo
