// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/touch_settings.h"

#include <algorithm>
#include <QJsonDocument>
#include <QJsonObject>

namespace relievo {

namespace {
constexpr int kProxyKinds = 3;
}

HapticOptions hapticOptions(const TouchSettings& settings, bool forces_on) {
  HapticOptions options;
  options.proxy.kind = settings.proxy;
  options.stiffness_by_detail = settings.stiffness_by_detail;
  options.force.stiffness_n_per_mm = settings.stiffness_n_per_mm;
  options.force.strength = settings.strength_percent / 100.0;
  options.force.forces_on = forces_on;
  options.frame = true;
  return options;
}

QByteArray toJson(const TouchSettings& settings) {
  const QJsonObject object{{"strength_percent", settings.strength_percent},
                           {"stiffness_by_detail", settings.stiffness_by_detail},
                           {"stiffness_n_per_mm", settings.stiffness_n_per_mm},
                           {"proxy", static_cast<int>(settings.proxy)},
                           {"device", QString::fromStdString(settings.device)}};
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

TouchSettings touchSettingsFromJson(const QByteArray& json) {
  const QJsonObject object = QJsonDocument::fromJson(json).object();
  TouchSettings settings;
  const int strength = object["strength_percent"].toInt(settings.strength_percent);
  settings.strength_percent = std::clamp(strength, 0, 100);
  settings.stiffness_by_detail = object["stiffness_by_detail"].toBool(true);
  const double k = object["stiffness_n_per_mm"].toDouble(settings.stiffness_n_per_mm);
  settings.stiffness_n_per_mm = std::clamp(k, kLeastStiffness, kMostStiffness);
  const QString device = object["device"].toString();
  if (!device.isEmpty()) settings.device = device.toStdString();
  const int proxy = object["proxy"].toInt(0);
  if (proxy >= 0 && proxy < kProxyKinds) settings.proxy = static_cast<ProxyKind>(proxy);
  return settings;
}

}  // namespace relievo
