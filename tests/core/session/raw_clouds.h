// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/sample_files.h"

namespace relievo::test {

/// Points as LAS stores them, in parts of `kRawScale` mm.
using Raw = std::vector<std::array<std::int32_t, 3>>;
inline constexpr double kRawScale = 1.0 / 512;  // Exact in float and double.

inline std::string lasOf(const Raw& raw) {
  Las las;
  las.scale = {kRawScale, kRawScale, kRawScale};
  las.raw = raw;
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(raw.size());
  return lasFile(las);
}

inline std::string lazOf(const Raw& raw) {
  Laz laz;
  for (const auto& point : raw) {
    std::string record;
    for (const std::int32_t stored : point) record += bytesOf(stored);
    laz.records.push_back(record + std::string(8, '\x11'));
  }
  laz.scale = kRawScale;
  laz.chunk_points = 5000;
  return lazFile(laz).bytes;
}

inline void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace relievo::test
