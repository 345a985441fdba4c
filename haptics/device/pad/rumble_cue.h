// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace relievo::pad {

/// What the hand does at one tick, as far as a pad rumbles for it.
struct TouchMoment {
  std::int64_t time_ns = 0;  ///< Monotonic.
  bool counts = false;       ///< Forces are on, and nothing has ended them.
  bool contact = false;
  bool at_edge = false;  ///< The hand is over the edge of the window, or of what was measured.
  double force_n = 0;    ///< Its size.
};

/// How hard a pad's two motors turn, 0 .. 1. A cue that something happened; it has no direction,
/// says nothing exact of a force, and is in no statistic of forces.
struct RumbleLevel {
  double strong = 0, weak = 0;
  bool any() const noexcept { return strong > 0 || weak > 0; }
  friend bool operator==(const RumbleLevel&, const RumbleLevel&) = default;
};

/// A short knock of the strong motor when the hand meets the surface, the harder the more the force
/// changed in 20 ms; the weak motor as long as the hand is at the edge. Nothing where moments are
/// older than 50 ms: the loop stands still. No clock of its own. [drain thread]
class RumbleCue {
 public:
  static constexpr std::int64_t kKnockNs = 80'000'000, kStaleNs = 50'000'000;
  static constexpr double kLeast = 0.25, kEdge = 0.375;
  static constexpr double kFullN = 2;  ///< A change of force that is shown in full.

  RumbleLevel next(std::span<const TouchMoment> moments, std::int64_t now_ns) noexcept;

 private:
  void take(const TouchMoment& moment) noexcept;

  TouchMoment before_;
  std::int64_t contact_ns_ = 0, knock_until_ns_ = 0;
  double force_before_n_ = 0, knock_ = 0;
};

}  // namespace relievo::pad
