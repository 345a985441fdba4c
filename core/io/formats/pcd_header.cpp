// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/formats/pcd_header.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/ply_header.h"
#include "core/io/point_columns.h"
#include "core/io/read_scan.h"
#include "core/io/worker/reader_guard.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMaxPoints = 1ULL << 40;
constexpr std::uint64_t kMaxNumbersPerPoint = 1 << 20;
constexpr std::size_t kMaxFields = 4096;

std::optional<ScalarType> scalarType(std::string_view type, std::string_view size) {
  constexpr std::array<std::pair<std::string_view, ScalarType>, 10> kTypes{{
      {"I1", ScalarType::i8},
      {"U1", ScalarType::u8},
      {"I2", ScalarType::i16},
      {"U2", ScalarType::u16},
      {"I4", ScalarType::i32},
      {"U4", ScalarType::u32},
      {"I8", ScalarType::i64},
      {"U8", ScalarType::u64},
      {"F4", ScalarType::f32},
      {"F8", ScalarType::f64},
  }};
  if (type.size() != 1 || size.size() != 1) return std::nullopt;
  for (const auto& [known, scalar] : kTypes) {
    if (known[0] == type[0] && known[1] == size[0]) return scalar;
  }
  return std::nullopt;
}

class PcdHeaderParser {
 public:
  PcdHeaderParser(std::string_view head, const std::filesystem::path& file)
      : head_(head), lines_(head), file_(file) {}

  PcdHeader parse() {
    while (lines_.next()) {
      if (lines_.line().size() > 65536) refuse(said<MessageId::pcd_long_line>());
      std::string_view rest = lines_.line();
      const std::string_view word = takeWord(rest);
      if (word.empty() || word.starts_with('#')) continue;
      if (word == "DATA") {
        parseData(rest);
        return std::move(header_);
      }
      parseLine(word, rest);
    }
    refuse(said<MessageId::pcd_without_end>());
  }

 private:
  [[noreturn]] void refuse(Message finding) const {
    throwReadError(file_, said<MessageId::refused_pcd_header>(std::move(finding), lines_.number()));
  }

  void parseLine(std::string_view word, std::string_view rest) {
    if (word == "FIELDS" || word == "COLUMNS") {
      names_ = words(rest);
    } else if (word == "SIZE") {
      sizes_ = words(rest);
    } else if (word == "TYPE") {
      types_ = words(rest);
    } else if (word == "COUNT") {
      counts_ = words(rest);
    } else if (word == "WIDTH") {
      width_ = number(word, rest);
    } else if (word == "HEIGHT") {
      height_ = number(word, rest);
    } else if (word == "POINTS") {
      points_ = number(word, rest);
    } else if (word == "VIEWPOINT") {
      readViewpoint(rest);
    } else if (word != "VERSION") {
      constexpr std::size_t kMostWarnings = 3;
      if (header_.warnings.size() >= kMostWarnings) return;
      header_.warnings.push_back(
          said<MessageId::header_line_not_of_pcd>(lines_.number(), shownStart(lines_.line())));
    }
  }

