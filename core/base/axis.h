// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// Limits and grid of one axis of a plot, in the unit of what is plotted.
struct Axis {
  double low = 0, high = 1, step = 0.2;
};

enum class AxisEnds {
  round,  ///< The limits are multiples of the step: for values.
  exact,  ///< The limits stay as given: for time and for length along a line.
};

/// The smallest step of 1, 2 or 5 times a power of ten that leaves at most `most_steps` of them
/// between the limits given. Limits that are the same are drawn half a unit apart.
Axis axisFor(double low, double high, int most_steps = 5, AxisEnds ends = AxisEnds::round);

/// A grid line's number with just the digits its step needs; the same in every locale.
std::string tickText(double value, double step);

/// A number with so many digits behind the point; the same in every locale.
std::string fixedDigits(double value, int digits);

}  // namespace relievo
