// SPDX-License-Identifier: BSD-3-Clause
// LAS 1.0 to 1.4, LAZ and COPC. Every point format starts with the coordinates; the rest of a
// record is not needed here. Points marked as withheld or noise are loaded as well.
#include <algorithm>
#include <string>

#include "core/io/las_header.h"
#include "core/io/las_records.h"
#include "core/io/las_unit.h"
#include "core/io/read_scan.h"
#include "core/io/scalar.h"
#include "core/io/scan_builder.h"

namespace relievo {
namespace {

void readPoints(LasRecords& records, const LasHeader& header, ScanBuilder& builder) {
  records.forEachBlock([&](const char* at, std::size_t count) {
    const auto coordinate = [&](std::size_t axis) {
      const auto stored = loadAs<std::int32_t>(at + 4 * axis, ByteOrder::little);
      return static_cast<double>(stored) * header.scale[axis] + header.offset[axis];
    };
    for (std::size_t i = 0; i < count; ++i, at += header.record_bytes) {
      builder.addPoint(coordinate(0), coordinate(1), coordinate(2));
    }
  });
}

}  // namespace

Scan readLas(const ReadJob& job) {
  ScanBuilder builder(job.file, job.options.max_points);
  ScanInfo& info = builder.info();
  const LasHeader header = parseLasHeader(job.bytes, job.file);
  info.format = (header.packed ? "LAZ 1." : "LAS 1.") + std::to_string(header.minor) +
                " point format " + std::to_string(header.point_format);
  LasRecords records(job, header, kLazCoordinates);
  const std::uint64_t found = records.count();
  if (found < header.points) handleShortfall({"points", header.points, found, found}, job, info);
  // Later versions may keep waveforms and extended records behind the points.
  if (header.minor <= 2 && records.bytesBehind() > 0) {
    info.warnings.emplace_back(
        "Bytes after the last of the points that the header promises were "
        "ignored.");
  }
  readLasUnit(job.bytes, header, info);
  builder.expectPoints(found);
  readPoints(records, header, builder);
  for (std::string& doubt : records.doubts()) info.warnings.push_back(std::move(doubt));
  return builder.finish();
}

}  // namespace relievo
