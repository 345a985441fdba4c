// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/task.h"
#include "core/io/formats/scalar.h"

namespace relievo {

class ScanBuilder;

/// A number in every record of a file.
struct StoredNumber {
  std::size_t offset = 0;  ///< Within the record.
  ScalarType type = ScalarType::f32;
  friend bool operator==(const StoredNumber&, const StoredNumber&) = default;
};

/// What is read of binary records, and where in them it lies.
struct RecordLayout {
  std::size_t bytes = 0;  ///< Of a record.
  ByteOrder order = ByteOrder::little;
  std::array<StoredNumber, 3> xyz;
  std::optional<std::array<StoredNumber, 3>> colour;  ///< Red, green and blue.
  std::optional<std::size_t> packed_colour;           ///< 32 bits 0x..RRGGBB.
  std::optional<StoredNumber> intensity;
  std::string colour_source;  ///< As ColourFact::source.

  bool hasColour() const noexcept { return colour || packed_colour; }
};

/// Are its colours three numbers of one byte each? Any others are settled when all are known.
bool hasByteColours(const RecordLayout& layout) noexcept;

/// A number of all points, one every `stride` bytes.
struct Column {
  const char* first = nullptr;  ///< Null: there is none.
  std::size_t stride = 0;
  ScalarType type = ScalarType::f32;

  double at(std::uint64_t i, ByteOrder order) const noexcept {
    return loadDouble(first + i * stride, type, order);
  }
};

/// Points whose numbers lie somewhere in memory, record by record or field by field.
struct PointColumns {
  ByteOrder order = ByteOrder::little;
  std::array<Column, 3> xyz;
  std::array<Column, 3> colour;
  Column packed_colour, intensity;
};

/// Columns of records one after the other.
PointColumns columnsOf(const RecordLayout& layout, const char* records);

/// Prepares `builder` for so many points with what the layout says of them.
/// @param bytes  whether colours will come as bytes
void expectRecords(const RecordLayout& layout, std::uint64_t count, bool bytes,
                   ScanBuilder& builder);

/// Adds points and what is stored with them.
void addColumns(const PointColumns& columns, std::uint64_t count, ScanBuilder& builder);

/// Adds a file's records block by block; reports and looks at the stop token between them.
/// @throw Cancelled
void addRecords(const RecordLayout& layout, std::string_view records, std::uint64_t count,
                const Task& task, ScanBuilder& builder);

// Which names stand for what, in any case of letters.

/// 0 red, 1 green, 2 blue; nothing for other names.
std::optional<std::size_t> colourChannel(std::string_view name);
bool isIntensity(std::string_view name);
bool sameLetters(std::string_view a, std::string_view b);  ///< But for upper and lower case.

}  // namespace relievo
