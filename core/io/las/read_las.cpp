// SPDX-License-Identifier: BSD-3-Clause
// LAS 1.0 to 1.4, LAZ and COPC. Points of the classes for noise are loaded as well.
#include <algorithm>
#include <optional>
#include <string>

#include "core/io/las/las_header.h"
#include "core/io/las/las_records.h"
#include "core/io/las/las_unit.h"
#include "core/io/las/las_values.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kCheckEvery = 1 << 16;
/// All that LasPointMaker reads.
constexpr LazWanted kWanted{
    .classes = true, .flags = true, .intensities = true, .colours = true, .others = false};

/// What the records of a file hold that is not packed; of others nobody looks twice.
std::optional<LasSurvey> surveyOf(const ReadJob& job, const LasHeader& header,
                                  std::uint64_t count) {
  if (header.packed) return std::nullopt;
  LasSurvey survey(header);
  const char* at = job.bytes.data() + std::min<std::uint64_t>(header.points_at, job.bytes.size());
  for (std::uint64_t i = 0; i < count && survey.look(at); ++i, at += header.record_bytes) {
    if (i % kCheckEvery == 0) job.task.check();
  }
  return survey;
}

void readPoints(const ReadJob& job, LasRecords& records, const LasHeader& header,
                ScanBuilder& builder) {
  const std::uint64_t count = records.count();
  LasPointMaker maker(header, surveyOf(job, header, count), job.options, count, builder);
  records.forEachBlock([&](const char* at, std::size_t block) {
    for (std::size_t i = 0; i < block; ++i, at += header.record_bytes) maker.add(at);
  });
  maker.finish();
}

}  // namespace

Scan readLas(const ReadJob& job) {
  ScanBuilder builder(job.file, job.options);
  ScanInfo& info = builder.info();
  const LasHeader header = parseLasHeader(job.bytes, job.file);
  info.format = (header.packed ? "LAZ 1." : "LAS 1.") + std::to_string(header.minor) +
                " point format " + std::to_string(header.point_format);
  LasRecords records(job, header, kWanted);
  const std::uint64_t found = records.count();
  if (found < header.points)
    handleTruncation({RecordKind::points, header.points, found, found}, job, info);
  builder.requireRoom(found);
  // Later versions may keep waveforms and extended records behind the points.
  if (header.minor <= 2 && records.bytesBehind() > 0) {
    info.warnings.push_back(said<MessageId::bytes_after_points>());
  }
  const double factor = readLasUnit(job.bytes, header, info);
  LasHeader converted = header;
  converted.scale[2] *= factor;
  converted.offset[2] *= factor;
  readPoints(job, records, converted, builder);
  for (Message& doubt : records.doubts()) info.warnings.push_back(std::move(doubt));
  return builder.finish();
}

}  // namespace relievo
