// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/exchange.h"

namespace relievo::batch {

/// Before the command line is read: this process works together with others, which read the same
/// one. [main thread]
void workTogether(Exchange& processes);

/// Those of this program; it alone, unless it said otherwise.
Exchange& processes();

}  // namespace relievo::batch
