// SPDX-License-Identifier: BSD-3-Clause
// Elements and attributes: ASTM E2807, sections on Data3D and CompressedVector.
#include "core/io/e57/e57_scans.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/io/e57/e57_pages.h"
#include "core/io/e57/xml_tree.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

std::string_view withoutSpace(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

[[noreturn]] void refuse(Message what) {
  throw E57Fault(said<MessageId::e57_entry>(std::move(what)));
}

XmlElement parse(const std::string& xml) {
  try {
    return parseXml(xml);
  } catch (const XmlError& error) {
    throw E57Fault(said<MessageId::e57_no_proper_xml>(printable(error.what())));
  }
}

/// A number, `absent` if nothing is written.
template <class Number>
Number numberOf(std::string_view text, Number absent) {
  text = withoutSpace(text);
  if (text.empty()) return absent;
  if constexpr (std::is_same_v<Number, double>) {
    const auto number = parseNumber(text);
    if (number && std::isfinite(*number)) return *number;
  } else {
    if (const auto number = parseWhole<Number>(text)) return *number;
  }
  refuse(said<MessageId::e57_entry_no_number>(printable(text.substr(0, 40))));
}

double childNumber(const XmlElement& element, std::string_view name, double absent) {
  const XmlElement* const child = element.child(name);
  return child == nullptr ? absent : numberOf(child->text, 0.0);
}

/// No codec means bits packed one after the other, the only one there is.
void checkCodecs(const XmlElement& points) {
  const XmlElement* const codecs = points.child("codecs");
  if (codecs == nullptr) return;
  for (const XmlElement& codec : codecs->children) {
    if (codec.child("bitPackCodec") == nullptr) refuse(said<MessageId::e57_entry_codec>());
  }
}

/// Nothing unless both are finite numbers: a scan without them can be read all the same.
std::optional<std::array<double, 2>> limitsOf(std::string_view low, std::string_view high) {
  const auto least = parseNumber(withoutSpace(low));
  const auto most = parseNumber(withoutSpace(high));
  if (!least || !most || !std::isfinite(*least) || !std::isfinite(*most)) return std::nullopt;
  return std::array{*least, *most};
}

E57Field fieldOf(const XmlElement& element) {
  E57Field field;
  field.name = element.name;
  const std::string_view type = element.attribute("type");
  if (type == "Float") {
    const bool single = element.attribute("precision") == "single";
    field.kind = single ? E57Field::Kind::f32 : E57Field::Kind::f64;
    field.bits = single ? 32 : 64;
    field.limits = limitsOf(element.attribute("minimum"), element.attribute("maximum"));
  } else if (type == "Integer" || type == "ScaledInteger") {
    using Limits = std::numeric_limits<std::int64_t>;
    field.kind = E57Field::Kind::whole;
    field.minimum = numberOf<std::int64_t>(element.attribute("minimum"), Limits::min());
    const auto maximum = numberOf<std::int64_t>(element.attribute("maximum"), Limits::max());
    if (maximum < field.minimum) refuse(said<MessageId::e57_entry_maximum>(printable(field.name)));
    field.bits = static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(maximum) -
                                                      static_cast<std::uint64_t>(field.minimum)));
    if (type == "ScaledInteger") {
      field.scale = numberOf(element.attribute("scale"), 1.0);
      field.offset = numberOf(element.attribute("offset"), 0.0);
    }
    if (!element.attribute("maximum").empty()) {
      const auto value = [&field](std::int64_t whole) {
        return static_cast<double>(whole) * field.scale + field.offset;
      };
      field.limits = std::array{value(field.minimum), value(maximum)};
    }
  }
  return field;
}

void addFields(const XmlElement& prototype, std::vector<E57Field>& fields) {
  for (const XmlElement& element : prototype.children) {
    if (element.attribute("type") == "Structure") {
      addFields(element, fields);
    } else {
      fields.push_back(fieldOf(element));
    }
  }
}

/// Of a quaternion w, x, y, z, which need not have length 1 to the last digit.
std::array<double, 9> rotationOf(const std::array<double, 4>& q) {
  const auto [w, x, y, z] = q;
  const double square = w * w + x * x + y * y + z * z;
  if (std::abs(square - 1) > 0.01) refuse(said<MessageId::e57_entry_rotation>());
  const double s = 2 / square;
  return {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
          s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
          s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
}

E57Pose poseOf(const XmlElement& element) {
  E57Pose pose;
  if (const XmlElement* const q = element.child("rotation")) {
    pose.rotation = rotationOf({childNumber(*q, "w", 0), childNumber(*q, "x", 0),
                                childNumber(*q, "y", 0), childNumber(*q, "z", 0)});
  }
  if (const XmlElement* const t = element.child("translation")) {
    pose.translation = {childNumber(*t, "x", 0), childNumber(*t, "y", 0), childNumber(*t, "z", 0)};
  }
  return pose;
}

void readColourLimits(const XmlElement& element, E57Scan& scan) {
  const XmlElement* const limits = element.child("colorLimits");
  if (limits == nullptr) return;
  constexpr std::array<std::string_view, 3> kNames{"colorRed", "colorGreen", "colorBlue"};
  for (std::size_t k = 0; k < 3; ++k) {
    const XmlElement* const low = limits->child(std::string(kNames[k]) + "Minimum");
    const XmlElement* const high = limits->child(std::string(kNames[k]) + "Maximum");
    // An element without text is the number 0.
    const auto text = [](const XmlElement* stated) {
      return withoutSpace(stated->text).empty() ? std::string_view("0") : stated->text;
    };
    if (low != nullptr && high != nullptr) {
      scan.colour_limits[k] = limitsOf(text(low), text(high));
    }
  }
}

E57Scan scanOf(const XmlElement& element) {
  const XmlElement& points = *element.child("points");
  if (points.attribute("type") != "CompressedVector") refuse(said<MessageId::e57_entry_points>());
  E57Scan scan;
  scan.records = numberOf<std::uint64_t>(points.attribute("recordCount"), 0);
  scan.section_at = numberOf<std::uint64_t>(points.attribute("fileOffset"), 0);
  checkCodecs(points);
  const XmlElement* const prototype = points.child("prototype");
  if (prototype == nullptr) refuse(said<MessageId::e57_entry_prototype>());
  addFields(*prototype, scan.fields);
  if (const XmlElement* const pose = element.child("pose")) {
    scan.pose = poseOf(*pose);
    scan.has_pose = true;
  }
  readColourLimits(element, scan);
  return scan;
}

/// What it says is wrong with one entry stays with that entry.
E57Scan scanOrFault(const XmlElement& element) {
  E57Scan scan;
  try {
    scan = scanOf(element);
  } catch (const E57Fault& fault) {
    scan.fault = fault.why;
  }
  if (const XmlElement* const name = element.child("name")) scan.name = withoutSpace(name->text);
  return scan;
}

}  // namespace

std::optional<std::size_t> E57Scan::find(std::string_view field_name) const noexcept {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].name == field_name && fields[i].kind != E57Field::Kind::other) return i;
  }
  return std::nullopt;
}

std::vector<E57Scan> listE57Scans(const std::string& xml) {
  const XmlElement root = parse(xml);
  const XmlElement* const list = root.child("data3D");
  std::vector<E57Scan> scans;
  if (list != nullptr) {
    for (const XmlElement& element : list->children) {
      if (element.child("points") != nullptr) scans.push_back(scanOrFault(element));
    }
  }
  if (scans.empty()) throw E57Fault(said<MessageId::e57_without_scans>());
  return scans;
}

}  // namespace relievo
