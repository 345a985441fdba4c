// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <utility>

#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "core/provenance/sha256.h"
#include "ui/frame/side_panels.h"
#include "ui/frame/status_fields.h"
#include "ui/language/spoken_text.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/replay_panel.h"
#include "ui/plots/time_plot.h"
#include "ui/style/mnemonic.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr double kLeastRateHz = 900;  // Of the force loop's 1000; below, stiffness has to give way.
constexpr quint64 kLateTicks = 10;    // Since the report before, half a second ago.

/// Of the window's sample nearest a view position.
Origin originAt(const RegionWindow& window, double x_mm, double y_mm) {
  const auto index = [&](double position, double start) {
    const double i = std::floor((position - start) / window.spacingMm());
    return static_cast<std::size_t>(std::clamp(i, 0.0, kWindowSamples - 1.0));
  };
  const std::size_t row = index(y_mm, window.region.y_mm);
  return window.origins[row * kWindowSamples + index(x_mm, window.region.x_mm)];
}

QString originText(Origin origin) {
  switch (origin) {
    case Origin::measured:
      return MainWindow::tr("measured");
    case Origin::interpolated:
      return MainWindow::tr("interpolated");
    case Origin::base_plane:
      return MainWindow::tr("hole, on base plane");
    case Origin::steep:
      return MainWindow::tr("steep");
    case Origin::outside:
      return MainWindow::tr("outside");
  }
  return {};
}

}  // namespace

void MainWindow::addPanel(const QString& title, QWidget* panel) {
  constexpr int kAfterWindow = 2;  // What is touched with stands beside what is touched.
  panels_->insert(kAfterWindow, title, panel);
}

void MainWindow::removePanel(QWidget* panel) {
  panels_->remove(panel);
}

void MainWindow::addToMenu(const QString& title, QAction* action) {
  action->setParent(this);
  addAction(action);
  const QList<QKeySequence> keys = action->shortcuts();
  if (!keys.isEmpty()) {
    const QString key = keys.front().toString(QKeySequence::NativeText);
    if (!action->toolTip().contains(key)) {
      action->setToolTip(QStringLiteral("%1 (%2)").arg(action->toolTip(), key));
    }
  }
  QMenu* to = menu(title, title);
  // A recording and its notes stand before what is made of them.
  const QStringList first{QStringLiteral("record"), QStringLiteral("addNote")};
  const int place = static_cast<int>(first.indexOf(action->objectName()));
  to->insertAction(place < 0 ? nullptr : to->actions().value(place), action);
  to->menuAction()->setVisible(true);
  const bool forces = action->objectName() == QLatin1String("forces");
  if (forces) connect(action, &QAction::toggled, this, &MainWindow::touchWhileForcesAreOn);
  if (action->objectName() == QLatin1String("forcesOff")) {
    connect(action, &QAction::triggered, this, [this] { touchWhileForcesAreOn(false); });
  }
  if (!forces && action->objectName() != QLatin1String("record")) return;
  if (action->icon().isNull()) action->setIcon(icon(forces ? Icon::forces : Icon::record));
  QAction* before = command("image");
  if (forces) tools_->insertAction(command("stereo"), action);
  if (!forces) tools_->insertAction(before, action);
  if (auto* button = qobject_cast<QToolButton*>(tools_->widgetForAction(action))) {
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAccessibleName(withoutMnemonic(action->text()));
  }
}

void MainWindow::showPosition(const ViewMm& position, std::optional<Origin> known) {
  const auto window = document_.window();
  if (!window) return;
  const double step = window->spacingMm();
  const Origin origin = known.value_or(originAt(*window, position.x, position.y));
  const double z = known ? position.z : windowHeightMm(*window, position.x, position.y);
  const QString place =
      tr("x %1  y %2  z %3 mm")
          .arg(mmText(position.x, step), mmText(position.y, step), mmText(z, step / 10));
  status_->set(StatusField::position, place);
  status_->set(StatusField::origin, originText(origin));
  detail_->setWhereAmI(tr("%1, %2. Detail %3 of %4")
                           .arg(place, originText(origin))
                           .arg(document_.detail())
                           .arg(document_.details()));
}

StepAbout MainWindow::about() const {
  if (probe_ && probe_->touching) return {probe_->proxy.x, probe_->proxy.y, true};
  if (const auto hand = detail_->hand()) return {hand->x, hand->y, false};
  // The hand of a device that floats above this window.
  const auto window = document_.window();
  if (probe_ && window && probe_->window_id == window->id) {
    return {probe_->proxy.x, probe_->proxy.y, false};
  }
  return document_.aboutCentre();
}

void MainWindow::showProbe(const Probe& probe) {
  const auto window = document_.window();
  if (!window || probe.window_id != window->id || replay_->showing()) return;
  drawProbe(probe);
  measure_panel_->follow(
      {{probe.proxy.x, probe.proxy.y}, norm(probe.force), probe.touching && probe.forces_on});
}

void MainWindow::drawProbe(const Probe& probe) {
  probe_ = probe;
  detail_->showProbe(probe);
  showPosition(probe.proxy, probe.origin);
  const double force = norm(probe.force);
  if (replay_->showing()) {
    status_->set(StatusField::force, tr("%1 N").arg(numberText(force, 2)),
                 tr("Force when it was recorded"));
    status_->set(StatusField::recording, tr("replay %1").arg(replay_->panel()->timeText()));
    return;
  }
  status_->set(
      StatusField::force,
      probe.forces_on ? tr("%1/%2 N").arg(numberText(force, 2), numberText(probe.force_limit_n, 1))
                      : tr("forces off"),
      probe.forces_on ? tr("Force on the hand and its limit") : tr("Press F5 to switch forces on"));
}

