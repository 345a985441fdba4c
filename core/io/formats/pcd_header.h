// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vec3.h"
#include "core/io/formats/scalar.h"
#include "core/io/point_columns.h"
#include "core/message/message.h"

namespace relievo {

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::uint64_t count = 1;   ///< Numbers per point.
  std::uint64_t column = 0;  ///< Of its first number in a text row.
  std::uint64_t offset = 0;  ///< Of its first byte in a binary record.
};

enum class PcdEncoding { ascii, binary, binary_compressed };

struct PcdHeader {
  PcdEncoding encoding = PcdEncoding::ascii;
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  std::uint64_t record_bytes = 0;
  std::size_t body_start = 0;
  std::uint64_t body_first_line = 0;
  std::array<std::size_t, 3> xyz{};                  ///< Fields.
  std::optional<std::array<std::size_t, 3>> colour;  ///< Fields red, green and blue.
  std::optional<std::size_t> packed_colour;          ///< The field rgb or rgba, 32 bits.
  std::optional<std::size_t> intensity;
  std::vector<Message> warnings;       ///< Of lines that were passed over.
  std::optional<FilePoint> viewpoint;  ///< If it is not 0 0 0, what programs write without knowing.
};

/// Where a point's numbers lie in a binary record.
RecordLayout recordLayoutOf(const PcdHeader& header);

/// Parses and checks a header: sizes, types and counts that agree, x, y and z present once each,
/// WIDTH x HEIGHT = POINTS without overflow. The body is not looked at. [any thread]
/// @param head  the first kMaxHeaderBytes of the file, or all of it
/// @throw FileError
PcdHeader parsePcdHeader(std::string_view head, const std::filesystem::path& file);

}  // namespace relievo
