// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/hdf5_log.h"

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "haptics/record/replay.h"

namespace relievo {

namespace {
constexpr hsize_t kChunkRows = 4096;
constexpr hsize_t kChunkEvents = 64;
constexpr unsigned kDeflate = 4;
/// More than a flush can write: every column's chunk as it is, the events, indices.
constexpr off_t kRoomBytes = 4 << 20;

/// The library serves one thread at a time.
std::mutex& library() {
  static std::mutex one;
  return one;
}

/// An HDF5 identifier and what closes it.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id_ < 0) throw WriteError("HDF5 refused a part of the file.", "E401");
  }
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  Id& operator=(Id&&) = delete;
  operator hid_t() const {
    return id_;
  }  // NOLINT(google-explicit-constructor): the library's type.

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status) {
  if (status < 0) throw WriteError("HDF5 could not write.", "E401");
}

Id textType(std::size_t bytes) {
  Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, bytes));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

void writeAttribute(hid_t object, const char* name, std::string_view text) {
  const std::string value(text.empty() ? "-" : text);
  const Id type = textType(value.size());
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, type, value.data()));
}

void writeText(hid_t file, const char* name, std::string_view text) {
  const std::string value(text.empty() ? "-" : text);
  const Id type = textType(value.size());
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
               H5Dclose);
  require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()));
}

Id growingSet(hid_t group, const std::string& name, hid_t type, hsize_t chunk) {
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Id space(H5Screate_simple(1, &none, &unlimited), H5Sclose);
  const Id properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  require(H5Pset_chunk(properties, 1, &chunk));
  require(H5Pset_deflate(properties, kDeflate));
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

void writeSurface(hid_t file, const HapticSpace& surface) {
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
}

/// What follows a word at the beginning of a header's line; empty: no such line.
std::string_view lineOf(std::string_view header, std::string_view word) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    const std::string_view line = header.substr(0, end);
    if (line.starts_with(word)) return line.substr(word.size());
    header.remove_prefix(std::min(end + 1, header.size()));
  }
  return {};
}

constexpr const char* kStateSet = "relievo:state";  // As in the CSV's comment.

constexpr const char* kEventsSet = "events";

/// One happening; the text is cut to what fits.
struct EventRow {
  double time_s = 0;
  double tick = 0;
  std::array<char, 256> text{};

  void take(std::string_view words) {
    std::size_t bytes = std::min(words.size(), text.size() - 1);
    const auto goes_on = [&] {
      return (static_cast<unsigned char>(words[bytes]) & 0xC0U) == 0x80U;
    };
    while (bytes > 0 && bytes < words.size() && goes_on()) --bytes;  // Whole characters.
    words.copy(text.data(), bytes);
  }
};

Id eventType() {
  Id type(H5Tcreate(H5T_COMPOUND, sizeof(EventRow)), H5Tclose);
  const Id text = textType(sizeof(EventRow::text));
  require(H5Tinsert(type, "time_s", HOFFSET(EventRow, time_s), H5T_NATIVE_DOUBLE));
  require(H5Tinsert(type, "tick", HOFFSET(EventRow, tick), H5T_NATIVE_DOUBLE));
  require(H5Tinsert(type, "text", HOFFSET(EventRow, text), text));
  return type;
}
}  // namespace

namespace {
std::string readText(hid_t file, const char* name) {
  const Id set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  const Id type(H5Dget_type(set), H5Tclose);
  std::string text(H5Tget_size(type), '\0');
  require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()));
  return text;
}

std::vector<double> readColumn(hid_t file, std::string_view name) {
  const Id set(H5Dopen2(file, ("log/" + std::string(name)).c_str(), H5P_DEFAULT), H5Dclose);
  const Id space(H5Dget_space(set), H5Sclose);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  require(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return values;
}

/// Logs of earlier versions have shorter texts, which the library brings to this length.
std::vector<LogEvent> readEvents(hid_t file) {
  const Id set(H5Dopen2(file, kEventsSet, H5P_DEFAULT), H5Dclose);
  const Id space(H5Dget_space(set), H5Sclose);
  const Id type = eventType();
  std::vector<EventRow> rows(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  if (!rows.empty()) {
    require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()));
  }
  std::vector<LogEvent> events;
  for (EventRow& row : rows) {
    row.text.back() = 0;
    events.push_back({row.time_s, static_cast<std::uint64_t>(row.tick), row.text.data()});
  }
  return events;
}
}  // namespace

