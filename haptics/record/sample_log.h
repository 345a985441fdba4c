// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/loop/haptic_core.h"

namespace relievo {

/// One column of a log: its name, its unit and what it holds.
struct LogColumn {
  std::string_view name, unit, description;
};

/// All columns but `event`, which is text; in the order of conventions for logs. `dev_*` are hand
/// mm.
inline constexpr std::array<LogColumn, 30> kLogColumns{{
    {"t_s", "s", "time since the start of the log, or the stroke's"},
    {"tick", "1", "number of the loop's tick; a gap was dropped"},
    {"hip_x_mm", "mm", "hand, on the object"},
    {"hip_y_mm", "mm", "hand, on the object"},
    {"hip_z_mm", "mm", "hand, on the object"},
    {"proxy_x_mm", "mm", "proxy, on the object"},
    {"proxy_y_mm", "mm", "proxy, on the object"},
    {"proxy_z_mm", "mm", "proxy, on the object"},
    {"f_x_N", "N", "force on the hand, after all stages"},
    {"f_y_N", "N", "force on the hand, after all stages"},
    {"f_z_N", "N", "force on the hand, after all stages"},
    {"f_cmd_N", "N", "size of the force before limits"},
    {"clamp", "1", "1: a limit changed the force"},
    {"contact", "1", "1: the proxy touches"},
    {"nx", "1", "surface normal at the proxy"},
    {"ny", "1", "surface normal at the proxy"},
    {"nz", "1", "surface normal at the proxy"},
    {"k_Npm", "N/m", "stiffness, per metre of hand"},
    {"detail", "1", "detail of the window; 1 is the whole"},
    {"region_id", "1", "number of the window"},
    {"origin", "1", "0 measured, 1 interpolated, 2 base, 3 steep, 4 outside"},
    {"buttons", "1", "bit i: button i is down; bit 4: the hand hovers"},
    {"rate_Hz", "Hz", "measured rate of the loop"},
    {"dev_hip_x_mm", "mm", "hand, in its workspace"},
    {"dev_hip_y_mm", "mm", "hand, in its workspace"},
    {"dev_hip_z_mm", "mm", "hand, in its workspace"},
    {"dev_proxy_x_mm", "mm", "proxy, in the hand's workspace"},
    {"dev_proxy_y_mm", "mm", "proxy, in the hand's workspace"},
    {"dev_proxy_z_mm", "mm", "proxy, in the hand's workspace"},
    {"age_s", "s", "age of the position"},
}};

/// The numbers of a row, in the columns' order. Each is exact in a double.
std::array<double, kLogColumns.size()> logValues(const HapticSample& sample, double t_s);

/// What follows a word at the beginning of a header's line; empty: no such line.
std::string_view headerLine(std::string_view header, std::string_view word);

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

/// Is it an HDF5 log, of this build or an earlier one? @param head  its first bytes, 32 or more
bool isHdf5Log(std::string_view head) noexcept;

/// The provenance inside an HDF5 log; nothing if it has none. @throw FileError  no HDF5 file
std::optional<std::string> hdf5State(const std::filesystem::path& file);

}  // namespace relievo
