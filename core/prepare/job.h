// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/scan.h"
#include "core/message/message.h"
#include "core/neighbours/point_neighbours.h"
#include "core/prepare/align/align.h"
#include "core/prepare/point_bits.h"
#include "core/prepare/recipe.h"

namespace relievo {

/// What the steps need to know of a scan; the lists belong to somebody else.
struct PrepareScan {
  std::string name;
  FilePoint origin;
  std::optional<FilePoint> viewpoint;
  double mm_per_unit = 1;
  std::span<const Point3f> points;
  std::span<const std::uint8_t> classes;       ///< Empty: none.
  std::span<const std::uint8_t> returns;       ///< Empty: none; else as Scan::returns.
  std::span<const std::uint16_t> intensities;  ///< Empty: none; else as `intensity` says.
  std::optional<IntensityRange> intensity;
};

/// What the worker is asked to do.
struct PrepareJob {
  std::vector<Step> steps;
  std::vector<PrepareScan> scans;

  std::size_t points() const noexcept {
    std::size_t sum = 0;
    for (const PrepareScan& scan : scans) sum += scan.points.size();
    return sum;
  }
};

/// What one step did.
struct StepResult {
  std::uint64_t before = 0, after = 0;  ///< Points of all scans together.
  double seconds = 0;
  std::vector<Message> notes;  ///< For people; may be none.
  bool done = true;            ///< Else `notes` say why not, and nothing was changed.
  PointBits kept;              ///< After it: the points of all scans, one after the other.
};

/// What the worker answers: bits, matrices and numbers. A scan's points keep their bytes.
struct PrepareAnswer {
  std::vector<StepResult> steps;
  std::vector<Pose> poses;           ///< One for each scan; identity: as stored.
  std::optional<AlignAnswer> align;  ///< If a step aligned.
  std::vector<Point3f> normals;      ///< Empty, or one for each point that is left.
  std::vector<Message> warnings;     ///< For people; each one sentence.
  std::string pcl, flann;            ///< Versions of the libraries that did it.
};

}  // namespace relievo
