// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/depth/depth_map.h"
#include "core/depth/depth_request.h"
#include "core/depth/quality.h"
#include "core/message/message.h"

namespace relievo {

/// "10.7 %"
Message percentWords(double share);

/// What was lost between a scan and its map; only what somebody should act on or
/// wonder at.
/// @param seen_through  cells that showed the back through gaps of the front
/// @param shares        of the finished map's cells by origin
std::vector<Message> lossReport(const DepthLosses& losses, std::size_t seen_through,
                                const std::array<double, kOriginCount>& shares);

/// Rules for one layer are proposed for nothing else; by hand they can be chosen for anything. A
/// sentence if this rule made one height of front and back in more than a hundredth of the cells.
/// @param cells  of the finished map, by origin
std::optional<Message> mixedLayerWords(PointRule chosen, const HiddenSurface& hidden,
                                       const OriginCounts& cells);

}  // namespace relievo
