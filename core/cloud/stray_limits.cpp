// SPDX-License-Identifier: BSD-3-Clause
#include "core/cloud/stray_limits.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "core/base/bands.h"
#include "core/base/wide_vectors.h"

namespace relievo {
namespace {

constexpr double kTail = 0.02;          // Left aside at each end when the middle is measured.
constexpr double kFew = 0.01;           // Strays, or groups, of all points.
constexpr double kGroup = 0.001;        // Points that hang together and are more than this stay.
constexpr double kThin = 0.005;         // Of the points in a usual cube: fewer are no surface.
constexpr int kMostAcross = 16;         // Cubes across the middle.
constexpr double kOverhang = 0.5;       // Of the longest side: less does not stretch the box.
constexpr double kOverhangOfFew = 2;    // The same of clouds below kSmall points.
constexpr std::uint64_t kSmall = 1000;  // Points.
constexpr double kMargin = 0.125;       // Of the longest side: what lies so near is no stray.

constexpr int kBins = 256;
using Histogram = std::array<std::array<std::uint64_t, kBins>, 3>;

double side(const AxisBox& box, std::size_t axis) noexcept {
  return box.max[axis] - box.min[axis];
}

/// Counts along each axis of `box`; what lies beyond an end counts in the bin there.
template <class At>
Histogram histogramOf(const PointsView& view, const AxisBox& box, const At& at) {
  const std::size_t count = view.points.size();
  const int threads = threadsFor(count, 0);
  std::vector<Histogram> parts(static_cast<std::size_t>(threads));
  Coordinates scale{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double width = side(box, axis);
    scale[axis] = width > 0 ? kBins / width : 0;
    if (!std::isfinite(scale[axis])) scale[axis] = 0;  // Narrower than numbers can divide.
  }
  parallelFor(threads, threads, [&](int band, int) {
    const auto part = static_cast<std::size_t>(band);
    Histogram& mine = parts[part];
    const std::size_t end = count * (part + 1) / parts.size();
    for (std::size_t i = count * part / parts.size(); i < end; ++i) {
      if (view.counted != nullptr && (*view.counted)[i] == 0) continue;
      const Coordinates p = at(i);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double bin = std::clamp((p[axis] - box.min[axis]) * scale[axis], 0.0, kBins - 1.0);
        ++mine[axis][static_cast<std::size_t>(bin)];
      }
    }
  });
  for (std::size_t part = 1; part < parts.size(); ++part) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t bin = 0; bin < kBins; ++bin) parts[0][axis][bin] += parts[part][axis][bin];
    }
  }
  return parts[0];
}

Histogram histogramOf(const PointsView& view, const AxisBox& box) {
  if (view.axes != nullptr) {
    return histogramOf(view, box, [&view](std::size_t i) { return view.at(i); });
  }
  const auto* const points = view.points.data();
  return histogramOf(view, box, [points](std::size_t i) {
    return Coordinates{static_cast<double>(points[i][0]), static_cast<double>(points[i][1]),
                       static_cast<double>(points[i][2])};
  });
}

std::uint64_t countOf(const Histogram& histogram) {
  std::uint64_t count = 0;
  for (const std::uint64_t bin : histogram[0]) count += bin;
  return count;
}

/// Points within 3/16 of an end, axis by axis.
struct EndCounts {
  std::array<std::uint64_t, 3> low{}, high{};
};

RELIEVO_WIDE_VECTORS
void countEnds(const std::array<float, 3>* points, std::size_t count,
               const std::array<float, 3>& low_ends, const std::array<float, 3>& high_ends,
               EndCounts& result) {
  constexpr std::size_t kBlock = 4096;  // Counted in 32 bits.
  for (std::size_t start = 0; start < count; start += kBlock) {
    const std::size_t end = std::min(start + kBlock, count);
    std::uint32_t low_x = 0, low_y = 0, low_z = 0, high_x = 0, high_y = 0, high_z = 0;
    for (std::size_t i = start; i < end; ++i) {
      low_x += points[i][0] <= low_ends[0] ? 1U : 0U;
      low_y += points[i][1] <= low_ends[1] ? 1U : 0U;
      low_z += points[i][2] <= low_ends[2] ? 1U : 0U;
      high_x += points[i][0] >= high_ends[0] ? 1U : 0U;
      high_y += points[i][1] >= high_ends[1] ? 1U : 0U;
      high_z += points[i][2] >= high_ends[2] ? 1U : 0U;
    }
    result.low[0] += low_x;
    result.low[1] += low_y;
    result.low[2] += low_z;
    result.high[0] += high_x;
    result.high[1] += high_y;
    result.high[2] += high_z;
  }
}

