// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/import.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/import_input.h"
#include "core/io/input_facts.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/embedded_state.h"
#include "core/io/raster/picture_pixels.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/raster_rows.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/system_unit.h"
#include "core/io/worker/facts_text.h"
#include "core/io/worker/import_answer.h"
#include "core/io/worker/scan_transport.h"
#include "core/io/worker/worker_process.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr int kRowsAtOnce = 64;            ///< Between two looks at the stop token.
constexpr std::size_t kFilesAtOnce = 100;  ///< Whose names one process is told.

/// @throw FileError  the answer is another one than `Wanted`
template <class Wanted>
Wanted importInWorker(const ImportAsk& ask, const Task& task) {
  WorkerAnswer answer = importAnswer(ask, task);
  if (auto* wanted = std::get_if<Wanted>(&answer)) return std::move(*wanted);
  refuseEnd(ask.file, ask.options, {});
}

void convertHeights(Scan& scan, double factor) {
  if (factor == 1) return;
  scan.origin.z *= factor;
  for (auto& p : scan.points) p[2] = static_cast<float>(static_cast<double>(p[2]) * factor);
  if (!scan.info.bounds) return;
  scan.info.bounds->min.z *= factor;
  scan.info.bounds->max.z *= factor;
}

}  // namespace

namespace {

/// @throw FileError  the answer is no scan
Scan scanOf(WorkerAnswer answer, const std::filesystem::path& file, const ImportOptions& options) {
  Scan scan;
  if (auto* read = std::get_if<Scan>(&answer)) {
    scan = std::move(*read);
  } else if (auto* of_system = std::get_if<ScanOfSystem>(&answer)) {
    scan = std::move(of_system->scan);
    convertHeights(scan, addUnitOfSystem(of_system->system, scan.info));
  } else {
    refuseEnd(file, options, {});
  }
  scan.info.file = file;
  if (scan.info.reader.empty()) scan.info.reader = "relievo";
  return scan;
}

}  // namespace

Scan importScan(const std::filesystem::path& file, const ImportOptions& options, const Task& task) {
  task.check();
  checkedFileSize(file);
  return scanOf(importAnswer({.file = file, .kind = ImportKind::scan, .options = options}, task),
                file, options);
}

std::variant<Scan, InputFacts> importInput(const std::filesystem::path& file,
                                           const ImportOptions& options, const Task& task) {
  task.check();
  checkedFileSize(file);
  WorkerAnswer answer =
      importAnswer({.file = file, .kind = ImportKind::input, .options = options}, task);
  const auto* const text = std::get_if<WorkerText>(&answer);
  if (text == nullptr) return scanOf(std::move(answer), file, options);
  const auto found = inputFactsOf(*text);
  if (!found || found->size() != 1) refuseEnd(file, options, {});
  if (found->front()) return *found->front();
  checkedFileSize(file);  // It has gone since.
  refuseEnd(file, options, {});
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
  const auto drop = [&](Message why) {
    map.info.warnings.push_back(std::move(why));
    return false;
  };
  try {
    const auto rows = importInWorker<RasterRows>({.program = ImportProgram::libraries,
                                                  .file = file,
                                                  .kind = ImportKind::raster,
                                                  .options = options},
                                                 task);
    const RasterHead& head = rows.head();
    if (head.info.format != format)
      return drop(said<MessageId::companion_not_of_map>(shownName(file)));
    if (head.size.cols != 2 * map.size.cols || head.size.rows != map.size.rows ||
        head.projection != std::to_string(checksum) || head.set != map.set) {
      return drop(said<MessageId::companion_of_another_map>(shownName(file)));
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
        const bool none = !map.valid[cell] ||
                          (!map.origins.empty() && (map.origins[cell] == CellStatus::base_plane ||
                                                    map.origins[cell] == CellStatus::outside));
        const std::uint32_t alpha = none ? 0 : whole(row[cols + i], 255);
        pixel(cell, alpha > 0 ? whole(row[i], 16777215) : 0, static_cast<std::uint8_t>(alpha));
      }
    }
  } catch (const FileError&) {
    return drop(said<MessageId::companion_unreadable>(shownName(file)));
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
  auto rows = importInWorker<RasterRows>({.program = ImportProgram::libraries,
                                          .file = file,
                                          .kind = ImportKind::raster_rows,
                                          .options = options,
                                          .answer_folder = folder.empty() ? "." : folder},
                                         task);
  rows.nameFile(file);
  refuseColours(rows, file);
  return rows;
}

