// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/formats/text_columns.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "core/io/formats/lines.h"
#include "core/io/point_columns.h"

namespace relievo {
namespace {

/// What a column of x, y or z is called.
constexpr std::array<std::array<std::string_view, 4>, 3> kAxisNames{
    {{"x", "easting", "east"},
     {"y", "northing", "north"},
     {"z", "elevation", "height", "altitude"}}};

/// "1,5 2,5 3,5": commas within words that blanks separate.
bool hasDecimalCommas(std::string_view line) {
  int words = 0;
  bool comma = false;
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line), ++words) {
    if (word.front() == ',' || word.back() == ',' || word.find('.') != std::string_view::npos ||
        std::count(word.begin(), word.end(), ',') > 1) {
      return false;
    }
    comma = comma || word.find(',') != std::string_view::npos;
  }
  return comma && words >= 3;
}

/// May columns first ... first + 2 be red, green and blue? Normals of a flat piece are 0 and 1.
bool areColours(std::span<const std::vector<double>> rows, std::size_t first) {
  double most = 0;
  for (const std::vector<double>& row : rows) {
    for (std::size_t k = first; k < first + 3; ++k) {
      if (k >= row.size() || !isByteNumber(row[k])) return false;
      most = std::max(most, row[k]);
    }
  }
  return most > 1;
}

}  // namespace

RowStyle styleOf(std::string_view line) {
  if (line.find(';') != std::string_view::npos) {
    return {';', line.find(',') != std::string_view::npos};
  }
  if (line.find(',') == std::string_view::npos) return {};
  if (hasDecimalCommas(line)) return {0, true};
  return {',', false};
}

bool hasThousandsSeparators(std::string_view line) {
  bool inside = false;
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = takeWord(line);
    if (word.empty() || word.find_first_not_of("0123456789.,+-eE") != std::string_view::npos ||
        word.front() == ',' || word.back() == ',') {
      return false;
    }
    inside = inside || word.find(',') != std::string_view::npos;
  }
  return inside;
}

std::optional<std::string_view> takeColumn(std::string_view& rest, char separator) {
  if (separator == 0) {
    const std::string_view word = takeWord(rest);
    return word.empty() ? std::nullopt : std::optional(word);
  }
  while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
  if (rest.empty()) return std::nullopt;
  std::size_t end = 0;
  while (end < rest.size() && rest[end] != separator && !isBlank(rest[end])) ++end;
  std::string_view column = rest.substr(0, end);
  rest.remove_prefix(end);
  while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
  if (!rest.empty() && rest.front() == separator) rest.remove_prefix(1);
  if (column.size() >= 2 && column.front() == '"' && column.back() == '"') {
    column = column.substr(1, column.size() - 2);
  }
  return column;
}

std::vector<std::string_view> columnsOf(std::string_view line, char separator) {
  std::vector<std::string_view> columns;
  while (const auto column = takeColumn(line, separator)) columns.push_back(*column);
  return columns;
}

std::optional<double> parseColumn(std::string_view column, bool decimal_comma) {
  constexpr std::array<std::string_view, 6> kMissing{"", "NA", "N/A", "null", "NULL", "-"};
  if (std::find(kMissing.begin(), kMissing.end(), column) != kMissing.end() ||
      column.find("#QNAN") != std::string_view::npos ||
      column.find("#IND") != std::string_view::npos) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!decimal_comma) return parseNumber(column);
  std::array<char, 64> copy{};
  if (column.size() > copy.size()) return std::nullopt;
  std::replace_copy(column.begin(), column.end(), copy.begin(), ',', '.');
  return parseNumber({copy.data(), column.size()});
}

std::vector<std::string_view> namesOf(std::string_view line, char separator) {
  if (separator == 0) return columnsOf(line, separator);
  std::vector<std::string_view> names;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = line.find(separator);
    std::string_view name = trimmed(line.substr(0, end));
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
      name = trimmed(name.substr(1, name.size() - 2));
    }
    names.push_back(name);
    line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
  }
  return names;
}

std::array<std::optional<std::size_t>, 3> axisColumns(std::span<const std::string_view> names) {
  std::array<std::optional<std::size_t>, 3> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    // Without the unit.
    const std::string_view name = names[i].substr(0, names[i].find_first_of("_[( "));
    for (std::size_t axis = 0; axis < found.size(); ++axis) {
      const auto& words = kAxisNames[axis];
      const bool is_it = std::any_of(words.begin(), words.end(), [&](std::string_view word) {
        return !word.empty() && sameLetters(name, word);
      });
      if (is_it && !found[axis]) found[axis] = i;
    }
  }
  return found;
}

TextValues namedValues(std::span<const std::string_view> names) {
  TextValues values;
  std::array<std::optional<std::size_t>, 3> colour;
  for (std::size_t i = 0; i < names.size(); ++i) {
    // CloudCompare's "Rf", "Gf", "Bf" are 0 ... 1.
    const bool shares = names[i].size() == 2 && names[i][1] == 'f';
    if (const auto channel = colourChannel(shares ? names[i].substr(0, 1) : names[i])) {
      if (!colour[*channel]) colour[*channel] = i;
    } else if (isIntensity(names[i]) && !values.intensity) {
      values.intensity = i;
    }
  }
  if (colour[0] && colour[1] && colour[2]) {
    values.colour = std::array{*colour[0], *colour[1], *colour[2]};
  }
  return values;
}

bool isByteNumber(double number) {
  return number >= 0 && number <= 255 && number == std::floor(number);
}

TextValues guessedValues(std::span<const std::vector<double>> rows, bool pts) {
  TextValues values;
  std::size_t columns = std::numeric_limits<std::size_t>::max();
  for (const std::vector<double>& row : rows) columns = std::min(columns, row.size());
  if (rows.empty() || columns < 4) return values;
  const bool late = columns >= 7 && areColours(rows, 4);
  if (columns >= 6 && (!pts || !late) && areColours(rows, 3)) {
    values.colour = std::array<std::size_t, 3>{3, 4, 5};
  } else if (late) {
    values.colour = std::array<std::size_t, 3>{4, 5, 6};
    values.intensity = 3;
  } else if (pts && (columns == 4 || columns >= 7)) {
    values.intensity = 3;
  }
  return values;
}

}  // namespace relievo