EndCounts endsOf(std::span<const std::array<float, 3>> points, const std::array<float, 3>& low_ends,
                 const std::array<float, 3>& high_ends) {
  const int threads = threadsFor(points.size(), 0);
  std::vector<EndCounts> parts(static_cast<std::size_t>(threads));
  parallelFor(threads, threads, [&](int band, int) {
    const auto part = static_cast<std::size_t>(band);
    const std::size_t begin = points.size() * part / parts.size();
    const std::size_t end = points.size() * (part + 1) / parts.size();
    countEnds(points.data() + begin, end - begin, low_ends, high_ends, parts[part]);
  });
  EndCounts ends;
  for (const EndCounts& part : parts) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ends.low[axis] += part.low[axis];
      ends.high[axis] += part.high[axis];
    }
  }
  return ends;
}

/// Can strays stretch this box at all? Where they do, by `kOverhang`, at least 3/16 at one end of
/// an axis that is at least a quarter of the longest hold strays only.
bool isThinAtAnEnd(const PointsView& view, const AxisBox& box) {
  std::array<float, 3> low_ends{}, high_ends{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double end = 3.0 / 16 * side(box, axis);
    low_ends[axis] = static_cast<float>(box.min[axis] + end);
    high_ends[axis] = static_cast<float>(box.max[axis] - end);
  }
  EndCounts ends;
  std::uint64_t all = view.points.size();
  if (view.axes == nullptr && view.counted == nullptr) {
    ends = endsOf(view.points, low_ends, high_ends);
  } else {
    all = 0;
    for (std::size_t i = 0; i < view.points.size(); ++i) {
      if (view.counted != nullptr && (*view.counted)[i] == 0) continue;
      ++all;
      const Coordinates p = view.at(i);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (p[axis] <= static_cast<double>(low_ends[axis])) ++ends.low[axis];
        if (p[axis] >= static_cast<double>(high_ends[axis])) ++ends.high[axis];
      }
    }
  }
  if (all < kLeastForStrays) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (side(box, axis) < 0.25 * longestSide(box)) continue;
    if (areFew(ends.low[axis], all) || areFew(ends.high[axis], all)) return true;
  }
  return false;
}

/// From the bin where the lower tail ends to the one where the upper begins.
AxisBox middleOf(const Histogram& histogram, const AxisBox& box) {
  const std::uint64_t all = countOf(histogram);
  const std::uint64_t tail =
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(kTail * static_cast<double>(all)));
  AxisBox middle;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double width = side(box, axis) / kBins;
    std::uint64_t passed = 0;
    std::size_t low = 0;
    while (low + 1 < kBins && passed + histogram[axis][low] <= tail) {
      passed += histogram[axis][low++];
    }
    passed = 0;
    std::size_t high = kBins - 1;
    while (high > low && passed + histogram[axis][high] <= tail) {
      passed += histogram[axis][high--];
    }
    middle.min[axis] = box.min[axis] + width * static_cast<double>(low);
    middle.max[axis] = box.min[axis] + width * static_cast<double>(high + 1);
  }
  return middle;
}

StrayGrid gridFrom(Histogram histogram, const PointsView& view, AxisBox box) {
  constexpr int kMostLooks = 64;  // Each is at least eight times as close as the one before.
  constexpr double kCoarse = 0.125;
  AxisBox middle = middleOf(histogram, box);
  for (int look = 0; look < kMostLooks && longestSide(middle) < kCoarse * longestSide(box);
       ++look) {
    box = middle;
    histogram = histogramOf(view, box);
    middle = middleOf(histogram, box);
  }
  const double across =
      std::clamp(std::sqrt(static_cast<double>(countOf(histogram))) / 2, 1.0, 1.0 * kMostAcross);
  StrayGrid grid{.centre = {}, .cell = longestSide(middle) / across};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.centre[axis] = 0.5 * (middle.min[axis] + middle.max[axis]);
  }
  if (!(grid.cell > 0) || !std::isfinite(1 / grid.cell)) grid.cell = 0;
  return grid;
}

}  // namespace

double shareTaken(const AxisBox& from, const AxisBox& kept) noexcept {
  double share = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double side = from.max[axis] - from.min[axis];
    if (side > 0) share = std::max(share, 1 - (kept.max[axis] - kept.min[axis]) / side);
  }
  return share;
}

bool contains(const AxisBox& box, const Coordinates& p) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(p[axis] >= box.min[axis] && p[axis] <= box.max[axis])) return false;
  }
  return true;
}