RasterMap importRaster(const std::filesystem::path& file, const ImportOptions& options,
                       const Task& task) {
  task.check();
  checkedFileSize(file);
  auto rows = importInWorker<RasterRows>({.program = ImportProgram::libraries,
                                          .file = file,
                                          .kind = ImportKind::raster,
                                          .options = options},
                                         task);
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

namespace {

/// What the program that starts soonest says of these files.
WorkerText askedOf(const std::vector<std::filesystem::path>& files, ImportKind kind,
                   const Task& task) {
  std::vector<std::string> others;
  for (std::size_t i = 1; i < files.size(); ++i) {
    others.push_back(std::filesystem::absolute(files[i]).string());
  }
  return importInWorker<WorkerText>(
      {.file = files.front(), .kind = kind, .options = {}, .more = std::move(others)}, task);
}

}  // namespace

std::vector<std::optional<InputFacts>> inputFacts(const std::vector<std::filesystem::path>& files,
                                                  const Task& task) {
  task.check();
  std::vector<std::optional<InputFacts>> facts;
  for (std::size_t first = 0; first < files.size(); first += kFilesAtOnce) {
    const std::vector<std::filesystem::path> some(
        files.begin() + static_cast<std::ptrdiff_t>(first),
        files.begin() + static_cast<std::ptrdiff_t>(std::min(first + kFilesAtOnce, files.size())));
    const auto found = inputFactsOf(askedOf(some, ImportKind::facts, task));
    if (!found || found->size() != some.size()) refuseEnd(some.front(), {}, {});
    facts.insert(facts.end(), found->begin(), found->end());
  }
  return facts;
}

std::optional<std::string> embeddedState(const std::filesystem::path& file, const Task& task) {
  task.check();
  checkedFileSize(file);
  auto state = stateOf(askedOf({file}, ImportKind::state, task));
  if (!state) refuseEnd(file, {}, {});
  return std::move(*state);
}

std::optional<StoredPixels> importPixels(const std::filesystem::path& file, const Task& task) {
  task.check();
  checkedFileSize(file);
  auto pixels = pixelsOf(importInWorker<WorkerText>({.program = ImportProgram::libraries,
                                                     .file = file,
                                                     .kind = ImportKind::pixels,
                                                     .options = {}},
                                                    task));
  if (!pixels) refuseEnd(file, {}, {});
  return std::move(*pixels);
}

InputFacts inputFacts(const std::filesystem::path& file, const Task& task) {
  checkedFileSize(file);
  const auto facts = inputFacts(std::vector{file}, task).front();
  if (facts) return *facts;
  checkedFileSize(file);  // It has gone since.
  refuseEnd(file, {}, {});
}

std::vector<std::optional<TiffHead>> importTiffHeads(
    const std::vector<std::filesystem::path>& files, const Task& task) {
  task.check();
  for (const std::filesystem::path& file : files) checkedFileSize(file);
  std::vector<std::optional<TiffHead>> heads;
  for (std::size_t first = 0; first < files.size(); first += kFilesAtOnce) {
    const std::vector<std::filesystem::path> some(
        files.begin() + static_cast<std::ptrdiff_t>(first),
        files.begin() + static_cast<std::ptrdiff_t>(std::min(first + kFilesAtOnce, files.size())));
    auto found = tiffHeadsOf(askedOf(some, ImportKind::tiff_heads, task));
    if (!found || found->size() != some.size()) refuseEnd(some.front(), {}, {});
    std::move(found->begin(), found->end(), std::back_inserter(heads));
  }
  return heads;
}

std::optional<TiffHead> importTiffHead(const std::filesystem::path& file, const Task& task) {
  return std::move(importTiffHeads({file}, task).front());
}

}  // namespace relievo
