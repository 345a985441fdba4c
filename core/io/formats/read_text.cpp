// SPDX-License-Identifier: BSD-3-Clause
// Points as rows of text: XYZ, ASC, PTS, CSV, TXT.
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/reader_steps.h"
#include "core/io/formats/text_columns.h"
#include "core/io/point_columns.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

class TextReader {
 public:
  explicit TextReader(const ReadJob& job)
      : job_(job), builder_(job.file, job.options), lines_(job.bytes) {
    if (job.bytes.starts_with("\xEF\xBB\xBF")) lines_ = Lines(job.bytes.substr(3));
  }

  Scan read() {
    builder_.info().format = "text";
    if (!nextRow()) throw failure<MessageId::no_rows_of_numbers>(shownName(job_.file));
    readCountLine();
    if (!at_end_) readHeader();
    if (!at_end_) chooseValues();
    while (!at_end_) {
      if (builder_.pointCount() % kReportEvery == 0) report();
      if (builder_.pointCount() == kReportEvery) builder_.requireMemory(estimatedPoints());
      if (!readRow()) break;
      nextRow();
    }
    checkCount();
    if (!guess_holds_) builder_.dropColours();
    if (style_.decimal_comma) {
      builder_.info().warnings.push_back(said<MessageId::commas_are_points>());
    }
    return builder_.finish();
  }

 private:
  /// If all rows are as long as those that were read.
  std::uint64_t estimatedPoints() const {
    const std::size_t read = job_.bytes.size() - lines_.rest().size();
    return builder_.pointCount() * job_.bytes.size() / std::max<std::size_t>(read, 1);
  }

  void report() const {
    job_.task.check();
    const std::size_t read = job_.bytes.size() - lines_.rest().size();
    job_.task.report("reading points",
                     static_cast<double>(read) / static_cast<double>(job_.bytes.size()));
  }

  /// Moves to the next line that is neither empty nor a comment. @return  false at the end
  bool nextRow() {
    while (lines_.next()) {
      if (lines_.line().size() > kMaxPointLine) {
        throwReadError(job_.file, said<MessageId::refused_line_of_points>(lines_.number()));
      }
      const std::string_view line = trimmed(lines_.line());
      const bool comment = line.starts_with('#') || line.starts_with("//");
      if (!line.empty() && !comment) return true;
      // "//X Y Z R G B" is how CloudCompare names the columns.
      if (comment && builder_.pointCount() == 0 && !line.empty()) last_comment_ = line;
    }
    at_end_ = true;
    return false;
  }

  [[noreturn]] void refuseRow() const {
    throwReadError(job_.file, said<MessageId::refused_line_without_numbers>(
                                  lines_.number(), shownStart(lines_.line())));
  }

  /// PTS files start with the number of points.
  void readCountLine() {
    std::string_view rest = lines_.line();
    const auto count = parseWhole<std::uint64_t>(takeWord(rest));
    if (!count || !takeWord(rest).empty()) return;
    promised_ = count;
    nextRow();
  }

  void takeStyle() {
    style_ = styleOf(lines_.line());
    if (style_.separator != ',' || !hasThousandsSeparators(lines_.line())) return;
    throwReadError(job_.file,
                   said<MessageId::refused_thousands>(lines_.number(), shownStart(lines_.line())));
  }

  void readHeader() {
    takeStyle();
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
    const std::vector<std::string_view> names = namesOf(lines_.line(), style_.separator);
    const auto found = axisColumns(names);
    if (found[0] && found[1] && found[2]) {
      place_ = {*found[0], *found[1], *found[2]};
    } else {
      builder_.info().warnings.push_back(said<MessageId::columns_without_xyz>(line));
    }
    values_ = namedValues(names);
    columns_are_named_ = true;
    if (nextRow()) takeStyle();
  }

