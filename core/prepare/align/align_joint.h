// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/prepare/align/align_pair.h"

/// More than two scans: all poses at once.
namespace relievo::align {

/// Two scans that were laid on each other.
struct Link {
  std::size_t scan = 0, onto = 0;
  PairFit fit;  ///< Its pose brings `scan` to `onto`.
};

/// Moves all scans that are not fixed so that every linked pair fits best, both ways, closer and
/// closer: Gauss-Newton on six numbers a scan. A chain of pairs leaves what each of them missed;
/// this spreads it (7 times less of it on four views, clouds.md 4.6).
/// @param poses  reference from scan, between middles
void solveTogether(std::span<const Cloud> clouds, std::span<const Link> links,
                   const std::vector<bool>& fixed, const Scale& scale,
                   std::vector<LocalPose>& poses, const Task& task);

}  // namespace relievo::align