double longestSide(const AxisBox& box) noexcept {
  return std::max({side(box, 0), side(box, 1), side(box, 2)});
}

Coordinates PointsView::at(std::size_t i) const noexcept {
  const Coordinates p{static_cast<double>(points[i][0]), static_cast<double>(points[i][1]),
                      static_cast<double>(points[i][2])};
  if (axes == nullptr) return p;
  const std::array<double, 9>& r = *axes;
  return {r[0] * p[0] + r[1] * p[1] + r[2] * p[2], r[3] * p[0] + r[4] * p[1] + r[5] * p[2],
          r[6] * p[0] + r[7] * p[1] + r[8] * p[2]};
}

bool areFew(std::uint64_t strays, std::uint64_t all) noexcept {
  return strays <=
         std::max<std::uint64_t>(1, static_cast<std::uint64_t>(kFew * static_cast<double>(all)));
}

std::size_t StrayCounts::Hash::operator()(const Cube& cube) const noexcept {
  std::size_t hash = 0;
  for (const double number : cube) {
    hash = hash * 0x9E3779B97F4A7C15U + std::hash<double>{}(number);
  }
  return hash;
}

StrayCounts::StrayCounts(const StrayGrid& grid)
    : grid_(grid), near_(static_cast<std::size_t>(kNear) * kNear * kNear) {}

std::optional<std::size_t> StrayCounts::nearIndex(const Cube& cube) noexcept {
  std::size_t index = 0;
  for (const double number : cube) {
    const double at = number + kMiddle;
    if (!(at >= 0 && at < kNear)) return std::nullopt;
    index = index * kNear + static_cast<std::size_t>(at);
  }
  return index;
}

void StrayCounts::add(const Coordinates& p) {
  ++points_;
  if (!(grid_.cell > 0)) return;
  Cube cube{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cube[axis] = std::floor((p[axis] - grid_.centre[axis]) / grid_.cell);
  }
  if (const auto index = nearIndex(cube)) {
    ++near_[*index];
  } else if (!is_too_wide_) {
    ++far_[cube];
    forgetIfTooWide();
  }
}

void StrayCounts::forgetIfTooWide() {
  if (far_.size() <= kMostFar) return;
  is_too_wide_ = true;
  far_.clear();
}

void StrayCounts::add(const StrayCounts& other) {
  points_ += other.points_;
  for (std::size_t i = 0; i < near_.size(); ++i) near_[i] += other.near_[i];
  is_too_wide_ = is_too_wide_ || other.is_too_wide_;
  for (const auto& [cube, count] : other.far_) far_[cube] += count;
  forgetIfTooWide();
}

/// A cube that holds fewer is no part of a surface; single strays must not join up to one.
std::string StrayCounts::bytes() const {
  std::string bytes;
  const auto put = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  std::vector<NearCube> near;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (near_[i] > 0) near.push_back({.index = static_cast<std::uint32_t>(i), .points = near_[i]});
  }
  put(points_);
  put(is_too_wide_);
  put(near.size());
  for (const NearCube& cube : near) put(cube);
  for (const auto& [cube, count] : far_) put(FarCube{.cube = cube, .points = count});
  return bytes;
}

void StrayCounts::add(std::string_view bytes) {
  StrayCounts other(grid_);
  const auto take = [&bytes](auto& value) {
    std::memcpy(&value, bytes.data(), sizeof(value));
    bytes.remove_prefix(sizeof(value));
  };
  std::size_t near = 0;
  take(other.points_);
  take(other.is_too_wide_);
  for (take(near); near > 0; --near) {
    NearCube cube;
    take(cube);
    other.near_[cube.index] = cube.points;
  }
  while (!bytes.empty()) {
    FarCube cube;
    take(cube);
    other.far_[cube.cube] = cube.points;
  }
  add(other);
}

std::uint64_t StrayCounts::leastInSolid() const {
  double squares = 0;
  const auto add = [&squares](std::uint64_t count) {
    squares += static_cast<double>(count) * static_cast<double>(count);
  };
  for (const std::uint32_t count : near_) add(count);
  for (const auto& [cube, count] : far_) add(count);
  // What a point finds in its own cube, on average: many thin cubes do not change it.
  const double usual = squares / static_cast<double>(points_);
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(kThin * usual)));
}

