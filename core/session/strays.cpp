// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/strays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/failure.h"
#include "core/cloud/part_of_scan.h"
#include "core/cloud/stray_limits.h"
#include "core/io/file_check.h"
#include "core/message/catalogue.h"
#include "core/session/loss_report.h"

namespace relievo {
namespace {

constexpr double kHuge = std::numeric_limits<double>::infinity();
constexpr double kSpike = 10;             // Sides of the object: no edge of a model is as long.
constexpr double kShareOfSurface = 0.01;  // A piece with more of a mesh's surface is no stray.

using Mask = std::vector<std::uint8_t>;  // Per point, 0 or 1.

/// The vertices that triangles use; empty for clouds.
Mask usedVertices(const Scan& scan) {
  if (scan.triangles.empty()) return {};
  Mask used(scan.points.size());
  for (const auto& triangle : scan.triangles) {
    for (const std::uint32_t corner : triangle) used[corner] = 1;
  }
  return used;
}

AxisBox boxOf(const PointsView& view) {
  AxisBox box{.min = {kHuge, kHuge, kHuge}, .max = {-kHuge, -kHuge, -kHuge}};
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    if (view.counted != nullptr && (*view.counted)[i] == 0) continue;
    const Coordinates p = view.at(i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], p[axis]);
      box.max[axis] = std::max(box.max[axis], p[axis]);
    }
  }
  return box;
}

/// Around all points of a cloud; without a look at them where the file's axes are meant.
AxisBox boxOf(const Scan& scan, const PointsView& view) {
  if (view.axes != nullptr || view.counted != nullptr || !scan.info.bounds) return boxOf(view);
  const FilePoint low = scan.info.bounds->min - scan.origin;
  const FilePoint high = scan.info.bounds->max - scan.origin;
  return {.min = {low.x, low.y, low.z}, .max = {high.x, high.y, high.z}};
}

double areaOf(const Scan& scan, const std::array<std::uint32_t, 3>& t) {
  const FilePoint a = scan.point(t[0]);
  const FilePoint u = scan.point(t[1]) - a;
  const FilePoint v = scan.point(t[2]) - a;
  return 0.5 * std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}

/// A large plane under a statue has four vertices, a spire one: few, but no strays.
bool isPartOfTheObject(const Scan& scan, const PointsView& view, const AxisBox& all,
                       const AxisBox& limits) {
  double near = 0;
  double far = 0;
  bool has_spikes = false;
  for (const auto& triangle : scan.triangles) {
    const auto inside = std::count_if(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
      return contains(limits, view.at(corner));
    });
    has_spikes = has_spikes || (inside > 0 && inside < 3);
    if (inside == 3) near += areaOf(scan, triangle);
    if (inside == 0) far += areaOf(scan, triangle);
  }
  if (far > kShareOfSurface * near) return true;
  return has_spikes && longestSide(all) < kSpike * longestSide(limits);
}

struct Found {
  Mask keep;         ///< Without strays. Empty: there are none.
  Mask keep_groups;  ///< Without groups and strays. Empty: there are no groups.
  Strays strays;
};

void markOutside(Mask& keep, const PointsView& view, const AxisBox& box) {
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!contains(box, view.at(i))) keep[i] = 0;
  }
}

std::uint64_t countLeftOut(const Mask& keep) {
  return static_cast<std::uint64_t>(std::count(keep.begin(), keep.end(), std::uint8_t{0}));
}

/// Of the vertices left out, those that no triangle uses.
std::uint64_t countUnused(const Mask& keep, const Mask& used) {
  std::uint64_t unused = 0;
  for (std::size_t i = 0; i < used.size(); ++i) unused += keep[i] == 0 && used[i] == 0 ? 1 : 0;
  return unused;
}

Found find(const Scan& scan, const std::array<double, 9>* axes, const Task& task) {
  task.check();
  const Mask used = usedVertices(scan);
  const PointsView view{
      .points = scan.points, .axes = axes, .counted = used.empty() ? nullptr : &used};
  const AxisBox in_use = boxOf(scan, view);
  StrayLimits limits = strayLimits(view, in_use);
  task.check();
  for (std::optional<AxisBox>* box : {&limits.strays, &limits.groups}) {
    if (*box && !used.empty() && isPartOfTheObject(scan, view, in_use, **box)) box->reset();
  }
  // From the points themselves: the file's own box is not rounded to float.
  AxisBox all = used.empty() ? in_use : boxOf(PointsView{.points = scan.points, .axes = axes});
  Found found{.keep = {}, .keep_groups = {}, .strays = {.all = scan.points.size()}};
  const auto boxOfKept = [&](const Mask& keep) {
    return boxOf(PointsView{.points = scan.points, .axes = axes, .counted = &keep});
  };
  const bool has_unused_beyond = !used.empty() && (all.min != in_use.min || all.max != in_use.max);
  if (limits.strays || has_unused_beyond) {
    found.keep.assign(scan.points.size(), 1);
    if (has_unused_beyond) markOutside(found.keep, view, in_use);
    if (limits.strays) markOutside(found.keep, view, *limits.strays);
    const AxisBox kept = boxOfKept(found.keep);
    found.strays.points = countLeftOut(found.keep);
    found.strays.unused = countUnused(found.keep, used);
    found.strays.share_of_box = shareTaken(all, kept);
    all = kept;
  }
  if (limits.groups) {
    found.keep_groups = found.keep.empty() ? Mask(scan.points.size(), std::uint8_t{1}) : found.keep;
    markOutside(found.keep_groups, view, *limits.groups);
    found.strays.grouped = countLeftOut(found.keep_groups) - found.strays.points;
    found.strays.share_of_box_grouped = shareTaken(all, boxOfKept(found.keep_groups));
    if (found.strays.grouped == 0) found.keep_groups.clear();
  }
  return found;
}

