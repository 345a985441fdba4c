// SPDX-License-Identifier: BSD-3-Clause
// Maps larger than memory, end to end: makes a LAS file of a relief with holes and a raster, makes
// their maps by tiles within a budget, and reads windows. Each time stands beside a copy of the
// same bytes in the same run, that of a window from file also beside GDAL's own RasterIO of the
// same heights and origins from the same files, with no more of them in its cache.
//
//   tiles_benchmark FOLDER [points in millions, 100] [cells across, 16384] [budget in MB, 2000]
//                   [cloud or raster; both]
//
// FOLDER needs 6 GB for the default sizes and is left as it was. For the peak memory of the
// raster's map run it alone: the allocator keeps what the cloud's map took.
#include <sys/resource.h>
#include <unistd.h>

#include <gdal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/session/large/large_map.h"
#include "core/session/large/tiled_surface.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tile_raster.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/io/las_sample.h"

namespace {

using namespace relievo;  // NOLINT(google-build-using-namespace)

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}

double reliefMm(double x, double y) {
  return 500 + 200 * std::sin(x / 700) * std::cos(y / 900) + 20 * std::sin(x / 31) +
         5 * std::sin(y / 7);
}

/// At least so many points in strips from left to right, as an aeroplane flies, 10 m x 10 m with
/// three holes; numbers of 0.1 mm.
void writeLas(const std::filesystem::path& file, std::uint64_t points) {
  constexpr double kHoleShare = 0.017;  // Of the area.
  constexpr int kStrips = 20;
  const auto tried = static_cast<std::uint64_t>(static_cast<double>(points) / (1 - kHoleShare));
  test::Las las;
  las.scale = {0.1, 0.1, 0.1};
  las.count = 0;
  std::ofstream out(file, std::ios::binary);
  out << test::lasFile(las);
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<char> block;
  std::uint32_t written = 0;
  for (std::uint64_t i = 0; i < tried; ++i) {
    const double flown = kStrips * static_cast<double>(i) / static_cast<double>(tried);
    const double x = std::min(1e4, 1e4 * (flown - std::floor(flown)) + 20 * uniform(random));
    const double y = 1e4 / kStrips * (std::floor(flown) + uniform(random));
    if (std::hypot(x - 3000, y - 6000) < 600 || std::hypot(x - 7000, y - 2000) < 400 ||
        std::hypot(x - 8000, y - 8000) < 100) {
      continue;
    }
    const double z = reliefMm(x, y) + uniform(random) - 0.5;
    for (const double v : {x, y, z}) {
      const auto stored = static_cast<std::int32_t>(std::lround(10 * v));
      const char* bytes = reinterpret_cast<const char*>(&stored);
      block.insert(block.end(), bytes, bytes + 4);
    }
    block.insert(block.end(), 8, '\0');
    ++written;
    if (block.size() > 1'000'000) {
      out.write(block.data(), static_cast<std::streamsize>(block.size()));
      block.clear();
    }
  }
  out.write(block.data(), static_cast<std::streamsize>(block.size()));
  constexpr int kCountAt = 107;
  out.seekp(kCountAt);
  out.write(reinterpret_cast<const char*>(&written), sizeof(written));
  std::printf("%u points\n", written);
}

void writeRaster(const std::filesystem::path& file, int side) {
  const GridFrame frame{
      .size = {.cols = side, .rows = side}, .spacing_mm = 1, .first_x_mm = 0.5, .first_y_mm = 0.5};
  TileRasterWriter writer(file, frame, {.cell_bytes = 4, .bands = 1, .nan_is_nodata = true});
  std::vector<float> row(static_cast<std::size_t>(side));
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const bool hole = std::hypot(i - 0.3 * side, j - 0.6 * side) < 0.05 * side;
      row[static_cast<std::size_t>(i)] = hole ? std::nanf("") : static_cast<float>(reliefMm(i, j));
    }
    const void* const bands[] = {row.data()};
    writer.add(bands);
  }
  writer.close({}, nullptr);
  writer.commit();
}

