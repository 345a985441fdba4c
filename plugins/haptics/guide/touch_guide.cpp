// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/guide/touch_guide.h"

#include <chrono>
#include <cmath>
#include <QFile>
#include <utility>

#include "core/base/failure.h"
#include "core/message/catalogue.h"
#include "ui/message/message_text.h"

namespace relievo {

namespace {
MessageId wordsOf(OutlineOf of) {
  switch (of) {
    case OutlineOf::raised:
      return MessageId::guide_of_raised;
    case OutlineOf::sunk:
      return MessageId::guide_of_sunk;
    case OutlineOf::object:
      break;
  }
  return MessageId::guide_of_object;
}

bool isWithinReach(const DeviceMm& p) {
  return std::abs(p.x) <= kHandReach.x && std::abs(p.y) <= kHandReach.y &&
         std::abs(p.z) <= kHandReach.z;
}
}  // namespace

TouchGuide::~TouchGuide() {
  if (finding_.valid()) finding_.wait();
}

bool TouchGuide::isPossible(const LoopSession& session, bool forces_on) {
  std::optional<Message> refusal;
  if (!host_.view.shownWindow()) {
    refusal = said<MessageId::place_nothing_open>();
  } else if (!(session.device().max_force_n > 0)) {
    refusal = said<MessageId::guide_needs_grip>();
  } else if (!forces_on) {
    refusal = said<MessageId::guide_needs_forces>();
  }
  if (refusal) {
    host_.messages.say({*refusal});
    Q_EMIT changed();  // A button that was pressed for it is up again.
  }
  return !refusal;
}

void TouchGuide::toggle(const LoopSession& session, bool forces_on, int rounds) {
  if (isOn()) return stop();
  rounds_ = rounds;
  if (!isPossible(session, forces_on)) return;
  const std::shared_ptr<const RegionWindow> window = host_.view.shownWindow();
  const double tolerance_mm = kOutlineToleranceMm * handMapping(*window).objectMmPerHandMm();
  finding_ =
      std::async(std::launch::async, [window, tolerance_mm, edges = host_.view.edges()]() -> Found {
        return {.window = window,
                .outlines = outlinesOf(*window, edges, tolerance_mm),
                .way = {},
                .problem = {}};
      });
  Q_EMIT changed();
}

void TouchGuide::along(const QString& file, const LoopSession& session, bool forces_on) {
  if (isOn()) drop();
  if (!isPossible(session, forces_on)) return;
  const std::shared_ptr<const RegionWindow> window = host_.view.shownWindow();
  const std::string name = QFile::encodeName(file).toStdString();
  finding_ = std::async(std::launch::async, [window, name]() -> Found {
    Found found{.window = window, .outlines = {}, .way = {}, .problem = {}};
    try {
      found.way = readWay(name);
    } catch (const Error& error) {
      found.problem = std::make_shared<const Message>(messageOf(error));
    }
    return found;
  });
  Q_EMIT changed();
}

void TouchGuide::stop() {
  if (!isOn()) return;
  drop();
  host_.messages.say({said<MessageId::guide_off>()});
}

void TouchGuide::letGo() {
  if (!isOn()) return;
  drop();
  host_.messages.say({said<MessageId::guide_you_lead>()});
}

void TouchGuide::drop() {
  if (!isOn()) return;
  if (finding_.valid()) finding_.wait();
  finding_ = {};
  path_ = 0;
  Q_EMIT changed();
}

std::optional<GuidePath> TouchGuide::pathOf(const Found& found, const HandMapping& mapping,
                                            const HapticSample& sample, MessageId& of) {
  if (!found.way.empty()) {
    of = MessageId::guide_of_stroke;
    std::vector<TimedPlace> way;
    for (const WayPoint& point : found.way) {
      // Recordings have heights of gain 1 or their own; the place is what counts.
      const DeviceMm place = mapping.device_from_view(point.place);
      if (!isWithinReach(place)) {
        host_.messages.announce(
            tr("The recorded way leaves the shown window. Go to where it was recorded."));
        return std::nullopt;
      }
      way.push_back({point.t_s, place});
    }
    return guideAlong(way);
  }
  const Outline* const nearest =
      nearestOutline(found.outlines, sample.hip_view.x, sample.hip_view.y);
  if (nearest == nullptr) {
    host_.messages.say({said<MessageId::guide_no_outline>()});
    return std::nullopt;
  }
  of = wordsOf(nearest->of);
  std::vector<DeviceMm> corners;
  for (const ViewMm& p : nearest->corners) corners.push_back(mapping.device_from_view(p));
  return guidePath(corners, true, static_cast<std::uint32_t>(rounds_));
}

void TouchGuide::take(LoopSession& session, const HapticSample& sample) {
  const Found found = finding_.get();
  if (found.problem) {
    host_.messages.showError(messageText(*found.problem), {});
    return;
  }
  const std::shared_ptr<const RegionWindow> window = host_.view.shownWindow();
  if (!window || window->id != found.window->id) {
    host_.messages.say({said<MessageId::guide_other_window>()});
    return;
  }
  MessageId of = MessageId::guide_of_object;
  try {
    const std::optional<GuidePath> path = pathOf(found, session.mapping(), sample, of);
    if (!path) return;
    path_ = session.lead(*path);
    host_.messages.say({said<MessageId::guide_begins>(Message{of, {}})});
  } catch (const Error& error) {
    host_.messages.showError(messageText(messageOf(error)), {});
  }
}

void TouchGuide::sayEnd(GuideEnd end) {
  switch (end) {
    case GuideEnd::you_lead:
    case GuideEnd::button:
      host_.messages.say({said<MessageId::guide_you_lead>()});
      return;
    case GuideEnd::arrived:
      host_.messages.say({said<MessageId::guide_done>()});
      return;
    case GuideEnd::surface:
      host_.messages.say({said<MessageId::guide_other_window>()});
      return;
    case GuideEnd::none:
    case GuideEnd::asked:
    case GuideEnd::no_forces:  // Which is said by whoever switched them off.
      return;
  }
}

void TouchGuide::frame(LoopSession& session, const HapticSample& sample) {
  if (finding_.valid()) {
    if (finding_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    if (session.isPreparing()) return;  // What it is led along lies on the surface that comes.
    take(session, sample);
    Q_EMIT changed();
    return;
  }
  if (path_ == 0 || sample.guide_path != path_) return;
  if (sample.guide != GuidePhase::off) return session.giveWay(sample);
  path_ = 0;
  sayEnd(sample.guide_end);
  Q_EMIT changed();
}

}  // namespace relievo