/// What of it a rule leaves out; nothing: nothing.
const Mask* maskOf(const Found& found, StrayRule rule) {
  if (rule == StrayRule::keep) return nullptr;
  if (rule == StrayRule::drop_groups && found.strays.grouped > 0) return &found.keep_groups;
  return found.strays.points > 0 ? &found.keep : nullptr;
}

/// Never "100 %" of what has something left.
Message shareWords(double share_of_box) {
  return percentWords(std::min(std::floor(1000 * share_of_box) / 1000, 0.999));
}

bool isAxisAligned(const std::array<double, 9>& axes) {
  return std::all_of(axes.begin(), axes.end(),
                     [](double c) { return c == 0 || c == 1 || c == -1; });
}

}  // namespace

bool isHeight(double z, double value, double origin_z) noexcept {
  return std::abs(z - value) <= 1e-6 * std::max({std::abs(value), std::abs(origin_z), 1e-30});
}

std::vector<Message> strayWordsOfFile(const Strays& strays) {
  std::vector<Message> words;
  const auto all = CountArgument::grouped(strays.all);
  if (strays.points > strays.unused) {
    words.push_back(
        said<MessageId::strays_in_file>(CountArgument::grouped(strays.points - strays.unused), all,
                                        shareWords(strays.share_of_box)));
  }
  if (strays.unused > 0) {
    words.push_back(
        said<MessageId::unused_vertices_in_file>(CountArgument::grouped(strays.unused)));
  }
  if (strays.grouped > 0) {
    words.push_back(said<MessageId::groups_in_file>(CountArgument::grouped(strays.grouped), all,
                                                    shareWords(strays.share_of_box_grouped)));
  }
  return words;
}

std::vector<Message> strayWords(const Strays& strays) {
  std::vector<Message> words;
  const auto all = CountArgument::grouped(strays.all);
  // Vertices without a face that stay are told with the others: they stretch the box like them.
  const std::uint64_t unused = strays.kept ? 0 : strays.unused;
  if (strays.points > unused) {
    const auto points = CountArgument::grouped(strays.points - unused);
    const Message share = shareWords(strays.share_of_box);
    words.push_back(strays.kept ? said<MessageId::strays_kept>(points, all, share)
                                : said<MessageId::strays_left_out>(points, all, share));
  }
  if (unused > 0) {
    words.push_back(said<MessageId::unused_vertices_left_out>(CountArgument::grouped(unused)));
  }
  if (strays.grouped > 0) {
    const auto points = CountArgument::grouped(strays.grouped);
    const Message share = shareWords(strays.share_of_box_grouped);
    words.push_back(strays.groups_kept ? said<MessageId::groups_kept>(points, all, share)
                                       : said<MessageId::groups_left_out>(points, all, share));
  }
  return words;
}

Strays straysOf(const Scan& scan, const Task& task) {
  return find(scan, nullptr, task).strays;
}

ScanInUse::ScanInUse(const Scan& whole, StrayRule rule, std::optional<double> missing_height,
                     const Task& task)
    : whole_(whole), rule_(rule) {
  if (missing_height) {
    Mask keep(whole.points.size());
    for (std::size_t i = 0; i < keep.size(); ++i) {
      keep[i] = isHeight(whole.point(i).z, *missing_height, whole.origin.z) ? 0 : 1;
    }
    missing_ = static_cast<std::uint64_t>(std::count(keep.begin(), keep.end(), std::uint8_t{0}));
    if (missing_ == keep.size()) {
      throw failure<MessageId::every_height_is_none>(shownName(whole.info.file));
    }
    if (missing_ > 0) part_ = partOf(whole, keep);
  }
  const Found found = find(scan(), nullptr, task);
  strays_ = found.strays;
  strays_.kept = rule == StrayRule::keep && strays_.points > 0;
  strays_.groups_kept = rule != StrayRule::drop_groups && strays_.grouped > 0;
  if (const Mask* const keep = maskOf(found, rule)) part_ = partOf(scan(), *keep);
}

void ScanInUse::dropAlong(const std::array<double, 9>& axes, const Task& task) {
  if (isAxisAligned(axes)) return;
  const Found found = find(scan(), &axes, task);
  const Strays& more = found.strays;
  if (more.points == 0 && more.grouped == 0) return;
  // Kept ones that were found along the file's axes are the same points.
  const auto add = [](std::uint64_t& count, std::uint64_t by, bool kept) {
    count = kept ? std::max(count, by) : count + by;
  };
  add(strays_.points, more.points, rule_ == StrayRule::keep);
  add(strays_.unused, more.unused, rule_ == StrayRule::keep);
  add(strays_.grouped, more.grouped, rule_ != StrayRule::drop_groups);
  strays_.share_of_box = std::max(strays_.share_of_box, more.share_of_box);
  strays_.share_of_box_grouped = std::max(strays_.share_of_box_grouped, more.share_of_box_grouped);
  strays_.kept = rule_ == StrayRule::keep && strays_.points > 0;
  strays_.groups_kept = rule_ != StrayRule::drop_groups && strays_.grouped > 0;
  if (const Mask* const keep = maskOf(found, rule_)) part_ = partOf(scan(), *keep);
}

}  // namespace relievo
