// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

namespace relievo {

/// Shortest texts that read back as the same doubles, a blank between; never a decimal comma.
inline std::string roundTripText(std::span<const double> numbers) {
  std::string text;
  std::array<char, 32> buffer{};
  for (const double number : numbers) {
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    if (!text.empty()) text += ' ';
    text.append(buffer.data(), end);
  }
  return text;
}

/// N finite numbers and nothing else. Null gives nothing.
template <std::size_t N>
std::optional<std::array<double, N>> parseNumbers(const char* text) {
  if (text == nullptr) return std::nullopt;
  std::array<double, N> numbers{};
  std::string_view rest(text);
  for (double& number : numbers) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  if (rest.find_first_not_of(' ') != std::string_view::npos) return std::nullopt;
  return numbers;
}

}  // namespace relievo
