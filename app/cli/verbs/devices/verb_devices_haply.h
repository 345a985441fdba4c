// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/json.h"
#include "app/cli/verb.h"

namespace relievo::batch {

/// Haply's Inverse Service, if one listens, and every device that it sees, with what keeps it from
/// being felt. Adds "haply_service" and "haplys" to the report.
/// @throw ArgumentError  RELIEVO_HAPLY_SERVICE is no address
void listHaplys(Json& json, CommandResult& outcome);

}  // namespace relievo::batch
