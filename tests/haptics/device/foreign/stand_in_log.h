// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace relievo::test {

/// One call of a stand-in plug-in (stand_in.cpp).
struct StandInEntry {
  enum class What : std::int32_t { step, cut, close };
  std::int64_t time_ns = 0;
  What what = What::step;
  double force_n = 0;  ///< Its size.
};

inline std::vector<StandInEntry> standInLog(const std::string& file) {
  std::vector<StandInEntry> entries;
  std::ifstream stream(file, std::ios::binary);
  StandInEntry entry;
  while (stream.read(reinterpret_cast<char*>(&entry), sizeof(entry))) entries.push_back(entry);
  return entries;
}

}  // namespace relievo::test
