// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/base/task.h"
#include "core/recording/log_table.h"
#include "haptics/record/sample_log.h"

namespace relievo {

/// Where a replay first gave something else than the log says.
struct ReplayDifference {
  std::uint64_t tick = 0;
  std::string column;
  double logged = 0, replayed = 0;
};

struct ReplayResult {
  std::uint64_t ticks = 0;
  std::uint64_t different = 0;  ///< Rows with at least one other bit.
  std::optional<ReplayDifference> first;
};

/// Gives a new core of that chain the hands, times and buttons of a log and compares what it makes
/// of them with what the log says, bit by bit. `core`: as the log's loop had it from its first tick
/// on; faults, cuts and the end of forces that the log's last lines tell of are given to it, too.
/// @throw FileError  samples were dropped, or such a line is damaged  @throw Cancelled
ReplayResult replay(const HapticSpace& space, const HapticOptions& core, ForceChain chain,
                    const LogTable& log,
                    const std::function<void(const HapticSample&, double t_s)>& each,
                    const Task& task = {});

// For replays: what a row says, and what is made of it.
std::int64_t nanosecondsOf(const TouchRow& row);  ///< Since the first row.
/// @param first_ns  time of the first row
DeviceReading readingOf(const TouchRow& row, std::int64_t first_ns);
/// Counts the row, one of the log, if the sample has another bit in a column that the log has, and
/// hands the sample on.
void compare(HapticSample& sample, const TouchRow& row, const LogTable& log, ReplayResult& result,
             const std::function<void(const HapticSample&, double t_s)>& each);

}  // namespace relievo
