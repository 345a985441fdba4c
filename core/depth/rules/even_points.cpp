// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/even_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "core/base/bands.h"

namespace relievo {
namespace {

// Cubes across the longest side, to learn the area: as many as hold some points each.
constexpr double kMostAcross = 192;
constexpr double kPointsOfCube = 8;
// Points in a cube and around it, itself among them: a surface meets some nine of these cubes.
constexpr double kFewestCompany = 4;
constexpr double kCompanyOfMean = 0.8;  // In cubes of the mean number of points.
// A cube with fewer points than this share of what those around it hold lies beside the surface.
constexpr double kShareOfAround = 0.5;

/// Fibonacci hashing: the upper bits of the product are well mixed.
std::uint64_t mixed(std::uint64_t number) {
  return number * 0x9E3779B97F4A7C15U;
}

/// How many points each cube of a grid holds: a table by the cubes' numbers, open addressing.
class CubeCounts {
 public:
  explicit CubeCounts(std::size_t expected)
      : cubes_(std::bit_ceil(2 * std::max<std::size_t>(expected, 1024))) {}

  /// One more point. @return  how many cubes were met before the point's own
  std::size_t add(std::uint64_t number) {
    if (2 * (count_ + 1) > cubes_.size()) grow();
    Cube& cube = cubes_[placeOf(number)];
    if (cube.number == kFree) {
      cube.number = number;
      cube.order = static_cast<std::uint32_t>(count_++);
    }
    ++cube.points;
    return cube.order;
  }
  std::uint32_t points(std::uint64_t number) const { return cubes_[placeOf(number)].points; }
  std::size_t count() const { return count_; }
  /// It will be asked for soon: a table of megabytes is not in the processor's cache.
  void expect(std::uint64_t number) const {
    __builtin_prefetch(&cubes_[mixed(number) >> (64 - std::countr_zero(cubes_.size()))]);
  }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  struct Cube {
    std::uint64_t number = kFree;
    std::uint32_t points = 0;
    std::uint32_t order = 0;
  };

  /// Where the cube is, or would be put.
  std::size_t placeOf(std::uint64_t number) const {
    std::size_t at = mixed(number) >> (64 - std::countr_zero(cubes_.size()));
    while (cubes_[at].number != kFree && cubes_[at].number != number) {
      at = (at + 1) & (cubes_.size() - 1);
    }
    return at;
  }
  void grow() {
    std::vector<Cube> old(2 * cubes_.size());
    old.swap(cubes_);
    for (const Cube& cube : old) {
      if (cube.number != kFree) cubes_[placeOf(cube.number)] = cube;
    }
  }

  std::vector<Cube> cubes_;
  std::size_t count_ = 0;
};

class CubeGrid {
 public:
  CubeGrid(const ViewBox& box, double side_mm) : low_(box.min), per_mm_(1 / side_mm) {}

  std::uint64_t operator()(const ViewMm& p) const {
    const auto step = [this](double value, double low) {
      return static_cast<std::uint64_t>(std::clamp((value - low) * per_mm_, 0.0, kMostSteps));
    };
    return step(p.x, low_.x) | step(p.y, low_.y) << 21U | step(p.z, low_.z) << 42U;
  }

