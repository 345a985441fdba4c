// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/source/source_in_use.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/session/source/missing_height.h"

namespace relievo {
namespace {

/// The cubes of the sample, in view millimetres.
StrayGrid gridInView(const Scan& sample, const Rotation& rotation, const ViewFromFile& view) {
  const RotatedBounds box = rotatedBounds(sample, rotation, 1);
  Scan nowhere;
  nowhere.points.push_back({0, 0, 0});
  nowhere.origin = sample.origin;
  const ViewMm at = rotatedBounds(nowhere, rotation, 1).min;  // The origin along the axes.
  const PointsView points{.points = sample.points, .axes = &rotation};
  const StrayGrid local =
      strayGrid(points, {.min = {box.min.x - at.x, box.min.y - at.y, box.min.z - at.z},
                         .max = {box.max.x - at.x, box.max.y - at.y, box.max.z - at.z}});
  const double mm = std::hypot(view.m[0], view.m[4], view.m[8]);
  return {.centre = {mm * (local.centre[0] + at.x), mm * (local.centre[1] + at.y),
                     mm * (local.centre[2] + at.z)},
          .cell = mm * local.cell};
}

AxisBox boxOf(const SourceBounds& bounds) {
  return {.min = {bounds.min.x, bounds.min.y, bounds.min.z},
          .max = {bounds.max.x, bounds.max.y, bounds.max.z}};
}

std::function<bool(const FilePoint&)> insideOf(const AxisBox& box,
                                               const ViewFromFile& view_from_file) {
  return [view_from_file, box](const FilePoint& p) {
    const ViewMm seen = view_from_file(p);
    return contains(box, {seen.x, seen.y, seen.z});
  };
}

/// A height that most likely stands for none. For nearly every file the bounding box alone shows
/// that there is none, and its points are not read.
std::optional<SuspectHeight> suspectIn(const PointSource& source, const SourceBounds& bounds) {
  const FileBounds& box = bounds.file;
  if (!isUsualNodata(box.min.z) && !isUsualNodata(box.max.z)) return std::nullopt;
  return suspectAmong([&source](const std::function<void(double)>& take) {
    forEachBlock(source, 0, source.count, [&take](std::span<const FilePoint> block) {
      for (const FilePoint& p : block) {
        if (isFinite(p)) take(p.z);
      }
    });
  });
}

}  // namespace

SourceInUse sourceInUse(PointSource all, const Scan& sample, const Rotation& rotation,
                        const ViewFromFile& view_from_file, const SurfaceOptions& options,
                        int threads, const Task& task, Exchange* processes) {
  SourceInUse in_use{.source = std::move(all), .keeps = {}, .bounds = {}, .strays = {}};
  const auto look = [&] {
    return boundsAndCountsOf(in_use.source, view_from_file,
                             gridInView(sample, rotation, view_from_file), threads, task,
                             processes);
  };
  BoundsAndCounts found = look();
  const std::uint64_t finite = found.bounds.finite_points;
  if (!options.nodata) in_use.suspect = suspectIn(in_use.source, found.bounds);
  if (const auto missing = missingHeight(options.nodata, in_use.suspect)) {
    in_use.keeps = [value = *missing](const FilePoint& p) { return !isHeight(p.z, value, 0); };
    in_use.source = filtered(std::move(in_use.source), in_use.keeps);
    found = look();
  }
  const auto& [bounds, counts] = found;
  if (bounds.finite_points == 0) {
    throw failure<MessageId::no_point_left>(shownName(sample.info.file));
  }
  in_use.missing = finite - bounds.finite_points;
  in_use.bounds = bounds;
  in_use.strays.all = bounds.finite_points;
  const StrayLimits limits = counts.limits(boxOf(bounds));
  const auto leave_out = [&](const AxisBox& box, const PointSource& kept,
                             const SourceBounds& rest) {
    in_use.source = kept;
    in_use.keeps = [before = std::move(in_use.keeps), is_inside = insideOf(box, view_from_file)](
                       const FilePoint& p) { return (!before || before(p)) && is_inside(p); };
    in_use.bounds = rest;
  };
  AxisBox counted = boxOf(bounds);
  std::uint64_t left = bounds.finite_points;
  for (const bool are_groups : {false, true}) {
    const std::optional<AxisBox>& box = are_groups ? limits.groups : limits.strays;
    if (!box) continue;
    const PointSource kept = filtered(in_use.source, insideOf(*box, view_from_file));
    const SourceBounds rest = boundsOf(kept, view_from_file, threads, task, processes);
    if (rest.finite_points >= left ||
        !areFew(bounds.finite_points - rest.finite_points, bounds.finite_points)) {
      continue;
    }
    const bool is_kept =
        are_groups ? options.strays != StrayRule::drop_groups : options.strays == StrayRule::keep;
    Strays& strays = in_use.strays;
    (are_groups ? strays.grouped : strays.points) = left - rest.finite_points;
    (are_groups ? strays.share_of_box_grouped : strays.share_of_box) =
        shareTaken(counted, boxOf(rest));
    (are_groups ? strays.groups_kept : strays.kept) = is_kept;
    if (!is_kept) leave_out(*box, kept, rest);
    counted = boxOf(rest);
    left = rest.finite_points;
  }
  return in_use;
}

}  // namespace relievo
