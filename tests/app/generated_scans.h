// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace relievo::test {

/// A scan file that nobody would draw by hand.
struct GeneratedScan {
  std::string name;   ///< With the ending of its format.
  std::string about;  ///< Shape, points, size and place, to read in a failure.
  std::string bytes;
};

/// The same for the same numbers: 0 to a million points, on a dome, a plane, a line or one place,
/// as small as 1e-30 or as large as 1e30 units, near the origin or far from it, in one of the
/// formats that are read; the formats take turns.
GeneratedScan generatedScan(std::uint32_t seed, int number);

}  // namespace relievo::test
