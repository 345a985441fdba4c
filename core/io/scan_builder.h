// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/cloud/scan.h"
#include "core/io/import.h"
#include "core/io/point_block.h"
#include "core/io/point_sink.h"

namespace relievo {

/// Coordinates beyond it are no measurements; differences of two such numbers are finite in float.
inline constexpr double kFarthestCoordinate = 1e38;

/// Collects what a reader finds, in double, and makes a Scan of it: counts, bounds, an origin near
/// the points (so that floats keep the file's resolution), triangles with valid indices.
class ScanBuilder {
 public:
  /// @throw FileError  from addPoint, when more than max_points come
  ScanBuilder(const std::filesystem::path& file, std::uint64_t max_points)
      : max_points_(max_points) {
    scan_.info.file = file;
  }
  /// The same with the limits of `options`, and one point in so many as they say.
  ScanBuilder(const std::filesystem::path& file, const ImportOptions& options);

  ScanInfo& info() noexcept { return scan_.info; }
  std::uint64_t pointCount() const noexcept { return scan_.info.points; }
  std::uint64_t keptCount() const noexcept { return left_ + scan_.points.size() + sample_.size(); }
  std::uint64_t faceCount() const noexcept { return scan_.info.faces; }
  void expectPoints(std::uint64_t count);  ///< A hint; never trusted beyond max_points.
  /// Points leave from here on as passOn says; with faces or parts they may not. Before the first
  /// of them and expectPoints. @param sink  null: they stay
  void leaveTo(PointSink* sink) { sink_ = sink; }
  /// To be called now and then between points: those that are many enough leave.
  void passOn() {
    if (sink_ != nullptr && scan_.points.size() >= kPassedOn) leave();
  }
  /// Where a file is known to hold so many points, before the first of them is read.
  /// @throw FileError  more than max_points, or (E102) than the memory holds
  void requireRoom(std::uint64_t count, bool is_mesh = false) const;
  /// Of these alone the latter: `count` may be an estimate. @throw FileError  E102
  void requireMemory(std::uint64_t count, bool is_mesh = false) const;

  /// The next stored point; those that are not finite are counted only.
  /// @return  whether it is kept; only then what the file says of it is added by the calls below.
  ///          Kept points without such a call have no colour, the lowest intensity
  bool addPoint(double x, double y, double z) {
    // NaN and infinity fail the comparisons. Binary files spend their time here; a call for every
    // point cost 2 to 7 ns more of 11 to 18 (reader_benchmark).
    if (every_ != 1 && scan_.info.points % every_ != 0) return thinOut();
    const bool usable = std::abs(x) <= kFarthestCoordinate && std::abs(y) <= kFarthestCoordinate &&
                        std::abs(z) <= kFarthestCoordinate;
    if (!usable || !origin_chosen_ || scan_.info.points >= max_points_) {
      addSpecialPoint({x, y, z}, usable);
      return usable;
    }
    ++scan_.info.points;
    extendBox(x, y, z);
    store({x, y, z});
    return true;
  }

  /// The next stored points, in this machine's order: as addPoint of each of them.
  /// @param xyz  three floats a point, one after the other, at any address
  void addPoints(const char* xyz, std::uint64_t count);

  /// The next stored point, which the file says is not to be used.
  void addLeftOutPoint() { addSpecialPoint({kNaN, kNaN, kNaN}, false); }

  // Hints before many of the calls below.
  void expectColours(std::uint64_t count, bool bytes);
  void expectIntensities(std::uint64_t count, bool words);
  void expectClasses(std::uint64_t count);
  void expectReturns(std::uint64_t count);

  void addColour(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    if (scan_.colours.size() + 1 < keptCount()) scan_.colours.resize(keptCount() - 1);
    scan_.colours.push_back({red, green, blue, 255});
  }
  void addNoColour() { scan_.colours.resize(keptCount()); }
  /// Numbers whose range is known only when all have come (point_values.h); never beside addColour.
  void addWideColour(const std::array<float, 3>& colour) {
    if (wide_colours_.size() + 1 < keptCount()) wide_colours_.resize(keptCount() - 1, kNoColour);
    wide_colours_.push_back(colour);
  }
  void addIntensity(std::uint16_t intensity) { scan_.intensities.push_back(intensity); }
  void addWideIntensity(float intensity) {
    if (wide_intensities_.size() + 1 < keptCount()) {
      wide_intensities_.resize(keptCount() - 1, std::numeric_limits<float>::quiet_NaN());
    }
    wide_intensities_.push_back(intensity);
  }
  void addClass(std::uint8_t number) { scan_.classes.push_back(number); }
  void addReturn(std::uint8_t packed) { scan_.returns.push_back(packed); }
  /// Points from here on belong to this new part; from the 256th on all to that one. A file of one
  /// part, without a viewpoint, needs none.
  void beginPart(ScanPart part);

