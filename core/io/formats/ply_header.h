// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/unit.h"
#include "core/io/formats/scalar.h"
#include "core/io/point_columns.h"
#include "core/message/message.h"

namespace relievo {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::f32;      ///< Of the value, or of a list's items.
  std::optional<ScalarType> list_length;  ///< Present: a list, and the type of its length.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool hasList() const noexcept;
  /// Bytes of a binary record; of one with lists, the least possible.
  std::uint64_t leastBytes() const noexcept;
};

enum class PlyEncoding { ascii, binary_little_endian, binary_big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body_start = 0;         ///< Byte after the header.
  std::uint64_t body_first_line = 0;  ///< Lines of the header.

  std::size_t vertex_element = 0;
  std::array<std::size_t, 3> xyz{};  ///< Properties of the vertex element.
  /// Red, green and blue of the vertex element; all three or none. Not of faces.
  std::optional<std::array<std::size_t, 3>> colour;
  std::optional<std::size_t> intensity;
  std::optional<LengthUnit> unit;  ///< Stated by a line "comment unit mm".
  std::optional<std::size_t> face_element;
  std::size_t face_corners = 0;  ///< The list property of the face element.

  std::vector<Message> warnings;  ///< Of lines that were passed over.

  const PlyElement& vertices() const noexcept { return elements[vertex_element]; }
  ByteOrder byteOrder() const noexcept {
    return encoding == PlyEncoding::binary_big_endian ? ByteOrder::big : ByteOrder::little;
  }
};

/// Where a point's numbers lie in the binary records of a vertex element without lists.
RecordLayout recordLayoutOf(const PlyHeader& header);

inline constexpr std::size_t kMaxHeaderBytes = 1 << 20;

/// Parses and checks a header: known types, x, y and z present as numbers, sane lists, names and
/// counts. The body is not looked at. [any thread]
/// @param head  the first kMaxHeaderBytes of the file, or all of it
/// @throw FileError
PlyHeader parsePlyHeader(std::string_view head, const std::filesystem::path& file);

}  // namespace relievo