LogTable readHdf5Log(const std::filesystem::path& file, const Task& task) {
  const std::string name = "The log \"" + file.string() + "\" ";
  std::unique_lock<std::mutex> turn(library());
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // Errors are ours to tell.
  LogTable table;
  try {
    const Id held(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    table.header = readText(held, "provenance");
    if (H5Lexists(held, "loop", H5P_DEFAULT) > 0) table.footer = readText(held, "loop");
    table.events = readEvents(held);
    for (std::size_t i = 0; i < kLogColumns.size(); ++i) {
      task.check();
      const std::vector<double> values = readColumn(held, kLogColumns[i].name);
      if (i == 0) table.rows.resize(values.size());
      if (values.size() != table.rows.size()) throw FileError(name + "has columns of two lengths.");
      turn.unlock();  // A recording may be running, and its thread must not wait for long.
      for (std::size_t row = 0; row < values.size(); ++row) table.rows[row][i] = values[row];
      turn.lock();
    }
  } catch (const WriteError&) {
    throw FileError(name + "cannot be read as a log of this version.");
  }
  if (table.rows.empty()) throw FileError(name + "has no rows.");
  return table;
}

std::optional<std::string> hdf5State(const std::filesystem::path& file) {
  const std::lock_guard<std::mutex> turn(library());
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  try {
    const Id held(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (H5Lexists(held, kStateSet, H5P_DEFAULT) <= 0) return std::nullopt;
    return readText(held, kStateSet);
  } catch (const WriteError&) {
    throw FileError("\"" + file.string() + "\" cannot be read as HDF5.");
  }
}

/// Every call into the library is made while its turn is held.
struct Hdf5Log::Impl {
  std::filesystem::path path;
  hid_t file = -1;
  int descriptor = -1;   // Of the same file, to take room and give it back.
  std::vector<Id> sets;  // One per column.
  std::vector<std::vector<double>> columns{kLogColumns.size()};
  std::vector<EventRow> events;
  std::uint64_t rows = 0, saved = 0, events_saved = 0;

  void create(std::string_view header, const HapticSpace* surface);
  void takeRoom(std::size_t more_bytes = 0);
  void giveBackRoom();
  void flush();
  void saveEvents();
  void shut() {
    sets.clear();
    if (file >= 0) H5Fclose(std::exchange(file, -1));
    if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
  }
  [[noreturn]] void giveUp(const char* why) {
    rows = saved;
    shut();
    throw WriteError(std::string("Recording stopped: ") + why + ". " + std::to_string(rows) +
                         " samples are saved and complete in \"" + path.string() + "\".",
                     "E401");
  }
};

/// A file that the library could write only a part of is lost with all that was recorded before.
/// So the room is taken first, and without it nothing is begun.
void Hdf5Log::Impl::takeRoom(std::size_t more_bytes) {
  haddr_t end = 0;
  require(H5Fget_eoa(file, &end));
  const off_t bytes = kRoomBytes + static_cast<off_t>(more_bytes);
  const int error = ::posix_fallocate(descriptor, static_cast<off_t>(end), bytes);
  if (error == 0) return;
  giveBackRoom();
  const bool full = error == ENOSPC || error == EFBIG || error == EDQUOT;
  giveUp(full ? "disk full" : std::strerror(error));
}

void Hdf5Log::Impl::giveBackRoom() {
  haddr_t end = 0;
  require(H5Fget_eoa(file, &end));
  if (::ftruncate(descriptor, static_cast<off_t>(end)) != 0) giveUp(std::strerror(errno));
}

void Hdf5Log::Impl::create(std::string_view header, const HapticSpace* surface) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // Errors are ours to tell.
  file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (file >= 0) descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0 || descriptor < 0) {
    throw WriteError("The recording \"" + path.string() +
                     "\" cannot be written. Choose another place.");
  }
  writeText(file, "provenance", header);
  const std::string_view parameters = lineOf(header, "parameters ");
  writeText(file, "parameters", parameters.empty() ? "{}" : parameters);
  const std::string_view state = lineOf(header, std::string(kStateSet) + " ");
  if (!state.empty()) writeText(file, kStateSet, state);
  if (surface != nullptr) writeSurface(file, *surface);
  const Id group(H5Gcreate2(file, "log", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  for (const LogColumn& column : kLogColumns) {
    sets.push_back(growingSet(group, std::string(column.name), H5T_IEEE_F64LE, kChunkRows));
    writeAttribute(sets.back(), "unit", column.unit);
    writeAttribute(sets.back(), "description", column.description);
  }
  const Id type = eventType();
  [[maybe_unused]] const Id made = growingSet(file, kEventsSet, type, kChunkEvents);
  require(H5Fflush(file, H5F_SCOPE_LOCAL));
}

void Hdf5Log::Impl::flush() {
  const auto count = static_cast<hsize_t>(columns[0].size());
  if (count == 0) return;
  takeRoom();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    append(sets[i], H5T_NATIVE_DOUBLE, saved, count, columns[i].data());
    columns[i].clear();
  }
  saveEvents();
  require(H5Fflush(file, H5F_SCOPE_LOCAL));
  saved += count;
  giveBackRoom();  // Until the next flush the file is complete, whatever becomes of the program.
}

void Hdf5Log::Impl::saveEvents() {
  if (events.empty()) return;
  const Id set(H5Dopen2(file, kEventsSet, H5P_DEFAULT), H5Dclose);
  const Id type = eventType();
  append(set, type, events_saved, events.size(), events.data());
  events_saved += events.size();
  events.clear();
}

Hdf5Log::Hdf5Log(std::filesystem::path file, std::string_view header, const HapticSpace* surface)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = std::move(file);
  const std::lock_guard<std::mutex> turn(library());
  try {
    impl_->create(header, surface);
  } catch (const WriteError&) {
    impl_->shut();
    throw;
  }
}

