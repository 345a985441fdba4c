// SPDX-License-Identifier: BSD-3-Clause
#include <gdal_priv.h>

#include <array>
#include <memory>

#include "tests/core/io/e57_sample.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/sample_files.h"
#include "tests/hostile/hostile_files.h"

namespace relievo::test {
namespace {

HostileFile good(const std::string& name, const std::string& bytes, std::uint64_t points) {
  return {name, bytes, Outcome::loads, points, points};
}

std::string threeDs() {
  const auto chunk = [](std::uint16_t kind, const std::string& body) {
    return bytesOf(kind) + bytesOf(static_cast<std::uint32_t>(6 + body.size())) + body;
  };
  const std::string vertices = chunk(0x4110, bytesOf(std::uint16_t{10}) + binaryRows<float>(10));
  std::string face;
  for (const int corner : {0, 1, 2, 0}) face += bytesOf(static_cast<std::uint16_t>(corner));
  const std::string faces = chunk(0x4120, bytesOf(std::uint16_t{1}) + face);
  const std::string name("a\0", 2);
  return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, name + chunk(0x4100, vertices + faces))));
}

std::string compressedPcd() {
  std::string columns;
  for (const double divisor : {1.0, 2.0, 4.0}) {
    for (int i = 0; i < 10; ++i) columns += bytesOf(static_cast<float>(i / divisor));
  }
  std::string packed;  // LZF literals: their number - 1, then they.
  for (std::size_t at = 0; at < columns.size(); at += 30) packed += '\x1D' + columns.substr(at, 30);
  PcdWords words;
  words.data = "binary_compressed";
  return pcdHeader(words) + bytesOf(static_cast<std::uint32_t>(packed.size())) +
         bytesOf(static_cast<std::uint32_t>(columns.size())) + packed;
}

std::string e57() {
  std::string doubles;
  for (int i = 0; i < 10; ++i) doubles += bytesOf(i * 0.5);
  const std::string real = R"(type="Float")";
  E57Sample sample;
  sample.add({"10",
              {{"cartesianX", real, doubles},
               {"cartesianY", real, doubles},
               {"cartesianZ", real, doubles}},
              {},
              {}});
  return sample.file();
}

/// 4 x 4 heights by one of GDAL's drivers.
std::string raster(const char* driver, GDALDataType type) {
  GDALAllRegister();
  auto* const drivers = GetGDALDriverManager();
  const std::unique_ptr<GDALDataset> memory(
      drivers->GetDriverByName("MEM")->Create("", 4, 4, 1, type, nullptr));
  std::array<double, 6> place{0, 1, 0, 4, 0, -1};
  memory->SetGeoTransform(place.data());
  std::array<double, 16> heights{};
  for (std::size_t i = 0; i < 16; ++i) heights[i] = static_cast<double>(i * i);
  const CPLErr error = memory->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 4, 4, heights.data(), 4,
                                                          4, GDT_Float64, 0, 0, nullptr);
  if (error != CE_None) return {};
  GDALClose(drivers->GetDriverByName(driver)->CreateCopy("/vsimem/good", memory.get(), 0, nullptr,
                                                         nullptr, nullptr));
  vsi_l_offset size = 0;
  const GByte* const bytes = VSIGetMemFileBuffer("/vsimem/good", &size, FALSE);
  std::string file(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  VSIUnlink("/vsimem/good");
  VSIUnlink("/vsimem/good.aux.xml");
  return file;
}

}  // namespace

std::vector<HostileFile> goodFiles() {
  const std::string le = "binary_little_endian";
  PcdWords binary;
  binary.data = "binary";
  Laz packed;
  packed.how.format = 1;
  packed.records = wanderingRecords(packed.how, 30);
  packed.chunk_points = 20;
  Laz copc;
  copc.how.format = 8;
  copc.records = wanderingRecords(copc.how, 30, 2);
  // None of them withheld: such points are left out.
  for (std::string& record : copc.records) record[15] = static_cast<char>(record[15] & ~0x04);
  copc.chunk_points = 0xFFFFFFFFU;
  copc.chunks = {10, 20};
  copc.levels = {0, 1};
  Las las14;
  las14.minor = 4;
  las14.format = 6;
  return {
      good("ascii.ply", plyHeader("ascii", "10") + textRows(10), 10),
      good("little.ply",
           plyHeader(le, "10", "float", kPlyFaces) + binaryRows<float>(10) +
               plyTriangles({0, 1, 2, 2, 3, 4}),
           10),
      good("big.ply", plyHeader("binary_big_endian", "10", "double") + binaryRows<double>(10, true),
           10),
      good("ascii.pcd", pcdHeader({}) + textRows(10), 10),
      good("binary.pcd", pcdHeader(binary) + binaryRows<float>(10), 10),
      good("packed.pcd", compressedPcd(), 10),
      good("mesh.obj", "v 0 0 0\nv 1 0 0.5\nv 0 1 0.25\nv 1 1 1\nf 1 2 3\nf 2 -1 3\n", 4),
      good("text.stl", asciiStl(), 6),
      good("binary.stl", binaryStl(3, 3), 9),
      good("mesh.3ds", threeDs(), 10),
      good("rows.xyz", textRows(10), 10),
      good("rows.pts", "10\n" + textRows(10), 10),
      good("rows.csv", "x,y,z,name\n" + textRows(10, ","), 10),
      good("scan.ptx",
           "5\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n1 1 1\n" +
               textRows(10).substr(textRows(1).size()),
           10),
      good("old.las", lasFile({}), 10),
      good("new.las", lasFile(las14), 10),
      good("packed.laz", lazFile(packed).bytes, 30),
      good("packed.copc.laz", lazFile(copc).bytes, 30),
      good("scan.e57", e57(), 10),
      good("heights.tif", raster("GTiff", GDT_Float32), 16),
      good("heights.png", raster("PNG", GDT_UInt16), 16),
      good("heights.asc",
           "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\n" +
               std::string("1 2 3 4\n5 6 7 8\n9 10 11 12\n13 14 15 16\n"),
           16),
  };
}

}  // namespace relievo::test
