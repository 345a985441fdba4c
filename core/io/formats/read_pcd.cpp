// SPDX-License-Identifier: BSD-3-Clause
// Bodies of PCD files.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/lzf.h"
#include "core/io/formats/pcd_header.h"
#include "core/io/formats/reader_steps.h"
#include "core/io/read_scan.h"
#include "core/io/reader_choice.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"

namespace relievo {
namespace {

class PcdReader {
 public:
  PcdReader(const ReadJob& job, const PcdHeader& header)
      : job_(job),
        header_(header),
        builder_(job.file, job.options),
        layout_(recordLayoutOf(header)),
        body_(job.bytes.substr(header.body_start)) {}

  Scan read() {
    constexpr std::array<std::string_view, 3> kEncodings{"ascii", "binary", "binary_compressed"};
    builder_.info().format =
        "PCD " + std::string(kEncodings[static_cast<std::size_t>(header_.encoding)]);
    builder_.info().warnings = header_.warnings;
    if (header_.viewpoint) {
      builder_.beginPart({.name = {}, .points = 0, .viewpoint = header_.viewpoint});
    }
    switch (header_.encoding) {
      case PcdEncoding::ascii:
        readRows();
        break;
      case PcdEncoding::binary:
        readRecords();
        break;
      case PcdEncoding::binary_compressed:
        readCompressed();
        break;
    }
    return builder_.finish();
  }

 private:
  void checkLimit() const {
    if (header_.points > job_.options.max_points) {
      throwReadError(job_.file,
                     said<MessageId::refused_pcd_limit>(header_.points, job_.options.max_points));
    }
  }

  void report(std::uint64_t point) const {
    if (point % kReportEvery != 0) return;
    job_.task.check();
    job_.task.report("reading points",
                     static_cast<double>(point) / static_cast<double>(header_.points));
  }

  void shortOf(std::uint64_t found) {
    handleTruncation({RecordKind::points, header_.points, found, found}, job_, builder_.info());
  }

  void readRecords() {
    const std::uint64_t found = std::min(header_.points, body_.size() / header_.record_bytes);
    if (found < header_.points) shortOf(found);
    plantedFault(header_.xyz[0] > header_.xyz[2]);
    builder_.requireRoom(found);
    expectRecords(layout_, found, hasByteColours(layout_), builder_);
    if (!byPcl()) return addRecords(layout_, body_, found, job_.task, builder_);
    builder_.info().reader = job_.pcl->name;
    std::uint64_t done = 0;
    if (!job_.pcl->pcd_records(header_, body_, found, taker(done))) {
      throwReadError(job_.file, said<MessageId::pcl_gave_up>());
    }
  }

  /// The program that called may have none: then ours reads, unless PCL was asked for.
  bool byPcl() const {
    if (!usesPcl(job_.options.scan.reader, whyNotPcl(header_), job_.file)) return false;
    const bool there = job_.pcl != nullptr && job_.pcl->pcd_records != nullptr;
    if (!there && job_.options.scan.reader == ReaderChoice::pcl) {
      throw failure<MessageId::file_was_changed>(shownName(job_.file));
    }
    return there;
  }

  TakeColumns taker(std::uint64_t& done) {
    return [this, &done](const PointColumns& columns, std::uint64_t count) {
      job_.task.check();
      job_.task.report("reading points",
                       static_cast<double>(done) / static_cast<double>(header_.points));
      addColumns(columns, count, builder_);
      done += count;
    };
  }

  /// Two sizes, then all points' first field, all points' second field ... as one LZF block.
  void readCompressed() {
    checkLimit();
    if (body_.size() < 8) refuseCut();
    const std::uint64_t packed = loadAs<std::uint32_t>(body_.data(), ByteOrder::little);
    const std::uint64_t unpacked = loadAs<std::uint32_t>(body_.data() + 4, ByteOrder::little);
    // Three bytes of LZF stand for at most 264, so that a small file cannot ask for much memory.
    if (unpacked != header_.points * header_.record_bytes || unpacked / 88 > packed) {
      throwReadError(job_.file, said<MessageId::refused_pcd_compressed>(unpacked, header_.points),
                     said<MessageId::advice_damaged_export>());
    }
    if (packed > body_.size() - 8) refuseCut();
    if (header_.points == 0) return;
    job_.task.report("reading points", 0);
    builder_.requireRoom(header_.points);
    expectRecords(layout_, header_.points, hasByteColours(layout_), builder_);
    if (byPcl()) {
      builder_.info().reader = job_.pcl->name;
      std::uint64_t done = 0;
      if (!job_.pcl->pcd_compressed(header_, body_, taker(done))) refuseUndecoded();
      return;
    }
    const std::vector<char> bytes = unpackLzf(body_.substr(8, static_cast<std::size_t>(packed)),
                                              static_cast<std::size_t>(unpacked));
    if (bytes.empty()) refuseUndecoded();
    addFields(bytes);
  }

  [[noreturn]] void refuseUndecoded() const {
    throw failure<MessageId::points_not_decoded>(shownName(job_.file));
  }