  std::vector<std::string> words(std::string_view rest) const {
    std::vector<std::string> list;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      if (list.size() >= kMaxFields) refuse(said<MessageId::pcd_many_fields>());
      list.emplace_back(word);
    }
    return list;
  }

  std::uint64_t number(std::string_view word, std::string_view rest) const {
    const auto value = parseWhole<std::uint64_t>(takeWord(rest));
    if (!value || *value > kMaxPoints) refuse(said<MessageId::pcd_without_number>(word));
    return *value;
  }

  void parseData(std::string_view rest) {
    const std::string_view kind = takeWord(rest);
    if (sameLetters(kind, "ascii")) {
      header_.encoding = PcdEncoding::ascii;
    } else if (sameLetters(kind, "binary")) {
      header_.encoding = PcdEncoding::binary;
    } else if (sameLetters(kind, "binary_compressed")) {
      header_.encoding = PcdEncoding::binary_compressed;
    } else {
      refuse(said<MessageId::pcd_unknown_data>());
    }
    header_.body_start = head_.size() - lines_.rest().size();
    header_.body_first_line = lines_.number();
    // Nobody could tell whether a LF that follows belongs to the line or to the points.
    if (header_.encoding != PcdEncoding::ascii && hasLoneCr(head_.substr(0, header_.body_start))) {
      refuse(said<MessageId::pcd_ends_with_cr>());
    }
    makeFields();
    findAxes();
    findValues();
    countPoints();
  }

  /// Seven numbers, place and turn of the camera; the points are in the file's axes all the same.
  void readViewpoint(std::string_view rest) {
    std::array<double, 3> place{};
    for (double& number : place) {
      const auto value = parseNumber(takeWord(rest));
      if (!value || !std::isfinite(*value)) return;
      number = *value;
    }
    if (place != std::array<double, 3>{}) header_.viewpoint = {place[0], place[1], place[2]};
  }

  void makeFields() {
    const std::size_t n = names_.size();
    if (n == 0) refuse(said<MessageId::pcd_without_fields>());
    if (sizes_.size() != n || types_.size() != n || (!counts_.empty() && counts_.size() != n)) {
      refuse(said<MessageId::pcd_field_without_form>());
    }
    std::uint64_t column = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto type = scalarType(types_[i], sizes_[i]);
      if (!type) {
        refuse(said<MessageId::pcd_field_of_no_type>(printable(names_[i].substr(0, 40))));
      }
      const auto count =
          counts_.empty() ? std::optional<std::uint64_t>(1) : parseWhole<std::uint64_t>(counts_[i]);
      if (!count || *count < 1 || *count > kMaxNumbersPerPoint) {
        refuse(said<MessageId::pcd_field_of_no_count>(printable(names_[i].substr(0, 40))));
      }
      header_.fields.push_back({names_[i], *type, *count, column, header_.record_bytes});
      column += *count;
      header_.record_bytes += *count * byteSize(*type);
    }
  }

  void findAxes() {
    constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto find = [&](const auto& isNamed) {
        int seen = 0;
        for (std::size_t i = 0; i < header_.fields.size(); ++i) {
          if (!isNamed(header_.fields[i].name) || header_.fields[i].count != 1) continue;
          header_.xyz[axis] = i;
          ++seen;
        }
        return seen;
      };
      const int exact = find([&](const std::string& name) { return name == kAxes[axis]; });
      // PDAL writes X, Y and Z.
      const int like = exact != 0 ? exact : find([&](const std::string& name) {
        return sameLetters(name, kAxes[axis]);
      });
      if (like != 1) refuse(said<MessageId::pcd_without_axis>(kAxes[axis]));
    }
  }

  void findValues() {
    std::array<std::optional<std::size_t>, 3> colour;
    for (std::size_t i = 0; i < header_.fields.size(); ++i) {
      const PcdField& field = header_.fields[i];
      if (field.count != 1) continue;
      const bool packed = (sameLetters(field.name, "rgb") || sameLetters(field.name, "rgba")) &&
                          byteSize(field.type) == 4;
      if (packed) {
        if (!header_.packed_colour) header_.packed_colour = i;
      } else if (const auto channel = colourChannel(field.name)) {
        if (!colour[*channel]) colour[*channel] = i;
      } else if (isIntensity(field.name) && !header_.intensity) {
        header_.intensity = i;
      }
    }
    if (!header_.packed_colour && colour[0] && colour[1] && colour[2]) {
      header_.colour = std::array{*colour[0], *colour[1], *colour[2]};
    }
  }

  void countPoints() {
    const std::uint64_t height = height_.value_or(1);
    if (!width_ && !points_) refuse(said<MessageId::pcd_without_count>());
    const std::uint64_t width = width_.value_or(*points_);
    if (height != 0 && width > kMaxPoints / height) refuse(said<MessageId::pcd_impossible_count>());
    header_.points = points_.value_or(width * height);
    if (width_ && width * height != header_.points) {
      refuse(said<MessageId::pcd_other_count>(header_.points, width, height));
    }
  }

  std::string_view head_;
  Lines lines_;
  const std::filesystem::path& file_;
  PcdHeader header_;
  std::vector<std::string> names_, sizes_, types_, counts_;
  std::optional<std::uint64_t> width_, height_, points_;
};

}  // namespace

RecordLayout recordLayoutOf(const PcdHeader& header) {
  const auto number = [&header](std::size_t field) {
    return StoredNumber{static_cast<std::size_t>(header.fields[field].offset),
                        header.fields[field].type};
  };
  const auto called = [&header](std::size_t field) { return header.fields[field].name; };
  RecordLayout layout;
  layout.bytes = static_cast<std::size_t>(header.record_bytes);
  for (std::size_t axis = 0; axis < 3; ++axis) layout.xyz[axis] = number(header.xyz[axis]);
  if (header.packed_colour) {
    layout.packed_colour = number(*header.packed_colour).offset;
    layout.colour_source = called(*header.packed_colour);
  }
  if (header.colour) {
    const auto& [red, green, blue] = *header.colour;
    layout.colour = std::array{number(red), number(green), number(blue)};
    layout.colour_source = called(red) + " " + called(green) + " " + called(blue);
  }
  if (header.intensity) layout.intensity = number(*header.intensity);
  return layout;
}

PcdHeader parsePcdHeader(std::string_view head, const std::filesystem::path& file) {
  requireReadersAllowed("parsePcdHeader");
  return PcdHeaderParser(head.substr(0, kMaxHeaderBytes), file).parse();
}

}  // namespace relievo
