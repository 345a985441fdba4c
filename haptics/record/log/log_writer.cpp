// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/log/log_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>

#include "core/base/failure.h"
#include "core/recording/log_checksum.h"
#include "core/recording/log_columns.h"
#include "haptics/record/recording_error.h"

namespace relievo {

namespace {
constexpr std::size_t kFlushBytes = 1U << 16U;

template <class Number>
void appendNumber(std::string& to, Number value) {
  std::array<char, 40> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc()) to.append(text.data(), end);
  to += ',';
}

void appendQuoted(std::string& to, std::string_view text) {
  to += '"';
  for (const char c : text) {
    if (c == '"') to += '"';
    to += (c == '\n' || c == '\r') ? ' ' : c;  // A row stays one line.
  }
  to += '"';
}

/// How the loop ran; and lines of which there may be any number.
struct Footer {
  std::string loop, windows;
};
Footer splitFooter(std::string_view text) {
  Footer parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const bool many = line.starts_with("window ") || line.starts_with("replay ");
    (many ? parts.windows : parts.loop).append(line).append("\n");
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

/// How many rows are among these lines: what is neither a comment nor the columns.
std::uint64_t rowsIn(std::string_view lines) {
  const std::string columns = logColumns();
  std::uint64_t rows = 0;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    rows += line.starts_with('#') || line == columns ? 0 : 1;
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return rows;
}

std::string commented(std::string_view header) {
  std::string text;
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    text.append("# ").append(header.substr(0, end)).append("\n");
    header.remove_prefix(std::min(end + 1, header.size()));
  }
  return text;
}
}  // namespace

void appendLogRow(std::string& to, const TouchRow& row, std::string_view event) {
  for (const LogColumn& column : kLogColumns) {
    if (column.type == ColumnType::text) {
      appendQuoted(to, event);
      to += ',';
    } else if (column.type == ColumnType::integer) {
      appendNumber(to, static_cast<std::int64_t>(column.value(row)));
    } else {
      appendNumber(to, column.value(row));
    }
  }
  to.back() = '\n';
}

LogWriter::LogWriter(std::filesystem::path file, std::string_view header, LogKind kind)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw recordingRefused(file_, errno);
  // What cannot be gone back in, a pipe, has no room: its last lines follow the rows.
  const bool has_room = kind == LogKind::recording && ::lseek(descriptor_, 0, SEEK_CUR) == 0;
  const std::string before =
      commented(header) + commented(has_room ? kChecksumsButRoom : kChecksums);
  const std::string columns = logColumns() + '\n';
  buffer_ = before + columns;
  if (kind != LogKind::recording) return;
  if (has_room) room_at_ = static_cast<std::int64_t>(before.size());
  const std::string sum = checksumLine(digits_, kBlockWord, "0", buffer_);
  if (!writeOut(before + (has_room ? emptyRoom() : std::string()) + columns + commented(sum))) {
    const int why = errno;
    ::close(std::exchange(descriptor_, -1));
    throw recordingRefused(file_, why);
  }
  digits_ = digitsOf(sum);
  buffer_.clear();
}

LogWriter::~LogWriter() {
  try {
    flush();
  } catch (const Error&) {
    // Said in the header: whoever wants to hear of it calls close().
  }
  if (descriptor_ >= 0) ::close(descriptor_);
}

void LogWriter::write(const HapticSample& sample, double t_s, std::string_view event) {
  if (descriptor_ < 0) return;
  if (rows_ == rows_on_disk_) unsaved_since_s_ = t_s;
  appendLogRow(buffer_, touchRow(sample, t_s), event);
  ++rows_;
  const bool is_late = unsaved_since_s_ + kMostUnsavedS <= t_s;
  if (buffer_.size() >= kFlushBytes || is_late) flush();
}

void LogWriter::keep(std::string_view lines) {
  if (descriptor_ >= 0) buffer_ += commented(lines);
}

bool LogWriter::writeOut(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
    bytes_on_disk_ += count;
  }
  return true;
}

void LogWriter::flush() {
  if (descriptor_ >= 0 && !buffer_.empty()) writeBlock(kBlockWord);
}

/// What is buffered, and its checksum; or as much of it as there is room for.
void LogWriter::writeBlock(std::string_view word) {
  const std::string sum = checksumLine(digits_, word, std::to_string(rows_), buffer_);
  const std::string line = commented(sum);
  const std::int64_t before = bytes_on_disk_;
  if (!writeOut(buffer_ + line)) {
    const int why = errno;
    const auto through = static_cast<std::size_t>(bytes_on_disk_ - before);
    bytes_on_disk_ = before;
    keepWholeRows(through < line.size() ? 0 : through - line.size());
    giveUp(why);
  }
  digits_ = digitsOf(sum);
  buffer_.clear();
  rows_on_disk_ = rows_;
}

/// The whole lines of so many bytes that are on the disk already, and their checksum over what
/// follows them there, which needs no new room.
void LogWriter::keepWholeRows(std::size_t bytes) {
  const std::size_t end = buffer_.rfind('\n', bytes == 0 ? 0 : bytes - 1);
  buffer_.resize(bytes == 0 || end == std::string::npos ? 0 : end + 1);
  rows_ = rows_on_disk_ + rowsIn(buffer_);
  const std::string line =
      commented(checksumLine(digits_, kBlockWord, std::to_string(rows_), buffer_));
  const std::int64_t at = bytes_on_disk_ + static_cast<std::int64_t>(buffer_.size());
  const ssize_t count = buffer_.empty() ? 0 : ::pwrite(descriptor_, line.data(), line.size(), at);
  bytes_on_disk_ = at + std::max<std::int64_t>(count, 0);
}

void LogWriter::giveUp(int error_number) {
  // A device such as /dev/full has no length to cut; then there is nothing to keep either.
  [[maybe_unused]] const int cut = ::ftruncate(descriptor_, bytes_on_disk_);
  ::close(descriptor_);
  descriptor_ = -1;
  buffer_.clear();
  throw recordingStopped(file_, error_number, rows_);
}

/// The last that is written, in one piece, so that a log is finished or it is not.
/// @return false: it could not be, errno says why
bool LogWriter::fillRoom(std::string lines) {
  lines += commented(checksumLine(digits_, kFinishedWord, std::to_string(rows_), lines));
  lines.insert(lines.size() - 1, kRoomBytes - lines.size(), ' ');
  const ssize_t count = ::pwrite(descriptor_, lines.data(), lines.size(), room_at_);
  return count == static_cast<ssize_t>(lines.size());
}

void LogWriter::close(std::string_view footer) {
  if (descriptor_ < 0) return;
  const Footer parts = splitFooter(footer);
  std::string loop = commented(parts.loop);
  constexpr std::size_t kMostChecksumBytes = 128;
  const bool fits = room_at_ > 0 && loop.size() + kMostChecksumBytes <= kRoomBytes;
  if (!fits) buffer_ += std::exchange(loop, {});
  buffer_ += commented(parts.windows);
  if (room_at_ > 0) {
    flush();
    if (!fillRoom(loop)) giveUp(errno);
  } else {
    writeBlock(kFinishedWord);
  }
  const int descriptor = std::exchange(descriptor_, -1);
  // Some file systems report a full disk only here.
  if (::close(descriptor) != 0) {
    throw failure<MessageId::recording_maybe_incomplete_for>(file_, std::strerror(errno));
  }
}

}  // namespace relievo
