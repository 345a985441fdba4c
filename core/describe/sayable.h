// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/message/message.h"
#include "core/region/region.h"

namespace relievo {

/// A number as one says it: of 1 to 20 and 25 to 100 by fives, of halves below 5, and of these by
/// powers of ten. What is further than 8 % from all of them has two digits instead.
struct SayableNumber {
  enum class Nearness : std::uint8_t { exact, nearly, over };
  double value = 0;
  Nearness nearness = Nearness::exact;  ///< `exact`: within 2 % of it.
};
/// @param value  finite, >= 0
SayableNumber sayableNumber(double value);

/// "30 centimetres", "nearly 4 centimetres": millimetres below 10, metres from 1000 mm on.
/// @param mm  finite; its sign is not said
Message sayableLength(double mm);

/// "about a sixth", "37 percent". @param share  0 .. 1
Message sayableShare(double share);

/// Where on an object: a third of its width and a third of its height, as one looks at it.
enum class Ninth : std::uint8_t {
  top_left,
  top_middle,
  top_right,
  middle_left,
  middle,
  middle_right,
  bottom_left,
  bottom_middle,
  bottom_right
};
inline constexpr int kNinths = 9;

/// Of a place, or of the place on the object that is nearest to it. @param object  view mm, not
/// empty
Ninth ninthOf(const RectMm& object, double x_mm, double y_mm);
Message messageOf(Ninth ninth);

}  // namespace relievo
