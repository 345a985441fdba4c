// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "plugins/haptics/buttons/button_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace relievo {

/// How buttons, the SpaceMouse and gamepads are used. Shows and asks; computes nothing.
class ButtonsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ButtonsPanel(QWidget* parent = nullptr);
  void setSettings(const ButtonSettings& settings);
  ButtonSettings settings() const;

 Q_SIGNALS:
  void settingsChanged();

 private:
  void changed();

  QCheckBox* one_button_ = nullptr;
  QDoubleSpinBox* scan_ = nullptr;
  QComboBox* space_mouse_ = nullptr;
  QCheckBox* rumble_ = nullptr;
};

}  // namespace relievo
