// SPDX-License-Identifier: BSD-3-Clause
// Bodies of PLY files.
#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/ply_header.h"
#include "core/io/formats/reader_steps.h"
#include "core/io/read_scan.h"
#include "core/io/reader_choice.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

/// What one record of an element contributes; filled by the two bodies below.
struct Record {
  std::array<double, 3> xyz{};
  std::array<float, 3> colour{};
  float intensity = 0;
  std::vector<std::int64_t> corners;
};

class PlyReader {
 public:
  PlyReader(const ReadJob& job, const PlyHeader& header)
      : job_(job),
        header_(header),
        builder_(job.file, job.options),
        layout_(recordLayoutOf(header)),
        body_(job.bytes.substr(header.body_start)),
        lines_(body_, header.body_first_line) {}

  Scan read() {
    constexpr std::array<std::string_view, 3> kEncodings{"ascii", "binary_little_endian",
                                                         "binary_big_endian"};
    builder_.info().unit = header_.unit;
    builder_.info().warnings = header_.warnings;
    builder_.info().format =
        "PLY " + std::string(kEncodings[static_cast<std::size_t>(header_.encoding)]);
    const bool ascii = header_.encoding == PlyEncoding::ascii;
    // Text may say anything, also 256 of a uchar; numbers without a type are settled at the end.
    has_byte_colours_ = !ascii && layout_.colour && hasByteColours(layout_);
    if (isPointsAlone()) builder_.leaveTo(job_.sink);
    for (element_ = 0; element_ < header_.elements.size(); ++element_) {
      const PlyElement& element = header_.elements[element_];
      if (isVertex()) expectVertices(element);
      const std::uint64_t found = ascii ? readLines(element) : readRecords(element);
      if (found < element.count && !acceptCut(element, found)) break;
    }
    noteUnreadFaces();
    return builder_.finish();
  }

 private:
  bool isVertex() const noexcept { return element_ == header_.vertex_element; }
  bool isFace() const noexcept { return element_ == header_.face_element; }

  /// Binary, without faces, whose corners are asked for their points, and without values.
  bool isPointsAlone() const {
    const bool faces = header_.face_element && header_.elements[*header_.face_element].count > 0;
    return header_.encoding != PlyEncoding::ascii && !faces && !layout_.hasColour() &&
           !layout_.intensity;
  }

  /// Records that the rest of the file could hold at most.
  std::uint64_t possibleRecords(const PlyElement& element) const {
    const bool ascii = header_.encoding == PlyEncoding::ascii;
    const std::uint64_t rest = ascii ? lines_.rest().size() : body_.size() - at_;
    const std::uint64_t least = ascii ? 2 * element.properties.size() : element.leastBytes();
    return least == 0 ? element.count : rest / least + 1;
  }

  void expectVertices(const PlyElement& element) {
    const std::uint64_t most = std::min(element.count, possibleRecords(element));
    // Records of one length are counted; as text, or with lists in them, there may be fewer.
    const bool counted = header_.encoding != PlyEncoding::ascii && !element.hasList() && most > 0;
    if (counted) builder_.requireRoom(most - 1, header_.face_element.has_value());
    expectRecords(layout_, most, has_byte_colours_, builder_);
  }

  /// @return  true to go on although the element is cut
  bool acceptCut(const PlyElement& element, std::uint64_t found) {
    const bool needed_later = builder_.pointCount() < header_.vertices().count;
    if (!isVertex() && !isFace() && !needed_later) {
      builder_.info().warnings.push_back(
          said<MessageId::ends_behind_points>(printable(element.name)));
      return false;
    }
    Truncation shortfall;
    if (isFace()) {
      shortfall = {RecordKind::faces, element.count, found, builder_.pointCount()};
    } else {
      const std::uint64_t points = builder_.pointCount();
      shortfall = {RecordKind::points, header_.vertices().count, points, points};
    }
    handleTruncation(shortfall, job_, builder_.info());
    return false;
  }

  void noteUnreadFaces() {
    for (const PlyElement& element : header_.elements) {
      const bool faces = element.name == "face" && !header_.face_element;
      if (element.count > 0 && (faces || element.name == "tristrips")) {
        builder_.info().warnings.push_back(
            said<MessageId::faces_not_read>(printable(element.name)));
      }
      const bool coloured =
          std::any_of(element.properties.begin(), element.properties.end(),
                      [](const PlyProperty& p) { return colourChannel(p.name).has_value(); });
      if (element.name == "face" && coloured && !header_.colour) {
        builder_.info().warnings.push_back(said<MessageId::colours_of_faces>());
      }
    }
  }

