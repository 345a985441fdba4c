// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/recording/log_columns.h"

namespace relievo {

/// What happened at a row.
struct LogEvent {
  double t_s = 0;
  std::uint64_t tick = 0;
  std::string text;

  friend bool operator==(const LogEvent&, const LogEvent&) = default;
};

/// A recording that was read back. A column that its use does not need and that the file does not
/// have, as earlier builds did not write it, leaves its member as TouchRow begins with it.
struct LogTable {
  std::string header;  ///< Comment lines before the rows, without "# ".
  std::string footer;  ///< Those after the first row: how the loop ran, where windows lay.
  std::vector<TouchRow> rows;
  std::vector<LogEvent> events;           ///< In order.
  std::vector<std::string_view> lacking;  ///< Columns that the file does not have.
};

/// Is a file's name that of an HDF5 log? All others are CSV.
bool isHdf5Name(const std::filesystem::path& file);

/// Reads a recording, CSV or HDF5. [any thread; HDF5 takes turns]
/// @throw FileError  unreadable, no recording, a column that `use` needs is missing; a value that
///                   is no number, but for replays also one that is not finite, names its row
/// @throw Cancelled
LogTable readLog(const std::filesystem::path& file, LogUse use = LogUse::replay,
                 const Task& task = {});

/// What to say of a file that is something else, and of one that lacks a column.
FileError noRecording(const std::filesystem::path& file);
FileError withoutColumn(const std::filesystem::path& file, std::string_view column);

/// What follows a word at the beginning of a header's line; empty: no such line.
std::string_view headerLine(std::string_view header, std::string_view word);

/// Is it an HDF5 log, of this build or an earlier one? @param head  its first bytes, 32 or more
bool isHdf5Log(std::string_view head) noexcept;

/// The provenance inside an HDF5 log; nothing if it has none. @throw FileError  no HDF5 file
std::optional<std::string> hdf5State(const std::filesystem::path& file);

}  // namespace relievo