  /// What the 26 cubes around one hold.
  struct Around {
    std::uint32_t points = 0;
    std::uint32_t cubes = 0;  ///< With points.
  };
  /// @param counts  knows points(number)
  template <class Counts>
  static Around around(std::uint64_t number, const Counts& counts) {
    Around found;
    for (int k = 0; k < 27; ++k) {
      const std::array<int, 3> off{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
      std::uint64_t near = 0;
      bool is_there = k != kOwnOf27;
      for (unsigned axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::int64_t>(number >> (21U * axis) & kLast) + off[axis];
        is_there = is_there && at >= 0 && at <= static_cast<std::int64_t>(kLast);
        near |= (static_cast<std::uint64_t>(at) & kLast) << (21U * axis);
      }
      const std::uint32_t points = is_there ? counts.points(near) : 0;
      found.points += points;
      found.cubes += points > 0 ? 1 : 0;
    }
    return found;
  }

  /// Along one axis.
  static std::uint64_t stepOf(std::uint64_t number, unsigned axis) {
    return number >> (21U * axis) & kLast;
  }

 private:
  static constexpr int kOwnOf27 = 13;
  static constexpr std::uint64_t kLast = (1U << 21U) - 1;
  static constexpr auto kMostSteps = static_cast<double>(kLast);
  ViewMm low_;
  double per_mm_;
};

std::array<float, 3> single(const ViewMm& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

bool isInside(const ViewBox& box, const ViewMm& p) {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y &&
         p.z >= box.min.z && p.z <= box.max.z;
}

/// take(points, place of the first among all in the box), for the points in the box in the cloud's
/// order, many at a time.
template <class Take>
void forBatches(const ViewBlocks& points, const ViewBox& box, const Task& task, Take&& take) {
  constexpr std::size_t kBatch = 1U << 16U;
  std::vector<ViewMm> batch;
  batch.reserve(kBatch);
  std::uint64_t before = 0;
  const auto give = [&] {
    task.check();
    take(std::span<const ViewMm>(batch), before);
    before += batch.size();
    batch.clear();
  };
  points([&](std::span<const ViewMm> block) {
    for (const ViewMm& p : block) {
      if (!isInside(box, p)) continue;
      batch.push_back(p);
      if (batch.size() == kBatch) give();
    }
  });
  give();
}

/// How many cubes of a coarse grid hold points: a bit a cube, of each thread its own.
class MetCubes {
 public:
  MetCubes(int threads, const CubeGrid& grid, double across)
      : grid_(grid), side_(static_cast<std::size_t>(across) + 2) {
    bits_.assign(static_cast<std::size_t>(threads),
                 std::vector<std::uint64_t>((side_ * side_ * side_ + 63) / 64));
  }

  void add(std::span<const ViewMm> points, std::uint64_t /*before*/) {
    const auto threads = static_cast<int>(bits_.size());
    parallelFor(threads, threads, [&](int number, int) {
      const auto part = static_cast<std::size_t>(number);
      std::vector<std::uint64_t>& bits = bits_[part];
      const std::size_t end = points.size() * (part + 1) / bits_.size();
      for (std::size_t i = points.size() * part / bits_.size(); i < end; ++i) {
        const std::size_t cube = placeOf(grid_(points[i]));
        bits[cube / 64] |= std::uint64_t{1} << (cube % 64);
      }
    });
  }
  std::size_t count() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < bits_.front().size(); ++i) {
      std::uint64_t word = 0;
      for (const std::vector<std::uint64_t>& bits : bits_) word |= bits[i];
      sum += static_cast<std::size_t>(std::popcount(word));
    }
    return sum;
  }

 private:
  std::size_t placeOf(std::uint64_t number) const {
    const auto step = [&](unsigned axis) {
      return std::min<std::size_t>(CubeGrid::stepOf(number, axis), side_ - 1);
    };
    return (step(2) * side_ + step(1)) * side_ + step(0);
  }

  CubeGrid grid_;
  std::size_t side_;
  std::vector<std::vector<std::uint64_t>> bits_;
};

/// The sum of what is in each cube, in the order in which the cubes were met.
class SummedCubes {
 public:
  struct Cube {
    std::uint64_t number = 0;
    std::uint64_t first = 0;  // The place of the first of its points.
    ViewMm sum{};
    std::uint32_t count = 0;
  };

  explicit SummedCubes(std::size_t expected) : counts_(expected) {
    cubes_.reserve(expected + expected / 2);
  }
  void add(std::uint64_t number, const ViewMm& from_corner, std::uint64_t place) {
    const std::size_t order = counts_.add(number);
    if (order == cubes_.size()) {
      cubes_.push_back({.number = number, .first = place, .sum = {}, .count = 0});
    }
    Cube& cube = cubes_[order];
    cube.sum = cube.sum + from_corner;
    ++cube.count;
  }
  void expect(std::uint64_t number) const { counts_.expect(number); }
  const CubeCounts& counts() const { return counts_; }
  const std::vector<Cube>& cubes() const { return cubes_; }

 private:
  CubeCounts counts_;
  std::vector<Cube> cubes_;
};

/// The cubes of a grid, each of them one thread's: what is in one is counted and summed in the
/// cloud's order, the same for any number of threads.
class SharedCubes {
 public:
  SharedCubes(int threads, const CubeGrid& grid, const ViewMm& corner, std::size_t expected)
      : grid_(grid), corner_(corner) {
    for (int i = 0; i < threads; ++i) {
      shares_.emplace_back(expected / static_cast<std::size_t>(threads));
    }
  }

  void add(std::span<const ViewMm> points, std::uint64_t before) {
    constexpr std::size_t kAhead = 12;
    numbers_.resize(points.size() + kAhead);
    onEach([&](std::size_t part) {
      const std::size_t end = points.size() * (part + 1) / shares_.size();
      for (std::size_t i = points.size() * part / shares_.size(); i < end; ++i) {
        numbers_[i] = grid_(points[i]);
      }
    });
    onEach([&](std::size_t own) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (ownerOf(numbers_[i + kAhead]) == own) shares_[own].expect(numbers_[i + kAhead]);
        const std::uint64_t number = numbers_[i];
        if (ownerOf(number) == own) shares_[own].add(number, points[i] - corner_, before + i);
      }
    });
  }
  /// work(i) for every share, each on a thread.
  template <class Work>
  void onEach(Work&& work) const {
    const auto count = static_cast<int>(shares_.size());
    parallelFor(count, count, [&](int own, int) { work(static_cast<std::size_t>(own)); });
  }
  /// How many cubes hold points.
  std::size_t count() const {
    std::size_t sum = 0;
    for (const SummedCubes& share : shares_) sum += share.counts().count();
    return sum;
  }
  std::uint32_t points(std::uint64_t number) const {
    return shares_[ownerOf(number)].counts().points(number);
  }
  const std::vector<SummedCubes>& shares() const { return shares_; }