  /// From all points' first field, all points' second field ...
  void addFields(const std::vector<char>& bytes) {
    const auto column = [&](std::size_t field, std::uint64_t first) {
      const PcdField& f = header_.fields[field];
      const std::size_t size = byteSize(f.type);
      return Column{bytes.data() + f.offset * header_.points + first * size, size, f.type};
    };
    for (std::uint64_t first = 0; first < header_.points; first += kReportEvery) {
      report(first);
      PointColumns columns;
      for (std::size_t k = 0; k < 3; ++k) {
        columns.xyz[k] = column(header_.xyz[k], first);
        if (header_.colour) columns.colour[k] = column((*header_.colour)[k], first);
      }
      if (header_.packed_colour) columns.packed_colour = column(*header_.packed_colour, first);
      if (header_.intensity) columns.intensity = column(*header_.intensity, first);
      addColumns(columns, std::min(kReportEvery, header_.points - first), builder_);
    }
  }

  [[noreturn]] void refuseCut() const {
    throwReadError(job_.file, said<MessageId::refused_pcd_cut>(header_.points),
                   said<MessageId::advice_copy_or_export>());
  }

  void readRows() {
    Lines lines(body_, header_.body_first_line);
    std::uint64_t found = 0;
    expectRecords(layout_, std::min<std::uint64_t>(header_.points, body_.size() / 6 + 1),
                  header_.packed_colour.has_value(), builder_);
    while (found < header_.points && lines.next()) {
      if (trimmed(lines.line()).empty() || lines.line().starts_with('#')) continue;
      report(found);
      // A last line without its end may be half a row, unless it is the last one promised.
      const bool may_be_cut = lines.rest().empty() && !lines.ended();
      if (may_be_cut && found + 1 < header_.points) break;
      if (!readRow(lines, may_be_cut)) break;
      ++found;
    }
    if (found < header_.points) shortOf(found);
  }

  /// @return  false if the row ends too early and may do so, because the file ends there
  bool readRow(const Lines& lines, bool may_be_cut) {
    words_.clear();
    std::string_view rest = lines.line();
    const PcdField& last_field = header_.fields.back();
    const std::uint64_t columns = last_field.column + last_field.count;
    for (std::uint64_t column = 0; column < columns; ++column) {
      const std::string_view word = takeWord(rest);
      if (word.empty()) {
        if (may_be_cut) return false;
        refuseRow(lines, said<MessageId::line_with_fewer_numbers>());
      }
      words_.push_back(word);
    }
    std::array<double, 3> p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = parseNumber(wordOf(header_.xyz[axis]));
      if (!value) refuseRow(lines, said<MessageId::line_without_coordinates>());
      p[axis] = *value;
    }
    if (builder_.addPoint(p[0], p[1], p[2])) addValues();
    return true;
  }

  std::string_view wordOf(std::size_t field) const {
    return words_[static_cast<std::size_t>(header_.fields[field].column)];
  }

  float numberOf(std::size_t field) const {
    return static_cast<float>(parseNumber(wordOf(field)).value_or(kNoCoordinate));
  }

  void addValues() {
    if (header_.packed_colour) {
      if (const auto packed = packedColour(wordOf(*header_.packed_colour))) {
        builder_.addColour(static_cast<std::uint8_t>(*packed >> 16U),
                           static_cast<std::uint8_t>(*packed >> 8U),
                           static_cast<std::uint8_t>(*packed));
      } else {
        builder_.addNoColour();
      }
    } else if (header_.colour) {
      const auto& [red, green, blue] = *header_.colour;
      builder_.addWideColour({numberOf(red), numberOf(green), numberOf(blue)});
    }
    if (header_.intensity) builder_.addWideIntensity(numberOf(*header_.intensity));
  }

  /// A colour as a whole number, or as the float that has its bits: such floats are tiny, or with
  /// an alpha of 255 huge and negative or no numbers, and never written as digits alone.
  static std::optional<std::uint32_t> packedColour(std::string_view word) {
    if (const auto whole = parseWhole<std::uint32_t>(word)) return whole;
    if (const auto whole = parseWhole<std::int32_t>(word)) {
      return static_cast<std::uint32_t>(*whole);
    }
    float value = 0;  // Not by way of double: that would make other bits of it.
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end || error != std::errc{} || std::isnan(value)) return std::nullopt;
    return std::bit_cast<std::uint32_t>(value);
  }

  [[noreturn]] void refuseRow(const Lines& lines, Message finding) const {
    throwReadError(
        job_.file,
        said<MessageId::refused_line>(lines.number(), shownStart(lines.line()), std::move(finding)),
        said<MessageId::advice_damaged_export>());
  }

  const ReadJob& job_;
  const PcdHeader& header_;
  ScanBuilder builder_;
  RecordLayout layout_;
  std::string_view body_;
  std::vector<std::string_view> words_;  ///< Of the current row.
};

}  // namespace

Scan readPcd(const ReadJob& job) {
  const PcdHeader header = parsePcdHeader(job.bytes, job.file);
  return PcdReader(job, header).read();
}

}  // namespace relievo
