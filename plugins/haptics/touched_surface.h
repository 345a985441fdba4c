// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <QObject>
#include <QString>
#include <vector>

#include "core/region/region_window.h"
#include "core/session/firmness.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/loop_session.h"
#include "plugins/haptics/recording/recording_control.h"
#include "plugins/haptics/touch_parts.h"
#include "plugins/haptics/training/touch_training.h"

namespace relievo {

/// What lies under the hand: gives the loop the window that the host shows, its shape, its texture,
/// and where the ground is firm. All calls: GUI thread.
class TouchedSurface : public QObject {
  Q_OBJECT
 public:
  TouchedSurface(TouchParts& parts, HandDevice& device, RecordingControl& recording);

  /// Gives the loop the window that the host shows, if it shows one.
  void showWindow();
  /// The same, if the settings ask for another kind of surface than the loop has.
  void applySettings();

  /// Whose shapes lie under the hand while it is on, in place of what the host shows; null: none.
  void setTraining(const TouchTraining* training) { training_ = training; }
  /// Gives the loop the shape of the introduction. Precondition: that is on.
  void showTraining();

  /// @param file  a raster that somebody has chosen; empty: the origins say where it is firm
  void chooseFirmness(const QString& file);
  /// Reads the raster that the settings name.
  void restoreFirmness();

 Q_SIGNALS:
  void laid(const relievo::RegionWindow& window);  ///< That was given: before given().
  void given();  ///< The loop got another surface; the host may have cleared its probe.

 private:
  void show(const RegionWindow& window);
  void showIfNew();
  bool isTraining() const { return training_ != nullptr && training_->isOn(); }
  SceneMaps mapsUnder(const RegionWindow& window);
  void takeFiner(quint64 window_id, const std::vector<float>& finer_mm, const QString& problem);
  void askFirmness(const QString& file, bool chosen_now);
  void takeFirmness(const QString& file, std::shared_ptr<const FirmnessMap> firmness,
                    const QString& problem);
  void setFirmness(std::shared_ptr<const FirmnessMap> firmness);

  TouchParts& parts_;
  HandDevice& device_;
  RecordingControl& recording_;
  const TouchTraining* training_ = nullptr;
  std::uint64_t given_window_ = 0;                   // To the loop, last.
  SurfaceKind surface_ = SurfaceKind::crease_aware;  // Likewise.
  bool textured_ = false;
  std::vector<float> finer_mm_;  // That came late; of the window below.
  quint64 finer_window_ = 0;
  std::shared_ptr<const FirmnessMap> firmness_;  // Null: the origins say where it is firm.
  bool firmness_fits_ = true;                    // The open map.
  QString firmness_awaited_;                     // Being read.
  bool firmness_chosen_now_ = false;             // Not remembered.
};

}  // namespace relievo
