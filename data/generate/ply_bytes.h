// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "data/generate/sample.h"

namespace relievo::samples {

/// Bytes of one point in the file.
std::size_t plyRecordBytes(const Cloud& cloud);

/// The whole PLY file: binary little endian, properties x y z and nothing else.
std::string plyBytes(const Cloud& cloud);

/// The same file cut off in the middle: the header promises all points, half of them are there,
/// and the last record is incomplete.
std::string truncatedPlyBytes(const Cloud& cloud);

}  // namespace relievo::samples
