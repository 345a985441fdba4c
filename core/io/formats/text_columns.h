// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace relievo {

/// How a file of rows separates its columns and writes its fractions.
struct RowStyle {
  char separator = 0;  ///< ';' or ',', besides blanks; 0: blanks only.
  bool decimal_comma = false;
};
RowStyle styleOf(std::string_view line);
/// "1,234.5 2,345.6 12" or "1.234,5 2.345,6 12": blanks separate three numbers, in which commas
/// neither separate columns nor are all that begins a fraction.
bool hasThousandsSeparators(std::string_view line);

/// Takes the next column off `rest`. Empty between two separators; nothing at the end.
std::optional<std::string_view> takeColumn(std::string_view& rest, char separator);
std::vector<std::string_view> columnsOf(std::string_view line, char separator);

/// A missing number ("1,,3", "NULL") is NaN; nothing for other words.
std::optional<double> parseColumn(std::string_view column, bool decimal_comma);

/// Columns beside the coordinates.
struct TextValues {
  std::optional<std::array<std::size_t, 3>> colour;
  std::optional<std::size_t> intensity;
};

/// The columns of a row of names: between separators other than blanks a name may have blanks,
/// "X (m)".
std::vector<std::string_view> namesOf(std::string_view line, char separator);

/// Columns named x, y and z: "x", "X", "x_mm", "X[m]", "X (m)", or as surveyors call them: easting,
/// northing, elevation or height.
std::array<std::optional<std::size_t>, 3> axisColumns(std::span<const std::string_view> names);
/// Columns named red, green, blue and intensity.
TextValues namedValues(std::span<const std::string_view> names);

/// A whole number from 0 to 255?
bool isByteNumber(double number);
/// By what the first rows hold. "x y z r g b ..." where these three are bytes and not only 0 and 1
/// as in normals; "x y z i r g b" of PTS files.
TextValues guessedValues(std::span<const std::vector<double>> rows, bool pts);

}  // namespace relievo
