// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QString>

namespace relievo {

/// Who says what the hand meets, and how.
struct VoiceSettings {
  bool own_voice = false;      ///< Else the screen reader, as everything else.
  QString language = {};       ///< "en", "de", "hi"; empty: the window's.
  int words_per_minute = 220;  ///< 100 to 449.
  int volume_percent = 100;
  int loudest_percent = 100;  ///< What commands raise it to at most: an exhibit's.
  /// The same where everybody hears it, and not one person by headphones; at most
  /// `loudest_percent`.
  int room_loudest_percent = 100;
  friend bool operator==(const VoiceSettings&, const VoiceSettings&) = default;
};
// By buttons it does not become silent: who does not look could not find the way back.
inline constexpr int kLeastVolume = 10;
inline constexpr int kSlowestSpeech = 100, kFastestSpeech = 449;

QByteArray jsonOf(const VoiceSettings& settings);
/// What is missing or makes no sense is the default's.
VoiceSettings voiceSettingsFromJson(const QByteArray& json);

}  // namespace relievo
