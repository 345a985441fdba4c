// SPDX-License-Identifier: BSD-3-Clause
// Points as rows of text: XYZ, ASC, PTS, CSV, TXT.
#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/lines.h"
#include "core/io/planted_fault.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"

namespace relievo {
namespace {

constexpr std::uint64_t kReportEvery = 1 << 16;
constexpr std::size_t kMaxLine = 65536;

/// How the file separates its columns and writes its fractions.
struct RowStyle {
  char separator = 0;  ///< ';' or ',', besides blanks; 0: blanks only.
  bool decimal_comma = false;
};

/// "1,5 2,5 3,5": commas within words that blanks separate.
bool hasDecimalCommas(std::string_view line) {
  int words = 0;
  bool comma = false;
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line), ++words) {
    if (word.front() == ',' || word.back() == ',' || word.find('.') != std::string_view::npos ||
        std::count(word.begin(), word.end(), ',') > 1) {
      return false;
    }
    comma = comma || word.find(',') != std::string_view::npos;
  }
  return comma && words >= 3;
}

RowStyle styleOf(std::string_view line) {
  if (line.find(';') != std::string_view::npos) {
    return {';', line.find(',') != std::string_view::npos};
  }
  if (line.find(',') == std::string_view::npos) return {};
  if (hasDecimalCommas(line)) return {0, true};
  return {',', false};
}

/// Takes the next column off `rest`. Empty between two separators; nothing at the end.
std::optional<std::string_view> takeColumn(std::string_view& rest, char separator) {
  if (separator == 0) {
    const std::string_view word = takeWord(rest);
    return word.empty() ? std::nullopt : std::optional(word);
  }
  while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
  if (rest.empty()) return std::nullopt;
  std::size_t end = 0;
  while (end < rest.size() && rest[end] != separator && !isBlank(rest[end])) ++end;
  std::string_view column = rest.substr(0, end);
  rest.remove_prefix(end);
  while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
  if (!rest.empty() && rest.front() == separator) rest.remove_prefix(1);
  if (column.size() >= 2 && column.front() == '"' && column.back() == '"') {
    column = column.substr(1, column.size() - 2);
  }
  return column;
}

std::vector<std::string_view> columnsOf(std::string_view line, char separator) {
  std::vector<std::string_view> columns;
  while (const auto column = takeColumn(line, separator)) columns.push_back(*column);
  return columns;
}

/// A missing number ("1,,3", "NULL") is a point without a position: stored, but not finite.
std::optional<double> parseColumn(std::string_view column, bool decimal_comma) {
  constexpr std::array<std::string_view, 6> kMissing{"", "NA", "N/A", "null", "NULL", "-"};
  if (std::find(kMissing.begin(), kMissing.end(), column) != kMissing.end() ||
      column.find("#QNAN") != std::string_view::npos ||
      column.find("#IND") != std::string_view::npos) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!decimal_comma) return parseNumber(column);
  std::array<char, 64> copy{};
  if (column.size() > copy.size()) return std::nullopt;
  std::replace_copy(column.begin(), column.end(), copy.begin(), ',', '.');
  return parseNumber({copy.data(), column.size()});
}

class TextReader {
 public:
  explicit TextReader(const ReadJob& job)
      : job_(job), builder_(job.file, job.options.max_points), lines_(job.bytes) {
    if (job.bytes.starts_with("\xEF\xBB\xBF")) lines_ = Lines(job.bytes.substr(3));
  }

  Scan read() {
    builder_.info().format = "text";
    if (!nextRow()) refuseScan(job_.file, "it holds no rows of numbers. Choose another file.");
    readCountLine();
    if (!at_end_) readHeader();
    while (!at_end_) {
      if (builder_.pointCount() % kReportEvery == 0) report();
      if (!readRow()) break;
      nextRow();
    }
    checkCount();
    if (style_.decimal_comma) {
      builder_.info().warnings.emplace_back("Commas were read as decimal points.");
    }
    return builder_.finish();
  }

 private:
  void report() const {
    job_.task.check();
    const std::size_t read = job_.bytes.size() - lines_.rest().size();
    job_.task.report("reading points",
                     static_cast<double>(read) / static_cast<double>(job_.bytes.size()));
  }

