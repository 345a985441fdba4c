// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/device/falcon/link/link_status.h"
#include "haptics/device/falcon/port.h"

namespace relievo::falcon {

/// Why a Falcon cannot be opened, as the driver would say it; of one that can be: not in use.
Message describe(const Opening& opening);

/// Would plugging or pulling one be heard, and nothing else help?
bool onlyThePlugHelps(Presence presence);

}  // namespace relievo::falcon
