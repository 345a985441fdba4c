// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "core/recording/touch_row.h"
#include "haptics/loop/haptic_core.h"

namespace relievo {

/// What a recording keeps of a sample. @param t_s  since the start of the log, or the stroke's
TouchRow touchRow(const HapticSample& sample, double t_s);

/// Of a log that is killed at most so much is lost, on its own clock.
inline constexpr double kMostUnsavedS = 0.4;

/// A log file that is being written. [one thread at a time]
class SampleLog {
 public:
  SampleLog() = default;
  virtual ~SampleLog() = default;  ///< Closes; an error at this point is lost: call close().
  SampleLog(const SampleLog&) = delete;
  SampleLog& operator=(const SampleLog&) = delete;

  /// @throw WriteError (E401)  says how many rows are saved; the file is closed, rows() is exact
  virtual void write(const HapticSample& sample, double t_s, std::string_view event = {}) = 0;
  /// Lines of the footer that the next row needs: on the disk as soon as that row is, so that the
  /// rows that are left of a recording say as much as whole ones. Each ends with a line end.
  virtual void keep(std::string_view lines) = 0;
  /// Ends the file; `footer` lines are kept with it. Further calls do nothing.
  /// @throw WriteError (E401)
  virtual void close(std::string_view footer = {}) = 0;
  virtual std::uint64_t rows() const noexcept = 0;  ///< Written; after an error: saved.
  virtual const std::filesystem::path& file() const noexcept = 0;
};

/// A stroke runs on a clock of its own; a recording has a loop whose times end it.
enum class LogKind : std::uint8_t { stroke, recording };

/// HDF5 where the name ends in .h5 or .hdf5, else CSV. What stands there already stays until the
/// log is closed; until then it is written beside it (LogPlace). A log that is never closed is
/// removed if it is a stroke's or has no rows. `header` as for LogWriter; its line "parameters
/// {...}" becomes /parameters of an HDF5 file, "relievo:state {...}" its /relievo:state. In a CSV
/// file of a recording the footer stands before the rows, in room that is kept for it. `surface`:
/// what is touched, for /surface; may be null.
/// @throw WriteError  the file cannot be made, or somebody else is writing it
std::unique_ptr<SampleLog> openLog(const std::filesystem::path& file, std::string_view header,
                                   const HapticSpace* surface = nullptr,
                                   LogKind kind = LogKind::stroke);

}  // namespace relievo
