// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/task.h"
#include "haptics/record/sample_log.h"

namespace relievo {

/// One row's numbers, as logValues() gives them.
using LogRow = std::array<double, kLogColumns.size()>;

/// What happened at a row.
struct LogEvent {
  double t_s = 0;
  std::uint64_t tick = 0;
  std::string text;
};

/// A log that was read back.
struct LogTable {
  std::string header;  ///< Comment lines before the rows, without "# ".
  std::string footer;  ///< Those after the first row: how the loop ran, where windows lay.
  std::vector<LogRow> rows;
  std::vector<LogEvent> events;  ///< In order.
};

/// Reads a log of `openLog`, CSV or HDF5.
/// @throw FileError  unreadable, no log, other columns; a value that is no number names its row
/// @throw Cancelled
LogTable readLog(const std::filesystem::path& file, const Task& task = {});

/// What to say of a file that is something else.
FileError noRecording(const std::filesystem::path& file);

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

/// Is a column computed again by a replay, and not what the replay is given?
bool isRecomputed(std::string_view column) noexcept;

// For replays: what a row says, and what is made of it.
std::uint64_t tickOf(const LogRow& row);
std::int64_t nanosecondsOf(const LogRow& row);  ///< Since the first row.
/// @param first_ns  time of the first row
DeviceReading readingOf(const LogRow& row, std::int64_t first_ns);
/// Counts the row if the sample has another bit, and hands the sample on.
void compare(HapticSample& sample, const LogRow& row, ReplayResult& result,
             const std::function<void(const HapticSample&, double t_s)>& each);

}  // namespace relievo
