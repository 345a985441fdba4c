// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/task.h"

namespace relievo {

using Point3f = std::array<float, 3>;

/// What is near one place or query, nearest first; equal distances in an order that is the same in
/// every run. Only valid during the call that gives it.
struct NearPlaces {
  std::size_t of = 0;                     ///< Number of the place, or of the query.
  std::span<const std::uint32_t> places;  ///< As many as there are, at most as many as asked for.
  std::span<const float> squared;         ///< Their squared distances, in the points' unit squared.
};

/// Takes one result. Called from several threads at once, each place from one of them; must not
/// throw anything but Cancelled.
using TakeNear = std::function<void(const NearPlaces&)>;

/// Points in 3-D that know who is near: exact, by FLANN's single k-d tree (Muja and Lowe 2014), on
/// all cores. Equal points are folded into one place, or a tree of 200 000 equal points would take
/// minutes; places are numbered along a Morton curve, so that queries one after the other find
/// their part of the tree in the cache (2.3 times as fast as in the file's order). The same results
/// for every number of threads.
class PointNeighbours {
 public:
  /// @param points  finite; not kept. At most 2^32 - 2. Centre them first: far from the origin
  ///                float has no room for differences. [worker]
  /// @throw ArgumentError  a point is not finite; Cancelled
  explicit PointNeighbours(std::span<const Point3f> points, const Task& task = {});
  ~PointNeighbours();
  PointNeighbours(PointNeighbours&&) noexcept;
  PointNeighbours& operator=(PointNeighbours&&) noexcept;
  PointNeighbours(const PointNeighbours&) = delete;
  PointNeighbours& operator=(const PointNeighbours&) = delete;

  std::size_t places() const noexcept { return places_.size(); }
  const Point3f& place(std::size_t place) const noexcept { return places_[place]; }

  /// Numbers of the points at a place, as they were given, rising; one at least.
  std::span<const std::uint32_t> pointsAt(std::size_t place) const noexcept {
    return {points_.data() + starts_[place], starts_[place + 1] - starts_[place]};
  }

  /// The k places nearest to every place; the first is the place itself, at distance 0. [worker]
  /// @param k  >= 1  @param threads  0: as many as there are cores  @throw Cancelled
  void nearest(int k, int threads, const Task& task, const TakeNear& take) const;

  /// The k places nearest to other points. @param queries  finite [worker] @throw Cancelled
  void nearestTo(std::span<const Point3f> queries, int k, int threads, const Task& task,
                 const TakeNear& take) const;

  /// All places no farther than `radius` from every place, itself first; at most `most` of them,
  /// the nearest. [worker] @throw Cancelled
  void within(float radius, std::size_t most, int threads, const Task& task,
              const TakeNear& take) const;

 private:
  struct Tree;

  template <class Search>
  void search(std::span<const Point3f> queries, int threads, const Task& task,
              const Search& search_block) const;

  std::vector<Point3f> places_;
  std::vector<std::uint32_t> starts_;  ///< Per place its first of `points_`, and the end.
  std::vector<std::uint32_t> points_;
  std::unique_ptr<Tree> tree_;  ///< Null if there are no points. Looks into places_.
};

/// Version of the library that does it, "1.9.2".
const char* flannVersion() noexcept;

}  // namespace relievo
