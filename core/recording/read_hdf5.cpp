// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/read_hdf5.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/failure.h"
#include "core/hash/sha256.h"
#include "core/recording/event_row.h"
#include "core/recording/hdf5_session.h"
#include "core/recording/log_checksum.h"

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

/// gzip makes a thousandth of what it is given at best, and what is not written yet takes no room:
/// a file that claims far more than its bytes can hold is damaged, and is given no memory for it.
void requireHeld(hid_t set, std::uint64_t elements) {
  constexpr std::uint64_t kMostTimes = 1100, kNotWrittenYet = std::uint64_t{1} << 20U;
  const Id type(H5Dget_type(set), H5Tclose);
  const std::uint64_t most = H5Dget_storage_size(set) * kMostTimes + kNotWrittenYet;
  const std::size_t bytes = H5Tget_size(type);
  require(bytes == 0 || elements > most / bytes ? -1 : 0);
}

std::size_t rowsIn(hid_t set) {
  const Id space(H5Dget_space(set), H5Sclose);
  const hssize_t rows = H5Sget_simple_extent_npoints(space);
  require(rows < 0 ? -1 : 0);
  requireHeld(set, static_cast<std::uint64_t>(rows));
  return static_cast<std::size_t>(rows);
}

std::string readText(hid_t file, const char* name) {
  const Id set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  const Id type(H5Dget_type(set), H5Tclose);
  requireHeld(set, 1);
  std::string text(H5Tget_size(type), '\0');
  require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()));
  return text;
}

std::vector<double> readColumn(hid_t file, std::string_view name) {
  const Id set(H5Dopen2(file, ("log/" + std::string(name)).c_str(), H5P_DEFAULT), H5Dclose);
  std::vector<double> values(rowsIn(set));
  require(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return values;
}

bool hasColumn(hid_t file, std::string_view name) {
  return H5Lexists(file, ("log/" + std::string(name)).c_str(), H5P_DEFAULT) > 0;
}

template <class Row>
std::vector<Row> readRows(hid_t file, const char* name, hid_t type) {
  const Id set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  std::vector<Row> rows(rowsIn(set));
  if (!rows.empty()) require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()));
  return rows;
}

/// Logs of earlier versions have shorter texts, which the library brings to this length.
std::vector<EventRow> readEventRows(hid_t file) {
  return readRows<EventRow>(file, kEventsSet, eventType());
}

/// What keep() was given; logs of earlier versions have none.
std::vector<KeptLine> readLines(hid_t file) {
  if (H5Lexists(file, kLinesSet, H5P_DEFAULT) <= 0) return {};
  return readRows<KeptLine>(file, kLinesSet, textType(kLineBytes));
}

std::vector<LogEvent> eventsIn(hid_t file) {
  std::vector<LogEvent> events;
  for (EventRow& row : readEventRows(file)) {
    row.text.back() = 0;
    events.push_back({row.time_s, static_cast<std::uint64_t>(row.tick), row.text.data()});
  }
  return events;
}

std::string linesIn(hid_t file) {
  std::string lines;
  for (KeptLine& line : readLines(file)) {
    line.back() = 0;
    lines.append(line.data()).append("\n");
  }
  return lines;
}

LogCheck changed(std::uint64_t rows, std::string where) {
  return {LogCheck::State::changed, rows, std::move(where)};
}

std::string readAttribute(hid_t object, const char* name) {
  const Id attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Id type(H5Aget_type(attribute), H5Tclose);
  std::string text(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, text.data()));
  return text;
}

/// Recordings made before a column came are without it. One that was taken out is missed by the
/// checksums, which cover the values.
bool mayLack(hid_t file, const LogColumn& column) {
  return column.needed_by == LogUse::nothing && !hasColumn(file, column.name);
}

/// Units and descriptions are those of every log, so that they need no checksum.
bool areColumnsNamedRight(hid_t file) {
  return std::all_of(kNumberColumns.begin(), kNumberColumns.end(), [&](const LogColumn& column) {
    if (mayLack(file, column)) return true;
    const Id set(H5Dopen2(file, ("log/" + std::string(column.name)).c_str(), H5P_DEFAULT),
                 H5Dclose);
    return readAttribute(set, "unit") == column.unit &&
           readAttribute(set, "description") == column.description;
  });
}

