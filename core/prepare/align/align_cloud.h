// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/neighbours/point_neighbours.h"
#include "core/prepare/align/align.h"

namespace relievo::align {

/// How fine scans of one object are looked at while they are laid on each other; file units, the
/// same for all of them. docs/adr/0093 says where the numbers come from.
struct Scale {
  double diagonal = 0;  ///< Of the largest scan's box.
  double spacing = 0;   ///< Of the coarsest scan: median distance of nearest neighbours.
  double fine = 0;      ///< Side of the cells that keep one point each; the measure of closeness.
  double mid = 0;
  double coarse = 0;
};

/// @throw ArgumentError  a scan of fewer than kFewestPoints different points; names it
Scale scaleOf(std::span<const AlignScan> scans, const Task& task);
inline constexpr std::size_t kFewestPoints = 100;

/// Thinned points with their normals, and who is near. All of them have a normal; in the order of
/// `neighbours`, so that a place's number is its point's.
struct OrientedSet {
  double cell = 0;
  std::vector<Point3f> points, normals;  ///< From the scan's middle.
  std::unique_ptr<PointNeighbours> neighbours;

  /// Of each query the point nearest to it, or kNobody where all are farther.
  static constexpr std::uint32_t kNobody = 0xFFFFFFFF;
  std::vector<std::uint32_t> nearest(std::span<const Point3f> queries, double farthest,
                                     const Task& task) const;
};

/// Of equal points the first counts.
OrientedSet setOf(std::span<const Point3f> points, std::span<const Point3f> normals, double cell,
                  const Task& task);

/// A scan at the three sizes of a Scale. Coordinates from the middle of its box, so that float
/// resolves them wherever the scan stands.
struct Cloud {
  FilePoint middle;
  OrientedSet fine, mid, coarse;
  std::vector<Point3f> surface;  ///< What they were thinned from: half a spacing apart.
  /// Neither a viewpoint nor the scan's own shape says on which side of it the air is: all normals
  /// may have to be turned over together.
  bool side_guessed = false;
};

Cloud cloudOf(const AlignScan& scan, const Scale& scale, const Task& task);

void turnOver(Cloud& cloud);

/// The scan at 1.5 spacings, nearly all points of the coarsest one, with normals that look where
/// those of `fine` do: for shapes that hold so weakly that every point counts.
OrientedSet finestOf(const Cloud& cloud, const Scale& scale, const Task& task);

/// Of the points of every cell (a cube of side `cell`) the number of the one nearest its middle,
/// rising.
std::vector<std::uint32_t> thinned(std::span<const Point3f> points, double cell);

/// Normals of `places` from the points of `surface` within `radius`, by PCL; not finite where fewer
/// than three are. Signs are any.
std::vector<Point3f> normalsOf(std::span<const Point3f> places, std::span<const Point3f> surface,
                               double radius);

}  // namespace relievo::align
