// SPDX-License-Identifier: BSD-3-Clause
#include "tests/hostile/hostile_files.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "tests/core/io/e57_sample.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/sample_files.h"

namespace relievo::test {
namespace {

using namespace std::string_literals;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string patched(std::string bytes, std::size_t at, const std::string& value) {
  return bytes.replace(at, value.size(), value);
}

std::string endingOf(const std::string& name) {
  return name.substr(name.rfind('.'));
}

/// Bytes that are no text and start like nothing.
std::string noise(std::size_t size) {
  std::mt19937 random(7);
  std::string bytes = "\1"s;
  while (bytes.size() < size) bytes += static_cast<char>(random());
  return bytes;
}

bool isText(const HostileFile& file) {
  return file.bytes.find('\0') == std::string::npos && file.name != "heights.png";
}

/// What every format suffers alike.
void addBent(const HostileFile& good, std::vector<HostileFile>& files) {
  const auto add = [&](const std::string& how, const std::string& bytes, Outcome outcome) {
    HostileFile file = good;
    file.name = how + "_" + good.name;
    file.bytes = bytes;
    file.outcome = outcome;
    files.push_back(file);
  };
  const std::string& bytes = good.bytes;
  const std::string ending = endingOf(good.name);
  // Rows of text without a count may end anywhere.
  const bool counted = ending != ".xyz" && ending != ".csv" && ending != ".obj";
  add("empty", "", Outcome::refused);
  add("half", bytes.substr(0, bytes.size() / 2), counted ? Outcome::refused : Outcome::free);
  add("start", bytes.substr(0, 4), counted ? Outcome::refused : Outcome::free);
  add("pointer",
      "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize " +
          std::to_string(bytes.size()) + "\n",
      Outcome::refused);
  add("zeros", std::string(bytes.size(), '\0'), Outcome::refused);
  add("noise", noise(bytes.size()), Outcome::refused);
  files.push_back(
      {"misnamed_" + good.name + ".dat", bytes, Outcome::loads, good.points, good.finite});
  if (!isText(good)) return;
  add("crlf", replaced(bytes, "\n", "\r\n"), Outcome::loads);
  add("garbage", bytes.substr(0, bytes.size() - 8) + "\x07\x1B[2J{]\n", Outcome::refused);
}

/// E57: ten sound points, and a scan with another rotation and count.
std::string twoScans(const std::string& rotation, const std::string& records = "10") {
  std::string doubles;
  for (int i = 0; i < 10; ++i) doubles += bytesOf(i * 0.5);
  const std::string real = R"(type="Float")";
  E57SampleScan scan{
      "10",
      {{"cartesianX", real, doubles}, {"cartesianY", real, doubles}, {"cartesianZ", real, doubles}},
      {},
      {}};
  E57Sample sample;
  sample.add(scan);
  scan.records = records;
  scan.pose = "<pose><rotation>" + rotation + "</rotation></pose>";
  sample.add(scan);
  return sample.file();
}

/// Rows of three numbers in every text format that has them.
void addNumbers(std::vector<HostileFile>& files) {
  struct Rows {
    std::string name, rows;
    Outcome outcome;
    std::uint64_t points, finite;
  };
  const std::vector<Rows> kinds{
      {"nan", "nan nan nan\n1 2 3\n", Outcome::loads, 2, 1},
      {"inf", "1 2 3\n-inf 0 inf\n", Outcome::loads, 2, 1},
      {"all_nan", "nan 1 2\nnan nan 3\n", Outcome::refused, 0, 0},
      {"equal", "5 5 5\n5 5 5\n", Outcome::loads, 2, 2},
      {"line", "0 0 0\n1 0 0\n", Outcome::loads, 2, 2},
      {"huge", "1e30 1e30 1e30\n-1e30 0 1\n", Outcome::loads, 2, 2},
      {"beyond", "1e308 0 0\n1 2 3\n", Outcome::loads, 2, 1},
      {"overflow", "1e999 0 0\n1 2 3\n", Outcome::loads, 2, 1},
      {"utm", "512022.123 5403117.456 226.94\n512549 5403502.5 357.03\n", Outcome::loads, 2, 2},
      {"hex", "0x10 1 2\n3 4 5\n", Outcome::refused, 0, 0},
      {"words", "one two three\nfour five six\n", Outcome::refused, 0, 0},
  };
  for (const Rows& kind : kinds) {
    const auto add = [&](const std::string& ending, const std::string& bytes) {
      files.push_back(
          {"rows_" + kind.name + ending, bytes, kind.outcome, kind.points, kind.finite});
    };
    PcdWords words;
    words.points = "2";
    add(".ply", plyHeader("ascii", "2") + kind.rows);
    add(".pcd", pcdHeader(words) + kind.rows);
    add(".pts", "2\n" + kind.rows);
    add(".obj", "v " + replaced(kind.rows.substr(0, kind.rows.size() - 1), "\n", "\nv ") + "\n");
  }
}

void addLies(std::vector<HostileFile>& files) {
  const auto refused = [&](const std::string& name, const std::string& bytes) {
    files.push_back({name, bytes, Outcome::refused, 0, 0});
  };
  const auto loads = [&](const std::string& name, const std::string& bytes, std::uint64_t points) {
    files.push_back({name, bytes, Outcome::loads, points, points});
  };
  const std::string le = "binary_little_endian";
  for (const char* const count : {"0", "-1", "2147483648", "4294967295", "1099511627776",
                                  "18446744073709551616", "1e3", "ten"}) {
    const std::string n = count;
    refused("count_" + n + ".ply", plyHeader(le, n) + binaryRows<float>(10));
    PcdWords words;
    words.data = "binary";
    words.points = n;
    refused("count_" + n + ".pcd", pcdHeader(words) + binaryRows<float>(10));
    words = {};
    words.count = "1 1 " + n;
    if (n != "1") refused("field_count_" + n + ".pcd", pcdHeader(words) + textRows(10));
    refused("columns_" + n + ".ptx", n + "\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n"
                                         "0 0 1 0\n5 6 7 1\n1 2 3\n");
    refused("cells_" + n + ".asc", "ncols " + n +
                                       "\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1"
                                       "\n1 2 3 4\n");
  }
  refused("list_length.ply", plyHeader(le, "2", "float", "property list uint float a\n") +
                                 binaryRows<float>(1) + bytesOf(0xFFFFFFFFU) +
                                 binaryRows<float>(9));
  loads("faces_nowhere.ply",
        plyHeader(le, "10", "float", kPlyFaces) + binaryRows<float>(10) +
            plyTriangles({-1, 99, 2147483647, 0, 0, 0}),
        10);
  loads("extra_properties.ply",
        plyHeader("ascii", "2", "double", "property uchar red\nproperty list uchar int n\n") +
            "1 2 3 255 0\n4 5 6 7 2 8 9\n",
        2);
  loads("bom.xyz", "\xEF\xBB\xBF" + textRows(10), 10);
  loads("decimal_commas.xyz", "1,5 2,5 3,5\n2,5 3,5 4,5\n", 2);
  refused("decimal_commas.ply", plyHeader("ascii", "1") + "1,5 2,5 3,5\n");
  loads("indices_nowhere.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\nf 0 1 2\nf -9 -1 -2\nf 1//\n",
        3);
  refused("index_word.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf one two three\n");
  for (const char* const sizes : {"3 4 4", "4 4", "4 4 -4", "16 4 4"}) {
    PcdWords words;
    words.size = sizes;
    refused("size_" + replaced(sizes, " ", "_") + ".pcd", pcdHeader(words) + textRows(10));
  }
  PcdWords packed;
  packed.data = "binary_compressed";
  for (const std::uint32_t stated : {0U, 100U, 0xFFFFFFFFU}) {
    refused("lzf_" + std::to_string(stated) + ".pcd",
            pcdHeader(packed) + bytesOf(stated) + bytesOf(std::uint32_t{120}) + noise(200));
  }
  packed.points = "300000000";  // 3.6 GB
  refused("lzf_bomb.pcd", pcdHeader(packed) + bytesOf(std::uint32_t{200}) +
                              bytesOf(std::uint32_t{3600000000}) + noise(200));
  for (const std::uint32_t count : {0U, 4U, 0x7FFFFFFFU, 0xFFFFFFFFU}) {
    refused("count_" + std::to_string(count) + ".stl", binaryStl(count, 3));
  }
}

/// LAZ and COPC that promise too much, or lead astray.
void addLaz(std::vector<HostileFile>& files) {
  const auto refused = [&](const std::string& name, const std::string& bytes) {
    files.push_back({name, bytes, Outcome::refused, 0, 0});
  };
  Laz laz;
  laz.how.format = 3;
  laz.records = wanderingRecords(laz.how, 20);
  laz.chunk_points = 0xFFFFFFFEU;
  const LazBytes one = lazFile(laz);
  refused("bomb.laz", patched(one.bytes, 107, bytesOf(0xFFFFFFFDU)));
  refused("table_0.laz", patched(one.bytes, one.points_at, bytesOf(std::uint64_t{0})));
  // The list of chunks is lost; the chunk is not.
  const auto loads = [&](const std::string& name, const std::string& place_of_list) {
    files.push_back(
        {name, patched(one.bytes, one.points_at, place_of_list), Outcome::loads, 20, 20});
  };
  loads("table_far.laz", bytesOf(~std::uint64_t{1}));
  loads("table_end.laz", bytesOf(~std::uint64_t{0}));
  refused("chunks.laz", patched(one.bytes, one.table_at + 4, bytesOf(0xFFFFFFFFU)));
  refused("items.laz", patched(one.bytes, one.packing_at + 32, bytesOf(std::uint16_t{0xFFFF})));
  laz.one_stream = true;
  const LazBytes stream = lazFile(laz);
  refused("stream_bomb.laz", patched(stream.bytes, 107, bytesOf(0xFFFFFFFFU)));
  laz.one_stream = false;
  laz.how.format = 7;
  laz.records = wanderingRecords(laz.how, 20);
  laz.chunk_points = 0xFFFFFFFFU;
  laz.chunks = {5, 15};
  laz.levels = {0, 2};
  const LazBytes copc = lazFile(laz);
  refused("points_64.copc.laz", patched(copc.bytes, 247, bytesOf(std::uint64_t{1} << 63U)));
  refused("layers.copc.laz", patched(copc.bytes, copc.chunks_at[0] + 40, bytesOf(0xFFFFFFFFU)));
  refused("circle.copc.laz",
          patched(copc.bytes, copc.child_at + 16,
                  bytesOf(std::uint64_t{copc.child_at}) + bytesOf(32) + bytesOf(-1)));
  refused("page_far.copc.laz",
          patched(copc.bytes, copc.root_at + 48, bytesOf(std::uint64_t{1} << 60U)));
  refused("page_huge.copc.laz", patched(copc.bytes, copc.root_at + 56, bytesOf(0x7FFFFFE0)));
}

/// LAS, E57, 3DS and rasters by changed bytes of good ones.
void addBinaryLies(const std::vector<HostileFile>& good, std::vector<HostileFile>& files) {
  const auto of = [&](const std::string& name) {
    for (const HostileFile& file : good) {
      if (file.name == name) return file.bytes;
    }
    return std::string();
  };
  const auto refused = [&](const std::string& name, const std::string& bytes) {
    files.push_back({name, bytes, Outcome::refused, 0, 0});
  };
  const std::string las = of("old.las");
  const std::string las14 = of("new.las");
  for (const int version : {0, 5, 9, 255}) {
    refused("version_" + std::to_string(version) + ".las",
            patched(las, 25, std::string(1, static_cast<char>(version == 0 ? 200 : version))));
  }
  for (const std::uint32_t count : {0U, 11U, 0xFFFFFFFFU}) {
    refused("count_" + std::to_string(count) + ".las", patched(las, 107, bytesOf(count)));
  }
  refused("count_64.las", patched(las14, 247, bytesOf(std::uint64_t{1} << 63U)));
  refused("format_127.las", patched(las, 104, "\x3F"));
  refused("not_packed.laz", patched(las, 104, "\x80"));
  addLaz(files);
  refused("record_0.las", patched(las, 105, bytesOf(std::uint16_t{0})));
  refused("points_at_end.las", patched(las, 96, bytesOf(0xFFFFFFFFU)));
  refused("scale_nan.las", patched(las, 131, bytesOf(std::nan(""))));
  refused("offset_inf.las", patched(las, 155, bytesOf(std::numeric_limits<double>::infinity())));
  const std::string e57 = of("scan.e57");
  refused("flipped_bit.e57", patched(e57, 500, std::string(1, static_cast<char>(e57[500] ^ 1))));
  refused("cut_page.e57", e57.substr(0, e57.size() - 1024));
  refused("page_size.e57", patched(e57, 40, bytesOf(std::uint64_t{0})));
  refused("xml_far.e57", patched(e57, 24, bytesOf(~std::uint64_t{0})));
  refused("version.e57", patched(e57, 8, bytesOf(std::uint32_t{2})));
  files.push_back({"one_bad_scan.e57", twoScans("<w>7</w>"), Outcome::loads, 10, 10});
  files.push_back(
      {"endless_scan.e57", twoScans("<w>1</w>", "18446744073709551615"), Outcome::refused, 0, 0});
  const std::string three_ds = of("mesh.3ds");
  refused("chunk_0.3ds", patched(three_ds, 8, bytesOf(0U)));
  refused("chunk_huge.3ds", patched(three_ds, 8, bytesOf(0xFFFFFFFFU)));
  const std::string tiff = of("heights.tif");
  refused("directory_far.tif", patched(tiff, 4, bytesOf(0xFFFFFFF0U)));
  refused("directory_itself.tif", patched(tiff, 4, bytesOf(4U)));
  const std::string png = of("heights.png");
  refused("wide.png", patched(png, 16, "\x7F\xFF\xFF\xFF"));
  refused("checksum.png", patched(png, 29, "zzzz"));
  const std::string grid = of("heights.asc");
  refused("cell_0.asc", replaced(grid, "cellsize 1", "cellsize 0"));
  refused("cell_nan.asc", replaced(grid, "cellsize 1", "cellsize nan"));
  refused("no_height.asc",
          replaced(grid.substr(0, grid.find("\n1 2")), "cellsize 1", "cellsize 1\nNODATA_value 7") +
              "\n7 7 7 7\n7 7 7 7\n7 7 7 7\n7 7 7 7\n");
}

}  // namespace

std::vector<HostileFile> hostileFiles() {
  const std::vector<HostileFile> good = goodFiles();
  std::vector<HostileFile> files;
  for (const HostileFile& file : good) addBent(file, files);
  addNumbers(files);
  addLies(files);
  addBinaryLies(good, files);
  return files;
}

}  // namespace relievo::test