/// A plain copy of as many bytes, read and written through memory.
double secondsToCopyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  const double s = seconds([&] {
    std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing);
  });
  std::filesystem::remove(to);
  return s;
}

void report(const char* what, const LargeMap& map, double total_s, double copy_s) {
  std::printf(
      "%s: %d x %d cells, %zu levels, %.1f s (first view %.2f, read %.1f, grid %.1f, fill %.1f, "
      "levels %.1f), %.1f times a copy of the input, spilled %.0f MB, peak memory %.0f MB\n",
      what, map.frames[0].size.cols, map.frames[0].size.rows, map.frames.size(), total_s,
      map.first_view_s, map.seconds.read, map.seconds.grid, map.seconds.fill, map.seconds.pyramid,
      total_s / copy_s, static_cast<double>(map.spilled_bytes) / 1e6, peakMegabytes());
  std::fflush(stdout);
}

/// Of many seconds; the least is what the program takes when nothing else runs.
struct Spread {
  double least = 0, median = 0, late = 0;
};
Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {.least = values.front(),
          .median = values[values.size() / 2],
          .late = values[values.size() * 99 / 100]};
}

/// The two rasters of one level as GDAL reads them by itself.
class GdalLevel {
 public:
  GdalLevel(const std::filesystem::path& heights, const GridFrame& frame)
      : frame_(frame), heights_(open(heights)), origins_(open(originFile(heights))) {}
  GdalLevel(const GdalLevel&) = delete;
  GdalLevel& operator=(const GdalLevel&) = delete;
  ~GdalLevel() {
    GDALClose(heights_);
    GDALClose(origins_);
  }

  /// The nodes around the samples of a region that has the level's spacing.
  void read(const Region& region) {
    GDALFlushCache(heights_);
    GDALFlushCache(origins_);
    const auto cell = [this](double at, double first, int count) {
      return std::clamp(static_cast<int>((at - first) / frame_.spacing_mm), 0,
                        std::max(count - kSide, 0));
    };
    const int cols = std::min(kSide, frame_.size.cols);
    const int rows = std::min(kSide, frame_.size.rows);
    const int col = cell(region.x_mm, frame_.first_x_mm, frame_.size.cols);
    const int row =
        frame_.size.rows - rows - cell(region.y_mm, frame_.first_y_mm, frame_.size.rows);
    const auto take = [&](GDALDatasetH from, void* to, GDALDataType type) {
      if (GDALRasterIO(GDALGetRasterBand(from, 1), GF_Read, col, row, cols, rows, to, cols, rows,
                       type, 0, 0) != CE_None) {
        std::abort();
      }
    };
    take(heights_, heights_mm_.data(), GDT_Float32);
    take(origins_, origin_codes_.data(), GDT_Byte);
  }

 private:
  static constexpr int kSide = kWindowSamples + 1;
  static GDALDatasetH open(const std::filesystem::path& file) {
    GDALAllRegister();
    GDALDatasetH dataset = GDALOpen(file.c_str(), GA_ReadOnly);
    if (dataset == nullptr) std::abort();
    return dataset;
  }

  GridFrame frame_;
  GDALDatasetH heights_, origins_;
  std::vector<float> heights_mm_ = std::vector<float>(std::size_t{kSide} * kSide);
  std::vector<unsigned char> origin_codes_ = std::vector<unsigned char>(heights_mm_.size());
};

