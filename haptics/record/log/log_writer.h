// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "haptics/record/sample_log.h"

namespace relievo {

/// Appends one CSV row with a line end: reals in round-trip form, `event` quoted. The same for
/// recordings and for `relievo touch`.
void appendLogRow(std::string& to, const TouchRow& row, std::string_view event);

/// Writes a log file: lines that start with #, the columns, then rows, between them what keep() was
/// given, each line behind "# ", and after each piece that is written its checksum
/// (core/recording/log_checksum.h). What is on disk is always whole rows: if the disk fills up, the
/// file is cut after the last row that fits and stays readable. [one thread]
class LogWriter : public SampleLog {
 public:
  /// @param header  comment lines, each without "#"; "" for none. Separated by line ends.
  /// A recording's header is on the disk at once.
  /// @throw WriteError  the file cannot be made
  explicit LogWriter(std::filesystem::path file, std::string_view header = {},
                     LogKind kind = LogKind::stroke);
  ~LogWriter()
      override;  ///< Of a log that was not closed: the rows are written, it stays unfinished.

  void write(const HapticSample& sample, double t_s, std::string_view event = {}) override;
  void keep(std::string_view lines) override;
  /// Writes out what is buffered. @throw WriteError (E401)  as above
  void flush();
  /// Footer lines, each with "# " before it. In a recording's header, but for lines "window ..."
  /// and "replay ...": those, and a stroke's, follow the rows. From here on the log is finished.
  void close(std::string_view footer = {}) override;

  std::uint64_t rows() const noexcept override { return rows_; }
  const std::filesystem::path& file() const noexcept override { return file_; }

 private:
  bool writeOut(std::string_view text);
  void writeBlock(std::string_view word);
  void keepWholeRows(std::size_t bytes);
  bool fillRoom(std::string lines);
  [[noreturn]] void giveUp(int error_number);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::string buffer_;  // What the next checksum covers.
  std::string digits_;  // Of the last checksum.
  std::uint64_t rows_ = 0;
  std::uint64_t rows_on_disk_ = 0;
  std::int64_t bytes_on_disk_ = 0;
  double unsaved_since_s_ = 0;  // Of the first row that is buffered.
  std::int64_t room_at_ = 0;    // Where the footer's room begins; 0: there is none.
};

}  // namespace relievo
