// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/touch_settings.h"

#include <algorithm>
#include <QJsonDocument>
#include <QJsonObject>

namespace relievo {

namespace {
constexpr int kProxyKinds = 3, kSurfaceKinds = 3;

double within(const QJsonValue& value, double least, double most, double otherwise) {
  return std::clamp(value.toDouble(otherwise), least, most);
}
}  // namespace

HapticOptions hapticOptions(const TouchSettings& settings, bool forces_on) {
  const SurfaceFeel& feel = settings.feel;
  HapticOptions options;
  options.proxy = proxyOptions(feel);
  options.stiffness_by_detail = feel.stiffness_by_detail;
  options.force.stiffness_n_per_mm = feel.stiffness_n_per_mm;
  options.force.damping_n_s_per_mm = feel.damping_n_s_per_mm;
  options.force.strength = settings.strength_percent / 100.0;
  options.force.forces_on = forces_on;
  options.frame = true;
  return options;
}

QByteArray toJson(const TouchSettings& settings) {
  const SurfaceFeel& feel = settings.feel;
  const QJsonObject object{{"strength_percent", settings.strength_percent},
                           {"stiffness_by_detail", feel.stiffness_by_detail},
                           {"stiffness_n_per_mm", feel.stiffness_n_per_mm},
                           {"proxy", static_cast<int>(feel.proxy)},
                           {"surface", static_cast<int>(feel.surface)},
                           {"friction", feel.friction},
                           {"damping_n_s_per_mm", feel.damping_n_s_per_mm},
                           {"device", QString::fromStdString(settings.device)}};
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

TouchSettings touchSettingsFromJson(const QByteArray& json) {
  const QJsonObject object = QJsonDocument::fromJson(json).object();
  TouchSettings settings;
  const int strength = object["strength_percent"].toInt(settings.strength_percent);
  settings.strength_percent = std::clamp(strength, 0, 100);
  SurfaceFeel& feel = settings.feel;
  feel.stiffness_by_detail = object["stiffness_by_detail"].toBool(true);
  feel.stiffness_n_per_mm = within(object["stiffness_n_per_mm"], kLeastStiffness, kMostStiffness,
                                   feel.stiffness_n_per_mm);
  feel.friction = within(object["friction"], 0, kMostFrictionAsked, 0);
  feel.damping_n_s_per_mm = within(object["damping_n_s_per_mm"], 0, kMostDamping, 0);
  const QString device = object["device"].toString();
  if (!device.isEmpty()) settings.device = device.toStdString();
  const int proxy = object["proxy"].toInt(0);
  if (proxy >= 0 && proxy < kProxyKinds) feel.proxy = static_cast<ProxyKind>(proxy);
  const int surface = object["surface"].toInt(0);
  if (surface >= 0 && surface < kSurfaceKinds) feel.surface = static_cast<SurfaceKind>(surface);
  return settings;
}

}  // namespace relievo
