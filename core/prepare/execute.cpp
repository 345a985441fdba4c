// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/execute.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/failure.h"
#include "core/prepare/align/poses.h"
#include "core/prepare/base_plane.h"
#include "core/prepare/crop.h"
#include "core/prepare/normals.h"
#include "core/prepare/off_surface.h"
#include "core/prepare/outliers.h"
#include "core/prepare/pcl_version.h"
#include "core/prepare/thin.h"

namespace relievo {
namespace {

constexpr double kSpacingsOfBase = 2;
constexpr double kManyStrays = 0.05;
constexpr double kLittlePlane = 0.05;
constexpr std::size_t kCheckEvery = 1U << 18U;

/// The points of one scan, or of all once they are one, that the steps before have left.
struct Group {
  std::size_t first_scan = 0, end_scan = 0;
  FilePoint centre;  ///< Added to every point.
  std::vector<Point3f> points;
  std::vector<std::uint32_t> numbers;  ///< Among the points of all scans.
};

Message percent(double share) {
  constexpr double kLeastShare = 0.001;  // Nobody reads "0.00747 %".
  if (share > 0 && share < kLeastShare) return said<MessageId::share_tiny>();
  return said<MessageId::share_in_percent>(
      NumberArgument{.value = 100 * share, .digits = 3, .form = NumberArgument::Form::significant});
}

class Executor {
 public:
  Executor(const PrepareJob& job, const AlignFunction& align, const Task& task)
      : job_(job), align_(align), task_(task), kept_(job.points()) {
    answer_.poses.resize(job.scans.size());
    std::uint32_t first = 0;
    for (const PrepareScan& scan : job.scans) {
      firsts_.push_back(first);
      first += static_cast<std::uint32_t>(scan.points.size());
    }
    firsts_.push_back(first);
  }

  PrepareAnswer run() {
    for (std::size_t i = 0; i < job_.steps.size(); ++i) {
      task_.check();
      task_.report(kindOf(job_.steps[i]),
                   static_cast<double>(i) / static_cast<double>(job_.steps.size()));
      const auto start = std::chrono::steady_clock::now();
      StepResult result;
      result.before = kept_.count();
      result_ = &result;
      std::visit(*this, job_.steps[i]);
      result.after = kept_.count();
      result.seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      result.kept = kept_;
      answer_.steps.push_back(std::move(result));
    }
    takeNormals();
    answer_.pcl = pclVersion();
    answer_.flann = flannVersion();
    return std::move(answer_);
  }

  void operator()(const CropBox& step) { keepPlaces(step); }
  void operator()(const CropOutline& step) { keepPlaces(step); }

  void operator()(const Classes& step) {
    for (std::size_t s = 0; s < job_.scans.size(); ++s) {
      const PrepareScan& scan = job_.scans[s];
      if (scan.classes.empty()) {
        notDone(said<MessageId::scan_without_classes>(scan.name));
        continue;
      }
      keepIf(s, [&](std::size_t i) { return keeps(step, scan.classes[i]); });
    }
  }

  void operator()(const Returns& step) {
    for (std::size_t s = 0; s < job_.scans.size(); ++s) {
      const PrepareScan& scan = job_.scans[s];
      if (scan.returns.empty()) {
        notDone(said<MessageId::scan_without_returns>(scan.name));
        continue;
      }
      keepIf(s, [&](std::size_t i) { return keeps(step, scan.returns[i]); });
    }
  }

  void operator()(const Intensities& step) {
    for (std::size_t s = 0; s < job_.scans.size(); ++s) {
      const PrepareScan& scan = job_.scans[s];
      if (scan.intensities.empty() || !scan.intensity) {
        notDone(said<MessageId::scan_without_intensities>(scan.name));
        continue;
      }
      const auto [low, high] = *scan.intensity;
      const double per_step = (high - low) / 65535;
      keepIf(s, [&](std::size_t i) {
        const double stored = low + per_step * scan.intensities[i];
        return stored >= step.low && stored <= step.high;
      });
    }
  }

