// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/scan_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/failure.h"
#include "core/base/large_pages.h"
#include "core/io/file_check.h"
#include "core/io/formats/polygon.h"
#include "core/io/point_values.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kMostParts = 256;  ///< One byte a point.
constexpr const char* kLaterParts = "the scans from here on";
constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

// Of a cloud between its file and its map, in both processes and on the way between them: measured
// 57 for a plane of 3 million points and 87 for a closed cloud of 1.5 million, programs included.
constexpr double kBytesPerPoint = 100;
constexpr double kGigabyte = 1e9;

NumberArgument gigabytes(double bytes) {
  return {.value = bytes / kGigabyte, .digits = 1, .unit = MessageUnit::gigabyte};
}

double medianOf(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// 0 where the coordinates are about as large as they are spread, so that floats of the file stay
/// as they are; else their median. Medians, because a few outliers cannot move them.
double originOf(std::vector<double>& coordinates) {
  const double middle = medianOf(coordinates);
  for (double& c : coordinates) c = std::abs(c - middle);
  // Evenly spread coordinates from 0 to L have the median L/2 and the deviation L/4.
  return std::abs(middle) <= 3 * medianOf(coordinates) ? 0 : middle;
}

FilePoint pointOf(const std::array<float, 3>& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Does a box that ended below zero come to end at one? Then the sign of the first of them counts.
bool risesToZero(const FilePoint& box_end, const FilePoint& end) {
  return (box_end.x < 0 && end.x == 0) || (box_end.y < 0 && end.y == 0) ||
         (box_end.z < 0 && end.z == 0);
}

}  // namespace

ScanBuilder::ScanBuilder(const std::filesystem::path& file, const ImportOptions& options)
    : ScanBuilder(file, options.max_points) {
  every_ = std::max<std::uint64_t>(options.scan.every, 1);
  // Stored points have numbers of 32 bits.
  max_points_ =
      std::min<std::uint64_t>(kNoPoint, max_points_ * std::min<std::uint64_t>(every_, kNoPoint));
  free_bytes_ = options.free_bytes;
}

void ScanBuilder::expectPoints(std::uint64_t count) {
  const std::uint64_t room = keptOf(std::min(count, max_points_));
  if (sink_ == nullptr) return reserveLarge(scan_.points, static_cast<std::size_t>(room));
  sink_->expect(room);
  scan_.points.reserve(2 * kSample);  // What may come between two calls of passOn.
}

void ScanBuilder::leave() {
  sink_->take(scan_.points);
  left_ += scan_.points.size();
  scan_.points.clear();
}

/// @return  false, and nothing is changed, where points must be looked at one by one
bool ScanBuilder::addBlock(PointBlock& block, std::size_t count) {
  ScanInfo& info = scan_.info;
  if (every_ != 1 || !origin_chosen_ || info.points + count > max_points_) return false;
  const BlockBox found = boxOf(block, count);
  if (!found.is_usable) return false;
  const FilePoint low = pointOf(found.low), high = pointOf(found.high);
  if (risesToZero(box_.max, high) || risesToZero(-1 * box_.min, -1 * low)) return false;
  extendBox(low.x, low.y, low.z);
  extendBox(high.x, high.y, high.z);
  const FilePoint& o = scan_.origin;
  if (o.x != 0 || o.y != 0 || o.z != 0) moveTo(o, block, count);
  scan_.points.insert(scan_.points.end(), block.begin(),
                      block.begin() + static_cast<std::ptrdiff_t>(count));
  info.points += count;
  return true;
}

void ScanBuilder::addPoints(const char* xyz, std::uint64_t count) {
  PointBlock block;  // Without initial values: made only to be overwritten.
  for (std::uint64_t done = 0; done < count;) {
    const auto now = static_cast<std::size_t>(std::min<std::uint64_t>(kPointBlock, count - done));
    const char* const from = xyz + done * sizeof(block[0]);
    std::memcpy(block.data(), from, now * sizeof(block[0]));
    done += now;
    if (addBlock(block, now)) continue;
    for (std::size_t i = 0; i < now; ++i) {
      const FilePoint p = pointOf(block[i]);
      addPoint(p.x, p.y, p.z);
    }
  }
}

void ScanBuilder::requireFewer(std::uint64_t count) const {
  if (count <= max_points_) return;
  throw failure<MessageId::file_too_many_points>(shownName(scan_.info.file),
                                                 CountArgument::grouped(max_points_));
}

void ScanBuilder::requireRoom(std::uint64_t count, bool is_mesh) const {
  requireFewer(count);
  requireMemory(count, is_mesh);
}

void ScanBuilder::requireMemory(std::uint64_t count, bool is_mesh) const {
  const auto needed = [this, count](std::uint64_t every) {
    return kBytesPerPoint * static_cast<double>((count + every - 1) / every);
  };
  if (!free_bytes_ || needed(every_) <= static_cast<double>(*free_bytes_)) return;
  const auto free = static_cast<double>(*free_bytes_);
  const std::string name = shownName(scan_.info.file);
  const CountArgument points = CountArgument::grouped(count);
  if (is_mesh) {
    throw failure<MessageId::mesh_needs_memory>(name, points, gigabytes(needed(every_)),
                                                gigabytes(free));
  }
  // Two thirds of what is free leave room for the map and its pictures.
  const double usable = std::max(2.0 / 3 * free, kBytesPerPoint);
  const auto every = static_cast<std::uint64_t>(std::ceil(needed(1) / usable));
  throw failure<MessageId::points_need_memory>(name, points, gigabytes(needed(every_)),
                                               gigabytes(free), CountArgument(every),
                                               gigabytes(needed(every)));
}

bool ScanBuilder::thinOut() {
  requireFewer(scan_.info.points + 1);
  ++scan_.info.points;
  return false;
}

void ScanBuilder::addSpecialPoint(const std::array<double, 3>& p, bool usable) {
  ScanInfo& info = scan_.info;
  requireFewer(info.points + 1);
  ++info.points;
  if (!usable) {
    skipped_.push_back(static_cast<std::uint32_t>(info.points - 1));
    const bool finite = std::all_of(p.begin(), p.end(), [](double v) { return std::isfinite(v); });
    if (finite) ++too_far_;
    return;
  }
  extendBox(p[0], p[1], p[2]);
  sample_.push_back(p);
  if (sample_.size() >= kSample) chooseOrigin();
}

void ScanBuilder::chooseOrigin() {
  origin_chosen_ = true;
  if (sample_.empty()) return;
  std::array<double, 3> origin{};
  std::vector<double> axis(sample_.size());
  for (std::size_t i = 0; i < 3; ++i) {
    std::transform(sample_.begin(), sample_.end(), axis.begin(),
                   [i](const std::array<double, 3>& p) { return p[i]; });
    origin[i] = originOf(axis);
  }
  scan_.origin = {origin[0], origin[1], origin[2]};
  for (const std::array<double, 3>& p : sample_) store(p);
  sample_ = {};
}

void ScanBuilder::addFace(std::span<const std::int64_t> corners) {
  if (every_ != 1) throw failure<MessageId::faces_are_not_thinned>(shownName(scan_.info.file));
  ++scan_.info.faces;
  corner_counts_.push_back(static_cast<std::uint32_t>(corners.size()));
  for (const std::int64_t corner : corners) {
    const bool possible = corner >= 0 && corner < static_cast<std::int64_t>(kNoPoint);
    corners_.push_back(possible ? static_cast<std::uint32_t>(corner) : kNoPoint);
  }
}

void ScanBuilder::addTexturedFace(std::span<const std::int64_t> corners,
                                  std::span<const std::array<float, 2>> places,
                                  std::uint16_t texture) {
  corner_places_.resize(corners_.size());
  face_textures_.resize(corner_counts_.size(), kNoTexture);
  addFace(corners);
  corner_places_.insert(corner_places_.end(), places.begin(), places.end());
  face_textures_.push_back(texture);
}

std::uint16_t ScanBuilder::addTexture(Texture texture) {
  scan_.textures.push_back(std::move(texture));
  return static_cast<std::uint16_t>(scan_.textures.size() - 1);
}

void ScanBuilder::expectColours(std::uint64_t count, bool bytes) {
  const auto room = static_cast<std::size_t>(keptOf(std::min(count, max_points_)));
  if (bytes) {
    reserveLarge(scan_.colours, room);
  } else {
    reserveLarge(wide_colours_, room);
  }
}

void ScanBuilder::expectIntensities(std::uint64_t count, bool words) {
  const auto room = static_cast<std::size_t>(keptOf(std::min(count, max_points_)));
  if (words) {
    reserveLarge(scan_.intensities, room);
  } else {
    reserveLarge(wide_intensities_, room);
  }
}

void ScanBuilder::expectClasses(std::uint64_t count) {
  reserveLarge(scan_.classes, static_cast<std::size_t>(keptOf(std::min(count, max_points_))));
}

void ScanBuilder::expectReturns(std::uint64_t count) {
  reserveLarge(scan_.returns, static_cast<std::size_t>(keptOf(std::min(count, max_points_))));
}

void ScanBuilder::beginPart(ScanPart part) {
  if (part_starts_.size() >= kMostParts) {
    if (scan_.info.parts.back().name != kLaterParts) {
      scan_.info.parts.back() = {
          .name = kLaterParts, .points = scan_.info.parts.back().points, .viewpoint = std::nullopt};
    }
    return;
  }
  part_starts_.push_back(keptCount());
  part.points = scan_.info.points;  // Made a difference in settleValues.
  scan_.info.parts.push_back(std::move(part));
}

void ScanBuilder::settleValues() {
  ScanInfo& info = scan_.info;
  if (!wide_colours_.empty()) {
    wide_colours_.resize(scan_.points.size(), kNoColour);
    ColourFact fact = info.colour.value_or(ColourFact{});
    scan_.colours = settledColours(wide_colours_, fact, info.warnings);
    wide_colours_ = {};
    info.colour = fact;
  } else if (!scan_.colours.empty()) {
    scan_.colours.resize(scan_.points.size());
    settleByteColours(scan_.colours, info.warnings);
  }
  if (!scan_.colours.empty()) {
    info.colour->points = static_cast<std::uint64_t>(
        std::count_if(scan_.colours.begin(), scan_.colours.end(),
                      [](const Rgba& colour) { return colour[3] != 0; }));
  } else if (scan_.textures.empty()) {
    info.colour.reset();
  }
  if (!wide_intensities_.empty()) {
    wide_intensities_.resize(scan_.points.size(), std::numeric_limits<float>::quiet_NaN());
    IntensityRange range;
    scan_.intensities = settledIntensities(wide_intensities_, range);
    wide_intensities_ = {};
    info.intensity = range;
  }
  if (scan_.intensities.empty()) info.intensity.reset();
  for (std::size_t i = 0; i < info.parts.size(); ++i) {
    const std::uint64_t end = i + 1 < info.parts.size() ? info.parts[i + 1].points : info.points;
    info.parts[i].points = end - info.parts[i].points;
  }
  if (info.parts.size() < 2) return;
  reserveLarge(scan_.parts, scan_.points.size());
  for (std::size_t i = 0; i < part_starts_.size(); ++i) {
    const std::size_t end = i + 1 < part_starts_.size() ? part_starts_[i + 1] : scan_.points.size();
    scan_.parts.resize(end, static_cast<std::uint8_t>(i));
  }
}

bool ScanBuilder::triangulate(std::size_t start, std::span<const std::uint32_t> corners,
                              std::uint16_t texture) {
  if (corners.size() < 3) return false;
  std::vector<std::uint32_t> kept;
  kept.reserve(corners.size());
  for (const std::uint32_t stored : corners) {
    if (stored >= scan_.info.points) return false;
    const auto before = std::lower_bound(skipped_.begin(), skipped_.end(), stored);
    if (before != skipped_.end() && *before == stored) return false;
    kept.push_back(stored - static_cast<std::uint32_t>(before - skipped_.begin()));
  }
  if (kept.size() == 3) {
    cut_.assign(1, {0, 1, 2});
  } else {
    std::vector<std::array<float, 3>> outline;
    outline.reserve(kept.size());
    for (const std::uint32_t corner : kept) outline.push_back(scan_.points[corner]);
    if (!cutPolygon(outline, cut_)) ++fanned_;
  }
  for (const auto& [a, b, c] : cut_) {
    // A triangle with a corner twice has no area and hides nothing.
    if (kept[a] == kept[b] || kept[a] == kept[c] || kept[b] == kept[c]) continue;
    scan_.triangles.push_back({kept[a], kept[b], kept[c]});
    if (scan_.textures.empty()) continue;
    const auto place = [&](std::uint32_t corner) {
      return start + corner < corner_places_.size() ? corner_places_[start + corner]
                                                    : std::array<float, 2>{};
    };
    scan_.texture_corners.push_back({place(a), place(b), place(c)});
    scan_.texture_of.push_back(texture);
  }
  return true;
}

void ScanBuilder::makeTriangles() {
  std::size_t start = 0;
  for (std::size_t face = 0; face < corner_counts_.size(); ++face) {
    const std::uint32_t count = corner_counts_[face];
    const std::uint16_t texture = face < face_textures_.size() ? face_textures_[face] : kNoTexture;
    if (!triangulate(start, std::span(corners_).subspan(start, count), texture)) {
      ++scan_.info.dropped_faces;
    }
    start += count;
  }
  if (fanned_ > 0) {
    scan_.info.warnings.push_back(
        said<MessageId::faces_cut_without_dents>(CountArgument::grouped(fanned_)));
  }
}

Scan ScanBuilder::finish() {
  if (!origin_chosen_) chooseOrigin();
  settleValues();
  makeTriangles();
  ScanInfo& info = scan_.info;
  info.finite_points = keptCount();
  if (sink_ != nullptr) leave();
  if (info.finite_points > 0) info.bounds = box_;
  if (info.dropped_faces > 0) {
    info.warnings.push_back(said<MessageId::faces_left_out>(
        CountArgument::grouped(info.dropped_faces), CountArgument::grouped(info.faces)));
  }
  if (every_ != 1) {
    info.warnings.push_back(said<MessageId::one_point_in_several>(
        CountArgument::grouped(every_), CountArgument::grouped(keptOf(info.points)),
        CountArgument::grouped(info.points)));
  }
  if (too_far_ > 0) {
    info.warnings.push_back(said<MessageId::points_too_far>(CountArgument::grouped(too_far_)));
  }
  if (info.finite_points == 0) {
    throw failure<MessageId::no_finite_point>(shownName(info.file),
                                              CountArgument::grouped(info.points));
  }
  if (info.bounds->min == info.bounds->max) {
    info.warnings.push_back(info.finite_points == 1 ? said<MessageId::scan_of_one_point>()
                                                    : said<MessageId::points_all_the_same>());
  }
  return std::move(scan_);
}

}  // namespace relievo
