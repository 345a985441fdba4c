// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/import.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <string>
#include <utility>
#include <variant>

#include "core/base/failure.h"
#include "core/io/colour_raster.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/pcd_header.h"
#include "core/io/ply_header.h"
#include "core/io/raster.h"
#include "core/io/raster_rows.h"
#include "core/io/read_scan.h"
#include "core/io/reader_choice.h"
#include "core/io/scan_transport.h"
#include "core/io/system_unit.h"
#include "core/io/worker_process.h"

namespace relievo {
namespace {

constexpr int kRowsAtOnce = 64;  ///< Between two looks at the stop token.

/// What can be refused by the first bytes is refused here, before a process is started.
/// @return  the program that reads the rest
ImportProgram precheck(const std::filesystem::path& file, ReaderChoice choice) {
  const std::uint64_t size = checkedFileSize(file);
  const std::string head = readHead(file, kMaxHeaderBytes);
  const FoundFormat found = findFormat(std::string_view(head).substr(0, kSniffedBytes), file, size);
  checkReadableAsScan(found, file);
  std::string why_not;
  if (found.format == FileFormat::ply) {
    why_not = whyNotPcl(parsePlyHeader(head, file));
  } else if (found.format == FileFormat::pcd) {
    why_not = whyNotPcl(parsePcdHeader(head, file));
  } else {
    why_not = whyNotPcl(found.format);
  }
  if (usesPcl(choice, why_not, file)) return ImportProgram::pcl;
  // Its pictures need GDAL.
  const bool may_have_pictures =
      found.format == FileFormat::obj && head.find("mtllib ") != std::string::npos;
  return may_have_pictures ? ImportProgram::libraries : ImportProgram::own;
}

[[noreturn]] void refuseEnd(const std::filesystem::path& file, const ImportOptions& options,
                            const WorkerEnd& end) {
  const std::string words = end.last_words.empty() ? "" : " (\"" + end.last_words + "\")";
  if (!end.exited && end.number == SIGXCPU) {
    refuseScan(file, "it takes more than " +
                         grouped(static_cast<std::uint64_t>(options.max_cpu_s)) +
                         " s of processor time. Thin it out or cut it into parts first.");
  }
  if (!end.exited && end.number == SIGBUS) {
    throw failure<MessageId::file_became_shorter>(shownName(file));
  }
  if (!end.exited && end.number == SIGKILL) {
    throw failure<MessageId::import_stopped_by_system>(shownName(file));
  }
  refuseScan(file, "its reader broke down on it" + words +
                       ". The program is unharmed; the file "
                       "is probably damaged. Export it again.");
}

/// What the worker answers to `wanted`; throws what it refuses with.
template <class Wanted>
Wanted importInWorker(ImportProgram program, const std::filesystem::path& file, ImportKind kind,
                      const ImportOptions& options, const Task& task,
                      const std::filesystem::path& answer_folder = {}) {
  task.report("opening", 0);
  WorkerProcess worker(program, file, kind, options, answer_folder);
  const WorkerEnd end = worker.wait(task);
  task.check();
  WorkerAnswer answer;
  if (end.exited && end.number == 0) answer = receiveAnswer(worker.answerFd(), task);
  if (auto* wanted = std::get_if<Wanted>(&answer)) return std::move(*wanted);
  if (const auto* refusal = std::get_if<WorkerRefusal>(&answer)) {
    if (refusal->code == kMisuse) throw ArgumentError(refusal->message);
    if (const auto message = messageFromBytes(refusal->of_catalogue)) throw FileError(*message);
    throw FileError(refusal->message, refusal->code);
  }
  refuseEnd(file, options, end);
}

}  // namespace

namespace {

void convertHeights(Scan& scan, double factor) {
  if (factor == 1) return;
  scan.origin.z *= factor;
  for (auto& p : scan.points) p[2] = static_cast<float>(static_cast<double>(p[2]) * factor);
  if (!scan.info.bounds) return;
  scan.info.bounds->min.z *= factor;
  scan.info.bounds->max.z *= factor;
}

}  // namespace

Scan importScan(const std::filesystem::path& file, const ImportOptions& options, const Task& task) {
  task.check();
  Scan scan = importInWorker<Scan>(precheck(file, options.scan.reader), file, ImportKind::scan,
                                   options, task);
  scan.info.file = file;
  if (scan.info.reader.empty()) scan.info.reader = "relievo";
  if (scan.info.format.starts_with("LAS") || scan.info.format.starts_with("LAZ")) {
    convertHeights(scan, addUnitOfSystem(file, scan.info));
  }
  return scan;
}

namespace {

/// @throw FileError  nobody but a map's reader wants it
void refuseColours(const RasterRows& rows, const std::filesystem::path& file) {
  const std::string& format = rows.head().info.format;
  if (format != kColourRasterFormat && format != kIntensityRasterFormat) return;
  const std::string name = shownName(file);
  if (format == kColourRasterFormat) throw failure<MessageId::raster_holds_colours>(name);
  throw failure<MessageId::raster_holds_intensities>(name);
}

/// Calls pixel(index, colour, alpha) for every cell of a companion. Nothing, and a warning, if it
/// does not belong to the map.
template <class Visit>
bool readCompanion(const std::filesystem::path& file, std::string_view format, RasterMap& map,
                   std::uint64_t checksum, const ImportOptions& options, const Task& task,
                   const Visit& pixel) {
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) return false;
  const auto drop = [&](const std::string& reason) {
    map.info.warnings.push_back(shownName(file) + " " + reason + " and was left aside.");
    return false;
  };
  try {
    const auto rows = importInWorker<RasterRows>(ImportProgram::libraries, file, ImportKind::raster,
                                                 options, task);
    const RasterHead& head = rows.head();
    if (head.info.format != format) return drop("was not written with the map");
    if (head.size.cols != 2 * map.size.cols || head.size.rows != map.size.rows ||
        head.projection != std::to_string(checksum) || head.set != map.set) {
      return drop("belongs to another map");
    }
    const auto cols = static_cast<std::size_t>(map.size.cols);
    std::vector<float> row(2 * cols);
    const auto whole = [](float value, float most) {  // What a worker sends may be anything.
      return value >= 0 && value <= most ? static_cast<std::uint32_t>(value) : 0U;
    };
    for (int r = 0; r < map.size.rows; ++r) {
      if (r % kRowsAtOnce == 0) task.check();
      rows.read(r, 1, row.data(), nullptr);
      for (std::size_t i = 0; i < cols; ++i) {
        const std::size_t cell = map.size.index({.col = static_cast<int>(i), .row = r});
        const bool none =
            !map.valid[cell] || (!map.origins.empty() && (map.origins[cell] == Origin::base_plane ||
                                                          map.origins[cell] == Origin::outside));
        const std::uint32_t alpha = none ? 0 : whole(row[cols + i], 255);
        pixel(cell, alpha > 0 ? whole(row[i], 16777215) : 0, static_cast<std::uint8_t>(alpha));
      }
    }
  } catch (const FileError&) {
    return drop("cannot be read");
  }
  return true;
}

void readColours(RasterMap& map, const ImportOptions& options, const Task& task) {
  const std::filesystem::path& file = map.info.file;
  std::error_code missing;
  const bool colours = std::filesystem::exists(colourFileOf(file), missing);
  const bool intensities = std::filesystem::exists(intensityFileOf(file), missing);
  if (!map.is_own_map || (!colours && !intensities)) return;
  const std::uint64_t checksum = heightsChecksum(map.values);
  map.colours.colours.resize(colours ? map.size.count() : 0);
  const bool has_colours =
      readCompanion(colourFileOf(file), kColourRasterFormat, map, checksum, options, task,
                    [&](std::size_t cell, std::uint32_t rgb, std::uint8_t alpha) {
                      map.colours.colours[cell] = {static_cast<std::uint8_t>(rgb >> 16U),
                                                   static_cast<std::uint8_t>(rgb >> 8U),
                                                   static_cast<std::uint8_t>(rgb), alpha};
                    });
  if (!has_colours) map.colours.colours = {};
  map.colours.intensities.resize(intensities ? map.size.count() : 0);
  const bool has_intensities =
      readCompanion(intensityFileOf(file), kIntensityRasterFormat, map, checksum, options, task,
                    [&](std::size_t cell, std::uint32_t grey, std::uint8_t alpha) {
                      map.colours.intensities[cell] = {static_cast<std::uint8_t>(grey), alpha};
                    });
  if (!has_intensities) map.colours.intensities = {};
}

}  // namespace