  void operator()(const Duplicates&) {
    forGroups([&](const Group& group) { keepOnly(group, withoutDuplicates(group.points, task_)); });
  }

  void operator()(const Outliers& step) {
    forGroups([&](const Group& group) {
      const PointNeighbours neighbours(group.points, task_);
      const auto kept = withoutOutliers(neighbours, group.points.size(), step, task_);
      keepButStrays(group, kept);
    });
  }

  void operator()(const Lonely& step) {
    forGroups([&](const Group& group) {
      const PointNeighbours neighbours(group.points, task_);
      const double radius = step.radius_mm
                                ? *step.radius_mm / mmPerUnit(group)
                                : step.spacings * spacingOf(neighbours, task_, step.share);
      if (!(radius > 0)) {
        notDone(said<MessageId::points_are_one_place>(nameOf(group)));
        return;
      }
      keepButStrays(group,
                    withoutLonely(neighbours, group.points.size(), radius, step.neighbours, task_));
    });
  }

  void operator()(const Sparse& step) {
    forGroups([&](const Group& group) {
      const PointNeighbours neighbours(group.points, task_);
      keepButStrays(group, withoutSparse(neighbours, group.points.size(), step, task_));
    });
    if (!(step.off_surface > 0)) return;
    forGroups([&](const Group& group) {
      const PointNeighbours neighbours(group.points, task_);
      keepOnly(group, withoutOffSurface(neighbours, group.points.size(), step.off_surface, task_));
    });
  }

  void operator()(const Thin& step) {
    forGroups([&](const Group& group) {
      keepOnly(group,
               thinned(group.points, group.centre, step.spacing_mm / mmPerUnit(group), task_));
    });
  }

  void operator()(const Base& step) {
    forGroups([&](const Group& group) { base(step, group); });
  }

  void operator()(const Normals& step) {
    normals_.assign(kept_.size(), {});
    std::size_t without = 0;
    forGroups([&](const Group& group) {
      const PointNeighbours neighbours(group.points, task_);
      const auto normals =
          normalsOf(neighbours, group.points.size(), step.neighbours, viewpointOf(group), task_);
      for (std::size_t i = 0; i < normals.size(); ++i) {
        normals_[group.numbers[i]] = normals[i];
        if (normals[i] == Point3f{}) ++without;
      }
    });
    if (without > 0) addNote(said<MessageId::points_without_normal>(without));
  }

  void operator()(const Align& step);

 private:
  const PrepareScan& scanOf(const Group& group) const { return job_.scans[group.first_scan]; }
  double mmPerUnit(const Group& group) const { return scanOf(group).mm_per_unit; }
  Message nameOf(const Group& group) const {
    if (group.end_scan - group.first_scan != 1) return said<MessageId::joined_scans>();
    return said<MessageId::quoted>(scanOf(group).name);
  }

  void addNote(const Message& note) {
    result_->notes.push_back(note);
    answer_.warnings.push_back(note);
  }
  void notDone(const Message& why) {
    addNote(why);
    result_->done = false;
  }

  /// Clears the bits of those points of a scan that are not to be kept.
  template <class Keep>
  void keepIf(std::size_t scan, const Keep& keep) {
    for (std::uint32_t i = firsts_[scan]; i < firsts_[scan + 1]; ++i) {
      if ((i - firsts_[scan]) % kCheckEvery == 0) task_.check();
      if (kept_[i] && !keep(i - firsts_[scan])) kept_.clear(i);
    }
  }

  template <class Crop>
  void keepPlaces(const Crop& step) {
    for (std::size_t s = 0; s < job_.scans.size(); ++s) {
      keepIf(s, [&](std::size_t i) { return keeps(step, placeOf(s, i)); });
    }
  }

