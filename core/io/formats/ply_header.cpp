// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/formats/ply_header.h"

#include <algorithm>
#include <utility>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/read_scan.h"
#include "core/io/worker/reader_guard.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMaxCount = 1ULL << 40;
constexpr std::size_t kMaxProperties = 4096;

std::optional<ScalarType> scalarType(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, ScalarType>, 16> kTypes{{
      {"char", ScalarType::i8},
      {"int8", ScalarType::i8},
      {"uchar", ScalarType::u8},
      {"uint8", ScalarType::u8},
      {"short", ScalarType::i16},
      {"int16", ScalarType::i16},
      {"ushort", ScalarType::u16},
      {"uint16", ScalarType::u16},
      {"int", ScalarType::i32},
      {"int32", ScalarType::i32},
      {"uint", ScalarType::u32},
      {"uint32", ScalarType::u32},
      {"float", ScalarType::f32},
      {"float32", ScalarType::f32},
      {"double", ScalarType::f64},
      {"float64", ScalarType::f64},
  }};
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  return std::nullopt;
}

/// One pass over the header lines.
class HeaderParser {
 public:
  HeaderParser(std::string_view head, const std::filesystem::path& file)
      : head_(head), lines_(head), file_(file) {}

  PlyHeader parse() {
    if (!lines_.next() || trimmed(lines_.line()) != "ply") {
      throwReadError(file_, said<MessageId::refused_no_ply>());
    }
    while (lines_.next()) {
      if (lines_.line().size() > 4096) refuseLine(said<MessageId::line_too_long_for_ply>());
      if (!lines_.ended()) break;
      std::string_view rest = lines_.line();
      const std::string_view word = takeWord(rest);
      if (word == "end_header") {
        header_.body_start = head_.size() - lines_.rest().size();
        header_.body_first_line = lines_.number();
        checkLineEnds();
        check();
        return std::move(header_);
      }
      parseLine(word, rest);
    }
    throw failure<MessageId::header_without_end>(shownName(file_), "\"end_header\"");
  }

 private:
  [[noreturn]] void refuseLine(Message finding) const {
    throwReadError(file_,
                   said<MessageId::refused_header_line>(lines_.number(), shownStart(lines_.line()),
                                                        std::move(finding)),
                   said<MessageId::advice_export_again>());
  }

  void parseLine(std::string_view word, std::string_view rest) {
    if (word == "format") return parseFormat(rest);
    if (word == "element") return parseElement(rest);
    if (word == "property") return parseProperty(rest);
    if (word == "comment") return parseComment(rest);
    if (word.empty() || word == "obj_info") return;
    // Programs write lines of their own; rply and others stop at them, VTK and MeshLab do not.
    constexpr std::size_t kMostWarnings = 3;
    if (header_.warnings.size() >= kMostWarnings) return;
    header_.warnings.push_back(
        said<MessageId::header_line_not_of_ply>(lines_.number(), shownStart(lines_.line())));
  }

  /// PLY has no field for the unit; "comment unit mm" is how our samples, and others, state it.
  void parseComment(std::string_view rest) {
    if (takeWord(rest) == "unit") header_.unit = lengthUnit(trimmed(rest));
  }

  void parseFormat(std::string_view rest) {
    constexpr std::array<std::pair<std::string_view, PlyEncoding>, 3> kEncodings{{
        {"ascii", PlyEncoding::ascii},
        {"binary_little_endian", PlyEncoding::binary_little_endian},
        {"binary_big_endian", PlyEncoding::binary_big_endian},
    }};
    const std::string_view name = takeWord(rest);
    for (const auto& [known, encoding] : kEncodings) {
      if (known != name) continue;
      header_.encoding = encoding;
      format_seen_ = true;
      return;
    }
    refuseLine(said<MessageId::line_with_unknown_format>());
  }

