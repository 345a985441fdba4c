// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/axis.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace relievo {
namespace {

constexpr double kRounding =
    1e-9;  // Of a step: a limit that is a multiple but for rounding is one.

}  // namespace

Axis axisFor(double low, double high, int most_steps, AxisEnds ends) {
  if (!(high - low > 1e-9)) {
    low -= 0.5;
    high += 0.5;
  }
  const double raw = (high - low) / most_steps;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= raw) step = factor * power;
  }
  if (ends == AxisEnds::round) {
    low = std::floor(low / step + kRounding) * step;
    high = std::ceil(high / step - kRounding) * step;
  }
  return {.low = low, .high = high, .step = step};
}

std::string fixedDigits(double value, int digits) {
  std::array<char, 350> text{};  // The longest double has 309 digits before the point.
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, std::clamp(digits, 0, 30));
  return {text.data(), end.ptr};
}

std::string tickText(double value, double step) {
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - kRounding)));
  return fixedDigits(std::abs(value) < kRounding * step ? 0 : value, digits);
}

}  // namespace relievo
