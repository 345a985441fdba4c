// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/force_law.h"

#include <array>
#include <charconv>

#include "core/recording/log_table.h"

namespace relievo {

namespace {
struct Law {
  int number;
  std::string_view since, change;
};
constexpr std::array<Law, 6> kLaws{{
    {2, "2026-11-22",
     "a tick sends the force that it has computed, not the last one's; settings and surfaces "
     "change "
     "by the force that is felt; the frame is one potential with the spring"},
    {3, "2026-11-23",
     "a slow loop or device bounds the stiffness (E306); a calibrated grip's weight is held"},
    {4, "2026-11-23", "friction pulls against the way of the last millimetre"},
    {5, "2026-11-23",
     "on rough ground friction pulls against the way of 1.5 times what it trails by"},
    {6, "2026-11-24",
     "a hand whose ground vanishes while one surface turns into another is let go step by step"},
    {7, "2026-11-28",
     "what a surface gives the hand by turning into another is owed by nobody: no damping takes it "
     "back, and many changes in a row soften nothing"},
}};
static_assert(kLaws.back().number == kForceLaw);
}  // namespace

std::string lawLine() {
  return "law " + std::to_string(kForceLaw);
}

std::optional<int> lawIn(std::string_view header) {
  const std::string_view text = headerLine(header, "law ");
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string lawDifference(std::string_view header) {
  const std::optional<int> law = lawIn(header);
  if (law == kForceLaw) return {};
  const std::string_view version = headerLine(header, "version ");
  std::string text = "It was made by version " + std::string(version.empty() ? "?" : version) +
                     " under " +
                     (law ? "force law " + std::to_string(*law) : "an earlier force law") +
                     "; this build has law " + std::to_string(kForceLaw) + ".";
  for (const Law& later : kLaws) {
    if (law && later.number <= *law) continue;
    text += " Law " + std::to_string(later.number) + " (" + std::string(later.since) +
            "): " + std::string(later.change) + ".";
  }
  return text;
}

}  // namespace relievo
