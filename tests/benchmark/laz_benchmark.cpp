// SPDX-License-Identifier: BSD-3-Clause
// laz_benchmark [FILE.laz...]: unpacking beside reading the same records as LAS, in one run.
// Without files, on made ones of formats 3 and 7. `1 thr`: all fields of all records; `xyz`: as the
// import wants them; `import`: readLas in this process, on all cores; all these are processor time,
// so that other work on the machine moves them less. `2 wall`: all records on two threads, by the
// clock, over the same with one: 0.5 at best; `2 proc`: their processor time over that of one, 1 at
// best, which tells on a busy machine that two threads do no more work than one. Last, the first
// view of made files: points of COPC's coarsest levels, of LAZ from the beginnings of its chunks,
// by the clock, beside unpacking all points on two threads. The line to beat is LASzip's published
// "one to three millions points per second" (Isenburg 2013, abstract), 333 to 1000 ns a point. Best
// of nine.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/io/las/las_records.h"
#include "core/io/mapped_file.h"
#include "core/io/point_stream.h"
#include "core/io/read_scan.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/temporary_folder.h"

namespace {

using namespace relievo;

struct Times {
  double processor_ns = 1e30, wall_ns = 1e30;  ///< A point.
};

Times best(std::uint64_t points, const std::function<void()>& work) {
  Times best;
  const auto processor = [] {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
  };
  for (int i = 0; i < 9; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const double processor_start = processor();
    work();
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    const auto count = static_cast<double>(points);
    best.processor_ns = std::min(best.processor_ns, (processor() - processor_start) / count);
    best.wall_ns = std::min(best.wall_ns, took.count() / count);
  }
  return best;
}

/// All records into one sum, so that they are used.
std::uint64_t sumOfRecords(std::string_view bytes, const LazWanted& wanted, int threads) {
  const std::filesystem::path name = "benchmark";
  const ImportOptions options;
  const Task task;
  const ReadJob job{name, bytes, options, task};
  const LasHeader header = parseLasHeader(bytes, name);
  LasRecords records(job, header, wanted, threads);
  std::uint64_t sum = 0;
  records.forEachBlock([&](const char* at, std::size_t count) {
    for (std::size_t i = 0; i < count * header.record_bytes; ++i) {
      sum += static_cast<unsigned char>(at[i]);
    }
  });
  return sum;
}

void importHere(std::string_view bytes) {
  const std::filesystem::path name = "benchmark";
  const ImportOptions options;
  const Task task;
  const ReadJob job{name, bytes, options, task};
  if (readLas(job).points.empty()) std::abort();
}

void measure(const std::string& name, std::string_view packed, const std::string& plain) {
  const std::uint64_t points = parseLasHeader(packed, name).points;
  const std::uint64_t sum = sumOfRecords(packed, {}, 1);
  const auto records = [&](const LazWanted& wanted, int threads) {
    return best(points, [&] {
      if (sumOfRecords(packed, wanted, threads) != sum && wanted.others) std::abort();
    });
  };
  const Times with_one = records({}, 1);
  const Times with_two = records({}, 2);
  std::printf("%-24s %9llu %7.0f %7.0f %7.0f %7.2f %7.2f", name.c_str(),
              static_cast<unsigned long long>(points), with_one.processor_ns,
              records(kLazCoordinates, 1).processor_ns,
              best(points, [&] { importHere(packed); }).processor_ns,
              with_two.wall_ns / with_one.wall_ns, with_two.processor_ns / with_one.processor_ns);
  if (!plain.empty()) {
    if (sumOfRecords(plain, {}, 1) != sum) std::abort();
    std::printf(" %9.1f %7.1f", best(points, [&] { sumOfRecords(plain, {}, 1); }).processor_ns,
                best(points, [&] { importHere(plain); }).processor_ns);
  }
  std::printf("\n");
}

void measureMade(const std::string& name, int format) {
  test::Laz laz;
  laz.how.format = format;
  laz.records = test::wanderingRecords(laz.how, 500'000, 1, 1, false);
  measure(name, test::lazFile(laz).bytes, test::lasOf(laz));
}

/// Of 500 000 points in chunks of 5000, as COPC and as LAZ.
void measureFirstView() {
  constexpr std::uint64_t kShown = 250'000;  // As first_view.cpp wants of a large scan.
  test::Laz laz;
  laz.how.format = 7;
  laz.records = test::wanderingRecords(laz.how, 500'000, 1, 1, false);
  laz.chunk_points = 5000;
  const test::TemporaryFolder folder;
  const auto measured = [&](const char* name, const std::string& bytes) {
    const std::filesystem::path file = folder.write(name, bytes);
    std::uint64_t shown = 0;
    const Times times = best(1, [&] {
      const PointStream stream(file);
      std::vector<FilePoint> points;
      shown = 0;
      for (const PointRange& range : stream.cheapSample(kShown)) {
        points.resize(static_cast<std::size_t>(range.count));
        shown += stream.read(range.first, points);
      }
    });
    const Times all = best(1, [&] { sumOfRecords(bytes, {}, 2); });
    std::printf("first view of %-9s %7llu points in %.0f ms; all 500000 in %.0f ms\n", name,
                static_cast<unsigned long long>(shown), 1e-6 * times.wall_ns, 1e-6 * all.wall_ns);
  };
  measured("made.laz", test::lazFile(laz).bytes);
  laz.chunk_points = ~std::uint32_t{0};
  laz.chunks.assign(100, 5000);
  for (int i = 0; i < 100; ++i) laz.levels.push_back(i < 1 ? 0 : i < 5 ? 1 : i < 21 ? 2 : 4);
  measured("made.copc.laz", test::lazFile(laz).bytes);
}

}  // namespace

int main(int argc, char** argv) {
  std::puts(
      "ns a point                  points   1 thr     xyz  import  2 wall  2 proc  LAS: rec  "
      "import");
  try {
    for (int i = 1; i < argc; ++i) {
      const std::filesystem::path file = argv[i];
      const MappedFile packed(file);
      const std::filesystem::path plain = std::filesystem::path(file).replace_extension(".las");
      std::string las;
      if (std::filesystem::exists(plain)) las = std::string(MappedFile(plain).bytes());
      measure(file.filename(), packed.bytes(), las);
    }
    if (argc > 1) return 0;
    measureMade("made, format 3", 3);
    measureMade("made, format 7", 7);
    measureFirstView();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
