// SPDX-License-Identifier: BSD-3-Clause
// What cleaning is worth and what it costs, as two tables.
//   prepare_benchmark strays SCAN...        1 % of strays planted around scans: found and lost
//   prepare_benchmark speed POINTS...       time and memory beside PCL's filters, in one run
// Strays are drawn evenly from 1.2 times the scan's box. "far" are those more than five spacings
// from every point of the scan; what is nearer is noise of the surface. Times are processor time of
// the whole process, so that other work on the machine moves them less.
#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/import.h"
#include "core/prepare/execute.h"
#include "core/prepare/off_surface.h"
#include "core/prepare/outliers.h"
#include "tests/core/prepare/made_clouds.h"

namespace relievo {
namespace {

using Points = std::vector<Point3f>;

double processorSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Of now, or the most since resetPeak().
double megabytes(const char* key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key)) return std::atof(line.c_str() + std::string_view(key).size()) / 1024;
  }
  return 0;
}
void resetPeak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

struct Planted {
  Points points;
  std::vector<char> is_stray, is_far;
};

Planted planted(const Points& good) {
  std::mt19937 random(7);
  Point3f low = good[0];
  Point3f high = good[0];
  for (const Point3f& p : good) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  Points strays(good.size() / 100);
  for (Point3f& p : strays) {
    for (std::size_t a = 0; a < 3; ++a) {
      const float more = 0.1F * (high[a] - low[a]);
      p[a] = std::uniform_real_distribution<float>(low[a] - more, high[a] + more)(random);
    }
  }
  const PointNeighbours neighbours(good);
  const double far = 5 * spacingOf(neighbours, {});
  std::vector<char> is_far(strays.size());
  neighbours.nearestTo(strays, 1, 0, {}, [&](const NearPlaces& near) {
    is_far[near.of] = std::sqrt(static_cast<double>(near.squared[0])) > far ? 1 : 0;
  });
  Planted all;
  std::size_t next = 0;
  const std::size_t every = good.size() / strays.size();
  for (std::size_t i = 0; i < good.size(); ++i) {
    all.points.push_back(good[i]);
    all.is_stray.push_back(0);
    all.is_far.push_back(0);
    if (i % every != 0 || next == strays.size()) continue;
    all.points.push_back(strays[next]);
    all.is_stray.push_back(1);
    all.is_far.push_back(is_far[next++]);
  }
  return all;
}

void strays(const std::string& name, const Points& good) {
  const Planted all = planted(good);
  const std::vector<std::pair<const char*, std::vector<Step>>> ways{
      {"--clean", cleaningSteps()},
      {"--outliers 8,2", {Outliers{}}},
      {"--lonely auto,3", {Lonely{}}}};
  for (const auto& [way, steps] : ways) {
    const PrepareAnswer answer =
        execute({.steps = steps, .scans = {test::scanOf(all.points)}}, {}, {});
    const PointBits& kept = answer.steps.back().kept;
    double planted_strays = 0;
    double found = 0;
    double far = 0;
    double far_found = 0;
    double lost = 0;
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      planted_strays += all.is_stray[i];
      far += all.is_far[i];
      if (kept[i]) continue;
      found += all.is_stray[i];
      far_found += all.is_far[i];
      lost += 1 - all.is_stray[i];
    }
    std::printf("| %-32s | %-16s | %8zu | %6.2f | %6.2f | %6.3f |\n", name.c_str(), way,
                good.size(), 100 * far_found / std::max(1.0, far), 100 * found / planted_strays,
                100 * lost / static_cast<double>(good.size()));
  }
}

template <class Work>
void measured(const char* what, std::size_t points, const Work& work) {
  const double before_mb = megabytes("VmRSS:");
  resetPeak();
  const double start = processorSeconds();
  const std::size_t kept = work();
  const double seconds = processorSeconds() - start;
  const double more_mb = megabytes("VmHWM:") - before_mb;
  std::printf("| %-28s | %9zu | %7.2f | %5.0f | %9zu |\n", what, points, seconds,
              more_mb * 1048576 / static_cast<double>(points), kept);
  std::fflush(stdout);
}

void speed(std::size_t count) {
  const Points points = test::reliefWithOutliers(count, 0.01, 1);
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Point3f& p : points) cloud->emplace_back(p[0], p[1], p[2]);
  std::vector<std::uint32_t> ours;
  pcl::Indices theirs;
  const auto compare = [&](const char* what) {
    const bool equal =
        ours.size() == theirs.size() &&
        std::equal(ours.begin(), ours.end(), theirs.begin(), [](std::uint32_t a, pcl::index_t b) {
          return a == static_cast<std::uint32_t>(b);
        });
    std::printf("  %s: %s points stay\n", what, equal ? "the same" : "OTHER");
  };
  measured("statistical 8,2", count, [&] {
    ours = withoutOutliers(PointNeighbours(points), count, {}, {});
    return ours.size();
  });
  measured("pcl::StatisticalOutlierRemoval", count, [&] {
    pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
    filter.setInputCloud(cloud);
    filter.setMeanK(8);
    filter.setStddevMulThresh(2);
    filter.filter(theirs);
    return theirs.size();
  });
  compare("statistical");
  const double radius = 4 * 100 / std::sqrt(static_cast<double>(count));
  measured("radius, 7 neighbours", count, [&] {
    ours = withoutLonely(PointNeighbours(points), count, radius, 7, {});
    return ours.size();
  });
  measured("pcl::RadiusOutlierRemoval", count, [&] {
    pcl::RadiusOutlierRemoval<pcl::PointXYZ> filter;
    filter.setInputCloud(cloud);
    filter.setRadiusSearch(radius);
    filter.setMinNeighborsInRadius(7);
    filter.filter(theirs);
    return theirs.size();
  });
  compare("radius");
  measured("sparse 8,2.6", count,
           [&] { return withoutSparse(PointNeighbours(points), count, {}, {}).size(); });
  measured("off the surface, 4 times", count,
           [&] { return withoutOffSurface(PointNeighbours(points), count, 4, {}).size(); });
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  const std::string_view what = argc > 2 ? argv[1] : "";
  if (what == "strays") {
    std::puts(
        "| scan | steps | points | far found % | found % | good lost % "
        "|\n|---|---|---:|---:|---:|---:|");
    for (int i = 2; i < argc; ++i) {
      const std::filesystem::path file = argv[i];
      relievo::strays(file.filename().string(), relievo::importScan(file).points);
    }
    relievo::strays("made relief, unevenly sampled",
                    relievo::test::reliefWithOutliers(100000, 0, 1));
    return 0;
  }
  if (what == "speed") {
    std::puts("| | points | s | B a point | stay |\n|---|---:|---:|---:|---:|");
    for (int i = 2; i < argc; ++i) relievo::speed(std::strtoull(argv[i], nullptr, 10));
    return 0;
  }
  std::fputs("prepare_benchmark strays SCAN... | speed POINTS...\n", stderr);
  return 1;
}