RasterRows importRasterRows(const std::filesystem::path& file, const std::filesystem::path& folder,
                            const ImportOptions& options, const Task& task) {
  task.check();
  checkedFileSize(file);
  auto rows = importInWorker<RasterRows>(ImportProgram::libraries, file, ImportKind::raster_rows,
                                         options, task, folder.empty() ? "." : folder);
  rows.nameFile(file);
  refuseColours(rows, file);
  return rows;
}

RasterMap importRaster(const std::filesystem::path& file, const ImportOptions& options,
                       const Task& task) {
  task.check();
  checkedFileSize(file);
  auto rows =
      importInWorker<RasterRows>(ImportProgram::libraries, file, ImportKind::raster, options, task);
  rows.nameFile(file);
  refuseColours(rows, file);
  RasterMap raster;
  static_cast<RasterHead&>(raster) = rows.head();
  const GridSize size = raster.size;
  raster.values.resize(size.count());
  if (rows.hasOrigins()) raster.origins.resize(size.count());
  for (int row = 0; row < size.rows; row += kRowsAtOnce) {
    task.check();
    const std::size_t start = size.index({.col = 0, .row = row});
    rows.read(row, std::min(kRowsAtOnce, size.rows - row), raster.values.data() + start,
              rows.hasOrigins() ? raster.origins.data() + start : nullptr);
  }
  raster.valid.reserve(raster.values.size());
  for (const float value : raster.values) raster.valid.push_back(!std::isnan(value));
  readColours(raster, options, task);
  return raster;
}

bool looksLikeRaster(const std::filesystem::path& file) {
  const std::uint64_t size = checkedFileSize(file);
  return isReadableRaster(findFormat(readHead(file, kSniffedBytes), file, size).format);
}

}  // namespace relievo
