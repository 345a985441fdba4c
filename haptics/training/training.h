// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/vec3.h"
#include "core/message/message.h"
#include "core/region/region_window.h"

namespace relievo {

/// What lies under the hand in the introduction, one after the other. All of them 80 mm wide, so
/// that 1 mm of the shape is 1 mm of hand.
enum class TrainingShape : std::uint8_t {
  plate,   ///< Flat.
  bump,    ///< A cap, 24 mm across and 6 mm high, at kBumpAt.
  step,    ///< 3 mm up beyond x = 40 mm.
  wave,    ///< Along x, 8 mm from crest to crest, 1 mm up and down.
  groove,  ///< Along x at kGrooveY, 4 mm wide and 2 mm deep.
};
inline constexpr int kTrainingShapes = 5;
inline constexpr double kTrainingSideMm = 80;
inline constexpr double kBumpX = 46, kBumpY = 48, kBumpRadiusMm = 12, kBumpHighMm = 6;
inline constexpr double kStepX = 40, kStepHighMm = 3;
inline constexpr double kWaveMm = 8, kWaveHighMm = 1;
inline constexpr double kGrooveY = 48, kGrooveWideMm = 4, kGrooveDeepMm = 2;

/// Height in closed form, view mm; x and y from the lower left corner.
double trainingHeightMm(TrainingShape shape, double x_mm, double y_mm);
/// The same as a surface. @param id  RegionWindow::id
RegionWindow trainingWindow(TrainingShape shape, std::uint64_t id);

/// What the hand does now.
struct TrainingTouch {
  ViewMm proxy;  ///< On the shape.
  bool contact = false;
};

/// Five tasks, or the first of them, each until the hand has found what it is about, or 20 s have
/// gone by; after 10 s a hint. So it takes less than two minutes, and any of them can be passed
/// over. No clock: time is an argument, and increases.
class Training {
 public:
  static constexpr double kHintS = 10, kMostS = 20;
  static constexpr double kPlateS = 6;  ///< Of contact in all.
  static constexpr double kBumpWithinMm = 8, kBumpS = 0.3;
  static constexpr double kStepBesideMm = 3, kStepS = 2;  ///< From one side to the other.
  static constexpr double kWaveWayMm = 24;                ///< Along x, in contact.
  static constexpr double kGrooveWayMm = 15;              ///< Likewise, in the groove.
  static constexpr double kPauseS = 1;  ///< Lifted for so long, a way begins anew.

  /// What there is to say and to do after a moment.
  struct News {
    std::vector<Message> say;
    bool other_shape = false;  ///< shape() is another one.
    bool over = false;
    bool found = false;  ///< What the task was about: for a tone.
  };

  /// The first task. @param before  what is said before it
  /// @param shapes  how many there are, 1 .. kTrainingShapes
  News begin(double now_s, std::vector<Message> before, int shapes = kTrainingShapes);
  /// Call it at least ten times a second.
  News touch(const TrainingTouch& touch, double now_s);
  /// On to the next task at once.
  News skip(double now_s);
  /// The task once more.
  Message task() const;
  TrainingShape shape() const { return shape_; }

 private:
  bool isFound(const TrainingTouch& touch, double now_s, double dt_s);
  News next(Message why, double now_s);
  void enter(TrainingShape shape, double now_s);

  TrainingShape shape_ = TrainingShape::plate;
  int shapes_ = kTrainingShapes;
  double since_s_ = 0, last_s_ = 0;
  bool hinted_ = false;
  double contact_s_ = 0;                     // In all; of the bump: within it, in a row.
  double way_mm_ = 0;                        // In contact.
  double lifted_s_ = 0;                      // In a row.
  double left_s_ = -1000, right_s_ = -1000;  // Last on either side of the step.
  std::optional<ViewMm> before_;             // Of the last touch, while in contact.
};

}  // namespace relievo
