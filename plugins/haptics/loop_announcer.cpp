// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/loop_announcer.h"

#include <utility>

#include "core/base/failure.h"
#include "haptics/record/events.h"
#include "ui/message/message_text.h"

namespace relievo {

void LoopAnnouncer::follow(const HapticSample& sample) {
  watchSurface();
  watchFault(sample);
  watchStop(sample);
  watchEdge(sample);
  watchWaiting(sample);
  watchSoftening(sample);
  watchRate(sample);
}

void LoopAnnouncer::announce(const QString& text, SaidBecause why) {
  parts_.host.messages.announce(text, why);
}

void LoopAnnouncer::watchSurface() {
  const std::string problem = device_.session()->takeProblem();
  if (problem.empty()) return;
  dropForces();
  announce(QString::fromStdString(problem));
}

void LoopAnnouncer::watchFault(const HapticSample& sample) {
  if (sample.fault == fault_) return;
  fault_ = sample.fault;
  if (fault_ == DeviceFault::none) return;
  dropForces();
  const QString sentence = tr("Forces off: %1.").arg(messageText(messageOf(fault_)));
  announce(sentence);
  Q_EMIT faultTold(sentence);
}

/// The loop has ended the forces already; the window follows.
void LoopAnnouncer::watchStop(const HapticSample& sample) {
  if (!parts_.forces_asked || sample.stopped == StopReason::none) return;
  const bool silent = sample.stopped == StopReason::window_silent;
  dropForces();
  if (silent) {
    announce(tr("Forces went off, because the window did not answer for %1 s. Press F5 to "
                "switch them on.")
                 .arg(parts_.settings.window_silence_s));
  }
}

void LoopAnnouncer::watchEdge(const HapticSample& sample) {
  const bool at_edge = parts_.forces_asked && sample.frame != 0;
  if (at_edge && !at_edge_) announce(tr("The hand pushes over the edge of the window."));
  at_edge_ = at_edge;
}

/// A hand that is clear of the surface waits for a few quiet ticks only.
void LoopAnnouncer::watchWaiting(const HapticSample& sample) {
  constexpr int kFramesUntilSaid = 6;  // A tenth of a second.
  if (!parts_.forces_asked || sample.engaged == EngagePhase::off) {
    frames_waiting_ = 0;
  } else if (sample.engaged != EngagePhase::waiting) {
    if (std::exchange(frames_waiting_, 0) >= kFramesUntilSaid) {
      announce(tr("The hand is clear: forces come on."));
    }
  } else if (++frames_waiting_ == kFramesUntilSaid) {
    announce(device_.session()->isSteered()
                 ? tr("Forces wait: the hand is inside. Let go or press Page Up.")
                 : tr("Forces wait: the hand is inside. Raise the grip."),
             SaidBecause::asked);
  }
}

void LoopAnnouncer::watchSoftening(const HapticSample& sample) {
  const bool again = sample.softened > softened_;
  softened_ = sample.softened;
  if (!again) return;
  announce(tr("Softened to %1 N/mm: hand and surface had begun to swing.")
               .arg(sample.stiffness_n_per_mm, 0, 'f', 2));
}

/// E306, in the words for speech; the panel has the numbers.
void LoopAnnouncer::watchRate(const HapticSample& sample) {
  if (sample.engaged == EngagePhase::off) slow_ = false;
  if (sample.slow.rate_hz > 0 && !std::exchange(slow_, true)) {
    announce(tr("Surface made softer to stay steady."));
  }
}

}  // namespace relievo
