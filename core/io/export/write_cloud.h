// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/file/atomic_file.h"

namespace relievo {

/// What a cloud file says beside its points.
struct CloudNotes {
  std::string state;  ///< JSON of one line: where the points come from; empty: nothing.
  std::span<const std::array<float, 3>> normals;  ///< Empty, or one for each point.
};

/// Writes points and triangles as binary PLY: x y z as double where the scan has an origin, else
/// as float, bit for bit; then nx ny nz, red green blue (alpha where a point has no colour),
/// intensity as it was stored, classification, and part where there are several. The unit, if it
/// is known, and the names of the parts are comments. The file takes its place when all is written.
/// [worker]
/// @pre  lists are empty or as long as the points
/// @throw WriteError  nothing was replaced  @throw Cancelled
void writeCloud(const OutputFile& file, const Scan& scan, const CloudNotes& notes = {},
                const Task& task = {});

/// Start of the comment lines that hold a state, piece by piece: other programs stop at lines of
/// 1000 characters and more.
inline constexpr std::string_view kCloudStateWords = "comment relievo:state ";

}  // namespace relievo
