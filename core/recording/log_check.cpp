// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/log_check.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/base/failure.h"
#include "core/recording/log_checksum.h"
#include "core/recording/read_hdf5.h"

namespace relievo {

namespace {

LogCheck changed(std::uint64_t rows, std::string where) {
  return {LogCheck::State::changed, rows, std::move(where)};
}

std::string_view commentIn(std::string_view line) {
  return line.substr(std::min<std::size_t>(2, line.size()));
}

/// The lines of a CSV log, in order, against the checksums among them.
class CsvCheck {
 public:
  explicit CsvCheck(std::ifstream& in) : in_(in) {}

  LogCheck result(const std::filesystem::path& file, const Task& task) {
    readHeader();
    for (std::uint64_t lines = 0; nextLine(); ++lines) {
      constexpr std::uint64_t kLinesPerCheck = 4096;
      if (lines % kLinesPerCheck == 0) task.check();
      takeLine();
    }
    if (in_.bad()) {
      throw failure<MessageId::log_unreadable_to_its_end>(file);
    }
    const std::string first_column = std::string(kLogColumns.front().name) + ',';
    if (!columns_.starts_with(first_column) && !is_marked_ && !has_trace_) throw noRecording(file);
    return verdict();
  }

 private:
  /// The line keeps its end, as checksums cover it. @return false: there is none
  bool nextLine() {
    if (!std::getline(in_, line_)) return false;
    if (!in_.eof()) line_ += '\n';
    return true;
  }

  void readHeader() {
    while (nextLine()) {
      if (!line_.starts_with('#')) {
        columns_ = line_;
        break;
      }
      const std::string_view comment = commentIn(line_);
      is_marked_ = is_marked_ || comment == std::string(kChecksums) + '\n';
      has_room_ = has_room_ || comment == std::string(kChecksumsButRoom) + '\n';
      has_trace_ = has_trace_ || isChecksumLine(comment);
      block_ += line_;
    }
    is_marked_ = is_marked_ || has_room_;
    if (has_room_ && block_.size() >= kRoomBytes) {
      room_ = block_.substr(block_.size() - kRoomBytes);
      block_.resize(block_.size() - kRoomBytes);
    }
    block_ += columns_;
  }

  void takeLine() {
    const bool is_comment = line_.starts_with('#');
    const std::string_view comment = is_comment ? commentIn(line_) : std::string_view();
    const bool ends = comment.starts_with(kFinishedWord);
    if (!ends && !comment.starts_with(kBlockWord)) {
      if (is_finished_) is_wrong_ = true;  // Nothing follows the end.
      rows_ += is_comment ? 0 : 1;
      // Of a log without checksums, or with a wrong one, nothing has to be kept.
      if (is_marked_ && !is_wrong_) block_ += line_;
      return;
    }
    has_trace_ = true;
    if (is_wrong_ || !is_marked_) return;
    const std::string right =
        checksumLine(before_, ends ? kFinishedWord : kBlockWord, std::to_string(rows_), block_);
    const std::string right_line = "# " + right + '\n';
    // Whoever wrote a recording was ended in the middle of this line.
    if (has_room_ && !line_.ends_with('\n') && right_line.starts_with(line_)) {
      block_ += line_;
      return;
    }
    if (is_finished_ || line_ != right_line) {
      is_wrong_ = true;
      return;
    }
    is_finished_ = ends;
    covered_ = rows_;
    before_ = digitsOf(right);
    block_.clear();
  }

  LogCheck verdict() const {
    if (!is_marked_) {
      if (!has_trace_) return {};
      return changed(0, "the line that announces its checksums is not as it was written");
    }
    if (is_wrong_ && before_.empty()) {
      return changed(0, "its header or its first rows are not as they were written");
    }
    if (is_wrong_) {
      return changed(covered_,
                     "what follows row " + std::to_string(covered_) + " is not as it was written");
    }
    if (has_room_ && !is_finished_) return verdictOfRoom();
    if (!is_finished_) {
      return changed(covered_, "its end is missing: it was cut, or ended while it was written");
    }
    return {LogCheck::State::whole, covered_, {}};
  }

  LogCheck verdictOfRoom() const {
    if (room_ == emptyRoom()) return {LogCheck::State::unfinished, covered_, {}};
    const std::size_t at = room_.rfind("# " + std::string(kFinishedWord));
    if (at == std::string::npos) return changed(covered_, "how it ended is not as it was written");
    std::string right = "# " + checksumLine(before_, kFinishedWord, std::to_string(rows_),
                                            std::string_view(room_).substr(0, at));
    right.resize(kRoomBytes - 1 - at, ' ');
    if (room_.substr(at) != right + '\n') {
      return changed(covered_,
                     "rows are missing at its end, or how it ended is not as it was "
                     "written");
    }
    if (!block_.empty()) return changed(covered_, "something was added at its end");
    return {LogCheck::State::whole, covered_, {}};
  }

  std::ifstream& in_;
  std::string line_, columns_, room_;
  std::string block_;   ///< What no checksum has covered so far.
  std::string before_;  ///< Digits of the last right checksum.
  std::uint64_t rows_ = 0, covered_ = 0;
  bool is_marked_ = false, has_room_ = false, has_trace_ = false;
  bool is_finished_ = false, is_wrong_ = false;
};

}  // namespace

LogCheck checkLog(const std::filesystem::path& file, const Task& task) {
  if (isHdf5Name(file)) return checkHdf5Log(file, task);
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw failure<MessageId::log_unreadable>(file);
  }
  return CsvCheck(in).result(file, task);
}

std::string_view name(LogCheck::State state) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"no checksum", "whole", "not finished",
                                                   "changed"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace relievo
