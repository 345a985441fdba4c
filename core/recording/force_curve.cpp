// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/force_curve.h"

#include <algorithm>
#include <iterator>

#include "core/recording/log_table.h"

namespace relievo {

std::vector<ForcePoint> readForceCurve(const std::filesystem::path& file, const Task& task) {
  const LogTable log = readLog(file, LogUse::plot, task);
  std::vector<ForcePoint> points;
  points.reserve(log.rows.size());
  std::transform(log.rows.begin(), log.rows.end(), std::back_inserter(points), forcePoint);
  return points;
}

}  // namespace relievo