  /// Moves to the next line that is neither empty nor a comment. @return  false at the end
  bool nextRow() {
    while (lines_.next()) {
      if (lines_.line().size() > kMaxLine) {
        refuseScan(job_.file, "line " + std::to_string(lines_.number()) +
                                  " is longer than 64 kB. It is no file of points.");
      }
      const std::string_view line = trimmed(lines_.line());
      if (!line.empty() && !line.starts_with('#') && !line.starts_with("//")) return true;
    }
    at_end_ = true;
    return false;
  }

  [[noreturn]] void refuseRow() const {
    const std::string shown(trimmed(lines_.line()).substr(0, 60));
    refuseScan(job_.file, "line " + std::to_string(lines_.number()) + " (\"" + shown +
                              "\") does not start with three numbers. Correct the line, or choose "
                              "another file.");
  }

  /// PTS files start with the number of points.
  void readCountLine() {
    std::string_view rest = lines_.line();
    const auto count = parseWhole<std::uint64_t>(takeWord(rest));
    if (!count || !takeWord(rest).empty()) return;
    promised_ = count;
    nextRow();
  }

  void readHeader() {
    style_ = styleOf(lines_.line());
    std::string_view rest = lines_.line();
    for (int i = 0; i < 3; ++i) {
      const auto column = takeColumn(rest, style_.separator);
      if (column && !column->empty() && !parseColumn(*column, style_.decimal_comma)) {
        takeNames();
        return;
      }
    }
  }

  /// The first row holds no numbers: it names the columns.
  void takeNames() {
    const std::uint64_t line = lines_.number();
    const std::vector<std::string_view> names = columnsOf(lines_.line(), style_.separator);
    std::array<std::optional<std::size_t>, 3> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto first = static_cast<char>(
          names[i].empty() ? 0 : std::tolower(static_cast<unsigned char>(names[i].front())));
      // "x", "X", "x_mm", "X[m]", "x(m)"
      const bool named = names[i].size() == 1 ||
                         (names[i].size() > 1 &&
                          std::string_view("_[(").find(names[i][1]) != std::string_view::npos);
      if (!named || first < 'x' || first > 'z') continue;
      auto& place = found[static_cast<std::size_t>(first - 'x')];
      if (!place) place = i;
    }
    if (found[0] && found[1] && found[2]) {
      place_ = {*found[0], *found[1], *found[2]};
    } else {
      builder_.info().warnings.push_back(
          "Line " + std::to_string(line) +
          " names no columns x, y, z; the first three columns were taken.");
    }
    if (nextRow()) style_ = styleOf(lines_.line());
  }

  bool lastLineMayBeCut() const {
    return promised_ && lines_.rest().empty() && !lines_.ended() &&
           builder_.pointCount() + 1 < *promised_;
  }

  /// @return  false to stop: the row is half a row at the end of a cut file
  bool readRow() {
    if (lastLineMayBeCut()) return false;
    std::array<double, 3> p{};
    int found = 0;
    std::string_view rest = lines_.line();
    bool last_is_empty =  // "1,2,"
        style_.separator != 0 && trimmed(rest).ends_with(style_.separator);
    const std::size_t last = *std::max_element(place_.begin(), place_.end());
    for (std::size_t column = 0; column <= last; ++column) {
      auto text = takeColumn(rest, style_.separator);
      if (!text && last_is_empty) {
        text = "";
        last_is_empty = false;
      }
      if (!text) break;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (place_[axis] != column) continue;
        const auto value = parseColumn(*text, style_.decimal_comma);
        if (!value) refuseRow();
        p[axis] = *value;
        ++found;
      }
    }
    if (found < 3) refuseRow();
    builder_.addPoint(p[0], p[1], p[2]);
    return true;
  }

  void checkCount() {
    const std::uint64_t found = builder_.pointCount();
    if (!promised_) return;
    plantedFault(style_.decimal_comma);
    if (found < *promised_) {
      handleShortfall({"points", *promised_, found, found}, job_, builder_.info());
    } else if (found > *promised_) {
      builder_.info().warnings.push_back("The first line promises " + grouped(*promised_) +
                                         " points; the file holds " + grouped(found) +
                                         ", and all were loaded.");
    }
  }

  const ReadJob& job_;
  ScanBuilder builder_;
  Lines lines_;
  RowStyle style_;
  std::array<std::size_t, 3> place_{0, 1, 2};  ///< Columns of x, y, z.
  std::optional<std::uint64_t> promised_;
  bool at_end_ = false;
};

}  // namespace

Scan readText(const ReadJob& job) {
  return TextReader(job).read();
}

}  // namespace relievo
