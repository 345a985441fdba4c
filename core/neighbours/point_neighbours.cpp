// SPDX-License-Identifier: BSD-3-Clause
#include "core/neighbours/point_neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <flann/config.h>
#include <flann/flann.hpp>

#include "core/base/bands.h"
#include "core/base/control_group.h"
#include "core/base/failure.h"

namespace relievo {
namespace {

constexpr int kLeafPoints = 15;
constexpr std::size_t kBlock = 1024;  // Queries between two looks at the stop token.
constexpr std::size_t kQueriesWorthAThread = 4096;

/// Every third bit of the result is one of the lower 21 of `value`.
std::uint64_t spread(std::uint64_t value) {
  value &= 0x1FFFFF;
  value = (value | value << 32U) & 0x1F00000000FFFF;
  value = (value | value << 16U) & 0x1F0000FF0000FF;
  value = (value | value << 8U) & 0x100F00F00F00F00F;
  value = (value | value << 4U) & 0x10C30C30C30C30C3;
  return (value | value << 2U) & 0x1249249249249249;
}

/// Places of a cube around all points on a Morton curve (Morton 1966).
class MortonCurve {
 public:
  explicit MortonCurve(std::span<const Point3f> points) {
    Point3f high = points[0];
    low_ = points[0];
    for (const Point3f& p : points) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(p[axis])) throw failure<MessageId::point_not_finite>();
        low_[axis] = std::min(low_[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
    double side = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      side = std::max(side, static_cast<double>(high[axis]) - static_cast<double>(low_[axis]));
    }
    steps_per_unit_ = side > 0 ? kSteps / side : 0;
  }

  std::uint64_t operator()(const Point3f& p) const {
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step =
          (static_cast<double>(p[axis]) - static_cast<double>(low_[axis])) * steps_per_unit_;
      key |= spread(static_cast<std::uint64_t>(step)) << axis;
    }
    return key;
  }

 private:
  static constexpr double kSteps = (1U << 21U) - 1;
  Point3f low_{};
  double steps_per_unit_ = 0;
};

/// A query takes about a microsecond of processor time, not of memory: every core pays.
int threadsForQueries(std::size_t queries, int wanted) {
  if (wanted > 0) return wanted;
  const auto worth = static_cast<int>(std::min<std::size_t>(queries / kQueriesWorthAThread, 1024));
  return std::clamp(worth, 1, usableCores());
}

struct Sorted {
  std::uint64_t key;
  Point3f point;
  std::uint32_t number;

  /// Equal keys by coordinates, so that equal points stand together; those by their number.
  friend bool operator<(const Sorted& a, const Sorted& b) {
    if (a.key != b.key) return a.key < b.key;
    if (a.point != b.point) return a.point < b.point;
    return a.number < b.number;
  }
};

std::vector<Sorted> sortedByCurve(std::span<const Point3f> points, const Task& task) {
  std::vector<Sorted> sorted(points.size());
  const MortonCurve key(points);
  const int threads = threadsFor(points.size(), 0);
  const auto part = [&](int k) {
    return sorted.begin() +
           static_cast<std::ptrdiff_t>(points.size() * static_cast<std::size_t>(k) /
                                       static_cast<std::size_t>(threads));
  };
  parallelFor(threads, threads, [&](int first, int end) {
    for (auto it = part(first); it != part(end); ++it) {
      const auto i = static_cast<std::size_t>(it - sorted.begin());
      // -0 becomes 0: the two are one place.
      const Point3f p{points[i][0] + 0.0F, points[i][1] + 0.0F, points[i][2] + 0.0F};
      *it = {.key = key(p), .point = p, .number = static_cast<std::uint32_t>(i)};
    }
    task.check();
    std::sort(part(first), part(end));
  });
  for (int k = 1; k < threads; ++k) {
    task.check();
    std::inplace_merge(sorted.begin(), part(k), part(k + 1));
  }
  return sorted;
}

}  // namespace

struct PointNeighbours::Tree {
  using Index = flann::Index<flann::L2_3D<float>>;
  explicit Tree(std::vector<Point3f>& places)
      : index(flann::Matrix<float>(places[0].data(), places.size(), 3),
              flann::KDTreeSingleIndexParams(kLeafPoints)) {
    index.buildIndex();
  }
  Index index;
};

