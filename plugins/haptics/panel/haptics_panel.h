// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <span>
#include <vector>

#include "core/recording/force_point.h"
#include "plugins/haptics/device/plugin_devices.h"
#include "plugins/haptics/panel/loop_health.h"
#include "plugins/haptics/touch_settings.h"

class QCheckBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace relievo {

class DeviceRows;
class FeelForm;
class FirmnessRow;
class LoopRows;
class SoundRows;
class StrengthRow;

/// Shows and asks; computes nothing.
class HapticsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit HapticsPanel(QWidget* parent = nullptr);

  /// All but on, off and strength. Stands elsewhere; belongs to whoever lays it out.
  QWidget* advanced() const { return advanced_; }
  void setSettings(const TouchSettings& settings);
  TouchSettings settings() const;
  void setForcesAsked(bool on);
  /// Is the raster of the settings laid under the hand, or does it not fit the open map?
  void setFirmnessUsed(bool used);
  /// Those that are there now, and those of plug-ins that were found; the chosen one stays chosen.
  void listDevices();
  void setPluginDevices(std::vector<PluginDevice> devices);
  void show(const LoopReport& report);  ///< A few times a second.
  using QWidget::show;
  void plot(std::span<const ForcePoint> samples);  ///< For the scope, if it is open.

 Q_SIGNALS:
  void forcesAsked(bool on);
  void takeBackAsked();  ///< A force that was taken away.
  void settingsChanged();
  void firmnessAsked(const QString& file);  ///< Empty: none.
  void devicesWanted();                     ///< Somebody turns to the list of devices.

 private:
  void buildControls();
  void connectControls();
  QFormLayout* rows();
  QFormLayout* advancedRows();
  void changed();

  StrengthRow* strength_;
  FeelForm* feel_;
  FirmnessRow* firmness_;
  DeviceRows* device_;
  LoopRows* loop_;
  SoundRows* sound_;
  QWidget* advanced_ = nullptr;
  QCheckBox* forces_ = nullptr;
  QLabel* state_ = nullptr;
  QPushButton* take_back_ = nullptr;  // Hidden while no force was taken away.
  QLabel* change_ = nullptr;          // Hidden while none comes.
};

}  // namespace relievo
