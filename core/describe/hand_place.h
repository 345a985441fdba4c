// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/origin.h"
#include "core/base/vec3.h"
#include "core/message/message.h"
#include "core/region/region.h"

namespace relievo {

/// Where a hand is on an object, and how it is felt there.
struct HandPlace {
  RectMm object;  ///< The whole map, view mm.
  ViewMm at;      ///< On the surface while touching; else the hand.
  bool touching = false;
  CellStatus origin = CellStatus::outside;  ///< Of the cell there, while touching.
  std::string name;                         ///< That somebody gave the place; empty: nobody did.
  int detail = 1, details = 1;
  double side_mm = 0;     ///< Of the window.
  double spacing_mm = 0;  ///< Of the samples of its level.
  double object_mm_per_hand_mm = 1;
};

/// "Touching: middle left, 30 millimetres high. Bookmark: Dome." Three facts at most.
std::vector<Message> shortWords(const HandPlace& place);
/// The same, then the distances from the edges, whether it was measured, and detailWords().
std::vector<Message> longWords(const HandPlace& place);
/// Resolution, window, scale of the hand, distance of samples.
std::vector<Message> detailWords(const HandPlace& place);

}  // namespace relievo
