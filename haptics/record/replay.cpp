// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/replay.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "haptics/record/hdf5_log.h"
#include "haptics/record/log_checksum.h"
#include "haptics/record/log_writer.h"
#include "haptics/record/recorded_loop.h"

namespace relievo {

namespace {
enum Column : std::size_t {
  kTime = 0,
  kTick = 1,
  kButtons = 21,
  kRate = 22,
  kHandX = 23,
  kAge = 29
};
static_assert(kLogColumns[kButtons].name == "buttons" && kLogColumns[kRate].name == "rate_Hz");
static_assert(kLogColumns[kHandX].name == "dev_hip_x_mm" && kLogColumns[kAge].name == "age_s");

std::string unquoted(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') ++i;  // Written twice.
    if (i < text.size()) plain += text[i];
  }
  return plain;
}

/// The numbers of a CSV row, and its one quoted field, the event.
bool parseRow(std::string_view line, std::array<double, kLogColumns.size()>& values,
              std::string& event) {
  const std::size_t quote = line.find('"'), last_quote = line.rfind('"');
  if (quote == std::string_view::npos || last_quote <= quote || quote == 0) return false;
  event = unquoted(line.substr(quote + 1, last_quote - quote - 1));
  std::string numbers(line.substr(0, quote - 1));
  numbers += line.substr(last_quote + 1);
  const char* at = numbers.data();
  const char* const end = numbers.data() + numbers.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc()) return false;
    const bool last = i + 1 == values.size();
    if (last ? next != end : (next == end || *next != ',')) return false;
    at = next + 1;
  }
  return true;
}

constexpr std::string_view kFirstColumns = "t_s,";   // Of every version.
constexpr std::string_view kNotEnded = "not ended";  // In the room of a recording's last lines.

LogTable readCsvLog(const std::filesystem::path& file, const Task& task) {
  const std::string name = "The log \"" + file.string() + "\" ";
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw FileError(name + "cannot be read.");
  LogTable table;
  bool have_columns = false;
  for (std::string line; std::getline(in, line);) {
    // Whoever wrote it was ended in the middle of a row: the ones before it are whole.
    if (in.eof() && table.header.find(kNotEnded) != std::string::npos) break;
    if (line.starts_with('#')) {
      const std::string comment = line.substr(std::min<std::size_t>(2, line.size()));
      std::string& lines = have_columns ? table.footer : table.header;
      if (!isChecksumLine(comment)) lines += comment + '\n';
      continue;
    }
    if (!have_columns) {
      if (!line.starts_with(kFirstColumns)) throw noRecording(file);
      if (line != logColumns()) throw FileError(name + "has other columns than this version's.");
      have_columns = true;
      continue;
    }
    constexpr std::size_t kRowsPerCheck = 4096;
    if (table.rows.size() % kRowsPerCheck == 0) task.check();
    LogRow& row = table.rows.emplace_back();
    std::string event;
    if (!parseRow(line, row, event)) {
      throw FileError(name + "has a row that cannot be read: number " +
                      std::to_string(table.rows.size()) + ".");
    }
    if (!event.empty()) table.events.push_back({row[kTime], tickOf(row), std::move(event)});
  }
  if (!have_columns) throw noRecording(file);
  if (table.rows.empty()) throw FileError(name + "has no rows.");
  return table;
}

std::int64_t nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
}  // namespace

FileError noRecording(const std::filesystem::path& file) {
  return FileError("\"" + file.string() +
                   "\" is no recording of relievo. Choose a .csv or .h5 file that it recorded.");
}

LogTable readLog(const std::filesystem::path& file, const Task& task) {
  const std::string ending = file.extension().string();
  return ending == ".h5" || ending == ".hdf5" ? readHdf5Log(file, task) : readCsvLog(file, task);
}

bool isRecomputed(std::string_view column) noexcept {
  constexpr std::array<std::string_view, 4> kGiven{"t_s", "buttons", "rate_Hz", "age_s"};
  return !column.starts_with("dev_hip_") &&
         std::find(kGiven.begin(), kGiven.end(), column) == kGiven.end();
}

std::uint64_t tickOf(const LogRow& row) {
  return static_cast<std::uint64_t>(row[kTick]);
}

std::int64_t nanosecondsOf(const LogRow& row) {
  return nanoseconds(row[kTime]);
}

DeviceReading readingOf(const LogRow& row, std::int64_t first_ns) {
  DeviceReading reading;
  reading.position = {row[kHandX], row[kHandX + 1], row[kHandX + 2]};
  reading.buttons = static_cast<std::uint32_t>(row[kButtons]);
  reading.time_ns = first_ns + nanosecondsOf(row) - nanoseconds(row[kAge]);
  return reading;
}

void compare(HapticSample& sample, const LogRow& row, ReplayResult& result,
             const std::function<void(const HapticSample&, double t_s)>& each) {
  sample.rate_hz = row[kRate];  // Measured, not computed.
  each(sample, row[kTime]);
  const auto values = logValues(sample, row[kTime]);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (sameBits(values[i], row[i])) continue;
    ++result.different;
    if (!result.first) {
      result.first =
          ReplayDifference{sample.tick, std::string(kLogColumns[i].name), row[i], values[i]};
    }
    return;
  }
}

ReplayResult replay(const HapticSpace& space, const HapticOptions& core_options, ForceChain chain,
                    const LogTable& log,
                    const std::function<void(const HapticSample&, double t_s)>& each,
                    const Task& task) {
  ReplayResult result;
  HapticCore core(chain);
  const std::map<std::uint64_t, LoopChange> told = loopChanges(log.footer);
  ChangeCursor changes(told);
  for (const LogRow& row : log.rows) {
    constexpr std::uint64_t kTicksPerCheck = 1024;
    if (tickOf(row) != result.ticks) {
      throw FileError("This recording cannot be replayed: samples were dropped before tick " +
                      std::to_string(result.ticks) + ".");
    }
    if (result.ticks++ % kTicksPerCheck == 0) task.check();
    changes.at(tickOf(row));
    const HapticOptions options = asTheLoopHad(core_options, changes.now().options_id);
    DeviceReading reading = readingOf(row, 0);
    changes.tell(core, options, reading);
    HapticSample sample = core.tick(space, options, reading, nanosecondsOf(row));
    compare(sample, row, result, each);
  }
  return result;
}

}  // namespace relievo
