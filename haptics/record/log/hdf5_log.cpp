// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/log/hdf5_log.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/hash/sha256.h"
#include "core/recording/event_row.h"
#include "core/recording/hdf5_session.h"
#include "core/recording/log_checksum.h"
#include "core/recording/log_table.h"
#include "haptics/record/log/pending_file.h"
#include "haptics/record/recording_error.h"

namespace relievo {

using hdf5::appendBytes;
using hdf5::appendText;
using hdf5::eventType;
using hdf5::Id;
using hdf5::kChecksumsSet;
using hdf5::KeptLine;
using hdf5::kEventsSet;
using hdf5::kLineBytes;
using hdf5::kLinesSet;
using hdf5::kStateSet;
using hdf5::library;
using hdf5::require;
using hdf5::textType;

namespace {
constexpr hsize_t kChunkRows = 400;  // kMostUnsavedS at 1 kHz: a chunk is written once.
constexpr hsize_t kChunkEvents = 64;
constexpr hsize_t kChunkChecksums = 16;
constexpr unsigned kDeflate = 4;

/// What the library sees of a PendingFile, which it can neither fill nor break: a library that
/// could write only a part leaves a file that nothing can read, and crashes at the program's end.
struct PendingDriver {
  H5FD_t shared{};  // The library's; the first, so that a pointer to one is one to the other.
  PendingFile* file = nullptr;
  haddr_t end = 0;  // Of the addresses in use.

  static PendingDriver& of(H5FD_t* shared) { return *reinterpret_cast<PendingDriver*>(shared); }
  static const PendingDriver& of(const H5FD_t* shared) {
    return *reinterpret_cast<const PendingDriver*>(shared);
  }
};

H5FD_t* openDriver(const char* /*name*/, unsigned flags, hid_t access, haddr_t /*most*/) {
  auto* driver = new (std::nothrow) PendingDriver;
  if (driver == nullptr) return nullptr;
  driver->file = *static_cast<PendingFile* const*>(H5Pget_driver_info(access));
  if ((flags & H5F_ACC_TRUNC) != 0) driver->file->resize(0);
  return &driver->shared;
}

herr_t readDriver(H5FD_t* shared, H5FD_mem_t /*type*/, hid_t /*how*/, haddr_t from,
                  std::size_t bytes, void* to) {
  return PendingDriver::of(shared).file->read(from, {static_cast<char*>(to), bytes}) ? 0 : -1;
}

herr_t writeDriver(H5FD_t* shared, H5FD_mem_t /*type*/, hid_t /*how*/, haddr_t at,
                   std::size_t bytes, const void* from) try {
  return PendingDriver::of(shared).file->write(at, {static_cast<const char*>(from), bytes}) ? 0
                                                                                            : -1;
} catch (const std::bad_alloc&) {
  return -1;  // The library is C.
}

H5FD_class_t pendingDriver() {
  H5FD_class_t driver{};
  driver.name = "relievo_pending";
  driver.maxaddr = (static_cast<haddr_t>(1) << 62U);
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(PendingFile*);  // NOLINT(bugprone-sizeof-expression): a pointer it is.
  driver.open = openDriver;
  driver.close = [](H5FD_t* shared) {
    delete &PendingDriver::of(shared);
    return 0;
  };
  driver.query = [](const H5FD_t*, unsigned long* features) {
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
                H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA |
                H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
  };
  driver.get_eoa = [](const H5FD_t* shared, H5FD_mem_t) { return PendingDriver::of(shared).end; };
  driver.set_eoa = [](H5FD_t* shared, H5FD_mem_t, haddr_t end) {
    PendingDriver::of(shared).end = end;
    return 0;
  };
  driver.get_eof = [](const H5FD_t* shared, H5FD_mem_t) {
    return static_cast<haddr_t>(PendingDriver::of(shared).file->size());
  };
  driver.read = readDriver;
  driver.write = writeDriver;
  driver.truncate = [](H5FD_t* shared, hid_t, hbool_t) {
    PendingDriver& own = PendingDriver::of(shared);
    own.file->resize(own.end);
    return 0;
  };
  const std::array<H5FD_mem_t, H5FD_MEM_NTYPES> map = H5FD_FLMAP_DICHOTOMY;
  std::copy(map.begin(), map.end(), std::begin(driver.fl_map));
  return driver;
}

Id accessTo(PendingFile& file) {
  static const H5FD_class_t kDriver = pendingDriver();
  const Id driver(H5FDregister(&kDriver), H5FDunregister);
  Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  PendingFile* const held = &file;
  require(H5Pset_driver(access, driver, &held));
  return access;
}

void writeAttribute(hid_t object, const char* name, std::string_view text) {
  const std::string value(text.empty() ? "-" : text);
  const Id type = textType(value.size());
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, type, value.data()));
}