  /// Which columns hold colours and intensities: by their names, else by what stands there.
  void chooseValues() {
    if (!columns_are_named_) {
      const std::size_t start = last_comment_.find_first_not_of("#/ \t");
      const std::string_view said = last_comment_.substr(std::min(start, last_comment_.size()));
      const auto names = namesOf(said, styleOf(said).separator);
      if (axisColumns(names) == std::array<std::optional<std::size_t>, 3>{0, 1, 2}) {
        values_ = namedValues(names);
        columns_are_named_ = true;
      }
    }
    if (!columns_are_named_) {
      const bool pts = promised_.has_value() || sameLetters(job_.file.extension().string(), ".pts");
      values_ = guessedValues(firstRows(), pts);
    }
    last_column_ = *std::max_element(place_.begin(), place_.end());
    if (values_.colour) {
      last_column_ = std::max(
          {last_column_, (*values_.colour)[0], (*values_.colour)[1], (*values_.colour)[2]});
      builder_.info().colour = ColourFact{
          .source = columns_are_named_ ? "named columns" : "columns", .bits = 8, .points = 0};
    }
    if (values_.intensity) last_column_ = std::max(last_column_, *values_.intensity);
  }

  /// The numbers of the current row and some more; NaN for words.
  std::vector<std::vector<double>> firstRows() const {
    constexpr std::size_t kRows = 64;
    std::vector<std::vector<double>> rows;
    Lines ahead = lines_;
    do {
      const std::string_view line = trimmed(ahead.line());
      if (line.empty() || line.starts_with('#') || line.starts_with("//")) continue;
      std::vector<double>& row = rows.emplace_back();
      for (const std::string_view column : columnsOf(line, style_.separator)) {
        row.push_back(parseColumn(column, style_.decimal_comma).value_or(kNoCoordinate));
      }
    } while (rows.size() < kRows && ahead.next());
    return rows;
  }

  bool lastLineMayBeCut() const {
    return promised_ && lines_.rest().empty() && !lines_.ended() &&
           builder_.pointCount() + 1 < *promised_;
  }

  /// @return  false to stop: the row is half a row at the end of a cut file
  bool readRow() {
    if (lastLineMayBeCut()) return false;
    std::array<double, 3> p{};
    std::array<float, 3> colour{kNoNumber, kNoNumber, kNoNumber};
    float intensity = kNoNumber;
    int found = 0;
    std::string_view rest = lines_.line();
    bool last_is_empty =  // "1,2,"
        style_.separator != 0 && trimmed(rest).ends_with(style_.separator);
    for (std::size_t column = 0; column <= last_column_; ++column) {
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
      takeValue(column, *text, colour, intensity);
    }
    if (found < 3) refuseRow();
    if (!builder_.addPoint(p[0], p[1], p[2])) return true;
    if (values_.colour) builder_.addWideColour(colour);
    if (values_.intensity) builder_.addWideIntensity(intensity);
    return true;
  }

  void takeValue(std::size_t column, std::string_view text, std::array<float, 3>& colour,
                 float& intensity) {
    const auto number = [&] {
      return static_cast<float>(parseColumn(text, style_.decimal_comma).value_or(kNoCoordinate));
    };
    if (values_.intensity == column) intensity = number();
    if (!values_.colour) return;
    for (std::size_t k = 0; k < 3; ++k) {
      if ((*values_.colour)[k] != column) continue;
      colour[k] = number();
      // Numbers that nobody named are colours only if all of them could be.
      if (!columns_are_named_ && !isByteNumber(static_cast<double>(colour[k]))) {
        guess_holds_ = false;
      }
    }
  }

  void checkCount() {
    const std::uint64_t found = builder_.pointCount();
    if (!promised_) return;
    plantedFault(style_.decimal_comma);
    if (found < *promised_) {
      handleTruncation({RecordKind::points, *promised_, found, found}, job_, builder_.info());
    } else if (found > *promised_) {
      builder_.info().warnings.push_back(said<MessageId::more_points_than_promised>(
          CountArgument::grouped(*promised_), CountArgument::grouped(found)));
    }
  }

  const ReadJob& job_;
  ScanBuilder builder_;
  Lines lines_;
  RowStyle style_;
  std::array<std::size_t, 3> place_{0, 1, 2};  ///< Columns of x, y, z.
  std::size_t last_column_ = 2;                ///< That is read.
  TextValues values_;
  bool columns_are_named_ = false;
  bool guess_holds_ = true;
  std::string_view last_comment_;  ///< Before the first row.
  std::optional<std::uint64_t> promised_;
  bool at_end_ = false;
};

}  // namespace

Scan readText(const ReadJob& job) {
  return TextReader(job).read();
}

}  // namespace relievo
