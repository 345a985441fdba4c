// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace relievo {

/// One row of a recording, as far as the paper's force figure needs it.
struct ForceCurveRow {
  double t_s = 0;
  double hip_z_mm = 0, proxy_z_mm = 0;  ///< View mm.
  double force_n = 0;                   ///< Norm of the force on the hand.
};

/// Reads the recording's CSV: comment lines with #, one header row, columns found by name.
/// @throw FileError  unreadable, a column is missing, a number is malformed (names the row), no row
std::vector<ForceCurveRow> readForceCurve(const std::filesystem::path& file);

}  // namespace relievo