  // These turned out to be none.
  void dropIntensities() {
    scan_.intensities = {};
    wide_intensities_ = {};
  }
  void dropClasses() { scan_.classes = {}; }
  void dropReturns() { scan_.returns = {}; }
  void dropColours() {
    scan_.colours = {};
    wide_colours_ = {};
    scan_.info.colour.reset();
  }

  /// The next stored polygon, corners counted from 0 in stored order; may come before its points.
  void addFace(std::span<const std::int64_t> corners);

  /// The same with a picture on it; `places` are of the corners. @param texture  see addTexture
  void addTexturedFace(std::span<const std::int64_t> corners,
                       std::span<const std::array<float, 2>> places, std::uint16_t texture);
  /// @return  its number for addTexturedFace
  std::uint16_t addTexture(Texture texture);

  Scan finish();

 private:
  void requireFewer(std::uint64_t count) const;
  bool thinOut();
  std::uint64_t keptOf(std::uint64_t count) const { return (count + every_ - 1) / every_; }
  void addSpecialPoint(const std::array<double, 3>& p, bool usable);
  void chooseOrigin();

  void extendBox(double x, double y, double z) noexcept {
    box_.min = {std::min(box_.min.x, x), std::min(box_.min.y, y), std::min(box_.min.z, z)};
    box_.max = {std::max(box_.max.x, x), std::max(box_.max.y, y), std::max(box_.max.z, z)};
  }
  void store(const std::array<double, 3>& p) {
    scan_.points.push_back({static_cast<float>(p[0] - scan_.origin.x),
                            static_cast<float>(p[1] - scan_.origin.y),
                            static_cast<float>(p[2] - scan_.origin.z)});
  }
  bool addBlock(PointBlock& block, std::size_t count);
  void leave();
  void settleValues();
  void makeTriangles();
  bool triangulate(std::size_t start, std::span<const std::uint32_t> corners,
                   std::uint16_t texture);

  static constexpr std::size_t kSample = 65536;
  static constexpr std::size_t kPassedOn = 32768;  ///< Points: 400 kB, in the nearer memory.
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr std::array<float, 3> kNoColour{-1, -1, -1};

  Scan scan_;
  std::uint64_t max_points_;  ///< Stored.
  std::uint64_t every_ = 1;   ///< Of so many one is kept.
  std::optional<std::uint64_t> free_bytes_;
  bool origin_chosen_ = false;
  FileBounds box_{{kInfinite, kInfinite, kInfinite}, {-kInfinite, -kInfinite, -kInfinite}};
  std::vector<std::array<double, 3>> sample_;  ///< Points that came before the origin was chosen.
  PointSink* sink_ = nullptr;                  ///< Who takes the points; null: nobody.
  std::uint64_t left_ = 0;                     ///< Points that it has.
  std::vector<std::uint32_t> skipped_;         ///< Stored indices of points left out, ascending.
  std::uint64_t too_far_ = 0;                  ///< Finite in the file, but not in float.
  std::vector<std::uint32_t> corners_;         ///< Of all faces, one after the other.
  std::vector<std::uint32_t> corner_counts_;
  // Of corners_ and of faces, from the first face with a picture on.
  std::vector<std::array<float, 2>> corner_places_;
  std::vector<std::uint16_t> face_textures_;
  std::vector<std::array<float, 3>> wide_colours_;
  std::vector<float> wide_intensities_;
  std::vector<std::uint64_t> part_starts_;         ///< Kept points before each part.
  std::vector<std::array<std::uint32_t, 3>> cut_;  ///< Of one polygon.
  std::uint64_t fanned_ = 0;                       ///< Concave polygons too long to be cut well.
};

}  // namespace relievo
