// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/report_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/provenance/name_text.h"

namespace relievo::batch {
namespace {

void nameTexts(Json& part) {
  if (part.is_string()) {
    part = textOfName(part.get_ref<const std::string&>());
  } else if (part.is_structured()) {
    for (Json& inner : part) nameTexts(inner);
  }
}

}  // namespace

double shownNumber(double value) {
  constexpr int kSureDigits = std::numeric_limits<double>::digits10;
  std::array<char, 40> text{};
  char* const begin = text.data();
  char* end = std::to_chars(begin, begin + text.size(), value, std::chars_format::scientific).ptr;
  const auto digits =
      std::count_if(begin, std::find(begin, end, 'e'), [](char c) { return c >= '0' && c <= '9'; });
  if (digits <= kSureDigits) return value;
  const bool in_range = std::abs(value) <= std::numeric_limits<float>::max();
  const float stored = in_range ? static_cast<float>(value) : 0;
  if (static_cast<double>(stored) == value) {
    end = std::to_chars(begin, begin + text.size(), stored).ptr;
  } else {
    end = std::to_chars(begin, begin + text.size(), value, std::chars_format::scientific,
                        kSureDigits - 1)
              .ptr;
  }
  std::from_chars(begin, end, value);
  return value;
}

std::string counted(std::uint64_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

std::string reportText(Json report) {
  nameTexts(report);
  return report.dump(2);
}

}  // namespace relievo::batch
