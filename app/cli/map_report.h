// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of app/cli: what is said of a map, however it was made.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/json.h"
#include "core/base/origin.h"
#include "core/depth/fill/fill.h"
#include "core/depth/quality.h"
#include "core/message/message.h"
#include "core/session/nodata.h"
#include "core/session/source/raster_scale.h"
#include "core/session/strays.h"

namespace relievo::batch {

/// @param shares  of all cells by origin
Json sharesJson(const std::array<double, kOriginCount>& shares);
Json holesJson(const std::vector<Hole>& holes);
/// null where they are not known.
Json lossesJson(const std::optional<DepthLosses>& losses);
Json straysJson(const Strays& strays);
/// null where there is none.
Json suspectJson(const std::optional<SuspectHeight>& suspect);
/// null for others than rasters from elsewhere.
Json scaleJson(const std::optional<ScaleInUse>& scale);
/// Each in English.
Json sentencesJson(const std::vector<Message>& sentences);
std::string lossesText(const std::optional<DepthLosses>& losses);

}  // namespace relievo::batch
