// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace relievo {

// Strays: few points so far from all others that they stretch the box around a scan, and with it
// the map, to several times the object. Every decision here depends on the set of points only,
// never on their order (docs/adr/0100-strays.md).

using Coordinates = std::array<double, 3>;

struct AxisBox {
  Coordinates min{}, max{};
};
bool contains(const AxisBox& box, const Coordinates& p) noexcept;
double longestSide(const AxisBox& box) noexcept;
/// Of the side that is shortened most: how much, 0 to 1.
double shareTaken(const AxisBox& from, const AxisBox& kept) noexcept;

/// Cubes laid over the middle of a cloud, as small as its points carry.
struct StrayGrid {
  Coordinates centre{};
  double cell = 0;  ///< 0: the cloud has no middle to speak of; it has no strays either.
};

/// Points in memory, along given axes.
struct PointsView {
  std::span<const std::array<float, 3>> points;
  /// Rows: the axes; null: the points' own.
  const std::array<double, 9>* axes = nullptr;
  /// As long as `points`; 0: does not count. Null: all count.
  const std::vector<std::uint8_t>* counted = nullptr;

  /// Point i along the axes.
  Coordinates at(std::size_t i) const noexcept;
};

/// Boxes around the object. Nothing: nothing of the kind stretches the box.
struct StrayLimits {
  std::optional<AxisBox> strays;  ///< Outside lie points that hang together with a thousandth of
                                  ///< all at most: nobody means them.
  std::optional<AxisBox> groups;  ///< Outside lie also groups of a hundredth at most: strays in a
                                  ///< clump, or a thing that somebody scanned.
};

/// How many points lie in which cube. Counts of parts add up to those of the whole.
class StrayCounts {
 public:
  explicit StrayCounts(const StrayGrid& grid);
  void add(const Coordinates& p);
  void add(const StrayCounts& other);  ///< @pre the same grid
  /// For another process of this program, which adds them to its own of the same grid.
  std::string bytes() const;
  void add(std::string_view bytes);
  std::uint64_t points() const noexcept { return points_; }
  /// The boxes outside of which only strays and groups lie, if their number allows it (`areFew`).
  /// @param all  around every point
  StrayLimits limits(const AxisBox& all) const;

 private:
  using Cube = std::array<double, 3>;  // Whole numbers; those of 1e38 do not fit in integers.
  struct NearCube {
    std::uint32_t index = 0, points = 0;
  };
  struct FarCube {
    Cube cube;
    std::uint64_t points = 0;
  };
  struct Hash {
    std::size_t operator()(const Cube& cube) const noexcept;
  };
  static std::optional<std::size_t> nearIndex(const Cube& cube) noexcept;
  void forgetIfTooWide();
  std::uint64_t leastInSolid() const;
  /// Touching cubes that are not thin.
  struct Group {
    std::uint64_t points = 0;
    AxisBox box;
  };
  std::vector<Group> groups() const;
  std::optional<AxisBox> stretchedBeyond(const AxisBox& main, const AxisBox& all) const;

  static constexpr int kNear = 64;       // Cubes across the part that is an array.
  static constexpr double kMiddle = 32;  // Its half.
  static_assert(2 * kMiddle == kNear);
  static constexpr std::size_t kMostFar = 1'000'000;  // Cubes beyond it: 64 MB, no few strays.
  StrayGrid grid_;
  bool is_too_wide_ = false;  // More than kMostFar.
  std::uint64_t points_ = 0;
  std::vector<std::uint32_t> near_;
  std::unordered_map<Cube, std::uint64_t, Hash> far_;
};

/// The cubes for a cloud, from where its middle 96 % lie along each axis. [worker]
/// @param all  around the points that count
StrayGrid strayGrid(const PointsView& view, const AxisBox& all);

/// All of it for points in memory; two looks at the points at most, one where nothing stretches
/// the box. [worker] @param all  around the points that count
StrayLimits strayLimits(const PointsView& view, const AxisBox& all);

/// Whether so many of all can be called few: at most a hundredth, and at least one.
bool areFew(std::uint64_t strays, std::uint64_t all) noexcept;

inline constexpr std::uint64_t kLeastForStrays = 20;  ///< Fewer points tell nothing of each other.

}  // namespace relievo
