// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/message/message.h"
#include "core/prepare/recipe.h"

namespace relievo {

/// A scan as the step Align sees it: what the steps before it left.
struct AlignScan {
  std::string name;
  FilePoint origin;                              ///< Added to every point.
  std::span<const std::array<float, 3>> points;  ///< File units from `origin`.
  std::optional<FilePoint> viewpoint;            ///< Where the scanner stood, file coordinates.
  double mm_per_unit = 1;
};

/// How one scan was laid on the others.
struct AlignVerdict {
  Pose pose;          ///< Reference from scan.
  Pose start;         ///< Where the search began.
  bool holds = true;  ///< Else the scan is left out, and `words` say why.
  double rms_mm = 0;
  double share = 0;                        ///< Of the scan's points with a partner.
  double tight_share = 0;                  ///< Of these within one spacing.
  double stability = 1;                    ///< 0: it slides.
  std::array<double, 3> weak_direction{};  ///< Unit, in the reference's file axes; 0: none.
  double uncertainty_mm = 0;   ///< Along the weakest motion, or about what picks leave open.
  std::vector<Message> words;  ///< For people: one or two sentences.
};

/// A chain of pairs that comes back to its beginning, and by how much it misses it.
struct AlignLoop {
  std::vector<std::uint32_t> scans;
  double deg = 0, mm = 0;
};

struct AlignAnswer {
  std::vector<AlignVerdict> scans;  ///< One for each; the reference has the identity.
  std::vector<AlignLoop> loops;
};

/// Does the step's methods `points` and `auto`; called in the worker only. Poses are rigid to 1e-9.
/// @throw Error  the step cannot be done at all  @throw Cancelled
using AlignFunction =
    std::function<AlignAnswer(const Align&, std::span<const AlignScan>, const Task&)>;

}  // namespace relievo
