// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo::batch {

/// Limits and grid of one axis of a figure.
struct Axis {
  double low = 0, high = 1, step = 0.2;
};

/// Round steps (1, 2, 5 times a power of ten) and limits that are multiples of them.
Axis axisFor(double low, double high);

// Pieces of an SVG text; lengths in SVG units, the same digits in every locale.
std::string fixedDigits(double value, int digits);
std::string tickText(double value, double step);  ///< A grid line's number.
std::string escaped(const std::string& text);     ///< For XML: a file may be called "a & b".
/// @param anchor  "start", "middle" or "end"; `more` are further attributes
std::string textAt(double x, double y, const std::string& anchor, const std::string& text,
                   const std::string& more = {});
std::string lineAt(double x1, double y1, double x2, double y2, const std::string& colour);

}  // namespace relievo::batch
