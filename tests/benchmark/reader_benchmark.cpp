// SPDX-License-Identifier: BSD-3-Clause
// Our readers of 10^6 points beside the libraries' of the same files and a plain copy of the same
// bytes, all in one run and one thread. `ns_per_point` is the reader alone: the file is in the page
// cache, no process is started. `times_memcpy` is its time over that of the copy. Both count the
// processor time of this thread, so that other work on the machine moves them less.
#include <benchmark/benchmark.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/PCLPointCloud2.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSimplePointsReader.h>

#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "core/io/formats/pcl_records.h"
#include "core/io/mapped_file.h"
#include "core/io/read_scan.h"

namespace {

using Points = std::vector<std::array<float, 3>>;
constexpr std::size_t kPoints = 1'000'000;

const Points& points() {
  static const Points kMade = [] {
    Points made(kPoints);
    std::mt19937_64 random(800);
    std::uniform_real_distribution<float> uniform(0, 100);
    for (auto& p : made) p = {uniform(random), uniform(random), uniform(random) / 20};
    return made;
  }();
  return kMade;
}

std::string binaryBody() {
  return {reinterpret_cast<const char*>(points().data()), kPoints * 12};
}

/// Points with so many bytes of colour behind each.
std::string colouredBody(std::size_t bytes) {
  std::string body;
  body.reserve(kPoints * (12 + bytes));
  for (const auto& p : points()) {
    body.append(reinterpret_cast<const char*>(p.data()), 12);
    body.append(bytes, static_cast<char>(body.size() % 251));
  }
  return body;
}

std::string textBody(const char* before) {
  std::string body;
  std::array<char, 96> line{};
  for (const auto& p : points()) {
    const int size = std::snprintf(line.data(), line.size(), "%s%.4f %.4f %.4f\n", before,
                                   static_cast<double>(p[0]), static_cast<double>(p[1]),
                                   static_cast<double>(p[2]));
    body.append(line.data(), static_cast<std::size_t>(size));
  }
  return body;
}

/// The files, made once and removed at the end.
class Files {
 public:
  Files()
      : folder_(std::filesystem::temp_directory_path() /
                ("relievo_readers_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    const std::string count = std::to_string(kPoints);
    const std::string ply = "element vertex " + count +
                            "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    write("binary.ply", "ply\nformat binary_little_endian 1.0\n" + ply + binaryBody());
    write("text.ply", "ply\nformat ascii 1.0\n" + ply + textBody(""));
    write("binary.pcd",
          "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
              count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n" +
              binaryBody());
    write("points.obj", textBody("v "));
    const std::string colours =
        "element vertex " + count +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nend_header\n";
    write("coloured.ply", "ply\nformat binary_little_endian 1.0\n" + colours + colouredBody(3));
    write("coloured.pcd",
          "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 "
          "1\nWIDTH " +
              count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n" +
              colouredBody(4));
    write("points.xyz", textBody(""));
  }
  ~Files() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  std::string path(const std::string& name) const { return folder_ / name; }

 private:
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  std::filesystem::path folder_;
};

const Files& files() {
  static const Files kFiles;
  return kFiles;
}

double processorSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double secondsToCopy(const std::string& file) {
  const relievo::MappedFile mapped(file);
  std::vector<char> to(mapped.bytes().size());
  const double start = processorSeconds();
  for (int i = 0; i < 10; ++i) {
    std::memcpy(to.data(), mapped.bytes().data(), to.size());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  return (processorSeconds() - start) / 10;
}

template <class Work>
void measure(benchmark::State& state, const std::string& file, Work&& work) {
  const double start = processorSeconds();
  for (auto _ : state) work();
  const double each_s = (processorSeconds() - start) / static_cast<double>(state.iterations());
  state.counters["ns_per_point"] = each_s * 1e9 / static_cast<double>(kPoints);
  state.counters["times_memcpy"] = each_s / secondsToCopy(file);
}

void readBy(benchmark::State& state, const std::string& name, relievo::ReaderChoice reader) {
  const std::string file = files().path(name);
  relievo::ImportOptions options;
  options.scan.reader = reader;
  measure(state, file, [&] {
    const relievo::Scan scan = relievo::readScanHere(
        file, options, {}, {.pcl = &relievo::pclLibrary(), .load_texture = nullptr});
    benchmark::DoNotOptimize(scan.points.data());
  });
}
void ours(benchmark::State& state, const std::string& name) {
  readBy(state, name, relievo::ReaderChoice::own);
}
/// Our header, PCL's body.
void throughPcl(benchmark::State& state, const std::string& name) {
  readBy(state, name, relievo::ReaderChoice::pcl);
}

template <class Reader>
void readByPcl(benchmark::State& state, const std::string& name) {
  const std::string file = files().path(name);
  measure(state, file, [&] {
    Reader reader;
    pcl::PCLPointCloud2 cloud;
    if (reader.read(file, cloud) < 0) state.SkipWithError("not read");
    benchmark::DoNotOptimize(cloud.data.data());
  });
}

void pclPly(benchmark::State& state, const std::string& name) {
  readByPcl<pcl::PLYReader>(state, name);
}
void pclPcd(benchmark::State& state, const std::string& name) {
  readByPcl<pcl::PCDReader>(state, name);
}
void pclObj(benchmark::State& state, const std::string& name) {
  readByPcl<pcl::OBJReader>(state, name);
}

void vtkXyz(benchmark::State& state, const std::string& name) {
  const std::string file = files().path(name);
  measure(state, file, [&] {
    const vtkNew<vtkSimplePointsReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    benchmark::DoNotOptimize(reader->GetOutput());
  });
}

BENCHMARK_CAPTURE(ours, ply_binary, "binary.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pclPly, ply_binary, "binary.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, pcd_binary, "binary.pcd")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pclPcd, pcd_binary, "binary.pcd")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(throughPcl, ply_binary, "binary.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(throughPcl, pcd_binary, "binary.pcd")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, ply_coloured, "coloured.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(throughPcl, ply_coloured, "coloured.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, pcd_coloured, "coloured.pcd")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(throughPcl, pcd_coloured, "coloured.pcd")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, ply_text, "text.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pclPly, ply_text, "text.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, obj, "points.obj")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pclObj, obj, "points.obj")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, xyz, "points.xyz")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(vtkXyz, xyz, "points.xyz")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