std::vector<StrayCounts::Group> StrayCounts::groups() const {
  const std::uint64_t least = leastInSolid();
  std::unordered_map<Cube, bool, Hash> far_seen;
  std::vector<bool> near_seen(near_.size());
  // Counts a cube once, and only if it is solid.
  const auto take = [&](const Cube& cube) -> std::uint64_t {
    if (const auto index = nearIndex(cube)) {
      if (near_seen[*index] || near_[*index] < least) return 0;
      near_seen[*index] = true;
      return near_[*index];
    }
    const auto found = far_.find(cube);
    if (found == far_.end() || found->second < least || far_seen[cube]) return 0;
    far_seen[cube] = true;
    return found->second;
  };
  std::vector<Group> groups;
  const auto gather = [&](const Cube& start) {
    std::uint64_t count = take(start);
    if (count == 0) return;
    AxisBox cubes{.min = start, .max = start};
    std::vector<Cube> open{start};
    while (!open.empty()) {
      const Cube cube = open.back();
      open.pop_back();
      for (int n = 0; n < 27; ++n) {
        const Cube next{cube[0] + n % 3 - 1, cube[1] + n / 3 % 3 - 1, cube[2] + n / 9 - 1};
        const std::uint64_t more = take(next);
        if (more == 0) continue;
        count += more;
        open.push_back(next);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          cubes.min[axis] = std::min(cubes.min[axis], next[axis]);
          cubes.max[axis] = std::max(cubes.max[axis], next[axis]);
        }
      }
    }
    AxisBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = grid_.centre[axis] + grid_.cell * cubes.min[axis];
      box.max[axis] = grid_.centre[axis] + grid_.cell * (cubes.max[axis] + 1);
    }
    groups.push_back({count, box});
  };
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (near_[i] < least || near_seen[i]) continue;
    const auto at = [](std::size_t place) { return static_cast<double>(place) - kMiddle; };
    gather({at(i / kNear / kNear), at(i / kNear % kNear), at(i % kNear)});
  }
  for (const auto& [cube, count] : far_) gather(cube);
  return groups;
}

/// `main` with its margin, if `all` reaches far beyond it.
std::optional<AxisBox> StrayCounts::stretchedBeyond(const AxisBox& main, const AxisBox& all) const {
  const double longest = longestSide(main);
  const double most = (points_ < kSmall ? kOverhangOfFew : kOverhang) * longest;
  AxisBox limits = main;
  bool is_stretched = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    is_stretched = is_stretched || main.min[axis] - all.min[axis] > most ||
                   all.max[axis] - main.max[axis] > most;
    limits.min[axis] -= kMargin * longest;
    limits.max[axis] += kMargin * longest;
  }
  return is_stretched ? std::optional(limits) : std::nullopt;
}

StrayLimits StrayCounts::limits(const AxisBox& all) const {
  if (points_ < kLeastForStrays || !(grid_.cell > 0) || is_too_wide_) return {};
  const std::vector<Group> found = groups();
  // Around all that are too many points to be told apart from the object.
  const auto around = [&](double share) {
    const std::uint64_t most = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(share * static_cast<double>(points_)));
    std::optional<AxisBox> box;
    for (const Group& group : found) {
      if (group.points <= most) continue;
      if (!box) box = group.box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box->min[axis] = std::min(box->min[axis], group.box.min[axis]);
        box->max[axis] = std::max(box->max[axis], group.box.max[axis]);
      }
    }
    return box;
  };
  StrayLimits limits;
  const std::optional<AxisBox> main = around(kGroup);
  if (!main) return limits;
  limits.strays = stretchedBeyond(*main, all);
  // Strays may lie far beyond a group that stretches nothing.
  if (const std::optional<AxisBox> core = around(kFew)) {
    limits.groups = stretchedBeyond(*core, *main);
  }
  return limits;
}

StrayGrid strayGrid(const PointsView& view, const AxisBox& all) {
  return gridFrom(histogramOf(view, all), view, all);
}

StrayLimits strayLimits(const PointsView& view, const AxisBox& all) {
  if (view.points.size() < kLeastForStrays) return {};
  if (!isThinAtAnEnd(view, all)) return {};
  const Histogram histogram = histogramOf(view, all);
  const std::uint64_t count = countOf(histogram);
  StrayCounts counts(gridFrom(histogram, view, all));
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    if (view.counted == nullptr || (*view.counted)[i] != 0) counts.add(view.at(i));
  }
  StrayLimits limits = counts.limits(all);
  for (std::optional<AxisBox>* box : {&limits.strays, &limits.groups}) {
    if (!*box) continue;
    std::uint64_t outside = 0;
    for (std::size_t i = 0; i < view.points.size(); ++i) {
      const bool counted = view.counted == nullptr || (*view.counted)[i] != 0;
      if (counted && !contains(**box, view.at(i))) ++outside;
    }
    if (outside == 0 || !areFew(outside, count)) box->reset();
  }
  return limits;
}

}  // namespace relievo
