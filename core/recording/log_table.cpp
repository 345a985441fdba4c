// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/log_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <utility>

#include "core/base/failure.h"
#include "core/recording/log_checksum.h"
#include "core/recording/read_hdf5.h"

namespace relievo {

namespace {

constexpr std::string_view kNotEnded = "not ended";  // In the room of a recording's last lines.

/// The next field of a CSV line, without its quotes; what is quoted twice stands once.
/// @return nothing: a quote is not closed
std::optional<std::string_view> nextField(std::string_view& line, std::string& unquoted) {
  if (!line.starts_with('"')) {
    const std::string_view field = line.substr(0, line.find(','));
    line.remove_prefix(field.size());
    return field;
  }
  unquoted.clear();
  line.remove_prefix(1);
  while (true) {
    const std::size_t quote = line.find('"');
    if (quote == std::string_view::npos) return std::nullopt;
    unquoted += line.substr(0, quote);
    line.remove_prefix(quote + 1);
    if (!line.starts_with('"')) return unquoted;
    unquoted += '"';
    line.remove_prefix(1);
  }
}

/// The columns of a CSV log in its own order; null: one that this version does not know.
/// @param lacking  takes the names of those that are not there
std::vector<const LogColumn*> columnsNamed(std::string_view line, const std::filesystem::path& file,
                                           LogUse use, std::vector<std::string_view>& lacking) {
  std::vector<const LogColumn*> columns;
  std::string unquoted;
  for (bool ends = false; !ends;) {
    const auto name = nextField(line, unquoted);
    const auto* const found =
        std::find_if(kLogColumns.begin(), kLogColumns.end(),
                     [&](const LogColumn& column) { return column.name == name; });
    columns.push_back(found == kLogColumns.end() ? nullptr : found);
    ends = line.empty();
    if (!ends) line.remove_prefix(1);
  }
  const auto has = [&](const LogColumn& column) {
    return std::find(columns.begin(), columns.end(), &column) != columns.end();
  };
  if (!has(kLogColumns.front())) throw noRecording(file);
  for (const LogColumn& column : kLogColumns) {
    if (column.type == ColumnType::text || has(column)) continue;
    if (column.needed_by <= use) throw withoutColumn(file, column.name);
    lacking.push_back(column.name);
  }
  return columns;
}

/// @return false: it is no row of these columns
bool parseRow(std::string_view line, const std::vector<const LogColumn*>& columns, LogUse use,
              TouchRow& row, std::string& event) {
  std::string unquoted;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) {
      if (!line.starts_with(',')) return false;
      line.remove_prefix(1);
    }
    const auto field = nextField(line, unquoted);
    if (!field) return false;
    const LogColumn* const column = columns[i];
    if (column == nullptr) continue;
    if (column->type == ColumnType::text) {
      event = *field;
      continue;
    }
    double value = 0;
    const char* const field_end = field->data() + field->size();
    const auto [end, error] = std::from_chars(field->data(), field_end, value);
    if (error != std::errc() || end != field_end) return false;
    if (!takeValue(*column, use, row, value)) return false;
  }
  return line.empty();
}

LogTable readCsvLog(const std::filesystem::path& file, LogUse use, const Task& task) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw failure<MessageId::log_unreadable>(file);
  }
  LogTable table;
  std::vector<const LogColumn*> columns;
  for (std::string line; std::getline(in, line);) {
    // Whoever wrote it was ended in the middle of a row: the ones before it are whole.
    if (in.eof() && table.header.find(kNotEnded) != std::string::npos) break;
    if (line.ends_with('\r')) line.pop_back();  // A text editor wrote it again.
    if (line.starts_with('#')) {
      const std::string comment = line.substr(std::min<std::size_t>(2, line.size()));
      std::string& lines = columns.empty() ? table.header : table.footer;
      if (!isChecksumLine(comment)) lines += comment + '\n';
      continue;
    }
    if (columns.empty()) {
      columns = columnsNamed(line, file, use, table.lacking);
      continue;
    }
    constexpr std::size_t kRowsPerCheck = 4096;
    if (table.rows.size() % kRowsPerCheck == 0) task.check();
    TouchRow& row = table.rows.emplace_back();
    std::string event;
    if (!parseRow(line, columns, use, row, event)) throw badRow(file, table.rows.size());
    if (!event.empty()) table.events.push_back({row.t_s, row.tick, std::move(event)});
  }
  if (columns.empty()) throw noRecording(file);
  return table;
}

}  // namespace

bool takeValue(const LogColumn& column, LogUse use, TouchRow& row, double value) {
  return (use == LogUse::replay || std::isfinite(value)) && column.set_value(row, value);
}

FileError badRow(const std::filesystem::path& file, std::size_t number) {
  return failure<MessageId::log_row_unreadable>(file, number);
}

FileError noRecording(const std::filesystem::path& file) {
  return failure<MessageId::no_recording>(file);
}

FileError withoutColumn(const std::filesystem::path& file, std::string_view column) {
  return failure<MessageId::log_without_column>(file, column);
}

bool isHdf5Name(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".h5" || ending == ".hdf5";
}

LogTable readLog(const std::filesystem::path& file, LogUse use, const Task& task) {
  LogTable table = isHdf5Name(file) ? readHdf5Log(file, use, task) : readCsvLog(file, use, task);
  if (table.rows.empty()) throw failure<MessageId::log_without_rows>(file);
  return table;
}

std::string_view headerLine(std::string_view header, std::string_view word) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    const std::string_view line = header.substr(0, end);
    if (line.starts_with(word)) return line.substr(word.size());
    header.remove_prefix(std::min(end + 1, header.size()));
  }
  return {};
}

}  // namespace relievo
