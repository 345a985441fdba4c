// SPDX-License-Identifier: BSD-3-Clause
// What lies under the hand: window, shape, texture, and where the ground is firm.
#include <QFile>
#include <QFileInfo>
#include <utility>

#include "core/base/failure.h"
#include "plugins/haptics/haptics_plugin.h"
#include "plugins/haptics/recording/recording_file.h"
#include "plugins/haptics/shown_file.h"
#include "ui/message/message_text.h"

namespace relievo {

void HapticsPlugin::showWindow(const RegionWindow& window) {
  shown_ = {};  // The host may have cleared its probe.
  given_window_ = window.id;
  surface_ = settings_.feel.surface;
  session_->show(window, surface_, mapsUnder(window));
  if (session_->recorder().running()) recorded_windows_ += windowLine(window);
}

void HapticsPlugin::applySurface() {
  const bool texture_missing = settings_.feel.fields.texture_mm > 0 && !textured_;
  if (!session_ || (surface_ == settings_.feel.surface && !texture_missing)) return;
  if (const auto window = host_->view.shownWindow()) showWindow(*window);
}

SceneMaps HapticsPlugin::mapsUnder(const RegionWindow& window) {
  SceneMaps maps;
  maps.map_state = host_->recordings.mapState(folderOfRecording()).toStdString();
  textured_ = settings_.feel.fields.texture_mm > 0;
  if (textured_) {
    maps.finer_mm = finer_window_ == window.id ? finer_mm_ : host_->view.finerHeights(window);
  }
  const bool fitted = std::exchange(firmness_fits_, true);
  if (firmness_) {
    try {
      maps.firmness = host_->view.firmnessUnder(*firmness_, window);
      maps.firmness_from = firmness_;
    } catch (const Error& error) {
      firmness_fits_ = false;
      if (fitted)
        host_->messages.announce(messageText(messageOf(error)),
                                 SaidBecause::noticed);  // Once, not for every window.
    }
  }
  if (panel_) panel_->setFirmnessUsed(firmness_fits_);
  return maps;
}

void HapticsPlugin::takeFiner(quint64 window_id, const std::vector<float>& finer_mm,
                              const QString& problem) {
  if (!problem.isEmpty()) host_->messages.announce(problem, SaidBecause::noticed);
  const auto window = host_->view.shownWindow();
  if (!textured_ || finer_mm.empty() || !window || window->id != window_id) return;
  finer_mm_ = finer_mm;
  finer_window_ = window_id;
  showWindow(*window);
}

void HapticsPlugin::askFirmness(const QString& file, bool chosen_now) {
  firmness_awaited_ = file;
  firmness_chosen_now_ = chosen_now;
  host_->view.readFirmness(file);
}

void HapticsPlugin::restoreFirmness() {
  firmness_awaited_.clear();
  const std::string before = firmness_ ? firmness_->file : std::string();
  if (settings_.firmness == before) return;
  if (settings_.firmness.empty()) return setFirmness(nullptr);
  askFirmness(QFile::decodeName(settings_.firmness.c_str()), false);
}

void HapticsPlugin::takeFirmness(const QString& file, std::shared_ptr<const FirmnessMap> firmness,
                                 const QString& problem) {
  if (!session_ || file != firmness_awaited_) return;
  firmness_awaited_.clear();
  QString refusal = problem;
  const auto window = host_->view.shownWindow();
  if (firmness && firmness_chosen_now_ && window) {
    try {
      host_->view.firmnessUnder(*firmness, *window);
    } catch (const Error& error) {
      refusal = messageText(messageOf(error));
    }
  }
  if (refusal.isEmpty()) {
    setFirmness(std::move(firmness));
    if (!firmness_chosen_now_) return;
    const QString name = shownFileName(file);
    host_->messages.announce(
        settings_.feel.fields.softest_part < 1
            ? tr("Stiffness map: %1.").arg(name)
            : tr("Stiffness map: %1. Set Not measured below 100 % to feel it.").arg(name));
    return;
  }
  // What was chosen before stays; a remembered one that cannot be read is forgotten.
  if (!firmness_chosen_now_) setFirmness(nullptr);
  host_->messages.announce(refusal);
}

void HapticsPlugin::setFirmness(std::shared_ptr<const FirmnessMap> firmness) {
  firmness_ = std::move(firmness);
  firmness_fits_ = true;
  settings_.firmness = firmness_ ? firmness_->file : std::string();
  if (panel_) panel_->setSettings(settings_);
  if (const auto window = host_->view.shownWindow()) showWindow(*window);
}

}  // namespace relievo
