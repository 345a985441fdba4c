// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "haptics/loop/haptic_loop.h"
#include "plugins/haptics/touch_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace relievo {

/// What the panel shows of the running loop.
struct LoopReport {
  HapticSample sample;
  LoopStats stats;
  RealtimeGrant realtime;
  QString device;
  bool actuated = false;  ///< The device can push back.
};

/// Shows and asks; computes nothing.
class HapticsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit HapticsPanel(QWidget* parent = nullptr);

  void setSettings(const TouchSettings& settings);
  TouchSettings settings() const;
  void setForcesAsked(bool on);
  void show(const LoopReport& report);  ///< A few times a second.
  using QWidget::show;

 Q_SIGNALS:
  void forcesAsked(bool on);
  void settingsChanged();

 private:
  void buildControls();
  void listDevices();
  void buildReadouts();
  void changed();

  QCheckBox* forces_ = nullptr;
  QSlider* strength_ = nullptr;
  QLabel* strength_value_ = nullptr;
  QCheckBox* by_detail_ = nullptr;
  QDoubleSpinBox* stiffness_ = nullptr;
  QComboBox* proxy_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* depth_ = nullptr;
  QComboBox* device_ = nullptr;
  QLabel* rate_ = nullptr;
  QLabel* worst_ = nullptr;
  QLabel* late_ = nullptr;
  QLabel* realtime_ = nullptr;
};

}  // namespace relievo
