// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/read_scan.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/mapped_file.h"
#include "core/io/worker/reader_guard.h"
#include "core/message/catalogue.h"

namespace relievo {

void throwReadError(const std::filesystem::path& file, Message reason, Message advice) {
  throw failure<MessageId::cannot_read>(
      shownName(file), WordsArgument::sentences({std::move(reason), std::move(advice)}));
}

void throwReadError(const std::filesystem::path& file, Message reason) {
  throw failure<MessageId::cannot_read>(shownName(file), WordsArgument(std::move(reason)));
}

void checkParts(const ReadJob& job, std::size_t count) {
  for (const int part : job.options.scan.parts) {
    if (part >= 1 && static_cast<std::size_t>(part) <= count) continue;
    throw FileError(
        "--parts: " + shownName(job.file) + " holds " +
            (count == 1 ? "one scan" : grouped(count) + " scans, 1 to " + grouped(count)) +
            "; there is no scan " + std::to_string(part) + ". Nothing was loaded.",
        kMisuse);
  }
}

bool isWantedPart(const ReadJob& job, std::size_t index) {
  const std::vector<int>& parts = job.options.scan.parts;
  return parts.empty() ||
         std::find(parts.begin(), parts.end(), static_cast<int>(index) + 1) != parts.end();
}

namespace {

[[noreturn]] void throwEndsEarly(const Truncation& shortfall, const ReadJob& job) {
  const std::string file = shownName(job.file);
  const CountArgument promised = CountArgument::grouped(shortfall.promised);
  const CountArgument found = CountArgument::grouped(shortfall.found);
  const CountArgument points = CountArgument::grouped(shortfall.complete_points);
  const bool none = shortfall.complete_points == 0;
  if (shortfall.records == RecordKind::faces) {
    if (none) throw failure<MessageId::file_ends_early_faces>(file, promised, found);
    throw failure<MessageId::file_ends_early_faces_with_points>(file, promised, found, points);
  }
  if (shortfall.records == RecordKind::bytes) {
    if (none) throw failure<MessageId::file_ends_early_bytes>(file, promised, found);
    throw failure<MessageId::file_ends_early_bytes_with_points>(file, promised, found, points);
  }
  if (none) throw failure<MessageId::file_ends_early>(file, promised, found);
  throw failure<MessageId::file_ends_early_with_points>(file, promised, found, points);
}

}  // namespace

void handleTruncation(const Truncation& shortfall, const ReadJob& job, ScanInfo& info) {
  if (!job.options.accept_incomplete) throwEndsEarly(shortfall, job);
  const CountArgument promised = CountArgument::grouped(shortfall.promised);
  const CountArgument found = CountArgument::grouped(shortfall.found);
  switch (shortfall.records) {
    case RecordKind::points:
      info.warnings.push_back(said<MessageId::incomplete_points>(promised, found));
      break;
    case RecordKind::faces:
      info.warnings.push_back(said<MessageId::incomplete_faces>(promised, found));
      break;
    case RecordKind::bytes:
      info.warnings.push_back(said<MessageId::incomplete_bytes>(promised, found));
      break;
  }
}

Scan readScanHere(const std::filesystem::path& file, const ImportOptions& options, const Task& task,
                  const ReadLibraries& libraries, PointSink* sink) {
  requireReadersAllowed("readScanHere");
  const MappedFile mapped(file);
  const ReadJob job{file,          mapped.bytes(),         options, task,
                    libraries.pcl, libraries.load_texture, sink};
  const FoundFormat found = findFormat(job.bytes.substr(0, kSniffedBytes), file, job.bytes.size());
  checkReadableAsScan(found, file);
  const bool may_hold_several = found.format == FileFormat::e57 || found.format == FileFormat::ptx;
  if (!may_hold_several) checkParts(job, 1);
  switch (found.format) {
    case FileFormat::ply:
      return readPly(job);
    case FileFormat::pcd:
      return readPcd(job);
    case FileFormat::obj:
      return readObj(job);
    case FileFormat::stl:
      return readStl(job);
    case FileFormat::three_ds:
      return read3ds(job);
    case FileFormat::las:
    case FileFormat::laz:
      return readLas(job);
    case FileFormat::e57:
      return readE57(job);
    case FileFormat::ptx:
      return readPtx(job);
    case FileFormat::text:
    case FileFormat::tiff:  // This one and those below were refused above.
    case FileFormat::png:
    case FileFormat::ascii_grid:
    case FileFormat::other_raster:
    case FileFormat::other:
      break;  // No default: a format without a line here does not compile.
  }
  return readText(job);
}

}  // namespace relievo
