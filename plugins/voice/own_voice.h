// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <QObject>
#include <QTimer>

#include "plugins/api/host.h"
#include "plugins/voice/espeak_child.h"
#include "plugins/voice/speech_queue.h"
#include "plugins/voice/ssip_client.h"
#include "plugins/voice/voice_settings.h"

namespace relievo {

/// By which ways a voice speaks.
struct VoiceWays {
  std::filesystem::path socket;  ///< Speech Dispatcher's; empty: nowhere.
  SpeakingProgram program = {};
  int answer_ms = SsipClient::kAnswerMs;  ///< Tests on a busy computer wait longer.
  int retry_ms = 30'000;                  ///< After a failure it looks again this often.
};

/// Speaks through Speech Dispatcher, else by espeak-ng, else not at all, and says which. Everything
/// happens in the event loop, nothing waits. [GUI thread]
class OwnVoice : public QObject, public Voice {
  Q_OBJECT
 public:
  enum class Channel { none, dispatcher, program };

  explicit OwnVoice(VoiceWays ways, QObject* parent = nullptr);

  bool isOn() const override { return settings_.own_voice; }
  bool isSpeaking() const override;
  bool speak(const std::vector<Message>& sentences, SaidBecause why) override;
  bool speak(const QString& text, SaidBecause why) override;
  void hush() override;
  void feel(const Probe& probe) override;
  /// What was said last, once more, in the language of now; without a channel it is unheard().
  /// @return false: nothing was said
  bool repeat();

  /// From the next words on. Switching the own voice on makes it look for one again.
  void setSettings(const VoiceSettings& settings);
  Channel channel() const;
  /// What a millimetre of hand is on the object: how fast a probe's hand moves.
  void setScale(double object_mm_per_hand_mm) { object_mm_per_hand_mm_ = object_mm_per_hand_mm; }

 Q_SIGNALS:
  /// Neither way speaks (E402); once, until one has spoken again.
  void failed(const relievo::Message& why);
  /// What speak() took and no channel has said: somebody else is to say it.
  void unheard(const relievo::Speech& speech);
  void channelChanged();

 private:
  bool take(Speech speech, SaidBecause why);
  void say(Speech speech, SaidBecause why);
  void sayWhatIsDue();
  void utter(const Speech& speech);
  void switchOn();
  void switchOff();
  std::unique_ptr<SsipClient> newClient();
  void lookAgain();
  void leaveClient(const SsipClient* client, const Message& why);
  void leaveProgram(const Message& why);
  void changeAfterFailure(Channel left, const Message& why);
  void wasHeard();
  QString textOf(const Speech& speech) const;
  SpeechStyle styleOf(const Speech& speech) const;

  VoiceWays ways_;
  VoiceSettings settings_;
  SpeechQueue queue_;
  std::unique_ptr<SsipClient> dispatcher_;  // Null: not now.
  std::unique_ptr<SsipClient> candidate_;   // Has not answered yet; nothing is said by it.
  EspeakChild program_, probe_;             // The probe says nothing, to see whether it can.
  bool program_failed_ = false, told_ = false;
  double object_mm_per_hand_mm_ = 1;
  std::optional<Speech> unheard_;     // Begun, and not known to be heard.
  Channel given_to_ = Channel::none;  // What is unheard.
  QTimer retry_, due_;
};

}  // namespace relievo
