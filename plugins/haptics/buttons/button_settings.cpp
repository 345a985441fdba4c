// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/buttons/button_settings.h"

#include <algorithm>
#include <QJsonDocument>
#include <QJsonObject>

namespace relievo {

QByteArray withButtons(const QByteArray& json, const ButtonSettings& settings) {
  QJsonObject object = QJsonDocument::fromJson(json).object();
  object["one_button"] = settings.one_button;
  object["scan_s"] = settings.scan_s;
  object["space_mouse"] =
      QLatin1String(settings.space_mouse == SpaceMouseMoves::view ? "view" : "hand");
  object["rumble"] = settings.rumble;
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

ButtonSettings buttonSettingsFromJson(const QByteArray& json) {
  const QJsonObject object = QJsonDocument::fromJson(json).object();
  ButtonSettings settings;
  settings.one_button = object["one_button"].toBool(false);
  settings.scan_s = std::clamp(object["scan_s"].toDouble(settings.scan_s), kLeastScanS, kMostScanS);
  if (object["space_mouse"].toString() == QLatin1String("view")) {
    settings.space_mouse = SpaceMouseMoves::view;
  }
  settings.rumble = object["rumble"].toBool(false);
  return settings;
}

}  // namespace relievo