  void parseElement(std::string_view rest) {
    PlyElement element;
    element.name = takeWord(rest);
    const auto count = parseWhole<std::uint64_t>(takeWord(rest));
    if (element.name.empty() || !count || *count > kMaxCount) {
      refuseLine(said<MessageId::line_without_count>());
    }
    element.count = *count;
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) refuseLine(said<MessageId::line_with_element_again>());
    }
    header_.elements.push_back(std::move(element));
  }

  void parseProperty(std::string_view rest) {
    if (header_.elements.empty()) refuseLine(said<MessageId::line_of_no_element>());
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    std::string_view type_name = takeWord(rest);
    if (type_name == "list") {
      property.list_length = scalarType(takeWord(rest));
      if (!property.list_length || !isWhole(*property.list_length)) {
        refuseLine(said<MessageId::line_with_list_of_no_whole_length>());
      }
      type_name = takeWord(rest);
    }
    const auto type = scalarType(type_name);
    if (!type) refuseLine(said<MessageId::line_with_unknown_type>());
    property.type = *type;
    property.name = takeWord(rest);
    if (property.name.empty()) refuseLine(said<MessageId::line_without_name>());
    if (element.properties.size() >= kMaxProperties)
      refuseLine(said<MessageId::line_with_property_too_many>());
    for (const PlyProperty& other : element.properties) {
      if (other.name == property.name) refuseLine(said<MessageId::line_with_property_again>());
    }
    element.properties.push_back(std::move(property));
  }

  void checkLineEnds() {
    const std::string_view header = head_.substr(0, header_.body_start);
    if (hasLoneCr(header) && header.find('\n') != std::string_view::npos) {
      throwReadError(file_, said<MessageId::refused_ply_line_ends>(),
                     said<MessageId::advice_damaged_export>());
    }
  }

  /// The one of that name; else the only one that differs from it in capitals alone.
  template <class List, class Wanted>
  static typename List::const_iterator findNamed(const List& list, std::string_view name,
                                                 const Wanted& isWanted) {
    const auto is_it = [&](const auto& item) { return item.name == name && isWanted(item); };
    const auto exact = std::find_if(list.begin(), list.end(), is_it);
    if (exact != list.end()) return exact;
    const auto is_like = [&](const auto& item) {
      return sameLetters(item.name, name) && isWanted(item);
    };
    const auto like = std::find_if(list.begin(), list.end(), is_like);
    return std::count_if(list.begin(), list.end(), is_like) == 1 ? like : list.end();
  }

  /// "vertex", or what some programs write in its place.
  std::vector<PlyElement>::const_iterator findVertices() const {
    const auto& elements = header_.elements;
    for (const char* name : {"vertex", "vertices", "point", "points"}) {
      const auto found = findNamed(elements, name, [](const PlyElement& /*any*/) { return true; });
      if (found != elements.end()) return found;
    }
    return elements.end();
  }

  void check() {
    if (!format_seen_) throw failure<MessageId::header_without_format>(shownName(file_));
    const auto& elements = header_.elements;
    const auto vertices = findVertices();
    if (vertices == elements.end()) {
      throw failure<MessageId::no_vertices_promised>(shownName(file_));
    }
    header_.vertex_element = static_cast<std::size_t>(vertices - elements.begin());
    constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& list = vertices->properties;
      const auto at = findNamed(list, kAxes[axis],
                                [](const PlyProperty& p) { return !p.list_length.has_value(); });
      if (at == list.end()) {
        throw failure<MessageId::no_coordinate>(shownName(file_), kAxes[axis]);
      }
      header_.xyz[axis] = static_cast<std::size_t>(at - list.begin());
    }
    findValues(vertices->properties);
    findFaces();
  }

  void findValues(const std::vector<PlyProperty>& list) {
    std::array<std::optional<std::size_t>, 3> colour;
    for (std::size_t p = 0; p < list.size(); ++p) {
      if (list[p].list_length) continue;
      if (const auto channel = colourChannel(list[p].name)) {
        if (!colour[*channel]) colour[*channel] = p;
      } else if (isIntensity(list[p].name) && !header_.intensity) {
        header_.intensity = p;
      }
    }
    if (colour[0] && colour[1] && colour[2]) {
      header_.colour = std::array{*colour[0], *colour[1], *colour[2]};
    }
  }

  void findFaces() {
    for (std::size_t e = 0; e < header_.elements.size(); ++e) {
      if (header_.elements[e].name != "face") continue;
      const auto& list = header_.elements[e].properties;
      for (std::size_t p = 0; p < list.size(); ++p) {
        const bool named = list[p].name == "vertex_indices" || list[p].name == "vertex_index";
        if (!named || !list[p].list_length || !isWhole(list[p].type)) continue;
        header_.face_element = e;
        header_.face_corners = p;
      }
    }
  }

  std::string_view head_;
  Lines lines_;
  const std::filesystem::path& file_;
  PlyHeader header_;
  bool format_seen_ = false;
};

}  // namespace

bool PlyElement::hasList() const noexcept {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.list_length.has_value(); });
}

std::uint64_t PlyElement::leastBytes() const noexcept {
  std::uint64_t sum = 0;
  for (const PlyProperty& p : properties) sum += byteSize(p.list_length.value_or(p.type));
  return sum;
}

RecordLayout recordLayoutOf(const PlyHeader& header) {
  const std::vector<PlyProperty>& list = header.vertices().properties;
  std::vector<StoredNumber> numbers;
  RecordLayout layout;
  layout.order = header.byteOrder();
  for (const PlyProperty& property : list) {
    numbers.push_back({layout.bytes, property.type});
    layout.bytes += byteSize(property.type);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) layout.xyz[axis] = numbers[header.xyz[axis]];
  if (header.colour) {
    const auto& [red, green, blue] = *header.colour;
    layout.colour = std::array{numbers[red], numbers[green], numbers[blue]};
    layout.colour_source = list[red].name + " " + list[green].name + " " + list[blue].name;
  }
  if (header.intensity) layout.intensity = numbers[*header.intensity];
  return layout;
}

PlyHeader parsePlyHeader(std::string_view head, const std::filesystem::path& file) {
  requireReadersAllowed("parsePlyHeader");
  return HeaderParser(head.substr(0, kMaxHeaderBytes), file).parse();
}

}  // namespace relievo
