// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <QObject>
#include <string>
#include <vector>

#include "core/outline/outline.h"
#include "core/region/region_window.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/record/recorded_way.h"
#include "plugins/api/plugin.h"
#include "plugins/haptics/loop_session.h"

namespace relievo {

/// Leads the hand along outlines and recorded ways, for menu, key and buttons, and says so. What it
/// is led along is found by a worker. [GUI thread]
class TouchGuide : public QObject {
  Q_OBJECT
 public:
  explicit TouchGuide(Host& host) : host_(host) {}
  ~TouchGuide() override;  ///< Waits for the worker, some ten milliseconds.

  /// Along the outline nearest to the hand; or off, if it leads already.
  /// @param rounds  1 .. kMostRounds
  void toggle(const LoopSession& session, bool forces_on, int rounds = kMostRounds);
  /// Along the way of a recording or a stroke.
  void along(const QString& file, const LoopSession& session, bool forces_on);
  /// Off, and says so if it was on.
  void stop();
  /// Off, as a button went down: the hand leads, and that is said.
  void letGo();
  /// Off without a word, as where forces or the device go, which is said already.
  void drop();
  /// Once a frame, after the buttons' events of this sample were looked at.
  void frame(LoopSession& session, const HapticSample& sample);
  /// What is asked for, or is being found.
  bool isOn() const { return path_ != 0 || finding_.valid(); }
  /// For HapticOptions.
  GuideOptions options() const { return {.path = path_}; }

 Q_SIGNALS:
  /// options() are others, or isOn() is.
  void changed();

 private:
  struct Found {
    std::shared_ptr<const RegionWindow> window;  ///< Where.
    std::vector<Outline> outlines;               ///< Of it; or ...
    std::vector<WayPoint> way;                   ///< ... of a file.
    std::shared_ptr<const Message> problem;      ///< Null: none.
  };
  bool isPossible(const LoopSession& session, bool forces_on);
  void take(LoopSession& session, const HapticSample& sample);
  std::optional<GuidePath> pathOf(const Found& found, const HandMapping& mapping,
                                  const HapticSample& sample, MessageId& of);
  void sayEnd(GuideEnd end);

  Host& host_;
  std::future<Found> finding_;
  std::uint64_t path_ = 0;  // GuidePath::id; 0: none.
  int rounds_ = kMostRounds;
};

}  // namespace relievo
