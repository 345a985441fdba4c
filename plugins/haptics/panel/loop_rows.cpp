// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/loop_rows.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "plugins/haptics/panel/panel_widgets.h"

namespace relievo {

LoopRows::LoopRows(QWidget* panel) : QObject(panel), panel_(panel) {
  depth_ = readout("pressDepth", tr("How far the hand is pressed in"));
  health_ = readout("loopHealth", tr("How the force loop runs"));
  details_ = named(new QPushButton(tr("More a&bout the loop…")), "loopDetailsButton",
                   tr("More about the force loop"));
  scope_ = named(new QPushButton(tr("Plots &with a cursor…")), "scopeButton",
                 tr("Plots of height and force with a cursor"));
  scope_->setToolTip(tr("Pause, zoom, read values, and save as SVG or CSV."));
  details_->setToolTip(tr("Wake-ups and computing times as tables, and what the system granted."));
  connect(scope_, &QPushButton::clicked, this, &LoopRows::showScope);
  connect(details_, &QPushButton::clicked, this, &LoopRows::showDetails);
}

void LoopRows::addDepth(QFormLayout* form) {
  form->addRow(tr("Pressed in"), depth_);
}

void LoopRows::addHealth(QFormLayout* form) {
  form->addRow(tr("Force loop"), health_);
  form->addRow(QString(), details_);
  form->addRow(QString(), scope_);
}

void LoopRows::showDetails() {
  if (!open_details_) {
    open_details_ = new LoopDetailsDialog(panel_);
    open_details_->setAttribute(Qt::WA_DeleteOnClose);
  }
  open_details_->show(report_);
  open_details_->show();
  open_details_->raise();
  open_details_->activateWindow();
}

void LoopRows::showScope() {
  if (!open_scope_) {
    open_scope_ = new ScopeDialog(panel_);
    open_scope_->setAttribute(Qt::WA_DeleteOnClose);
  }
  open_scope_->show();
  open_scope_->raise();
  open_scope_->activateWindow();
}

void LoopRows::plot(std::span<const ForcePoint> samples) {
  if (open_scope_) open_scope_->add(samples);
}

void LoopRows::show(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  setTextIfNew(depth_, sample.contact
                           ? tr("%1 mm of hand").arg(norm(sample.proxy - sample.hip), 0, 'f', 2)
                           : tr("not touching"));
  report_ = report;
  if (open_details_) open_details_->show(report_);
  showHealth();
}

void LoopRows::showHealth() {
  // Read by speech, too: no oftener than once a second. Each new text is a picture of the window,
  // and without forces nobody waits for it.
  const int shows_per_line = report_.sample.engaged == EngagePhase::off ? 32 : 8;
  const bool rests = report_.stats.at_rest;
  const bool same = std::exchange(health_at_rest_, rests) == rests;
  if (health_shows_++ % shows_per_line != 0 && health_rate_hz_ > 0 && same) return;
  health_rate_hz_ = report_.stats.rate_hz;
  const QString health = healthText(report_);
  setTextIfNew(health_, health);
  health_->setAccessibleDescription(health);
}

}  // namespace relievo
