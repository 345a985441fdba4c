// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace relievo::test {

/// One call of the stand-in for Force Dimension's library (stand_in_dhd.cpp) that changes anything.
struct DhdCall {
  enum class What : std::int32_t { open, force, enable, gravity, watchdog, most_force, close };
  std::int64_t time_ns = 0;
  What what = What::open;
  std::int32_t thread = 0;
  std::array<double, 3> given{};  ///< A force in the library's axes, N; else one number.
};

inline std::vector<DhdCall> dhdLog(const std::string& file) {
  std::vector<DhdCall> calls;
  std::ifstream stream(file, std::ios::binary);
  DhdCall call;
  while (stream.read(reinterpret_cast<char*>(&call), sizeof(call))) calls.push_back(call);
  return calls;
}

}  // namespace relievo::test
