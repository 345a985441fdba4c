// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <QObject>

#include "core/base/vec3.h"
#include "haptics/guide/beacon_pull.h"
#include "haptics/loop/haptic_core.h"
#include "plugins/api/plugin.h"
#include "plugins/haptics/loop_session.h"

namespace relievo {

/// Pulls the hand back to a marker that was gone to, once the marker's window lies under it, and
/// says how that ended. A device that cannot push is left alone. [GUI thread]
class MarkerPull : public QObject {
  Q_OBJECT
 public:
  explicit MarkerPull(Host& host) : host_(host) {}

  /// A marker was gone to. @param x_mm  view mm, as y_mm
  void goTo(double x_mm, double y_mm);
  /// Off without a word, as where forces or the device go, which is said already.
  void drop();
  /// Once a frame.
  void frame(LoopSession& session, const HapticSample& sample, bool forces_on);
  /// For HapticOptions.
  const BeaconOptions& options() const { return beacon_; }

 Q_SIGNALS:
  void changed();  ///< options() are others.

 private:
  void begin(const LoopSession& session, const HapticSample& sample);

  Host& host_;
  std::optional<ViewMm> wanted_;  // Gone to, and not under the hand yet.
  BeaconOptions beacon_;
  std::uint64_t last_id_ = 0;
};

}  // namespace relievo
