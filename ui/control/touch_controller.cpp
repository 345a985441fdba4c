// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/touch_controller.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <utility>

#include "core/region/window.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/replay_control.h"
#include "ui/panels/replay_panel.h"
#include "ui/plots/time_plot.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr double kLeastRateHz = 900;  // Of the force loop's 1000; below, stiffness has to give way.
constexpr quint64 kLateTicks = 10;    // Since the report before, half a second ago.

/// Of the window's sample nearest a view position.
CellStatus originAt(const RegionWindow& window, double x_mm, double y_mm) {
  const auto index = [&](double position, double start) {
    const double i = std::floor((position - start) / window.spacingMm());
    return static_cast<std::size_t>(std::clamp(i, 0.0, kWindowSamples - 1.0));
  };
  const std::size_t row = index(y_mm, window.region.y_mm);
  return window.origins[row * kWindowSamples + index(x_mm, window.region.x_mm)];
}

QString originText(CellStatus origin) {
  switch (origin) {
    case CellStatus::measured:
      return TouchController::tr("measured");
    case CellStatus::interpolated:
      return TouchController::tr("interpolated");
    case CellStatus::base_plane:
      return TouchController::tr("hole, on base plane");
    case CellStatus::steep:
      return TouchController::tr("steep");
    case CellStatus::outside:
      return TouchController::tr("outside");
  }
  return {};
}

}  // namespace

TouchController::TouchController(const ControllerParts& parts, DetailView& detail, TimePlot& plot,
                                 ReplayControl& replay, MeasurePanel& measure)
    : Controller(parts), detail_(detail), plot_(plot), replay_(replay), measure_(measure) {
  // Longer than a line of the status bar.
  commands_.on(Command::introduction, this, [this] { messages_.show(introduction()); });
  connect(&replay_, &ReplayControl::probeMoved, this, &TouchController::drawProbe);
  connect(&document_, &Document::windowChanged, this, [this] {
    if (document_.window()) forgetProbe();
  });
  connect(&detail_, &DetailView::handMoved, this, [this](const ViewMm& position, bool inside) {
    if (inside && !probe_) showPosition(position, {});
  });
  connect(&detail_, &DetailView::pressDepthChanged, this, [this](double depth) {
    announce(tr("Press depth %1 mm of hand").arg(numberText(depth, 2)));
  });
}

void TouchController::showPosition(const ViewMm& position, std::optional<CellStatus> known) {
  const auto window = document_.window();
  if (!window) return;
  const double step = window->spacingMm();
  const CellStatus origin = known.value_or(originAt(*window, position.x, position.y));
  const double z = known ? position.z : windowHeightMm(*window, position.x, position.y);
  const QString place =
      tr("x %1  y %2  z %3 mm")
          .arg(mmText(position.x, step), mmText(position.y, step), mmText(z, step / 10));
  messages_.set(StatusField::position, place);
  messages_.set(StatusField::origin, originText(origin));
  detail_.setWhereAmI(tr("%1, %2. Resolution %3 of %4")
                          .arg(place, originText(origin))
                          .arg(document_.detail())
                          .arg(document_.details()));
}

StepAbout TouchController::about() const {
  if (probe_ && probe_->touching) return {probe_->proxy.x, probe_->proxy.y, true};
  if (const auto hand = detail_.hand()) return {hand->x, hand->y, false};
  // The hand of a device that floats above this window.
  const auto window = document_.window();
  if (probe_ && window && probe_->window_id == window->id) {
    return {probe_->proxy.x, probe_->proxy.y, false};
  }
  return document_.region().aboutCentre();
}

void TouchController::showProbe(const Probe& probe) {
  const auto window = document_.window();
  if (!window || probe.window_id != window->id || replay_.showing()) return;
  drawProbe(probe);
  measure_.follow(
      {{probe.proxy.x, probe.proxy.y}, norm(probe.force), probe.touching && probe.forces_on});
}

void TouchController::drawProbe(const Probe& probe) {
  probe_ = probe;
  detail_.showProbe(probe);
  showPosition(probe.proxy, probe.origin);
  const double force = norm(probe.force);
  if (replay_.showing()) {
    messages_.set(StatusField::force, tr("%1 N").arg(numberText(force, 2)),
                  tr("Force when it was recorded"));
    messages_.set(StatusField::recording, tr("replay %1").arg(replay_.panel()->timeText()));
    return;
  }
  messages_.set(
      StatusField::force,
      probe.forces_on ? tr("%1/%2 N").arg(numberText(force, 2), numberText(probe.force_limit_n, 1))
                      : tr("forces off"),
      probe.forces_on ? tr("Force on the hand and its limit") : tr("Press F5 to switch forces on"));
}

void TouchController::plot(std::span<const ForcePoint> points) {
  plot_.add(points);
}

void TouchController::show(const TouchReadout& readout) {
  if (!is_present_) {
    is_present_ = true;
    QAction& plots = commands_[Command::show_plots];
    plots.setVisible(true);
    const QVariant shown = settings_.layout(QStringLiteral("show_plots"));
    plots.setChecked(!shown.isValid() || shown.toBool());
    commands_.onToggled(Command::show_plots, this, [this](bool on) {
      if (!window_.isFullScreen()) settings_.setLayout(QStringLiteral("show_plots"), on);
    });
  }
  readout_ = readout;
  Q_EMIT readoutShown(readout);
  if (replay_.showing()) {
    if (!readout.forces_on) return;
    replay_.close();  // Whoever feels something must see where the hand is.
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
  messages_.set(
      StatusField::rate,
      late || is_slow
          ? tr("%1/s, late %2").arg(numberText(readout.rate_hz, 0)).arg(readout.late_ticks)
          : QString(),
      more.join('\n'));
  messages_.set(StatusField::recording,
                readout.recording ? tr("recording %1").arg(readout.recorded_samples) : QString());
  if (!readout.forces_on && !probe_) {
    messages_.set(StatusField::force, tr("forces off"), tr("Press F5 to switch forces on"));
  }
}

void TouchController::showMissing(const QString& reason) {
  announce(tr("Touch is not available: %1 Viewing works.").arg(reason));
}

QString TouchController::introduction() const {
  if (!document_.isOpen()) return tr("Nothing is open. Open a scan with Ctrl+O.");
  const DetailLadder& ladder = document_.surface()->ladder;
  return tr("%1, %2 by %3 mm, in %4 resolutions. Push the hand in to touch; F5 switches forces on. "
            "Plus: finer; Minus: coarser; both for two seconds: help.")
      .arg(shownName(document_.file()), QString::number(ladder.width_mm, 'f', 0),
           QString::number(ladder.height_mm, 'f', 0), QString::number(document_.details()));
}

bool TouchController::stopForces() {
  if (!readout_.forces_on) return false;
  QAction* forces = commands_.named(QStringLiteral("forcesOff"));
  if (forces == nullptr || !forces->isEnabled()) return false;
  forces->trigger();
  return true;
}

}  // namespace relievo