  void report(std::uint64_t record, std::uint64_t count) {
    if (record % kReportEvery != 0) return;
    job_.task.check();
    const auto share = static_cast<double>(record) / static_cast<double>(count);
    job_.task.report(isFace() ? "reading faces" : "reading points", share);
  }

  void take(const Record& record) {
    if (isFace()) builder_.addFace(record.corners);
    if (!isVertex() || !builder_.addPoint(record.xyz[0], record.xyz[1], record.xyz[2])) return;
    if (layout_.colour && has_byte_colours_) {
      const auto channel = [&](std::size_t k) {
        return static_cast<std::uint8_t>(record.colour[k]);
      };
      builder_.addColour(channel(0), channel(1), channel(2));
    } else if (layout_.colour) {
      builder_.addWideColour(record.colour);
    }
    if (layout_.intensity) builder_.addWideIntensity(record.intensity);
  }

  // ---- binary ------------------------------------------------------------------------------

  /// @return  complete records found
  std::uint64_t readRecords(const PlyElement& element) {
    if (element.properties.empty()) return element.count;
    if (!element.hasList() && isVertex()) return readFixedPoints(element);
    if (!element.hasList() && !isFace()) return skipRecords(element);
    Record record;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      report(i, element.count);
      if (!readRecord(element, record)) return i;
      take(record);
    }
    return element.count;
  }

  /// The program that called may have none: then ours reads, unless PCL was asked for.
  bool byPcl() const {
    if (!usesPcl(job_.options.scan.reader, whyNotPcl(header_), job_.file)) return false;
    if (job_.pcl == nullptr && job_.options.scan.reader == ReaderChoice::pcl) {
      throw failure<MessageId::file_was_changed>(shownName(job_.file));
    }
    return job_.pcl != nullptr;
  }

  std::uint64_t skipRecords(const PlyElement& element) {
    const std::uint64_t bytes = element.leastBytes();
    const std::uint64_t found = std::min(element.count, (body_.size() - at_) / bytes);
    at_ += found * bytes;
    return found;
  }

  /// Points without lists among their properties: the same places in every record.
  std::uint64_t readFixedPoints(const PlyElement& element) {
    const std::string_view rest = body_.substr(at_);
    const std::uint64_t found = std::min(element.count, rest.size() / layout_.bytes);
    if (byPcl()) {
      builder_.info().reader = job_.pcl->name;
      std::uint64_t done = 0;
      const auto take = [&](const PointColumns& columns, std::uint64_t count) {
        report(done, element.count);
        addColumns(columns, count, builder_);
        done += count;
      };
      if (!job_.pcl->ply_records(header_, rest, found, take)) {
        throwReadError(job_.file, said<MessageId::pcl_gave_up>());
      }
    } else {
      addRecords(layout_, rest, found, job_.task, builder_);
    }
    at_ += found * layout_.bytes;
    return found;
  }

  bool readRecord(const PlyElement& element, Record& record) {
    std::size_t at = at_;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const std::size_t first = byteSize(property.list_length.value_or(property.type));
      if (first > body_.size() - at) return false;
      if (!property.list_length) {
        if (isVertex()) {
          takeNumber(p, loadDouble(body_.data() + at, property.type, header_.byteOrder()), record);
        }
        at += first;
        continue;
      }
      const auto length = static_cast<std::int64_t>(
          loadDouble(body_.data() + at, *property.list_length, header_.byteOrder()));
      at += first;
      if (length < 0) {
        throwReadError(job_.file, said<MessageId::refused_ply_list_length>(length),
                       said<MessageId::advice_damaged_export>());
      }
      plantedFault(isFace() && length == 77);
      const std::size_t item = byteSize(property.type);
      if (static_cast<std::uint64_t>(length) > (body_.size() - at) / item) return false;
      if (isFace() && p == header_.face_corners) takeCorners(property, at, length, record);
      at += static_cast<std::size_t>(length) * item;
    }
    at_ = at;
    return true;
  }

  /// Of the vertex element's property `p`.
  void takeNumber(std::size_t p, double number, Record& record) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (header_.xyz[k] == p) record.xyz[k] = number;
      if (header_.colour && (*header_.colour)[k] == p)
        record.colour[k] = static_cast<float>(number);
    }
    if (header_.intensity == p) record.intensity = static_cast<float>(number);
  }

  bool isRead(std::size_t p) const {
    const auto is = [p](std::size_t other) { return other == p; };
    return std::any_of(header_.xyz.begin(), header_.xyz.end(), is) || header_.intensity == p ||
           (header_.colour && std::any_of(header_.colour->begin(), header_.colour->end(), is));
  }

  void takeCorners(const PlyProperty& property, std::size_t at, std::int64_t length,
                   Record& record) {
    record.corners.clear();
    for (std::int64_t i = 0; i < length; ++i) {
      const char* const item =
          body_.data() + at + static_cast<std::size_t>(i) * byteSize(property.type);
      record.corners.push_back(
          static_cast<std::int64_t>(loadDouble(item, property.type, header_.byteOrder())));
    }
  }

  // ---- text --------------------------------------------------------------------------------

  [[noreturn]] void refuseLine(Message finding) const {
    throwReadError(job_.file,
                   said<MessageId::refused_line>(lines_.number(), shownStart(lines_.line()),
                                                 std::move(finding)),
                   said<MessageId::advice_damaged_export>());
  }

  std::uint64_t readLines(const PlyElement& element) {
    if (element.properties.empty()) return element.count;
    Record record;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      report(i, element.count);
      do {
        if (!lines_.next()) return i;
      } while (trimmed(lines_.line()).empty());
      const bool last_of_file = lines_.rest().empty();
      const bool may_be_cut = last_of_file && !lines_.ended();
      // A last line without its end may be half a record, unless it is the last one promised.
      const bool promised_more = i + 1 < element.count || element_ + 1 < header_.elements.size();
      if (may_be_cut && promised_more) return i;
      if (!readLine(element, may_be_cut, record)) return i;
      take(record);
    }
    return element.count;
  }

  /// @return  false if the line ends too early and may do so, because the file ends there
  bool readLine(const PlyElement& element, bool may_be_cut, Record& record) {
    std::string_view rest = lines_.line();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const std::string_view word = takeWord(rest);
      if (word.empty()) {
        if (may_be_cut) return false;
        refuseLine(said<MessageId::line_with_few_numbers>());
      }
      if (property.list_length) {
        if (!readList(p, word, rest, may_be_cut, record)) return false;
        continue;
      }
      if (isVertex() && isRead(p)) takeNumber(p, number(p, word), record);
    }
    return true;
  }

  /// The digits of the text, even if the property says float: they are what was measured.
  double number(std::size_t p, std::string_view word) const {
    if (const auto value = parseNumber(word)) return *value;
    const bool needed = std::find(header_.xyz.begin(), header_.xyz.end(), p) != header_.xyz.end();
    if (needed) refuseLine(said<MessageId::line_without_coordinates>());
    return std::numeric_limits<double>::quiet_NaN();
  }

  bool readList(std::size_t p, std::string_view length_word, std::string_view& rest,
                bool may_be_cut, Record& record) {
    const auto length = parseWhole<std::uint64_t>(length_word);
    if (!length) refuseLine(said<MessageId::line_with_list_without_length>());
    const bool corners = isFace() && p == header_.face_corners;
    if (corners) record.corners.clear();
    for (std::uint64_t i = 0; i < *length; ++i) {
      const std::string_view word = takeWord(rest);
      if (word.empty()) {
        if (may_be_cut) return false;
        refuseLine(said<MessageId::line_with_short_list>());
      }
      if (corners) record.corners.push_back(parseWhole<std::int64_t>(word).value_or(-1));
    }
    return true;
  }

  const ReadJob& job_;
  const PlyHeader& header_;
  ScanBuilder builder_;
  RecordLayout layout_;  ///< Its places are right where the vertex element has no lists.
  bool has_byte_colours_ = false;
  std::string_view body_;
  std::size_t element_ = 0;
  std::size_t at_ = 0;  ///< Binary: next byte of the body.
  Lines lines_;         ///< Text: next line.
};

}  // namespace

Scan readPly(const ReadJob& job) {
  const PlyHeader header = parsePlyHeader(job.bytes, job.file);
  return PlyReader(job, header).read();
}

}  // namespace relievo