/// What the first checksum covers.
std::string bytesBeforeRows(hid_t file) {
  std::string bytes;
  appendText(bytes, readText(file, "provenance"));
  appendText(bytes, readText(file, "parameters"));
  const bool has_state = H5Lexists(file, kStateSet, H5P_DEFAULT) > 0;
  appendText(bytes, has_state ? readText(file, kStateSet) : std::string());
  if (H5Lexists(file, "surface", H5P_DEFAULT) <= 0) return bytes;
  const auto heights = readRows<float>(file, "surface/depth", H5T_NATIVE_FLOAT);
  appendBytes(bytes, heights.data(), heights.size());
  const auto origins = readRows<std::uint8_t>(file, "surface/origin", H5T_NATIVE_UINT8);
  appendBytes(bytes, origins.data(), origins.size());
  return bytes;
}

/// How many rows, events and lines a checksum covers, with all before it.
struct Covered {
  std::size_t rows = 0, events = 0, lines = 0;
};

std::optional<Covered> coveredBy(std::string_view checksum_line) {
  Covered count;
  if (!checksum_line.starts_with(kBlockWord)) return std::nullopt;
  const char* at = checksum_line.data() + kBlockWord.size();
  const char* const end = checksum_line.data() + checksum_line.size();
  for (std::size_t* number : {&count.rows, &count.events, &count.lines}) {
    const auto [next, error] = std::from_chars(at, end, *number);
    if (error != std::errc() || next == end || *next != ' ') return std::nullopt;
    at = next + 1;
  }
  return count;
}

/// The blocks of a log that was not finished. [the library's turn is held]
LogCheck checkBlocks(hid_t file, const Task& task) {
  std::vector<std::string> sums;
  for (KeptLine& line : readRows<KeptLine>(file, kChecksumsSet, textType(kLineBytes))) {
    line.back() = 0;
    sums.emplace_back(line.data());
  }
  const std::string first = checksumLine({}, kBlockWord, hdf5::kNothingYet, bytesBeforeRows(file));
  if (sums.empty() || sums.front() != first || !areColumnsNamedRight(file)) {
    return changed(0, "its header or its surface is not as it was written");
  }
  std::vector<std::vector<double>> columns;
  for (const LogColumn& column : kNumberColumns) {
    task.check();
    if (!mayLack(file, column)) columns.push_back(readColumn(file, column.name));
  }
  const std::vector<EventRow> events = readEventRows(file);
  const std::vector<KeptLine> lines = readLines(file);
  Covered before;
  std::string digits = digitsOf(first);
  for (std::size_t i = 1; i < sums.size(); ++i) {
    const std::optional<Covered> now = coveredBy(sums[i]);
    const bool is_possible = now && now->rows >= before.rows && now->events >= before.events &&
                             now->lines >= before.lines && now->rows <= columns.front().size() &&
                             now->events <= events.size() && now->lines <= lines.size();
    std::string block;
    for (std::size_t c = 0; is_possible && c < columns.size(); ++c) {
      if (columns[c].size() != columns.front().size()) break;
      appendBytes(block, columns[c].data() + before.rows, now->rows - before.rows);
    }
    if (is_possible) {
      appendBytes(block, events.data() + before.events, now->events - before.events);
      appendBytes(block, lines.data() + before.lines, now->lines - before.lines);
    }
    const std::string count = is_possible
                                  ? std::to_string(now->rows) + ' ' + std::to_string(now->events) +
                                        ' ' + std::to_string(now->lines)
                                  : std::string();
    if (!is_possible || sums[i] != checksumLine(digits, kBlockWord, count, block)) {
      return changed(before.rows, "what follows row " + std::to_string(before.rows) +
                                      " is not as it was written");
    }
    digits = digitsOf(sums[i]);
    before = *now;
  }
  if (columns.front().size() != before.rows) {
    return changed(before.rows, "it has rows without a checksum");
  }
  return {LogCheck::State::unfinished, before.rows, {}};
}

