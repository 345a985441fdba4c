// SPDX-License-Identifier: BSD-3-Clause
// What the window's thread waits for when it steps over a map by tiles: each window of a walk
// (a quarter of a side on, finer, coarser), from a cold disk, from the page cache, and after the
// prefetcher had the time between two steps; and jumps, which nothing foresees. Each beside a copy
// of a window's heights in the same run. And what is measured across the whole map.
//
//   tiled_window_benchmark MAP.tif
//
// "Cold" asks the system to drop the map's pages (posix_fadvise) before every step; a disk's own
// cache is not emptied.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <random>
#include <vector>

#include "core/measure/measure.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/map_facts.h"
#include "core/tiles/tiled_map.h"

namespace {

using namespace relievo;  // NOLINT(google-build-using-namespace)

constexpr int kSteps = 200;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void dropPages(const std::filesystem::path& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return;
  ::posix_fadvise(fd, 0, 0, POSIX_FADV_DONTNEED);
  ::close(fd);
}

void dropPages(const TiledMap& map) {
  dropPages(map.file());
  for (const auto& file : map.otherFiles()) dropPages(file);
}

void say(const char* what, std::vector<double>& times) {
  std::vector<float> from(kWindowCount);
  std::vector<float> to(kWindowCount);
  std::vector<double> copies;
  copies.reserve(kSteps);
  for (int i = 0; i < kSteps; ++i) {
    copies.push_back(
        seconds([&] { std::memcpy(to.data(), from.data(), sizeof(float) * from.size()); }));
  }
  std::sort(copies.begin(), copies.end());
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2];
  std::printf("%-44s median %8.3f ms, 99 %% %8.3f ms, most %8.3f ms; %.0f times a copy\n", what,
              1e3 * median, 1e3 * times[times.size() * 99 / 100], 1e3 * times.back(),
              median / copies[copies.size() / 2]);
}

Region nextStep(const DetailLadder& ladder, const Region& from, std::mt19937& random) {
  const StepAbout centre{.x_mm = from.centreX(), .y_mm = from.centreY()};
  switch (random() % 6) {
    case 0:
      return finer(ladder, from, centre).value_or(from);
    case 1:
      return coarser(ladder, from, centre).value_or(from);
    default:
      return moved(ladder, from, random() % 2 == 0 ? 0.25 : -0.25, random() % 2 == 0 ? 0.25 : -0.25)
          .value_or(from);
  }
}

Region somewhere(const DetailLadder& ladder, std::mt19937& random) {
  const double side = 200 * ladder.spacings_mm.front();
  std::uniform_real_distribution<double> x(0, std::max(ladder.width_mm - side, 1e-3));
  std::uniform_real_distribution<double> y(0, std::max(ladder.height_mm - side, 1e-3));
  return {.x_mm = x(random), .y_mm = y(random), .side_mm = side, .level = {0}};
}

enum class Disk { cold, cached };
enum class Ahead { nothing, prefetched };
enum class Way { walk, jumps };

void windows(const char* what, const std::filesystem::path& file, Disk disk, Ahead ahead, Way way) {
  const Surface surface = openTiledSurface(file);
  TilePrefetcher prefetcher(surface.tiles);
  std::mt19937 random(5);
  Region region = somewhere(surface.ladder, random);
  std::vector<double> times;
  for (int i = 0; i < kSteps; ++i) {
    if (ahead == Ahead::prefetched) {
      prefetcher.around(region);
      prefetcher.wait();
    }
    if (disk == Disk::cold) dropPages(*surface.tiles);
    region = way == Way::jumps ? somewhere(surface.ladder, random)
                               : nextStep(surface.ladder, region, random);
    times.push_back(seconds([&] { windowOf(surface, region); }));
  }
  say(what, times);
}

void measuring(const std::filesystem::path& file) {
  const Surface surface = openTiledSurface(file);
  const double right = surface.ladder.width_mm;
  const double top = surface.ladder.height_mm;
  const auto timed = [&](const char* what, const Measurement& m) {
    const double s = seconds([&] { read(mapCells(surface), m); });
    std::printf("%-44s %8.1f ms\n", what, 1e3 * s);
  };
  timed("a point", {.kind = MeasureKind::point, .places = {{0.3 * right, 0.4 * top}}});
  timed("a profile from corner to corner",
        {.kind = MeasureKind::profile, .places = {{0, 0}, {right, top}}});
  timed("area and volume of the whole map",
        {.kind = MeasureKind::area, .places = {{0, 0}, {right, 0}, {right, top}, {0, top}}});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "tiled_window_benchmark MAP.tif\n");
    return 1;
  }
  const std::filesystem::path file = argv[1];
  windows("walk, page cache", file, Disk::cached, Ahead::nothing, Way::walk);
  windows("walk, page cache, prefetched", file, Disk::cached, Ahead::prefetched, Way::walk);
  windows("walk, cold", file, Disk::cold, Ahead::nothing, Way::walk);
  windows("walk, cold, prefetched", file, Disk::cold, Ahead::prefetched, Way::walk);
  windows("jumps, page cache", file, Disk::cached, Ahead::nothing, Way::jumps);
  windows("jumps, cold", file, Disk::cold, Ahead::nothing, Way::jumps);
  measuring(file);
  return 0;
}
