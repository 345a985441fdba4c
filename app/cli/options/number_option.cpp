// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/number_option.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <CLI/CLI.hpp>
#include <string_view>

#include "core/io/formats/lines.h"

namespace relievo::batch {
namespace {

/// Shortest text that is read as the same number: 0.5, 1e+06.
std::string shortText(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string wordsOf(const NumberRange& range) {
  const std::string unit = *range.unit == '\0' ? "" : std::string(" ") + range.unit;
  return shortText(range.low) + " to " + shortText(range.high) + unit;
}

/// Empty where the number is in the range; not a number is in none.
std::string refusal(std::string_view text, const NumberRange& range) {
  const auto value = parseNumber(text);
  if (value && *value >= range.low && *value <= range.high) return {};
  return "'" + std::string(text) + "' is not a number from " + wordsOf(range);
}

std::string refusalOfList(std::string_view text, std::size_t count, const NumberRange& range) {
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  if (commas + 1 != count) {
    return "'" + std::string(text) + "' is not " + std::to_string(count) +
           " numbers separated by commas";
  }
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    if (std::string why = refusal(text.substr(0, comma), range); !why.empty()) return why;
    if (comma == text.size()) return {};
    text.remove_prefix(comma + 1);
  }
}

}  // namespace

CLI::Option& takes(CLI::Option* option, const NumberRange& range) {
  return *option->check(CLI::Validator(
      [range](const std::string& text) { return refusal(text, range); }, wordsOf(range), "number"));
}

CLI::Option& takesList(CLI::Option* option, std::size_t count, const NumberRange& range) {
  return *option->check(CLI::Validator(
      [count, range](const std::string& text) { return refusalOfList(text, count, range); },
      "each " + wordsOf(range), "number"));
}

void refuseEmptyTexts(CLI::App& verb) {
  for (CLI::Option* option : verb.get_options()) {
    option->check(CLI::Validator(
        [](const std::string& text) {
          return text.empty() ? std::string("it is given without a value") : std::string();
        },
        "", "not empty"));
  }
  for (CLI::App* sub : verb.get_subcommands({})) refuseEmptyTexts(*sub);
}

}  // namespace relievo::batch
