// SPDX-License-Identifier: BSD-3-Clause
// PTX: per scan its columns and rows, the scanner's place and axes (four lines, repeated by the
// matrix), a 4 x 4 matrix that multiplies row vectors, and a row of text for every direction.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/reader_steps.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

using Matrix = std::array<double, 16>;  ///< Row-major; the translation is the last row.

class PtxReader {
 public:
  explicit PtxReader(const ReadJob& job)
      : job_(job), builder_(job.file, job.options), lines_(job.bytes) {
    if (job.bytes.starts_with("\xEF\xBB\xBF")) lines_ = Lines(job.bytes.substr(3));
  }

  Scan read() {
    builder_.info().format = "PTX";
    while (!cut_ && nextLine()) readScan();
    if (!cut_) checkParts(job_, scans_);
    const std::uint64_t found = builder_.pointCount();
    if (cut_)
      handleTruncation({RecordKind::points, promised_, found, found}, job_, builder_.info());
    return builder_.finish();
  }

 private:
  /// Moves to the next line that is not empty. @return  false at the end
  bool nextLine() {
    while (lines_.next()) {
      if (lines_.line().size() > kMaxPointLine) {
        throwReadError(job_.file, said<MessageId::refused_line_of_points>(lines_.number()));
      }
      if (!trimmed(lines_.line()).empty()) return true;
    }
    return false;
  }

  [[noreturn]] void refuseLine(MessageId wanted) const {
    throwReadError(job_.file,
                   said<MessageId::refused_ptx_line>(lines_.number(), shownStart(lines_.line()),
                                                     Message{wanted, {}}),
                   said<MessageId::advice_export_again>());
  }

  /// The current line starts the scan.
  void readScan() {
    const std::uint64_t columns = countInLine(MessageId::ptx_columns);
    if (!nextHeadLine()) return;
    const std::uint64_t rows = countInLine(MessageId::ptx_rows);
    if (columns != 0 && rows > (~std::uint64_t{0} - promised_) / columns) {
      throwReadError(job_.file, said<MessageId::refused_ptx_points>(),
                     said<MessageId::advice_export_again>());
    }
    wanted_ = isWantedPart(job_, scans_++);
    if (wanted_) promised_ += columns * rows;
    std::array<double, 4> unused{};
    for (int line = 0; line < 4; ++line) {
      if (!nextHeadLine()) return;
      numbersInLine(unused, 3, MessageId::ptx_three_numbers);
    }
    Matrix matrix{};
    for (std::size_t row = 0; row < 4; ++row) {
      if (!nextHeadLine()) return;
      std::array<double, 4> numbers{};
      numbersInLine(numbers, 4, MessageId::ptx_matrix_row);
      std::copy(numbers.begin(), numbers.end(),
                matrix.begin() + static_cast<std::ptrdiff_t>(4 * row));
    }
    checkMatrix(matrix);
    if (wanted_) {
      // The scanner stands at 0 0 0 of its own axes.
      builder_.beginPart(
          {.name = {}, .points = 0, .viewpoint = FilePoint{matrix[12], matrix[13], matrix[14]}});
    }
    readPoints(columns * rows, matrix);
  }

  /// A file that ends within a scan's head is cut, even if it promised no more points by then.
  bool nextHeadLine() {
    if (nextLine()) return true;
    cut_ = true;
    return false;
  }

  std::uint64_t countInLine(MessageId wanted) const {
    const auto count = parseWhole<std::uint64_t>(trimmed(lines_.line()));
    if (!count) refuseLine(wanted);
    return *count;
  }

  void numbersInLine(std::array<double, 4>& numbers, std::size_t count, MessageId wanted) const {
    std::string_view rest = lines_.line();
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = parseNumber(takeWord(rest));
      if (!number) refuseLine(wanted);
      numbers[i] = *number;
    }
  }

  void checkMatrix(const Matrix& m) const {
    const bool finite = std::all_of(m.begin(), m.end(), [](double v) { return std::isfinite(v); });
    const bool is_affine = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
    const double volume = m[0] * (m[5] * m[10] - m[6] * m[9]) -
                          m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
    plantedFault(volume < -1);
    if (finite && is_affine && volume != 0) return;
    throwReadError(job_.file, said<MessageId::refused_ptx_matrix>(lines_.number() + 1),
                   said<MessageId::advice_export_again>());
  }

  void readPoints(std::uint64_t count, const Matrix& matrix) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if (i % kReportEvery == 0) report();
      const bool may_be_last = i + 1 == count;
      if (!nextLine() || (!may_be_last && lines_.rest().empty() && !lines_.ended())) {
        cut_ = true;  // Half a row at the end is no point.
        return;
      }
      if (wanted_) addPoint(matrix);
    }
  }

  void addPoint(const Matrix& m) {
    std::array<double, 3> p{};
    std::string_view rest = lines_.line();
    for (double& number : p) {
      const auto value = parseNumber(takeWord(rest));
      if (!value) refuseLine(MessageId::ptx_point);
      number = *value;
    }
    if (p[0] == 0 && p[1] == 0 && p[2] == 0) {  // Nothing was measured in this direction.
      builder_.addPoint(kNoCoordinate, kNoCoordinate, kNoCoordinate);
      return;
    }
    const bool kept = builder_.addPoint(p[0] * m[0] + p[1] * m[4] + p[2] * m[8] + m[12],
                                        p[0] * m[1] + p[1] * m[5] + p[2] * m[9] + m[13],
                                        p[0] * m[2] + p[1] * m[6] + p[2] * m[10] + m[14]);
    if (kept) addValues(rest);
  }

  /// What follows the coordinates: an intensity, or that and red, green and blue.
  void addValues(std::string_view rest) {
    std::array<float, 4> values{};
    std::size_t found = 0;
    for (; found < values.size(); ++found) {
      const auto value = parseNumber(takeWord(rest));
      if (!value) break;
      values[found] = static_cast<float>(*value);
    }
    if (found >= 1) builder_.addWideIntensity(values[0]);
    if (found < 4) return;
    auto& fact = builder_.info().colour;
    if (!fact) fact = ColourFact{.source = "red green blue", .bits = 8, .points = 0};
    builder_.addWideColour({values[1], values[2], values[3]});
  }

  void report() const {
    job_.task.check();
    const std::size_t read = job_.bytes.size() - lines_.rest().size();
    job_.task.report("reading points",
                     static_cast<double>(read) / static_cast<double>(job_.bytes.size()));
  }

  const ReadJob& job_;
  ScanBuilder builder_;
  Lines lines_;
  std::uint64_t promised_ = 0;  ///< By the scans begun so far.
  std::size_t scans_ = 0;       ///< Begun so far.
  bool wanted_ = true;          ///< The current one.
  bool cut_ = false;
};

}  // namespace

Scan readPtx(const ReadJob& job) {
  return PtxReader(job).read();
}

}  // namespace relievo
