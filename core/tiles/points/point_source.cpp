// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/points/point_source.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/exchange.h"
#include "core/base/plain_bytes.h"
#include "core/base/threads.h"

namespace relievo {
namespace {

constexpr std::size_t kBlock = 16384;
constexpr std::uint64_t kStep = 1U << 20U;  // Points between two looks at the stop token.
constexpr double kHuge = std::numeric_limits<double>::infinity();

template <class Point>
struct Box {
  Point min{kHuge, kHuge, kHuge}, max{-kHuge, -kHuge, -kHuge};

  void add(const Point& p) noexcept {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
};

struct Found {
  std::uint64_t finite = 0;
  Box<ViewMm> view;
  Box<FilePoint> file;

  void add(const Found& other) noexcept {
    finite += other.finite;
    if (other.finite == 0) return;
    file.add(other.file.min);
    file.add(other.file.max);
    view.add(other.view.min);
    view.add(other.view.max);
  }
};

/// The points that this process looks at.
struct Part {
  std::uint64_t first = 0, end = 0;
};
Part partOf(std::uint64_t count, const Exchange* processes) {
  if (processes == nullptr) return {.first = 0, .end = count};
  const auto ranks = static_cast<std::uint64_t>(processes->ranks());
  const auto before = [&](std::uint64_t rank) {
    return count / ranks * rank + count % ranks * rank / ranks;
  };
  const auto rank = static_cast<std::uint64_t>(processes->rank());
  return {.first = before(rank), .end = before(rank + 1)};
}

}  // namespace

void forEachBlock(const PointSource& source, std::uint64_t first, std::uint64_t end,
                  const std::function<void(std::span<const FilePoint>)>& take) {
  std::vector<FilePoint> block(std::min<std::uint64_t>(kBlock, end - first));
  while (first < end) {
    const auto wanted =
        static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), end - first));
    const std::size_t got = source.read(first, std::span(block).first(wanted));
    if (got == 0) return;
    take(std::span<const FilePoint>(block).first(got));
    first += got;
  }
}

namespace {

/// Reads its part once. @param also(part, view point)  of every finite point, on any thread
template <class Also>
SourceBounds measure(const PointSource& source, const ViewFromFile& view_from_file, int workers,
                     const Task& task, Exchange* processes, const Also& also) {
  std::vector<Found> found(static_cast<std::size_t>(workers));
  const Part mine = partOf(source.count, processes);
  for (std::uint64_t start = mine.first; start < mine.end; start += kStep) {
    task.check();
    task.report("Measuring the scan", static_cast<double>(start - mine.first) /
                                          static_cast<double>(mine.end - mine.first));
    const std::uint64_t end = std::min(start + kStep, mine.end);
    inParts(start, end, workers, [&](int part, std::uint64_t first, std::uint64_t last) {
      const auto index = static_cast<std::size_t>(part);
      Found& of_part = found[index];
      forEachBlock(source, first, last, [&](std::span<const FilePoint> block) {
        for (const FilePoint& p : block) {
          if (!isFinite(p)) continue;
          ++of_part.finite;
          of_part.file.add(p);
          const ViewMm seen = view_from_file(p);
          of_part.view.add(seen);
          also(index, seen);
        }
      });
    });
  }
  Found all;
  for (const Found& part : found) all.add(part);
  if (processes != nullptr) {
    const std::vector<std::string> told = processes->share(plainBytes(all));
    all = {};
    for (const std::string& one : told) {
      Found part;
      PlainBytes(one).take(part);
      all.add(part);
    }
  }
  return {.finite_points = all.finite,
          .min = all.view.min,
          .max = all.view.max,
          .file = {all.file.min, all.file.max}};
}

}  // namespace

SourceBounds boundsOf(const PointSource& source, const ViewFromFile& view_from_file, int threads,
                      const Task& task, Exchange* processes) {
  return measure(source, view_from_file, threadCount(threads), task, processes,
                 [](std::size_t, const ViewMm&) {});
}

BoundsAndCounts boundsAndCountsOf(const PointSource& source, const ViewFromFile& view_from_file,
                                  const StrayGrid& grid, int threads, const Task& task,
                                  Exchange* processes) {
  const int workers = threadCount(threads);
  std::vector<StrayCounts> counts(static_cast<std::size_t>(workers), StrayCounts(grid));
  const SourceBounds bounds = measure(source, view_from_file, workers, task, processes,
                                      [&counts](std::size_t part, const ViewMm& p) {
                                        counts[part].add({p.x, p.y, p.z});
                                      });
  for (std::size_t part = 1; part < counts.size(); ++part) counts[0].add(counts[part]);
  if (processes != nullptr && !processes->isAlone()) {
    const std::vector<std::string> told = processes->share(counts[0].bytes());
    counts[0] = StrayCounts(grid);
    for (const std::string& one : told) counts[0].add(std::string_view(one));
  }
  return {.bounds = bounds, .counts = std::move(counts[0])};
}

PointSource filtered(PointSource source, std::function<bool(const FilePoint&)> keeps) {
  const std::uint64_t count = source.count;
  return {.count = count,
          .read = [source = std::move(source), keeps = std::move(keeps)](
                      std::uint64_t first, std::span<FilePoint> block) {
            const std::size_t got = source.read(first, block);
            constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
            for (FilePoint& p : block.first(got)) {
              if (!keeps(p)) p = {kNone, kNone, kNone};
            }
            return got;
          }};
}

}  // namespace relievo
