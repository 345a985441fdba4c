// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/assemble.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/failure.h"

namespace relievo {
namespace {

constexpr std::size_t kCheckEvery = 1U << 18U;
constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();
constexpr Rgba kNoColour{0, 0, 0, 0};
constexpr std::uint8_t kNeverClassified = 0;
constexpr std::uint8_t kOnlyReturn = 0x11;  // The first of one.

class Assembly {
 public:
  Assembly(const std::vector<const Scan*>& scans, const std::vector<Pose>& poses,
           const PointBits& kept, const Task& task)
      : scans_(scans), poses_(poses), kept_(kept), task_(task) {
    const auto any = [&](auto list) {
      return std::any_of(scans.begin(), scans.end(),
                         [&](const Scan* scan) { return !((*scan).*list).empty(); });
    };
    has_colours_ = any(&Scan::colours);
    has_intensities_ = any(&Scan::intensities);
    has_classes_ = any(&Scan::classes);
    has_returns_ = any(&Scan::returns);
    has_parts_ = scans.size() > 1 || any(&Scan::parts);
    has_textures_ = any(&Scan::texture_of);
  }

  Scan run() {
    takeInfo();
    chooseOrigin();
    chooseIntensities();
    std::size_t first = 0;
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      takePoints(s, first);
      takeTriangles(*scans_[s]);
      first += scans_[s]->points.size();
    }
    finish();
    return std::move(out_);
  }

 private:
  bool moved(std::size_t scan) const { return !(poses_[scan] == Pose{}); }

  void takeInfo() {
    out_.info = scans_[0]->info;
    out_.info.parts.clear();
    out_.info.warnings.clear();
    for (const Scan* scan : scans_) {
      out_.info.dropped_faces += scan == scans_[0] ? 0 : scan->info.dropped_faces;
      out_.info.warnings.insert(out_.info.warnings.end(), scan->info.warnings.begin(),
                                scan->info.warnings.end());
    }
    if (scans_.size() > 1) out_.info.format = std::to_string(scans_.size()) + " scans";
  }

  /// Near the points, so that floats keep the file's resolution.
  void chooseOrigin() {
    const FilePoint& stored = scans_[0]->origin;
    out_.origin = !moved(0) || stored == FilePoint{} ? stored : poses_[0](stored);
  }

  /// One range that holds those of all scans.
  void chooseIntensities() {
    out_.info.intensity.reset();
    for (const Scan* scan : scans_) {
      if (scan->intensities.empty() || !scan->info.intensity) continue;
      const IntensityRange& range = *scan->info.intensity;
      if (!out_.info.intensity) out_.info.intensity = range;
      out_.info.intensity->low = std::min(out_.info.intensity->low, range.low);
      out_.info.intensity->high = std::max(out_.info.intensity->high, range.high);
    }
    has_intensities_ = has_intensities_ && out_.info.intensity;
  }