std::uint64_t rowsOf(hid_t file) {
  const Id set(H5Dopen2(file, "log/t_s", H5P_DEFAULT), H5Dclose);
  return rowsIn(set);
}

/// Of a file whose every byte is as it was written. [the library's turn is held]
LogCheck wholeHdf5(const std::filesystem::path& file) {
  const Id held(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  return {LogCheck::State::whole, rowsOf(held), {}};
}

/// The checksum of all that follows the user block.
std::string digitsOfFile(std::ifstream& in, const Task& task) {
  constexpr std::size_t kPieceBytes = 1U << 20U;
  std::string piece(kPieceBytes, '\0');
  Sha256 hash;
  while (in) {
    task.check();
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    hash.add(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  return hash.finish();
}

}  // namespace

LogTable readHdf5Log(const std::filesystem::path& file, LogUse use, const Task& task) {
  std::unique_lock<std::mutex> turn(library());
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // Errors are ours to tell.
  LogTable table;
  try {
    if (H5Fis_hdf5(file.c_str()) == 0) throw noRecording(file);
    const Id held(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    table.header = readText(held, "provenance");
    if (H5Lexists(held, "loop", H5P_DEFAULT) > 0) table.footer = readText(held, "loop");
    const std::string lines = linesIn(held);
    if (!lines.empty()) table.footer += '\n' + lines;
    table.events = eventsIn(held);
    for (const LogColumn& column : kNumberColumns) {
      task.check();
      if (!hasColumn(held, column.name)) {
        if (column.name == kNumberColumns.front().name) throw noRecording(file);
        if (column.needed_by <= use) throw withoutColumn(file, column.name);
        table.lacking.push_back(column.name);
        continue;
      }
      const std::vector<double> values = readColumn(held, column.name);
      if (column.name == kNumberColumns.front().name) table.rows.resize(values.size());
      if (values.size() != table.rows.size()) {
        throw failure<MessageId::log_columns_differ>(file);
      }
      turn.unlock();  // A recording may be running, and its thread must not wait for long.
      std::size_t row = 0;
      while (row < values.size() && takeValue(column, use, table.rows[row], values[row])) ++row;
      turn.lock();
      if (row < values.size()) throw badRow(file, row + 1);
    }
  } catch (const WriteError&) {
    throw failure<MessageId::log_of_another_version>(file);
  }
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
    throw failure<MessageId::not_hdf5>(file);
  }
}

bool isHdf5Log(std::string_view head) noexcept {
  return head.starts_with("\x89HDF") || head.starts_with(kUserBlockWords);
}

LogCheck checkHdf5Log(const std::filesystem::path& file, const Task& task) {
  std::ifstream in(file, std::ios::binary);
  std::string block(kUserBlockBytes, '\0');
  in.read(block.data(), static_cast<std::streamsize>(block.size()));
  block.resize(static_cast<std::size_t>(in.gcount()));
  if (block.starts_with("\x89HDF")) return {};  // Earlier builds left no room before it.
  // All before the library sees it: what was changed may be anywhere.
  const bool is_unfinished = block == userBlock({});
  const bool is_whole = !is_unfinished && in && block == userBlock(digitsOfFile(in, task));
  const std::lock_guard<std::mutex> turn(library());
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // Errors are ours to tell.
  if (is_whole) return wholeHdf5(file);
  if (!is_unfinished) {
    const bool is_log = block.starts_with(kUserBlockWords) || H5Fis_hdf5(file.c_str()) > 0;
    if (!is_log) throw noRecording(file);
    return changed(0, "its bytes are not those of which it carries the checksum");
  }
  try {
    const Id held(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    return checkBlocks(held, task);
  } catch (const WriteError&) {
    return changed(0, "a part of it cannot be read");
  } catch (const std::bad_alloc&) {
    return changed(0, "a part of it has an impossible size");
  } catch (const std::length_error&) {
    return changed(0, "a part of it has an impossible size");
  }
}

}  // namespace relievo
