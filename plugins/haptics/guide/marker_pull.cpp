// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/guide/marker_pull.h"

#include <cmath>

#include "core/message/catalogue.h"

namespace relievo {

void MarkerPull::goTo(double x_mm, double y_mm) {
  drop();
  wanted_ = ViewMm{x_mm, y_mm, 0};
}

void MarkerPull::drop() {
  wanted_.reset();
  if (beacon_.id == 0) return;
  beacon_ = {};
  Q_EMIT changed();
}

void MarkerPull::frame(LoopSession& session, const HapticSample& sample, bool forces_on) {
  if (wanted_) {
    if (!forces_on || !(session.device().max_force_n > 0)) return drop();
    const auto window = host_.view.shownWindow();
    const bool is_there =
        window && !session.isPreparing() && sample.window_id == window->id && sample.change >= 1;
    if (is_there) begin(session, sample);
    return;
  }
  if (beacon_.id == 0 || sample.beacon != beacon_.id) return;
  if (sample.pulled_back) return session.giveWay(sample);
  const GuideEnd end = sample.beacon_end;
  drop();
  if (end == GuideEnd::arrived) host_.messages.say({said<MessageId::marker_reached>()});
  if (end == GuideEnd::you_lead || end == GuideEnd::button) {
    host_.messages.say({said<MessageId::guide_you_lead>()});
  }
}

void MarkerPull::begin(const LoopSession& session, const HapticSample& sample) {
  const DeviceMm place = session.mapping().device_from_view(*wanted_);
  wanted_.reset();
  if (std::abs(place.x) > kHandReach.x || std::abs(place.y) > kHandReach.y) return;
  beacon_ = {.id = ++last_id_, .place = place, .scene_id = sample.scene_id};
  Q_EMIT changed();
}

}  // namespace relievo
