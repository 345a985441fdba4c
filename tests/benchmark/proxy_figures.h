// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace relievo {

/// One row of docs/dev/haptics-figures.md: what was measured beside what it should be. Prototype,
/// peers and paper are quoted; ours is measured when the program runs.
struct FigureRow {
  std::string what, target, ours;
  bool met = true;
  std::string prototype, others;
};

// Groups of rows; each takes some seconds.
std::vector<FigureRow> accuracyRows();
std::vector<FigureRow> robustnessRows();
std::vector<FigureRow> timeRows();

std::string decimal(double value, int digits);

}  // namespace relievo
