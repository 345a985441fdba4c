// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/read_scan.h"

#include <string>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/mapped_file.h"

namespace relievo {

void refuseScan(const std::filesystem::path& file, std::string_view reason) {
  throw FileError("Cannot read " + shownName(file) + ": " + printable(reason));
}

void handleShortfall(const Shortfall& shortfall, const ReadJob& job, ScanInfo& info) {
  const std::string records(shortfall.records);
  const std::string found = grouped(shortfall.found);
  if (job.options.accept_incomplete) {
    info.warnings.push_back("The file is incomplete: its header promises " +
                            grouped(shortfall.promised) + " " + records + ", it ends at " + found +
                            ". What is there was loaded.");
    return;
  }
  std::string message = "Cannot read " + shownName(job.file) + ": header promises " +
                        grouped(shortfall.promised) + " " + records + ", file ends at " + found +
                        ". Nothing was loaded. ";
  if (shortfall.complete_points == 0) throw FileError(message + "Choose another file.");
  message += "Load the " + grouped(shortfall.complete_points) + " ";
  message += records == "faces" ? "points and " + found + " complete faces" : "complete points";
  throw FileError(message + ", or choose another file.", "E101");
}

Scan readScanHere(const std::filesystem::path& file, const ImportOptions& options, const Task& task,
                  UnpackLzf unpack_lzf) {
  const MappedFile mapped(file);
  const ReadJob job{file, mapped.bytes(), options, task, unpack_lzf};
  const FoundFormat found = findFormat(job.bytes.substr(0, kSniffedBytes), file, job.bytes.size());
  checkReadableAsScan(found, file);
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
    default:
      return readText(job);
  }
}

}  // namespace relievo