 private:
  std::size_t ownerOf(std::uint64_t number) const {
    return shares_.size() == 1 ? 0 : (mixed(number) >> 20U) % shares_.size();
  }

  CubeGrid grid_;
  ViewMm corner_;
  std::vector<SummedCubes> shares_;
  std::vector<std::uint64_t> numbers_;  // Of a batch's points, and some that are not looked at.
};

/// Does a cube lie on a surface? Thinning leaves of a surface one point in many, of strays every
/// one: most of what is chosen would be strays. Their cubes have nobody around, or hold one point
/// where those beside them hold many.
class OnSurface {
 public:
  OnSurface(const SharedCubes& cubes, std::uint64_t count)
      : cubes_(cubes), mean_(static_cast<double>(count) / static_cast<double>(cubes.count())) {}

  bool operator()(const SummedCubes::Cube& cube) const {
    const double own = cube.count;
    const double company = std::max(kFewestCompany, std::floor(kCompanyOfMean * mean_));
    if (own >= company) return true;
    const CubeGrid::Around near = CubeGrid::around(cube.number, cubes_);
    if (own + near.points < company) return false;
    const bool is_thin = own < kShareOfAround * mean_;
    return !is_thin || own * near.cubes >= kShareOfAround * near.points;
  }

 private:
  const SharedCubes& cubes_;
  double mean_;  // Points of a cube.
};

/// The middle of each cube that lies on a surface, in the order in which the cubes were met.
std::vector<std::array<float, 3>> middlesOnSurfaces(const SharedCubes& cubes, std::uint64_t count) {
  struct Chosen {
    std::uint64_t first;
    std::array<float, 3> middle;
  };
  const OnSurface is_on_surface(cubes, count);
  std::vector<std::vector<Chosen>> of_shares(cubes.shares().size());
  cubes.onEach([&](std::size_t own) {
    for (const SummedCubes::Cube& cube : cubes.shares()[own].cubes()) {
      if (!is_on_surface(cube)) continue;
      const double points = cube.count;
      of_shares[own].push_back(
          {cube.first, single({cube.sum.x / points, cube.sum.y / points, cube.sum.z / points})});
    }
  });
  std::vector<Chosen> all = std::move(of_shares.front());
  for (std::size_t i = 1; i < of_shares.size(); ++i) {
    const auto middle = static_cast<std::ptrdiff_t>(all.size());
    all.insert(all.end(), of_shares[i].begin(), of_shares[i].end());
    std::inplace_merge(all.begin(), all.begin() + middle, all.end(),
                       [](const Chosen& a, const Chosen& b) { return a.first < b.first; });
  }
  std::vector<std::array<float, 3>> chosen;
  chosen.reserve(all.size());
  for (const Chosen& one : all) chosen.push_back(one.middle);
  return chosen;
}

}  // namespace

std::vector<std::array<float, 3>> evenPoints(const ViewBlocks& points, const ViewBox& box,
                                             std::uint64_t count, std::size_t wanted,
                                             const Task& task) {
  const double side =
      std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z, 1e-300});
  if (count <= wanted) {
    std::vector<std::array<float, 3>> all;
    all.reserve(static_cast<std::size_t>(count));
    forBatches(points, box, task, [&](std::span<const ViewMm> batch, std::uint64_t) {
      for (const ViewMm& p : batch) all.push_back(single(p - box.min));
    });
    return all;
  }
  const int threads = threadsFor(static_cast<std::size_t>(count), 0);
  const auto fill = [&](auto& cubes) {
    forBatches(points, box, task, [&](std::span<const ViewMm> batch, std::uint64_t before) {
      cubes.add(batch, before);
    });
  };
  // A surface meets the square of twice as many cubes of half the side.
  const double across =
      std::clamp(std::sqrt(static_cast<double>(count) / kPointsOfCube), 1.0, kMostAcross);
  const double counted_side = side / across;
  MetCubes coarse(threads, CubeGrid(box, counted_side), across);
  fill(coarse);
  const double cube_side =
      counted_side * std::sqrt(static_cast<double>(coarse.count()) / static_cast<double>(wanted));
  SharedCubes cubes(threads, CubeGrid(box, std::max(cube_side, side / (1U << 20U))), box.min,
                    wanted);
  fill(cubes);
  return middlesOnSurfaces(cubes, count);
}

}  // namespace relievo
