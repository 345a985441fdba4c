// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/guide/felt_patterns.h"

#include <QAction>
#include <QSignalBlocker>
#include <utility>

#include "plugins/api/host.h"

namespace relievo {

namespace {
// Three taps take a third of a second; what comes sooner could not be told from them.
constexpr qint64 kLeastApartMs = 600;
}  // namespace

FeltPatterns::FeltPatterns(TouchParts& parts) : parts_(parts) {
  connect(parts_.actions.felt, &QAction::toggled, this, &FeltPatterns::setOn);
  showSettings();
}

void FeltPatterns::showSettings() {
  const QSignalBlocker blocker(parts_.actions.felt);
  parts_.actions.felt->setChecked(parts_.settings.felt_patterns);
}

void FeltPatterns::setOn(bool on) {
  if (on == parts_.settings.felt_patterns) return;
  parts_.settings.felt_patterns = on;
  parts_.showSettings();
  parts_.host.messages.announce(on ? tr("Felt patterns on: one tap is yes, two not measured, "
                                        "three the edge.")
                                   : tr("Felt patterns off."));
}

void FeltPatterns::feel(FeltPattern pattern) {
  if (!parts_.settings.felt_patterns || !parts_.forces_asked) return;
  if (since_.isValid() && since_.elapsed() < kLeastApartMs) return;
  since_.start();
  taps_ = {.id = taps_.id + 1, .pattern = pattern};
  Q_EMIT changed();
}

void FeltPatterns::follow(const HapticSample& sample) {
  const bool is_on = sample.engaged == EngagePhase::on;
  const bool is_filled = sample.contact && (sample.origin == CellStatus::interpolated ||
                                            sample.origin == CellStatus::base_plane);
  const bool is_at_edge = sample.frame != 0;
  const bool comes_on = !std::exchange(is_on_, is_on) && is_on;
  const bool fills = !std::exchange(is_filled_, is_filled) && is_filled;
  const bool ends = !std::exchange(is_at_edge_, is_at_edge) && is_at_edge;
  if (ends) {
    feel(FeltPattern::edge);
  } else if (fills) {
    feel(FeltPattern::not_measured);
  } else if (comes_on) {
    feel(FeltPattern::yes);
  }
}

}  // namespace relievo
