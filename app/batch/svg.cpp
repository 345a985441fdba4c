// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace relievo::batch {

Axis axisFor(double low, double high) {
  if (!(high - low > 1e-9)) {
    low -= 0.5;
    high += 0.5;
  }
  const double raw = (high - low) / 5;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= raw) step = factor * power;
  }
  return {
      .low = std::floor(low / step) * step, .high = std::ceil(high / step) * step, .step = step};
}

std::string fixedDigits(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::string tickText(double value, double step) {
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fixedDigits(std::abs(value) < 1e-12 ? 0 : value, digits);
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string textAt(double x, double y, const std::string& anchor, const std::string& text,
                   const std::string& more) {
  return "<text x='" + fixedDigits(x, 1) + "' y='" + fixedDigits(y, 1) + "' text-anchor='" +
         anchor + "'" + more + ">" + text + "</text>\n";
}

std::string lineAt(double x1, double y1, double x2, double y2, const std::string& colour) {
  return "<line x1='" + fixedDigits(x1, 1) + "' y1='" + fixedDigits(y1, 1) + "' x2='" +
         fixedDigits(x2, 1) + "' y2='" + fixedDigits(y2, 1) + "' stroke='" + colour + "'/>\n";
}

}  // namespace relievo::batch