Hdf5Log::~Hdf5Log() {
  try {
    close();
  } catch (const Error&) {
    // Said in the header: whoever wants to hear of it calls close().
  }
}

void Hdf5Log::write(const HapticSample& sample, double t_s, std::string_view event) {
  if (impl_->file < 0) return;
  const auto values = logValues(sample, t_s);
  for (std::size_t i = 0; i < values.size(); ++i) impl_->columns[i].push_back(values[i]);
  if (!event.empty()) {
    EventRow row{t_s, static_cast<double>(sample.tick), {}};
    row.take(event);
    impl_->events.push_back(row);
  }
  ++impl_->rows;
  if (impl_->columns[0].size() < kChunkRows) return;
  const std::lock_guard<std::mutex> turn(library());
  try {
    impl_->flush();
  } catch (const WriteError&) {
    if (impl_->file < 0) throw;  // Given up already, with the reason.
    impl_->giveUp("HDF5 could not write");
  }
}

void Hdf5Log::close(std::string_view footer) {
  if (impl_->file < 0) return;
  const std::lock_guard<std::mutex> turn(library());
  try {
    impl_->flush();
    if (!footer.empty()) {
      impl_->takeRoom(footer.size());
      writeText(impl_->file, "loop", footer);
      require(H5Fflush(impl_->file, H5F_SCOPE_LOCAL));
      impl_->giveBackRoom();
    }
  } catch (const WriteError&) {
    if (impl_->file < 0) throw;
    impl_->giveUp("HDF5 could not write");
  }
  impl_->sets.clear();
  const bool closed = H5Fclose(std::exchange(impl_->file, -1)) >= 0;
  impl_->shut();
  if (!closed) {
    throw WriteError("The recording \"" + impl_->path.string() + "\" may be incomplete.", "E401");
  }
}

std::uint64_t Hdf5Log::rows() const noexcept {
  return impl_->rows;
}
const std::filesystem::path& Hdf5Log::file() const noexcept {
  return impl_->path;
}

}  // namespace relievo
