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
};

/// Speaks through Speech Dispatcher, else by espeak-ng, else not at all, and says which. Everything
/// happens in the event loop, nothing waits. [GUI thread]
class OwnVoice : public QObject, public Voice {
  Q_OBJECT
 public:
  enum class Channel { none, dispatcher, program };
  /// After a failure it looks again this often.
  static constexpr int kRetryMs = 30'000;

  explicit OwnVoice(VoiceWays ways, QObject* parent = nullptr);

  bool speak(const std::vector<Message>& sentences, SaidBecause why) override;
  bool speak(const QString& text, SaidBecause why) override;
  void hush() override;
  void feel(const Probe& probe) override;
  /// What was said last, once more, in the language of now. @return false: nothing was
  bool repeat();

  /// From the next words on. Switching the own voice on makes it look for one again.
  void setSettings(const VoiceSettings& settings);
  Channel channel() const;
  /// What a millimetre of hand is on the object: how fast a probe's hand moves.
  void setScale(double object_mm_per_hand_mm) { object_mm_per_hand_mm_ = object_mm_per_hand_mm; }

 Q_SIGNALS:
  /// Neither way speaks (E402); once, until one has spoken again.
  void failed(const relievo::Message& why);
  void channelChanged();

 private:
  void say(Speech speech, SaidBecause why);
  void sayWhatIsDue();
  void utter(const Speech& speech);
  void connectToDispatcher();
  void leaveDispatcher(const Message& why);
  void leaveProgram(const Message& why);
  bool isSpeaking() const;
  QString textOf(const Speech& speech) const;
  SpeechStyle styleOf(const Speech& speech) const;

  VoiceWays ways_;
  VoiceSettings settings_;
  SpeechQueue queue_;
  std::unique_ptr<SsipClient> dispatcher_;  // Null: not now.
  EspeakChild program_;
  bool program_failed_ = false, told_ = false;
  double object_mm_per_hand_mm_ = 1;
  std::optional<Speech> unheard_;  // Begun, and not known to be heard.
  QTimer retry_, due_;
};

}  // namespace relievo