  FilePoint placeOf(std::size_t scan, std::size_t point) const {
    const PrepareScan& from = job_.scans[scan];
    const Point3f& p = from.points[point];
    const FilePoint stored{from.origin.x + static_cast<double>(p[0]),
                           from.origin.y + static_cast<double>(p[1]),
                           from.origin.z + static_cast<double>(p[2])};
    return answer_.poses[scan] == Pose{} ? stored : answer_.poses[scan](stored);
  }

  /// What is left of some scans. A scan where it is stored gives its own floats; others are
  /// centred first, in double, because far from the middle a float has no room for differences.
  Group gathered(std::size_t first_scan, std::size_t end_scan) const {
    Group group{
        .first_scan = first_scan, .end_scan = end_scan, .centre = {}, .points = {}, .numbers = {}};
    const bool as_stored = end_scan - first_scan == 1 && answer_.poses[first_scan] == Pose{};
    group.centre = as_stored ? job_.scans[first_scan].origin : middleOf(first_scan, end_scan);
    for (std::size_t s = first_scan; s < end_scan; ++s) {
      for (std::uint32_t i = firsts_[s]; i < firsts_[s + 1]; ++i) {
        if ((i - firsts_[s]) % kCheckEvery == 0) task_.check();
        if (!kept_[i]) continue;
        group.numbers.push_back(i);
        if (as_stored) {
          group.points.push_back(job_.scans[s].points[i - firsts_[s]]);
        } else {
          const FilePoint p = placeOf(s, i - firsts_[s]) - group.centre;
          group.points.push_back(
              {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        }
      }
    }
    return group;
  }

  FilePoint middleOf(std::size_t first_scan, std::size_t end_scan) const {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    FilePoint low{kInfinite, kInfinite, kInfinite};
    FilePoint high{-kInfinite, -kInfinite, -kInfinite};
    for (std::size_t s = first_scan; s < end_scan; ++s) {
      for (std::uint32_t i = firsts_[s]; i < firsts_[s + 1]; ++i) {
        if (!kept_[i]) continue;
        const FilePoint p = placeOf(s, i - firsts_[s]);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
    return low.x > high.x ? FilePoint{} : 0.5 * (low + high);
  }

  template <class Do>
  void forGroups(const Do& work) {
    const std::size_t scans = job_.scans.size();
    const std::size_t at_once = joined_ ? scans : 1;
    for (std::size_t s = 0; s < scans; s += at_once) {
      const Group group = gathered(s, s + at_once);
      if (!group.points.empty()) work(group);
    }
  }

  /// @param stays  numbers within the group, rising
  void keepOnly(const Group& group, const std::vector<std::uint32_t>& stays) {
    auto next = stays.begin();
    for (std::uint32_t i = 0; i < group.numbers.size(); ++i) {
      if (next != stays.end() && *next == i) {
        ++next;
      } else {
        kept_.clear(group.numbers[i]);
      }
    }
  }

  void keepButStrays(const Group& group, const std::vector<std::uint32_t>& stays) {
    const double share =
        1 - static_cast<double>(stays.size()) / static_cast<double>(group.points.size());
    if (share > kManyStrays) {
      addNote(said<MessageId::more_than_strays>(percent(share), nameOf(group)));
    }
    keepOnly(group, stays);
  }

  void base(const Base& step, const Group& group) {
    double distance = step.distance_mm ? *step.distance_mm / mmPerUnit(group) : 0;
    if (!step.distance_mm) {
      distance = kSpacingsOfBase * spacingOf(PointNeighbours(group.points, task_), task_);
    }
    const auto plane = basePlane(group.points, distance, step.seed, task_);
    if (!plane) {
      notDone(said<MessageId::no_plane_found>(nameOf(group)));
      return;
    }
    const double share =
        static_cast<double>(plane->on_it.size()) / static_cast<double>(group.points.size());
    addNote(share < kLittlePlane ? said<MessageId::small_plane_found>(percent(share), nameOf(group))
                                 : said<MessageId::plane_found>(percent(share), nameOf(group)));
    if (step.lay) {
      const Pose laid = layingFlat(*plane, group.centre);
      for (std::size_t s = group.first_scan; s < group.end_scan; ++s) move(s, laid);
    } else {
      for (const std::uint32_t i : plane->on_it) kept_.clear(group.numbers[i]);
    }
  }

  void move(std::size_t scan, const Pose& pose) {
    answer_.poses[scan] = after(pose, answer_.poses[scan]);
    if (normals_.empty()) return;
    const auto& m = pose.m;
    for (std::uint32_t i = firsts_[scan]; i < firsts_[scan + 1]; ++i) {
      const Point3f n = normals_[i];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double turned = 0;
        for (std::size_t k = 0; k < 3; ++k) turned += m[4 * axis + k] * static_cast<double>(n[k]);
        normals_[i][axis] = static_cast<float>(turned);
      }
    }
  }

  /// Relative to the group's centre, where the scan stands now.
  std::optional<Point3f> viewpointOf(const Group& group) const {
    const auto& stored = scanOf(group).viewpoint;
    if (!stored || group.end_scan - group.first_scan != 1) return std::nullopt;
    const FilePoint p = answer_.poses[group.first_scan](*stored) - group.centre;
    return Point3f{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }

  void takeNormals() {
    for (std::uint32_t i = 0; i < normals_.size(); ++i) {
      if (kept_[i]) answer_.normals.push_back(normals_[i]);
    }
  }

  const PrepareJob& job_;
  const AlignFunction& align_;
  const Task& task_;
  PointBits kept_;
  std::vector<std::uint32_t> firsts_;  ///< Per scan its first point; and the end.
  bool joined_ = false;
  std::vector<Point3f> normals_;  ///< Of all points; empty: none are known.
  StepResult* result_ = nullptr;
  PrepareAnswer answer_;
};

void Executor::operator()(const Align& step) {
  const std::size_t scans = job_.scans.size();
  AlignAnswer found;
  if (!step.poses.empty()) {
    for (const Pose& pose : step.poses) {
      AlignVerdict& verdict = found.scans.emplace_back();
      verdict.pose = verdict.start = pose;
      verdict.words = {said<MessageId::pose_found_before>()};
    }
  } else if (step.method == AlignMethod::stored) {
    found.scans.resize(scans);
    for (AlignVerdict& verdict : found.scans) verdict.words = {said<MessageId::pose_as_stored>()};
  } else if (!align_) {
    notDone(said<MessageId::aligns_no_scans>());
    found.scans.resize(scans);
  } else {
    std::vector<Group> groups;
    std::vector<AlignScan> parts;
    for (std::size_t s = 0; s < scans; ++s) groups.push_back(gathered(s, s + 1));
    for (std::size_t s = 0; s < scans; ++s) {
      const PrepareScan& scan = job_.scans[s];
      std::optional<FilePoint> viewpoint = scan.viewpoint;
      if (viewpoint) viewpoint = answer_.poses[s](*viewpoint);
      parts.push_back({.name = scan.name,
                       .origin = groups[s].centre,
                       .points = groups[s].points,
                       .viewpoint = viewpoint,
                       .mm_per_unit = scan.mm_per_unit});
    }
    found = align_(step, parts, task_);
  }
  if (found.scans.size() != scans) {
    throw failure<MessageId::recipe_has_other_poses>(found.scans.size(), scans);
  }
  for (std::size_t s = 0; s < scans; ++s) {
    const AlignVerdict& verdict = found.scans[s];
    if (verdict.holds) {
      move(s, verdict.pose);
      continue;
    }
    notDone(said<MessageId::scan_left_out>(job_.scans[s].name,
                                           WordsArgument::sentences(verdict.words)));
    for (std::uint32_t i = firsts_[s]; i < firsts_[s + 1]; ++i) kept_.clear(i);
  }
  answer_.align = std::move(found);
  joined_ = true;
}

}  // namespace

PrepareAnswer execute(const PrepareJob& job, const AlignFunction& align, const Task& task) {
  return Executor(job, align, task).run();
}

}  // namespace relievo
