// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <QObject>

#include "core/region/region_window.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/training/training.h"
#include "plugins/api/plugin.h"

namespace relievo {

/// The introduction to touch: says its tasks, and which shape lies under the hand meanwhile in
/// place of the relief. [GUI thread]
class TouchTraining : public QObject {
  Q_OBJECT
 public:
  explicit TouchTraining(Host& host) : host_(host) {}

  struct Beginning {
    int shapes = kTrainingShapes;     ///< The first so many.
    bool switches_forces_on = false;  ///< They were off, and come on for it.
  };
  void begin(const Beginning& beginning, double now_s);
  /// On to the next shape.
  void skip(double now_s);
  /// The task once more.
  void repeat();
  /// Off; the relief is back.
  void stop();
  /// Once a frame.
  void frame(const HapticSample& sample, double now_s);
  bool isOn() const { return window_ != nullptr; }
  /// What lies under the hand; null: it is off.
  const RegionWindow* window() const { return window_.get(); }
  /// Where the pointer's hand is on the shape: at the same part of its width, as deep below it.
  /// @param shown  that the target is over
  ViewMm target(const HandTarget& target, const RegionWindow& shown) const;

 Q_SIGNALS:
  void found();  ///< What a task was about.
  /// window() is another one, or none.
  void changed();

 private:
  void take(const Training::News& news);

  Host& host_;
  Training training_;
  std::unique_ptr<const RegionWindow> window_;
  std::uint64_t windows_ = 0;  // So far.
};

}  // namespace relievo