void MainWindow::plot(std::span<const ForcePoint> points) {
  plot_->add(points);
}

void MainWindow::showTouch(const TouchReadout& readout) {
  if (!touch_present_) {
    touch_present_ = true;
    QAction* plots = command("show_plots");
    plots->setVisible(true);
    const QVariant shown = settings_.layout(QStringLiteral("show_plots"));
    plots->setChecked(!shown.isValid() || shown.toBool());
    connect(plots, &QAction::toggled, this, [this](bool on) {
      if (!isFullScreen()) settings_.setLayout(QStringLiteral("show_plots"), on);
    });
  }
  touch_ = readout;
  touchWhileForcesAreOn(readout.forces_on);
  if (replay_->showing()) {
    if (!readout.forces_on) return;
    replay_->close();  // Whoever feels something must see where the hand is.
    announce(tr("Forces are on: the replay was closed."));
  }
  QStringList more{tr("Device: %1").arg(readout.device),
                   tr("Worst period: %1 ms").arg(numberText(readout.worst_period_ms, 2))};
  more << (readout.realtime ? tr("Real-time priority")
                            : tr("No real-time priority: %1").arg(readout.realtime_note));
  // A loop that runs as it should says nothing; the panel Touch has its numbers at any time.
  const bool late =
      std::exchange(late_ticks_seen_, readout.late_ticks) + kLateTicks < readout.late_ticks;
  const bool is_slow = readout.rate_hz > 0 && readout.rate_hz < kLeastRateHz;
  status_->set(StatusField::rate,
               late || is_slow
                   ? tr("%1/s, late %2").arg(numberText(readout.rate_hz, 0)).arg(readout.late_ticks)
                   : QString(),
               more.join('\n'));
  status_->set(StatusField::recording,
               readout.recording ? tr("recording %1").arg(readout.recorded_samples) : QString());
  if (!readout.forces_on && !probe_) {
    status_->set(StatusField::force, tr("forces off"), tr("Press F5 to switch forces on"));
  }
}

void MainWindow::showTouchMissing(const QString& reason) {
  announce(tr("Touch is not available: %1 Viewing works.").arg(reason));
}

void MainWindow::announce(const QString& text) {
  status_->set(StatusField::message, text);
  tell(text);
}

void MainWindow::tell(const QString& text) {
  const QString spoken = forEars(text);
  if (!speaker_ || !speaker_(spoken)) status_->tell(spoken);
}

void MainWindow::setSpeaker(std::function<bool(const QString& text)> speaker) {
  speaker_ = std::move(speaker);
}

void MainWindow::announceAs(const QString& text, const QString& spoken) {
  status_->set(StatusField::message, text);
  if (!spoken.isEmpty()) status_->tell(forEars(spoken));
}

bool MainWindow::runCommand(const QString& name) {
  auto* action = findChild<QAction*>(name, Qt::FindDirectChildrenOnly);
  if (action == nullptr || !action->isEnabled()) return false;
  action->trigger();
  return true;
}

QString MainWindow::introduction() const {
  if (!document_.isOpen()) return tr("Nothing is open. Open a scan with Ctrl+O.");
  const DetailLadder& ladder = document_.surface()->ladder;
  return tr("%1, %2 by %3 mm, in %4 details. Push the hand in to touch; F5 switches forces on. "
            "Plus: finer; Minus: coarser; both for two seconds: help.")
      .arg(shownName(document_.file()), QString::number(ladder.width_mm, 'f', 0),
           QString::number(ladder.height_mm, 'f', 0), QString::number(document_.details()));
}

bool MainWindow::stopForces() {
  if (!touch_.forces_on) return false;
  QAction* forces = command("forcesOff");
  if (forces == nullptr || !forces->isEnabled()) return false;
  forces->trigger();
  return true;
}

std::string MainWindow::carriedState(const QString& file) const {
  return toJson(document_.provenanceIn(file), -1);
}

QString MainWindow::recordingHeader(const QString& file) const {
  if (!document_.isOpen()) return {};
  const Surface& s = *document_.surface();
  const Project& state = document_.project();
  const auto word = [](std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
  };
  const auto exact = [](double v) { return QString::number(v, 'g', 17); };
  QStringList matrix;
  for (const double v : s.view_from_file.m) matrix << exact(v);
  const Region& r = state.region;
  return QStringList{
      QLatin1String("# application: relievo ") + QStringLiteral(RELIEVO_VERSION_STRING),
      QLatin1String("# input: ") + wholeName(document_.file()),
      QLatin1String("# input_sha256: ") + document_.fileSha256(),
      QLatin1String("# unit: ") + word(name(s.unit)) + QLatin1String(" (") +
          word(name(s.unit_source)) + ')',
      QLatin1String("# view: ") + QString::fromStdString(s.view_name),
      QLatin1String("# view_from_file: ") + matrix.join(' '),
      QLatin1String("# engine: ") + QString::fromStdString(s.engine),
      QStringLiteral("# region_mm: %1 %2 %3 %3")
          .arg(exact(r.x_mm), exact(r.y_mm), exact(r.side_mm)),
      QStringLiteral("# level: %1").arg(r.level.value),
      QLatin1String("# gain: ") + exact(state.gain),
      QLatin1String("# ") + QString::fromStdString(stateLine(carriedState(file)))}
      .join('\n');
}

}  // namespace relievo
