// SPDX-License-Identifier: BSD-3-Clause
// The only file that sees PCL. Never compile it with AVX flags: Debian's PCL aligns to 16 bytes.
#include "core/io/read_pcl.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/PCLPointCloud2.h>

#include <array>
#include <cstring>
#include <string>

#include "core/io/file_check.h"
#include "core/io/read_scan.h"
#include "core/io/scalar.h"
#include "core/io/scan_builder.h"

static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "PCL would free what it did not allocate");

namespace relievo {
namespace {

struct FieldPlace {
  std::size_t offset = 0;
  ScalarType type = ScalarType::f32;
};

ScalarType scalarType(const pcl::PCLPointField& field, const std::filesystem::path& file) {
  switch (field.datatype) {
    case pcl::PCLPointField::INT8:
      return ScalarType::i8;
    case pcl::PCLPointField::UINT8:
      return ScalarType::u8;
    case pcl::PCLPointField::INT16:
      return ScalarType::i16;
    case pcl::PCLPointField::UINT16:
      return ScalarType::u16;
    case pcl::PCLPointField::INT32:
      return ScalarType::i32;
    case pcl::PCLPointField::UINT32:
      return ScalarType::u32;
    case pcl::PCLPointField::FLOAT32:
      return ScalarType::f32;
    case pcl::PCLPointField::FLOAT64:
      return ScalarType::f64;
    default:
      refuseScan(file, "its " + field.name + " coordinates are of an unknown type.");
  }
}

/// Never into pcl::PointXYZ: fields of another type than float would silently become zeros.
void take(const pcl::PCLPointCloud2& cloud, const std::filesystem::path& file,
          std::uint64_t expected, ScanBuilder& builder) {
  const std::uint64_t count = static_cast<std::uint64_t>(cloud.width) * cloud.height;
  if (count != expected || cloud.point_step == 0 || cloud.data.size() / cloud.point_step < count) {
    refuseScan(file, "it promises " + grouped(expected) + " points, but " + grouped(count) +
                         " could be read. The file is damaged; export it again.");
  }
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  std::array<FieldPlace, 3> places;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const pcl::PCLPointField* field = nullptr;
    for (const pcl::PCLPointField& candidate : cloud.fields) {
      if (candidate.name == kAxes[axis]) field = &candidate;
    }
    if (field == nullptr) {
      refuseScan(file, std::string("its points have no ") + kAxes[axis] +
                           " coordinate. Export it with x, y and z.");
    }
    places[axis] = {field->offset, scalarType(*field, file)};
    if (places[axis].offset + byteSize(places[axis].type) > cloud.point_step) {
      refuseScan(file, "its fields overlap. The file is damaged; export it again.");
    }
  }
  const auto* record = reinterpret_cast<const char*>(cloud.data.data());
  for (std::uint64_t i = 0; i < count; ++i, record += cloud.point_step) {
    std::array<double, 3> p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p[axis] = loadDouble(record + places[axis].offset, places[axis].type, ByteOrder::little);
    }
    builder.addPoint(p[0], p[1], p[2]);
  }
}

[[noreturn]] void refuseBody(const std::filesystem::path& file) {
  refuseScan(file, "its points cannot be decoded. The file is damaged; export it again.");
}

}  // namespace

void readPlyPointsByPcl(const std::filesystem::path& file, std::uint64_t expected,
                        ScanBuilder& builder) {
  pcl::PLYReader reader;
  pcl::PCLPointCloud2 cloud;
  if (reader.read(file.string(), cloud) < 0) refuseBody(file);
  take(cloud, file, expected, builder);
}

void readPcdPointsByPcl(const std::filesystem::path& file, std::uint64_t expected,
                        ScanBuilder& builder) {
  pcl::PCDReader reader;
  pcl::PCLPointCloud2 cloud;
  if (reader.read(file.string(), cloud) < 0) refuseBody(file);
  take(cloud, file, expected, builder);
}

}  // namespace relievo
