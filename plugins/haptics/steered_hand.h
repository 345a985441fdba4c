// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/region/hand.h"
#include "core/region/region_window.h"
#include "haptics/device/device.h"
#include "haptics/loop/haptic_core.h"

namespace relievo {

/// A hand that mouse and keys move, over the surface that the loop has. Does nothing where a person
/// holds the device. [GUI thread]
class SteeredHand {
 public:
  static constexpr double kMostLeadMm = 6;

  /// @param device  owned by the loop; null: a person holds it
  explicit SteeredHand(SteeredDevice* device) : device_(device) {}

  bool isSteered() const noexcept { return device_ != nullptr; }
  /// The loop has a surface, laid under the hand so. The hand keeps its place sideways, as far as
  /// that is over the window, and its depth.
  /// @param last   the newest sample  @param first  the loop had no surface before
  void takeSurface(const RegionWindow& window, const HandMapping& mapping, const HapticSample& last,
                   bool first);
  /// Where the pointer wants it, view mm of that window.
  void moveTo(const RegionWindow& window, ViewMm target);
  /// Carries it on from where it was last sent. @param hip  where it is
  void push(DeviceMm by, DeviceMm hip);
  /// Follows a hand that is led a little, as an arm gives way. Once a frame. @param hip  where it
  /// is
  void giveWay(DeviceMm hip);
  /// How the loop's surface lies under the hand.
  const HandMapping& mapping() const noexcept { return mapping_; }

 private:
  void hoverAt(ViewMm target);

  SteeredDevice* device_;
  HandMapping mapping_;
  DeviceMm sent_;       // Where it was last sent ...
  bool hovers_ = true;  // ... and how.
};

}  // namespace relievo