  std::uint16_t intensityOf(const Scan& scan, std::size_t i) const {
    if (scan.intensities.empty() || !scan.info.intensity) return 0;
    const IntensityRange& from = *scan.info.intensity;
    const IntensityRange& to = *out_.info.intensity;
    if (from.low == to.low && from.high == to.high) return scan.intensities[i];
    const double value = from.low + (from.high - from.low) * scan.intensities[i] / 65535;
    const double span = to.high - to.low;
    const double share = span > 0 ? (value - to.low) / span : 0;
    return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535));
  }

  std::array<float, 3> floatsOf(std::size_t s, std::size_t i) const {
    const Scan& scan = *scans_[s];
    if (!moved(s) && scan.origin == out_.origin) return scan.points[i];
    const FilePoint p = poses_[s](scan.point(i)) - out_.origin;
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }

  void takePoints(std::size_t s, std::size_t first) {
    const Scan& scan = *scans_[s];
    const std::size_t first_part = out_.info.parts.size();
    if (has_parts_) takeParts(s);
    new_number_.assign(scan.points.size(), kGone);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (i % kCheckEvery == 0) task_.check();
      if (!kept_[first + i]) continue;
      new_number_[i] = static_cast<std::uint32_t>(out_.points.size());
      out_.points.push_back(floatsOf(s, i));
      if (has_colours_) out_.colours.push_back(scan.colours.empty() ? kNoColour : scan.colours[i]);
      if (has_intensities_) out_.intensities.push_back(intensityOf(scan, i));
      if (has_classes_) {
        out_.classes.push_back(scan.classes.empty() ? kNeverClassified : scan.classes[i]);
      }
      if (has_returns_) {
        out_.returns.push_back(scan.returns.empty() ? kOnlyReturn : scan.returns[i]);
      }
      if (has_parts_) {
        const std::size_t part = first_part + (scan.parts.empty() ? 0 : scan.parts[i]);
        out_.parts.push_back(static_cast<std::uint8_t>(part));
        ++out_.info.parts[part].points;
      }
    }
  }

  void takeParts(std::size_t s) {
    const Scan& scan = *scans_[s];
    std::vector<ScanPart> parts = scan.info.parts;
    if (parts.empty() || scan.parts.empty()) {
      parts = {{.name = scan.info.file.filename().string(), .points = 0, .viewpoint = {}}};
      if (scan.info.parts.size() == 1) parts[0].viewpoint = scan.info.parts[0].viewpoint;
    }
    if (out_.info.parts.size() + parts.size() > kMostScans) {
      throw failure<MessageId::files_hold_many_scans>(kMostScans);
    }
    for (ScanPart& part : parts) {
      part.points = 0;
      if (part.viewpoint) part.viewpoint = poses_[s](*part.viewpoint);
      out_.info.parts.push_back(part);
    }
  }

  void takeTriangles(const Scan& scan) {
    const std::size_t first_texture = out_.textures.size();
    if (has_textures_) {
      out_.textures.insert(out_.textures.end(), scan.textures.begin(), scan.textures.end());
    }
    for (std::size_t t = 0; t < scan.triangles.size(); ++t) {
      if (t % kCheckEvery == 0) task_.check();
      auto corners = scan.triangles[t];
      for (std::uint32_t& corner : corners) corner = new_number_[corner];
      if (std::max({corners[0], corners[1], corners[2]}) == kGone) continue;
      out_.triangles.push_back(corners);
      if (!has_textures_) continue;
      const bool textured = !scan.texture_of.empty() && scan.texture_of[t] != kNoTexture;
      out_.texture_corners.push_back(textured ? scan.texture_corners[t] : TextureCorners{});
      out_.texture_of.push_back(
          textured ? static_cast<std::uint16_t>(first_texture + scan.texture_of[t]) : kNoTexture);
    }
  }

  void finish() {
    if (out_.points.empty()) throw failure<MessageId::no_point_left_after_steps>();
    ScanInfo& info = out_.info;
    info.points = info.finite_points = out_.points.size();
    info.faces = out_.triangles.size();
    FileBounds box{out_.point(0), out_.point(0)};
    for (std::size_t i = 0; i < out_.points.size(); ++i) {
      if (i % kCheckEvery == 0) task_.check();
      const FilePoint p = out_.point(i);
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
    info.bounds = box;
  }

  const std::vector<const Scan*>& scans_;
  const std::vector<Pose>& poses_;
  const PointBits& kept_;
  const Task& task_;
  bool has_colours_ = false, has_intensities_ = false, has_classes_ = false, has_returns_ = false,
       has_parts_ = false, has_textures_ = false;
  std::vector<std::uint32_t> new_number_;  ///< Per point of the scan at hand.
  Scan out_;
};

}  // namespace

Scan assembled(const std::vector<const Scan*>& scans, const std::vector<Pose>& poses,
               const PointBits& kept, const Task& task) {
  return Assembly(scans, poses, kept, task).run();
}

}  // namespace relievo
