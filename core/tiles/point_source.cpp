// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/point_source.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/tiles/threads.h"

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
};

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

SourceBounds boundsOf(const PointSource& source, const ViewFromFile& view_from_file, int threads,
                      const Task& task) {
  const int workers = threadCount(threads);
  std::vector<Found> found(static_cast<std::size_t>(workers));
  for (std::uint64_t start = 0; start < source.count; start += kStep) {
    task.check();
    task.report("Measuring the scan",
                static_cast<double>(start) / static_cast<double>(source.count));
    const std::uint64_t end = std::min(start + kStep, source.count);
    inParts(start, end, workers, [&](int part, std::uint64_t first, std::uint64_t last) {
      Found& mine = found[static_cast<std::size_t>(part)];
      forEachBlock(source, first, last, [&](std::span<const FilePoint> block) {
        for (const FilePoint& p : block) {
          if (!isFinite(p)) continue;
          ++mine.finite;
          mine.file.add(p);
          mine.view.add(view_from_file(p));
        }
      });
    });
  }
  Found all;
  for (const Found& part : found) {
    all.finite += part.finite;
    if (part.finite == 0) continue;
    all.file.add(part.file.min);
    all.file.add(part.file.max);
    all.view.add(part.view.min);
    all.view.add(part.view.max);
  }
  return {.finite_points = all.finite,
          .min = all.view.min,
          .max = all.view.max,
          .file = {all.file.min, all.file.max}};
}

}  // namespace relievo
