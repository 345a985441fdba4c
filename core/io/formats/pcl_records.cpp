// SPDX-License-Identifier: BSD-3-Clause
// With pcl_ply.cpp the only file that sees PCL. Never compile either with AVX flags: Debian's PCL
// aligns to 16 bytes.
#include "core/io/formats/pcl_records.h"

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/pcl_config.h>
#include <pcl/PCLPointCloud2.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace relievo {
namespace {

/// Of records in the processor's nearer memory, and small enough for PCL's 32-bit sums.
constexpr std::uint64_t kPcdBlock = 16384;

std::uint8_t pclType(ScalarType type) {
  using Field = pcl::PCLPointField;
  constexpr std::array<int, 10> kTypes{Field::INT8,    Field::UINT8,  Field::INT16, Field::UINT16,
                                       Field::INT32,   Field::UINT32, Field::INT64, Field::UINT64,
                                       Field::FLOAT32, Field::FLOAT64};
  return static_cast<std::uint8_t>(kTypes[static_cast<std::size_t>(type)]);
}

pcl::PCLPointField fieldOf(const StoredNumber& number, std::size_t count = 1) {
  pcl::PCLPointField field;
  field.offset = static_cast<pcl::uindex_t>(number.offset);
  field.datatype = pclType(number.type);
  field.count = static_cast<pcl::uindex_t>(count);
  return field;
}

/// PCL walks over all listed fields to see whether points are finite, so only those are listed that
/// are read. A colour is listed as a whole number: as a float many of them are no numbers.
std::vector<pcl::PCLPointField> fieldsOf(const RecordLayout& layout) {
  std::vector<pcl::PCLPointField> fields;
  for (const StoredNumber& number : layout.xyz) fields.push_back(fieldOf(number));
  if (layout.packed_colour) {
    fields.push_back(fieldOf({*layout.packed_colour, ScalarType::u32}));
  }
  if (layout.colour) {
    for (const StoredNumber& number : *layout.colour) fields.push_back(fieldOf(number));
  }
  if (layout.intensity) fields.push_back(fieldOf(*layout.intensity));
  // Names steer PCL; ours mean nothing to it.
  for (std::size_t i = 0; i < fields.size(); ++i) fields[i].name = "f" + std::to_string(i);
  return fields;
}

void shape(pcl::PCLPointCloud2& cloud, std::uint64_t points, std::size_t record_bytes) {
  cloud.width = static_cast<pcl::uindex_t>(points);
  cloud.height = 1;
  cloud.point_step = static_cast<pcl::uindex_t>(record_bytes);
  cloud.row_step = static_cast<pcl::uindex_t>(points * record_bytes);
  cloud.data.resize(points * record_bytes);
}

const unsigned char* bytesOf(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}
const char* charsOf(const pcl::PCLPointCloud2& cloud) {
  return reinterpret_cast<const char*>(cloud.data.data());
}

bool readPcdRecords(const PcdHeader& header, std::string_view records, std::uint64_t count,
                    const TakeColumns& take) {
  const RecordLayout layout = recordLayoutOf(header);
  pcl::PCDReader reader;
  pcl::PCLPointCloud2 cloud;
  cloud.fields = fieldsOf(layout);
  // Long records in smaller blocks, so that sums of bytes stay small.
  const std::uint64_t at_once =
      std::clamp<std::uint64_t>((std::uint64_t{64} << 20U) / layout.bytes, 1, kPcdBlock);
  for (std::uint64_t done = 0; done < count; done += at_once) {
    const std::uint64_t block = std::min(at_once, count - done);
    shape(cloud, block, layout.bytes);
    if (reader.readBodyBinary(bytesOf(records.substr(done * layout.bytes)), cloud, 0, false, 0) <
        0) {
      return false;
    }
    take(columnsOf(layout, charsOf(cloud)), block);
  }
  return true;
}

bool readPcdCompressed(const PcdHeader& header, std::string_view body, const TakeColumns& take) {
  const RecordLayout layout = recordLayoutOf(header);
  pcl::PCDReader reader;
  pcl::PCLPointCloud2 cloud;
  // All fields, because their order says where each column begins.
  for (const PcdField& field : header.fields) {
    cloud.fields.push_back(fieldOf({static_cast<std::size_t>(field.offset), field.type},
                                   static_cast<std::size_t>(field.count)));
    cloud.fields.back().name = "f" + std::to_string(cloud.fields.size());
  }
  shape(cloud, header.points, layout.bytes);
  if (reader.readBodyBinary(bytesOf(body), cloud, 0, true, 0) < 0) return false;
  if (cloud.data.size() != header.points * layout.bytes) return false;
  const PointColumns columns = columnsOf(layout, charsOf(cloud));
  take(columns, header.points);
  return true;
}

}  // namespace

const PclLibrary& pclLibrary() {
  // What PCL prints would become the last words of the import program.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  static const PclLibrary kLibrary{"PCL " PCL_VERSION_PRETTY, readPcdRecords, readPcdCompressed,
                                   pclPlyLibrary().ply_records};
  return kLibrary;
}

}  // namespace relievo
