// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

#include "core/depth/depth_request.h"
#include "core/message/message.h"

namespace relievo {

/// "front", "second", "topmean", "median", "mean", "splat", "quadratic", "min"; nothing for other
/// words.
std::optional<PointRule> pointRule(std::string_view name);
/// In words, for people: "front-most point", "median of the points", ...
std::string_view describe(PointRule rule);
/// The same as a message.
Message ruleMessage(PointRule rule);

/// Proposed only where the points lie in one layer, so that nothing shows through.
bool isForOneLayer(PointRule rule);

/// Makes one height of all points of a cell, also where they lie on the object's front and back.
bool mixesLayers(PointRule rule);

/// A rule and why.
struct RuleProposal {
  PointRule rule = PointRule::front;
  Message reason;  ///< "2.5 points per cell"
};
/// "2.5 points per cell: local quadratic"
Message ruleAndWhy(const RuleProposal& proposal);

/// From the cells the points fall into, in the rows looked at. One point at every
/// sample: that point. Several layers (an object and its back): the mean of the top layer, so that
/// the back does not mix with the front. One layer: local quadratics below 4 points a cell, else
/// the median. [worker]
/// @throw Cancelled
RuleProposal proposeRule(const DepthRequest& request, const Task& task = {});

/// Standard deviation of the points about local quadratics, the median over some rows. [worker]
/// @throw Cancelled
double pointNoise(const DepthRequest& request, const Task& task = {});

/// Height of every cell from its points by request.rule; NaN where there is none, and how well the
/// points carry it. Points off all their neighbours are left out. [worker]
/// @throw Cancelled
CapturedDepths scatterPoints(const DepthRequest& request, const Task& task = {});

}  // namespace relievo
