// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/voice_settings.h"

#include <algorithm>
#include <QJsonDocument>
#include <QJsonObject>

#include "ui/translations/message_languages.h"

namespace relievo {

QByteArray jsonOf(const VoiceSettings& settings) {
  return QJsonDocument(QJsonObject{{"own_voice", settings.own_voice},
                                   {"language", settings.language},
                                   {"words_per_minute", settings.words_per_minute},
                                   {"volume_percent", settings.volume_percent},
                                   {"loudest_percent", settings.loudest_percent},
                                   {"room_loudest_percent", settings.room_loudest_percent}})
      .toJson(QJsonDocument::Compact);
}

VoiceSettings voiceSettingsFromJson(const QByteArray& json) {
  const QJsonObject object = QJsonDocument::fromJson(json).object();
  VoiceSettings settings;
  settings.own_voice = object["own_voice"].toBool(false);
  const std::string language = object["language"].toString().toStdString();
  if (messageLanguage(language).tag == language) {
    settings.language = QString::fromStdString(language);
  }
  settings.words_per_minute = std::clamp(
      object["words_per_minute"].toInt(settings.words_per_minute), kSlowestSpeech, kFastestSpeech);
  settings.loudest_percent =
      std::clamp(object["loudest_percent"].toInt(settings.loudest_percent), kLeastVolume, 100);
  settings.room_loudest_percent =
      std::clamp(object["room_loudest_percent"].toInt(settings.loudest_percent), kLeastVolume,
                 settings.loudest_percent);
  settings.volume_percent = std::clamp(object["volume_percent"].toInt(settings.volume_percent), 0,
                                       settings.loudest_percent);
  return settings;
}

}  // namespace relievo
