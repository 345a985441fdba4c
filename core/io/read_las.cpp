// SPDX-License-Identifier: BSD-3-Clause
// LAS 1.0 to 1.4. Points of the classes for noise are loaded as well.
#include <algorithm>
#include <string>

#include "core/io/las_header.h"
#include "core/io/las_records.h"
#include "core/io/las_unit.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"

namespace relievo {
namespace {

constexpr std::uint64_t kReportEvery = 1 << 16;

void readPoints(const ReadJob& job, const LasHeader& header, std::uint64_t count,
                ScanBuilder& builder) {
  const char* const first =
      job.bytes.data() + std::min<std::uint64_t>(header.points_at, job.bytes.size());
  LasSurvey survey(header);
  const char* at = first;
  for (std::uint64_t i = 0; i < count && survey.look(at); ++i, at += header.record_bytes) {
    if (i % kReportEvery == 0) job.task.check();
  }
  LasRecords records(header, survey, job.options, count, builder);
  at = first;
  for (std::uint64_t i = 0; i < count; ++i, at += header.record_bytes) {
    if (i % kReportEvery == 0) {
      job.task.check();
      job.task.report("reading points", static_cast<double>(i) / static_cast<double>(count));
    }
    records.add(at);
  }
  records.finish();
}

}  // namespace

Scan readLas(const ReadJob& job) {
  ScanBuilder builder(job.file, job.options.max_points);
  ScanInfo& info = builder.info();
  LasHeader header = parseLasHeader(job.bytes, job.file);
  info.format = "LAS 1." + std::to_string(header.minor) + " point format " +
                std::to_string(header.point_format);
  const std::uint64_t size = job.bytes.size();
  const std::uint64_t room =
      header.points_at < size ? (size - header.points_at) / header.record_bytes : 0;
  const std::uint64_t found = std::min(room, header.points);
  if (found < header.points) handleShortfall({"points", header.points, found, found}, job, info);
  // Later versions may keep waveforms and extended records behind the points.
  if (header.minor <= 2 && room > found) {
    info.warnings.emplace_back(
        "Bytes after the last of the points that the header promises were "
        "ignored.");
  }
  const double factor = readLasUnit(job.bytes, header, info);
  header.scale[2] *= factor;
  header.offset[2] *= factor;
  readPoints(job, header, found, builder);
  return builder.finish();
}

}  // namespace relievo
