// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "plugins/voice/own_voice.h"
#include "plugins/voice/voice_settings.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace relievo {

/// Who speaks, in which language, how fast and how loud.
class VoicePanel : public QWidget {
  Q_OBJECT
 public:
  explicit VoicePanel(QWidget* parent = nullptr);

  VoiceSettings settings() const;
  void setSettings(const VoiceSettings& settings);
  void showChannel(OwnVoice::Channel channel);

 Q_SIGNALS:
  void settingsChanged();
  void trialAsked();
  void repeatAsked();

 private:
  void enableParts();

  QComboBox* speaker_;
  QComboBox* language_;
  QSpinBox* rate_;
  QSpinBox* volume_;
  QLabel* channel_;
  QPushButton* trial_;
  QPushButton* repeat_;
};

}  // namespace relievo
