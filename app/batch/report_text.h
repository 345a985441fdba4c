// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/batch/json.h"

namespace relievo::batch {

/// A report, also where it tells names that are no UTF-8: those as textOfName() writes them.
std::string reportText(Json report);

}  // namespace relievo::batch
