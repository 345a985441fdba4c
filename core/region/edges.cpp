// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/edges.h"

namespace relievo {

std::uint8_t edgesOf(const DetailLadder& ladder, const Region& region) {
  constexpr double kStep = 0.25;  // As one step of Move mode.
  std::uint8_t edges = 0;
  if (!moved(ladder, region, -kStep, 0)) edges |= 1U;
  if (!moved(ladder, region, kStep, 0)) edges |= 2U;
  if (!moved(ladder, region, 0, -kStep)) edges |= 4U;
  if (!moved(ladder, region, 0, kStep)) edges |= 8U;
  return edges;
}

}  // namespace relievo
