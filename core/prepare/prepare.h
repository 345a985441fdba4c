// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/prepare/job.h"
#include "core/prepare/recipe.h"

namespace relievo {

struct PrepareOptions {
  std::uint64_t max_memory_bytes = 6ULL << 30;  ///< Address space of the child.
  double max_cpu_s = 1800;
};

/// What the steps of a recipe left, and what they did.
struct Prepared {
  Scan scan;             ///< Of all scans together; without `answer.normals`.
  PrepareAnswer answer;  ///< Checked as from outside.
  LengthUnit unit = LengthUnit::mm;
  bool unit_known = false;  ///< Given or stated by a file; else 1 mm is assumed.

  /// What could not be done, for people, step by step; empty: all was.
  std::vector<std::vector<Message>> notDone() const;
};

/// Does the steps of a recipe in the child process relievo-prepare, with limits and in the C
/// locale. Measured points keep their bytes: the child says which stay and how scans are laid, no
/// more. The same scans and recipe give the same points. Acts on a stop request within 250 ms.
/// [worker]
/// @param scans  as `recipe.scans` names them, which may be empty
/// @throw ArgumentError  a recipe that `check` refuses, scans in different units, or no point left
/// @throw FileError  the child is missing, or broke down  @throw Cancelled
Prepared prepare(const std::vector<const Scan*>& scans, const Recipe& recipe,
                 const PrepareOptions& options = {}, const Task& task = {});

}  // namespace relievo
