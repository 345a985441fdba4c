// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/touched_surface.h"

#include <QFile>
#include <QFileInfo>
#include <utility>

#include "core/base/failure.h"
#include "plugins/haptics/recording/recording_file.h"
#include "plugins/haptics/shown_file.h"
#include "ui/message/message_text.h"

namespace relievo {

TouchedSurface::TouchedSurface(TouchParts& parts, HandDevice& device, RecordingControl& recording)
    : parts_(parts), device_(device), recording_(recording) {
  const ShownWindow* const view = &parts_.host.view;
  connect(view, &ShownWindow::windowShown, this,
          [this](const std::shared_ptr<const RegionWindow>& window) {
            if (window && device_.session() && window->id != given_window_) show(*window);
          });
  connect(view, &ShownWindow::handMoved, this, [this](const HandTarget& target) {
    if (!device_.session()) return;
    if (isTraining()) {
      const auto shown = parts_.host.view.shownWindow();
      if (shown) device_.session()->moveHand(training_->target(target, *shown));
      return;
    }
    showIfNew();
    device_.session()->moveHand(target.position);
  });
  connect(view, &ShownWindow::finerHeightsRead, this, &TouchedSurface::takeFiner);
  connect(view, &ShownWindow::firmnessRead, this, &TouchedSurface::takeFirmness);
}

void TouchedSurface::show(const RegionWindow& window) {
  if (isTraining()) return;  // It comes once the introduction has ended.
  given_window_ = window.id;
  surface_ = parts_.settings.feel.surface;
  device_.session()->show(window, surface_, mapsUnder(window));
  recording_.addWindow(window);
  Q_EMIT laid(window);
  Q_EMIT given();
}

void TouchedSurface::showTraining() {
  surface_ = SurfaceKind::crease_aware;
  given_window_ = training_->window()->id;
  device_.session()->show(*training_->window(), surface_);
  Q_EMIT laid(*training_->window());
  Q_EMIT given();
}

void TouchedSurface::showWindow() {
  if (const auto window = parts_.host.view.shownWindow()) return show(*window);
  given_window_ = 0;  // Whichever comes next is new.
}

/// The hand is over what the host shows, whoever heard first of another window.
void TouchedSurface::showIfNew() {
  const auto window = parts_.host.view.shownWindow();
  if (window && window->id != given_window_) show(*window);
}

void TouchedSurface::applySettings() {
  const SurfaceFeel& feel = parts_.settings.feel;
  const bool texture_missing = feel.fields.texture_mm > 0 && !textured_;
  if (!device_.session() || (surface_ == feel.surface && !texture_missing)) return;
  showWindow();
}

SceneMaps TouchedSurface::mapsUnder(const RegionWindow& window) {
  SceneMaps maps;
  maps.map_state = parts_.host.recordings.mapState(recording_.folder()).toStdString();
  textured_ = parts_.settings.feel.fields.texture_mm > 0;
  if (textured_) {
    maps.finer_mm = finer_window_ == window.id ? finer_mm_ : parts_.host.view.finerHeights(window);
  }
  const bool fitted = std::exchange(firmness_fits_, true);
  if (firmness_) {
    try {
      maps.firmness = parts_.host.view.firmnessUnder(*firmness_, window);
      maps.firmness_from = firmness_;
    } catch (const Error& error) {
      firmness_fits_ = false;
      if (fitted)
        parts_.host.messages.announce(messageText(messageOf(error)),
                                      SaidBecause::noticed);  // Once, not for every window.
    }
  }
  recording_.setFirmness(firmness_fits_ ? firmness_ : nullptr);
  if (parts_.panel) parts_.panel->setFirmnessUsed(firmness_fits_);
  return maps;
}

void TouchedSurface::takeFiner(quint64 window_id, const std::vector<float>& finer_mm,
                               const QString& problem) {
  if (!problem.isEmpty()) parts_.host.messages.announce(problem, SaidBecause::noticed);
  const auto window = parts_.host.view.shownWindow();
  if (!textured_ || finer_mm.empty() || !window || window->id != window_id) return;
  finer_mm_ = finer_mm;
  finer_window_ = window_id;
  show(*window);
}

void TouchedSurface::askFirmness(const QString& file, bool chosen_now) {
  firmness_awaited_ = file;
  firmness_chosen_now_ = chosen_now;
  parts_.host.view.readFirmness(file);
}

void TouchedSurface::chooseFirmness(const QString& file) {
  if (!file.isEmpty()) return askFirmness(file, true);
  firmness_awaited_.clear();
  setFirmness(nullptr);
  parts_.host.messages.announce(tr("The surface is stiff where it was measured."));
}

void TouchedSurface::restoreFirmness() {
  firmness_awaited_.clear();
  const std::string before = firmness_ ? firmness_->file : std::string();
  if (parts_.settings.firmness == before) return;
  if (parts_.settings.firmness.empty()) return setFirmness(nullptr);
  askFirmness(QFile::decodeName(parts_.settings.firmness.c_str()), false);
}

void TouchedSurface::takeFirmness(const QString& file, std::shared_ptr<const FirmnessMap> firmness,
                                  const QString& problem) {
  if (!device_.session() || file != firmness_awaited_) return;
  firmness_awaited_.clear();
  QString refusal = problem;
  const auto window = parts_.host.view.shownWindow();
  if (firmness && firmness_chosen_now_ && window) {
    try {
      parts_.host.view.firmnessUnder(*firmness, *window);
    } catch (const Error& error) {
      refusal = messageText(messageOf(error));
    }
  }
  if (refusal.isEmpty()) {
    setFirmness(std::move(firmness));
    if (!firmness_chosen_now_) return;
    const QString name = shownFileName(file);
    parts_.host.messages.announce(
        parts_.settings.feel.fields.softest_part < 1
            ? tr("Stiffness map: %1.").arg(name)
            : tr("Stiffness map: %1. Set Not measured below 100 % to feel it.").arg(name));
    return;
  }
  // What was chosen before stays; a remembered one that cannot be read is forgotten.
  if (!firmness_chosen_now_) setFirmness(nullptr);
  parts_.host.messages.announce(refusal);
}

void TouchedSurface::setFirmness(std::shared_ptr<const FirmnessMap> firmness) {
  firmness_ = std::move(firmness);
  firmness_fits_ = true;
  parts_.settings.firmness = firmness_ ? firmness_->file : std::string();
  recording_.setFirmness(firmness_);
  parts_.showSettings();
  showWindow();
}

}  // namespace relievo