void readWindows(const std::filesystem::path& file) {
  double open_s = 0;
  std::unique_ptr<TiledMap> map;
  open_s = seconds([&] { map = std::make_unique<TiledMap>(file, std::size_t{1} << 20U); });
  std::printf("open: %.1f ms\n", 1e3 * open_s);
  const TiledMap roomy(file);
  std::mt19937 random(9);
  std::vector<float> from(kWindowCount);  // What a window's heights are.
  std::vector<float> to(from.size());
  for (int level = 0; level < static_cast<int>(map->frames().size()); ++level) {
    const double side = 200 * map->frames()[static_cast<std::size_t>(level)].spacing_mm;
    const DetailLadder& ladder = map->ladder();
    std::uniform_real_distribution<double> x(0, std::max(ladder.width_mm - side, 1e-3));
    std::uniform_real_distribution<double> y(0, std::max(ladder.height_mm - side, 1e-3));
    std::vector<double> from_file;
    std::vector<double> resident;
    std::vector<double> copied;
    std::vector<double> by_gdal;
    GdalLevel gdal(levelFile(file, level), map->frames()[static_cast<std::size_t>(level)]);
    for (int i = 0; i < 300; ++i) {
      const Region region{.x_mm = x(random), .y_mm = y(random), .side_mm = side, .level = {level}};
      // The cache of `map` holds four tiles, so that nearly every window comes from the file.
      from_file.push_back(seconds([&] { map->window(region); }));
      by_gdal.push_back(seconds([&] { gdal.read(region); }));
      roomy.prefetch(region);
      resident.push_back(seconds([&] { roomy.window(region); }));
      copied.push_back(seconds([&] { std::memcpy(to.data(), from.data(), 4 * from.size()); }));
    }
    const Spread copy_s = spreadOf(copied);
    const auto say = [&](const char* what, const Spread& s) {
      std::printf("level %d, %s: least %.0f us, median %.0f, 99 %% %.0f; %.1f times a copy\n",
                  level, what, 1e6 * s.least, 1e6 * s.median, 1e6 * s.late,
                  s.median / copy_s.median);
    };
    const double ratio = spreadOf(from_file).median / spreadOf(by_gdal).median;
    say("from file", spreadOf(from_file));
    say("GDAL's RasterIO alone", spreadOf(by_gdal));
    std::printf("level %d: a window from file takes %.2f times GDAL's RasterIO\n", level, ratio);
    say("resident", spreadOf(resident));
  }
}

void removeLevels(const std::filesystem::path& finest) {
  for (int level = 0; std::filesystem::remove(levelFile(finest, level)); ++level) {
    std::filesystem::remove(originFile(levelFile(finest, level)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr,
                 "tiles_benchmark FOLDER [million points] [cells across] [MB] [cloud|raster]\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  const auto points = static_cast<std::uint64_t>(1e6 * (argc > 2 ? std::atof(argv[2]) : 100));
  const int cells = argc > 3 ? std::atoi(argv[3]) : 16384;
  const auto budget = static_cast<std::uint64_t>(1e6 * (argc > 4 ? std::atof(argv[4]) : 2000));
  const std::string only = argc > 5 ? argv[5] : "cloud raster";
  const std::filesystem::path map = folder / "tiles_benchmark_map.tif";
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{.name = "top", .rotation = std::nullopt};
  LargeMapOptions large{.file = map, .memory_bytes = budget, .on_view = [](const Surface&) {}};
  std::printf("peak memory before: %.0f MB\n", peakMegabytes());

  if (only.find("cloud") != std::string::npos) {
    const std::filesystem::path las = folder / "tiles_benchmark.las";
    writeLas(las, points);
    options.cells = cells;
    options.rule = PointRule::median;
    const double copy_s = secondsToCopyFile(las, folder / "tiles_benchmark.copy");
    LargeMap made;
    const double total_s = seconds([&] { made = makeLargeMap(las, options, large); });
    report("cloud", made, total_s, copy_s);
    std::filesystem::remove(las);
    readWindows(map);
    removeLevels(map);
  }
  if (only.find("raster") != std::string::npos) {
    options.cells.reset();
    options.rule.reset();
    const std::filesystem::path raster = folder / "tiles_benchmark_raster.tif";
    writeRaster(raster, cells);
    const double copy_s = secondsToCopyFile(raster, folder / "tiles_benchmark.copy");
    LargeMap made;
    const double total_s = seconds([&] { made = makeLargeMap(raster, options, large); });
    report("raster", made, total_s, copy_s);
    std::filesystem::remove(raster);
    readWindows(map);
    removeLevels(map);
  }
  return 0;
}