/// @return  what is in the file now
std::string writeText(hid_t file, const char* name, std::string_view text) {
  std::string value(text.empty() ? "-" : text);
  const Id type = textType(value.size());
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
               H5Dclose);
  require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()));
  return value;
}

Id growingSet(hid_t group, const std::string& name, hid_t type, hsize_t chunk,
              unsigned deflate = kDeflate) {
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Id space(H5Screate_simple(1, &none, &unlimited), H5Sclose);
  const Id properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  require(H5Pset_chunk(properties, 1, &chunk));
  if (deflate > 0) require(H5Pset_deflate(properties, deflate));
  return {H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
          H5Dclose};
}

void append(hid_t set, hid_t type, hsize_t before, hsize_t count, const void* values) {
  const hsize_t after = before + count;
  require(H5Dset_extent(set, &after));
  const Id everything(H5Dget_space(set), H5Sclose);
  require(H5Sselect_hyperslab(everything, H5S_SELECT_SET, &before, nullptr, &count, nullptr));
  const Id block(H5Screate_simple(1, &count, nullptr), H5Sclose);
  require(H5Dwrite(set, type, block, everything, H5P_DEFAULT, values));
}

/// @return  heights and origins, as they are in the file now
std::string writeSurface(hid_t file, const HapticSpace& surface) {
  const Id group(H5Gcreate2(file, "surface", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  const std::array<hsize_t, 2> cells{kWindowSamples, kWindowSamples};
  const Id space(H5Screate_simple(2, cells.data(), nullptr), H5Sclose);
  const Id depth(
      H5Dcreate2(group, "depth", H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  std::vector<float> heights_mm(kWindowCount);
  std::transform(surface.samples.begin(), surface.samples.end(), heights_mm.begin(),
                 [](const SurfaceSample& sample) { return sample.height_mm; });
  require(H5Dwrite(depth, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, heights_mm.data()));
  writeAttribute(depth, "unit", "mm");
  writeAttribute(depth, "description", "heights of the window, row 0 at the lowest y");
  const Id origin(
      H5Dcreate2(group, "origin", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  require(
      H5Dwrite(origin, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, surface.origins.data()));
  writeAttribute(origin, "description",
                 "0 measured, 1 interpolated, 2 base plane, 3 steep, 4 outside");
  std::string bytes;
  appendBytes(bytes, heights_mm.data(), heights_mm.size());
  appendBytes(bytes, surface.origins.data(), surface.origins.size());
  return bytes;
}

}  // namespace

/// Every call into the library is made while its turn is held.
struct Hdf5Log::Impl {
  std::filesystem::path path;
  std::optional<PendingFile> disk;
  hid_t file = -1;
  std::vector<Id> sets;  // One per column.
  std::vector<std::vector<double>> columns{kNumberColumns.size()};
  std::vector<EventRow> events;
  std::vector<std::uint64_t> rows_of_events;
  std::vector<KeptLine> lines;
  std::uint64_t rows = 0, saved = 0, events_saved = 0, lines_saved = 0, checksums_saved = 0;
  std::string digits, next_digits;  // Of the last checksum on the disk, and of the one prepared.

  void create(std::string_view header, const HapticSpace* surface);
  void openSets();
  void prepare(std::size_t count);
  std::size_t prepareEvents(std::uint64_t before_row);
  void prepareChecksum(std::string_view count, std::string_view block);
  bool fits(std::size_t count);
  void flush();
  void saveWhatFits(int why);
  void closeFile() {
    sets.clear();
    if (file >= 0) H5Fclose(std::exchange(file, -1));
  }
  void finishDisk();
  void shut(bool is_finished);
  [[noreturn]] void giveUp(int why);
};

void Hdf5Log::Impl::create(std::string_view header, const HapticSpace* surface) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // Errors are ours to tell.
  const Id creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  require(H5Pset_userblock(creation, kUserBlockBytes));
  file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, accessTo(*disk));
  require(file < 0 ? -1 : 0);
  require(disk->write(0, userBlock({})) ? 0 : -1);
  std::string covered;
  appendText(covered, writeText(file, "provenance", header));
  const std::string_view parameters = headerLine(header, "parameters ");
  appendText(covered, writeText(file, "parameters", parameters.empty() ? "{}" : parameters));
  const std::string_view state = headerLine(header, std::string(kStateSet) + " ");
  appendText(covered, state.empty() ? std::string() : writeText(file, kStateSet, state));
  if (surface != nullptr) covered += writeSurface(file, *surface);
  const Id group(H5Gcreate2(file, "log", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  for (const LogColumn& column : kNumberColumns) {
    sets.push_back(growingSet(group, std::string(column.name), H5T_IEEE_F64LE, kChunkRows));
    writeAttribute(sets.back(), "unit", column.unit);
    writeAttribute(sets.back(), "description", column.description);
  }
  const Id type = eventType();
  [[maybe_unused]] const Id made = growingSet(file, kEventsSet, type, kChunkEvents);
  const Id line_type = textType(kLineBytes);
  [[maybe_unused]] const Id kept = growingSet(file, kLinesSet, line_type, kChunkEvents);
  [[maybe_unused]] const Id sums =
      growingSet(file, kChecksumsSet, line_type, kChunkChecksums, 0);  // Digits do not get smaller.
  prepareChecksum(hdf5::kNothingYet, covered);
  require(H5Fflush(file, H5F_SCOPE_LOCAL));
}

/// The file as the disk has it.
void Hdf5Log::Impl::openSets() {
  closeFile();
  disk->drop();
  file = H5Fopen(path.c_str(), H5F_ACC_RDWR, accessTo(*disk));
  require(file < 0 ? -1 : 0);
  for (const LogColumn& column : kNumberColumns) {
    sets.emplace_back(H5Dopen2(file, ("log/" + std::string(column.name)).c_str(), H5P_DEFAULT),
                      H5Dclose);
  }
}

/// The first rows that are held, and what happened in them; not yet on the disk.
void Hdf5Log::Impl::prepare(std::size_t count) {
  std::string block;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    append(sets[i], H5T_NATIVE_DOUBLE, saved, count, columns[i].data());
    appendBytes(block, columns[i].data(), count);
  }
  const std::size_t event_count = prepareEvents(saved + count);
  appendBytes(block, events.data(), event_count);
  // All that are held, also where some of their rows do not fit any more: a line that no row needs
  // says nothing.
  if (!lines.empty()) {
    const Id set(H5Dopen2(file, kLinesSet, H5P_DEFAULT), H5Dclose);
    const Id type = textType(kLineBytes);
    append(set, type, lines_saved, lines.size(), lines.data());
  }
  appendBytes(block, lines.data(), lines.size());
  prepareChecksum(std::to_string(saved + count) + ' ' + std::to_string(events_saved + event_count) +
                      ' ' + std::to_string(lines_saved + lines.size()),
                  block);
  require(H5Fflush(file, H5F_SCOPE_LOCAL));
}

void Hdf5Log::Impl::prepareChecksum(std::string_view count, std::string_view block) {
  const std::string text = checksumLine(digits, kBlockWord, count, block);
  assert(text.size() < kLineBytes);
  KeptLine line{};
  text.copy(line.data(), kLineBytes - 1);
  const Id set(H5Dopen2(file, kChecksumsSet, H5P_DEFAULT), H5Dclose);
  const Id type = textType(kLineBytes);
  append(set, type, checksums_saved, 1, line.data());
  next_digits = digitsOf(text);
}

/// @return  how many
std::size_t Hdf5Log::Impl::prepareEvents(std::uint64_t before_row) {
  const auto end = std::lower_bound(rows_of_events.begin(), rows_of_events.end(), before_row);
  const auto count = static_cast<hsize_t>(end - rows_of_events.begin());
  if (count == 0) return 0;
  const Id set(H5Dopen2(file, kEventsSet, H5P_DEFAULT), H5Dclose);
  const Id type = eventType();
  append(set, type, events_saved, count, events.data());
  return count;
}

void Hdf5Log::Impl::flush() {
  const std::size_t held = columns[0].size();
  if (held == 0) return;
  prepare(held);
  if (const int error = disk->commit(); error != 0) saveWhatFits(error);
  saved += held;
  events_saved += events.size();
  lines_saved += lines.size();
  ++checksums_saved;
  digits = next_digits;
  lines.clear();
  for (std::vector<double>& column : columns) column.clear();
  events.clear();
  rows_of_events.clear();
}

bool Hdf5Log::Impl::fits(std::size_t count) {
  openSets();
  prepare(count);
  return disk->takeRoom() == 0;
}

/// How long rows are, compressed, shows only when they are written. So the most for which there is
/// room are found by trying, in memory.
void Hdf5Log::Impl::saveWhatFits(int why) {
  if (disk->whole()) {
    std::size_t most = 0;
    for (std::size_t too_many = columns[0].size(); too_many - most > 1;) {
      const std::size_t middle = (most + too_many) / 2;
      (fits(middle) ? most : too_many) = middle;
    }
    openSets();
    if (most > 0) {
      prepare(most);
      if (disk->commit() == 0) saved += most;
    }
  }
  giveUp(why);
}

/// The checksum of the whole file, before it. Its place is there already: this takes no room.
void Hdf5Log::Impl::finishDisk() {
  constexpr std::uint64_t kPieceBytes = 1U << 20U;
  std::string piece;
  Sha256 hash;
  for (std::uint64_t at = kUserBlockBytes; at < disk->size(); at += piece.size()) {
    piece.resize(std::min(kPieceBytes, disk->size() - at));
    if (!disk->read(at, piece)) return;
    hash.add(piece);
  }
  if (!disk->write(0, userBlock(hash.finish()))) return;
  [[maybe_unused]] const int error = disk->commit();  // whole() says the same below.
}

/// What the library writes as it closes is kept if it can be: the file is complete without it.
void Hdf5Log::Impl::shut(bool is_finished) {
  closeFile();
  if (!disk) return;
  const int error = disk->commit();
  if (is_finished && error == 0) finishDisk();
  const bool whole = disk->whole() && disk->close() == 0;
  disk.reset();
  if (whole) return;
  throw failure<MessageId::recording_maybe_incomplete>(path);
}

/// @param why  an errno; 0: the library
void Hdf5Log::Impl::giveUp(int why) {
  rows = saved;
  closeFile();
  disk->drop();
  shut(false);
  throw recordingStopped(path, why, rows);
}

Hdf5Log::Hdf5Log(std::filesystem::path file, std::string_view header, const HapticSpace* surface)
    : impl_(std::make_unique<Impl>()) {
  Impl& log = *impl_;
  log.path = std::move(file);
  const std::lock_guard<std::mutex> turn(library());
  log.disk.emplace(log.path);
  int error = 0;
  try {
    log.create(header, surface);
    error = log.disk->commit();
    if (error == 0) {
      ++log.checksums_saved;
      log.digits = log.next_digits;
      return;
    }
  } catch (const WriteError&) {
    // Told below, with the file's name.
  }
  log.closeFile();
  log.disk.reset();
  std::error_code ignored;
  if (std::filesystem::is_regular_file(std::filesystem::symlink_status(log.path, ignored))) {
    std::filesystem::remove(log.path, ignored);
  }
  throw recordingRefused(log.path, error);
}

Hdf5Log::~Hdf5Log() {
  try {
    if (impl_->file < 0) return;
    const std::lock_guard<std::mutex> turn(library());
    impl_->flush();
    impl_->shut(false);
  } catch (const Error&) {
    // Said in the header: whoever wants to hear of it calls close().
  }
}

void Hdf5Log::write(const HapticSample& sample, double t_s, std::string_view event) {
  if (impl_->file < 0) return;
  const TouchRow touched = touchRow(sample, t_s);
  for (std::size_t i = 0; i < kNumberColumns.size(); ++i) {
    impl_->columns[i].push_back(kNumberColumns[i].value(touched));
  }
  if (!event.empty()) {
    EventRow row{t_s, static_cast<double>(sample.tick), {}};
    row.take(event);
    impl_->events.push_back(row);
    impl_->rows_of_events.push_back(impl_->rows);
  }
  ++impl_->rows;
  const bool is_late = impl_->columns[0].front() + kMostUnsavedS <= t_s;
  if (impl_->columns[0].size() < kChunkRows && !is_late) return;
  const std::lock_guard<std::mutex> turn(library());
  try {
    impl_->flush();
  } catch (const WriteError&) {
    if (!impl_->disk) throw;  // Given up already, with the reason.
    impl_->giveUp(0);
  }
}

void Hdf5Log::keep(std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    KeptLine line{};
    assert(end < kLineBytes);
    lines.substr(0, end).copy(line.data(), kLineBytes - 1);
    impl_->lines.push_back(line);
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
}

void Hdf5Log::close(std::string_view footer) {
  if (impl_->file < 0) return;
  const std::lock_guard<std::mutex> turn(library());
  try {
    impl_->flush();
    if (!footer.empty()) {
      writeText(impl_->file, "loop", footer);
      require(H5Fflush(impl_->file, H5F_SCOPE_LOCAL));
      if (const int error = impl_->disk->commit(); error != 0) impl_->giveUp(error);
    }
  } catch (const WriteError&) {
    if (!impl_->disk) throw;
    impl_->giveUp(0);
  }
  impl_->shut(true);
}

std::uint64_t Hdf5Log::rows() const noexcept {
  return impl_->rows;
}
const std::filesystem::path& Hdf5Log::file() const noexcept {
  return impl_->path;
}

}  // namespace relievo
