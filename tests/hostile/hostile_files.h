// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace relievo::test {

/// What must come of a file. `free` is for files that a reader may take or refuse with equal right,
/// as a text that happens to end between two rows.
enum class Outcome { loads, refused, free };

struct HostileFile {
  std::string name;
  std::string bytes;
  Outcome outcome = Outcome::refused;
  std::uint64_t points = 0;  ///< If it loads: records stored, cells of a raster.
  std::uint64_t finite = 0;  ///< Of these.
};

/// A small good file of every format and encoding.
std::vector<HostileFile> goodFiles();

/// The same, bent in the ways that files are bent: emptied, cut, of another name, with other line
/// ends, with bytes before or behind; and those that lie in the ways their format allows.
std::vector<HostileFile> hostileFiles();

}  // namespace relievo::test
