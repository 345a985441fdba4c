// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QAction>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include "plugins/api/plugin.h"
#include "plugins/voice/output_watch.h"
#include "plugins/voice/own_voice.h"
#include "plugins/voice/voice_panel.h"

namespace relievo {

/// Gives the program a voice of its own: the panel Voice, and commands that repeat and change the
/// volume, for keys, menus and the device's buttons. Tests set the
/// properties "speakingProgram" (instead of espeak-ng, with arguments), "answerMs" and "retryMs"
/// before attach.
class VoicePlugin : public QObject, public Plugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID RELIEVO_PLUGIN_IID FILE "voice_plugin.json")
  Q_INTERFACES(relievo::Plugin)

 public:
  ~VoicePlugin() override;
  void attach(Host& host) override;
  void detach() noexcept override;
  QByteArray saveState() const override;
  void restoreState(const QByteArray& state) override;
  /// Any key cuts what is being said.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void applySettings();
  struct Command {
    QString name, label, key, tip;
  };
  QAction* addCommand(const Command& command);
  void repeat();
  void changeVolume(bool louder);
  /// What buttons raise the volume to at most, where the sound comes out now.
  int loudestNow() const;
  /// Headphones that are pulled out are followed by a loudspeaker, which is never louder than the
  /// room bears.
  void watchOutput();
  /// The screen reader says what the voice could not.
  void handBack(const Speech& speech);

  Host* host_ = nullptr;
  VoiceSettings settings_;
  std::unique_ptr<OwnVoice> voice_;
  QPointer<VoicePanel> panel_;
  std::unique_ptr<OutputWatch> output_;  // While a room bears less than headphones.
  SoundOutput sounds_by_ = SoundOutput::unknown;
  /// What the volume was lowered from before anybody knew where it sounds; 0: it was not.
  int lowered_from_ = 0;
  QTimer look_;
  QPointer<QAction> repeat_action_, louder_action_, softer_action_;
};

}  // namespace relievo
