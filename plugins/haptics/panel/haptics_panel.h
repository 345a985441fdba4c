// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

#include "plugins/haptics/device/plugin_devices.h"
#include "plugins/haptics/panel/loop_health.h"
#include "plugins/haptics/panel/scope.h"
#include "plugins/haptics/touch_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace relievo {

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
  void settingsChanged();
  void firmnessAsked(const QString& file);  ///< Empty: none.
  void devicesWanted();                     ///< Somebody turns to the list of devices.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildControls();
  void buildFeel();
  void buildFields();
  void connectControls();
  void takePreset(int index);
  void showPreset();
  void showStiffness();
  void takeStiffness(double value);
  std::size_t level() const;  // Index of the shown level's own stiffness.
  SurfaceFeel feel() const;
  void chooseDevice(const QString& id);
  void showTried();
  void buildReadouts();
  QFormLayout* rows();
  QFormLayout* advancedRows();
  void showDetails();
  void showScope();
  void askFirmness();
  void showFirmness();
  void changed();

  QWidget* advanced_ = nullptr;
  QCheckBox* forces_ = nullptr;
  QSlider* strength_ = nullptr;
  QLabel* strength_value_ = nullptr;
  QCheckBox* by_detail_ = nullptr;
  QDoubleSpinBox* stiffness_ = nullptr;
  QComboBox* preset_ = nullptr;
  QComboBox* surface_ = nullptr;
  QComboBox* proxy_ = nullptr;
  QDoubleSpinBox* friction_ = nullptr;
  QDoubleSpinBox* damping_ = nullptr;
  QDoubleSpinBox* soft_ = nullptr;
  QLabel* firmness_name_ = nullptr;
  QPushButton* firmness_choose_ = nullptr;
  QPushButton* firmness_none_ = nullptr;
  QDoubleSpinBox* tick_ = nullptr;
  QDoubleSpinBox* texture_ = nullptr;
  QDoubleSpinBox* knock_ = nullptr;
  QDoubleSpinBox* magnet_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* change_ = nullptr;  // Hidden while none comes.
  QLabel* depth_ = nullptr;
  QComboBox* device_ = nullptr;
  QLabel* tried_ = nullptr;  // Hidden where nobody can feel a force.
  QLabel* heat_ = nullptr;   // Hidden where no device says it.
  std::vector<PluginDevice> plugin_devices_;
  QCheckBox* holds_grip_ = nullptr;
  QLabel* health_ = nullptr;
  QPushButton* details_ = nullptr;
  QPointer<LoopDetailsDialog> open_details_;
  QPushButton* scope_ = nullptr;
  QPointer<ScopeDialog> open_scope_;
  LoopReport report_;  // The last one shown.
  DetailStiffness detail_stiffness_ = kDetailStiffness;
  double fixed_stiffness_ = 0;  // The same at every level.
  double magnet_reach_mm_ = 3;  // No control of its own.
  std::string firmness_;        // As in the settings.
  bool firmness_used_ = true;
  int health_shows_ = 0;       // Since the health line was written.
  double health_rate_hz_ = 0;  // As the line says; 0: not known yet.
};

}  // namespace relievo
