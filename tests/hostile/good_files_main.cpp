// SPDX-License-Identifier: BSD-3-Clause
// Writes a small good file of every format into a folder, for tests/hostile/attack.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/hostile/hostile_files.h"

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("Usage: hostile_good_files FOLDER\n", stderr);
    return 1;
  }
  for (const relievo::test::HostileFile& file : relievo::test::goodFiles()) {
    std::ofstream out(std::filesystem::path(words[1]) / file.name, std::ios::binary);
    out << file.bytes;
    if (!out.flush()) return 3;
  }
  return 0;
}
