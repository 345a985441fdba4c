// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/log_columns.h"

namespace relievo {

std::string logColumns() {
  std::string names;
  for (const LogColumn& column : kLogColumns) {
    if (!names.empty()) names += ',';
    names += column.name;
  }
  return names;
}

}  // namespace relievo