PointNeighbours::PointNeighbours(std::span<const Point3f> points, const Task& task) {
  starts_.push_back(0);
  if (points.empty()) return;
  const std::vector<Sorted> sorted = sortedByCurve(points, task);
  points_.reserve(sorted.size());
  for (const Sorted& s : sorted) {
    if (places_.empty() || s.point != places_.back()) {
      if (!places_.empty()) starts_.push_back(static_cast<std::uint32_t>(points_.size()));
      places_.push_back(s.point);
    }
    points_.push_back(s.number);
  }
  starts_.push_back(static_cast<std::uint32_t>(points_.size()));
  task.check();
  tree_ = std::make_unique<Tree>(places_);
}

PointNeighbours::~PointNeighbours() = default;
PointNeighbours::PointNeighbours(PointNeighbours&&) noexcept = default;
PointNeighbours& PointNeighbours::operator=(PointNeighbours&&) noexcept = default;

/// search_block(first query, queries) for blocks of queries, on threads.
template <class Search>
void PointNeighbours::search(std::span<const Point3f> queries, int threads, const Task& task,
                             const Search& search_block) const {
  if (!tree_ || queries.empty()) return;
  const auto blocks = static_cast<int>((queries.size() + kBlock - 1) / kBlock);
  parallelFor(blocks, threadsForQueries(queries.size(), threads), [&](int first, int end) {
    for (int block = first; block < end; ++block) {
      task.check();
      const std::size_t begin = static_cast<std::size_t>(block) * kBlock;
      search_block(begin, queries.subspan(begin, std::min(kBlock, queries.size() - begin)));
    }
  });
}

void PointNeighbours::nearestTo(std::span<const Point3f> queries, int k, int threads,
                                const Task& task, const TakeNear& take) const {
  if (k < 1) throw failure<MessageId::no_neighbour_asked>();
  const std::size_t found = std::min(static_cast<std::size_t>(k), places_.size());
  flann::SearchParams exact(flann::FLANN_CHECKS_UNLIMITED, 0, true);
  exact.cores = 1;
  search(queries, threads, task, [&](std::size_t first, std::span<const Point3f> block) {
    std::vector<std::size_t> numbers(block.size() * found);
    std::vector<float> squared(block.size() * found);
    std::vector<Point3f> places(block.begin(), block.end());  // FLANN wants no const.
    flann::Matrix<float> wanted(places[0].data(), places.size(), 3);
    flann::Matrix<std::size_t> number_rows(numbers.data(), block.size(), found);
    flann::Matrix<float> squared_rows(squared.data(), block.size(), found);
    tree_->index.knnSearch(wanted, number_rows, squared_rows, found, exact);
    std::vector<std::uint32_t> near(found);
    for (std::size_t i = 0; i < block.size(); ++i) {
      std::transform(number_rows[i], number_rows[i] + found, near.begin(),
                     [](std::size_t place) { return static_cast<std::uint32_t>(place); });
      take({.of = first + i, .places = near, .squared = {squared_rows[i], found}});
    }
  });
}

void PointNeighbours::nearest(int k, int threads, const Task& task, const TakeNear& take) const {
  nearestTo(places_, k, threads, task, take);
}

void PointNeighbours::within(float radius, std::size_t most, int threads, const Task& task,
                             const TakeNear& take) const {
  flann::SearchParams exact(flann::FLANN_CHECKS_UNLIMITED, 0, true);
  exact.cores = 1;
  exact.max_neighbors = static_cast<int>(std::min<std::size_t>(most, places_.size()));
  // FLANN takes what is nearer than the radius; what lies on it counts here.
  const float limit = std::nextafter(radius * radius, std::numeric_limits<float>::infinity());
  search(places_, threads, task, [&](std::size_t first, std::span<const Point3f> block) {
    std::vector<Point3f> places(block.begin(), block.end());
    std::vector<std::vector<std::size_t>> numbers;
    std::vector<std::vector<float>> squared;
    tree_->index.radiusSearch(flann::Matrix<float>(places[0].data(), places.size(), 3), numbers,
                              squared, limit, exact);
    std::vector<std::uint32_t> near;
    for (std::size_t i = 0; i < block.size(); ++i) {
      near.assign(numbers[i].begin(), numbers[i].end());
      take({.of = first + i, .places = near, .squared = squared[i]});
    }
  });
}

const char* flannVersion() noexcept {
  return FLANN_VERSION_;
}

}  // namespace relievo
