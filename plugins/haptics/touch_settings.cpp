// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/touch_settings.h"

#include <algorithm>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace relievo {

namespace {
constexpr int kProxyKinds = 3, kSurfaceKinds = 3;

double within(const QJsonValue& value, double least, double most, double otherwise) {
  return std::clamp(value.toDouble(otherwise), least, most);
}

QString gripName(GripPosition position) {
  const std::string_view word = name(position);
  return QString::fromLatin1(word.data(), static_cast<int>(word.size()));
}
}  // namespace

HapticOptions hapticOptions(const TouchSettings& settings, bool forces_on) {
  HapticOptions options;
  setFeel(options, settings.feel);
  options.force.strength = settings.strength_percent / 100.0;
  options.force.forces_on = forces_on;
  options.force.limit_n = settings.limit_n;
  options.frame = true;
  options.bound_by_rate = settings.bound_by_rate;
  options.holds_grip = settings.holds_grip;
  options.grip = settings.grip;
  options.stop.window_silence_s = settings.window_silence_s;
  return options;
}

QByteArray toJson(const TouchSettings& settings) {
  const SurfaceFeel& feel = settings.feel;
  QJsonArray by_detail;
  for (const double k : feel.detail_stiffness) by_detail.append(k);
  const QJsonObject object{{"strength_percent", settings.strength_percent},
                           {"stiffness_by_detail", feel.stiffness_by_detail},
                           {"stiffness_n_per_mm", feel.stiffness_n_per_mm},
                           {"proxy", static_cast<int>(feel.proxy)},
                           {"surface", static_cast<int>(feel.surface)},
                           {"friction", feel.friction},
                           {"damping_n_s_per_mm", feel.damping_n_s_per_mm},
                           {"detail_stiffness_n_per_mm", by_detail},
                           {"softest_part", feel.fields.softest_part},
                           {"texture_mm", feel.fields.texture_mm},
                           {"magnet_n", feel.fields.magnet_n},
                           {"magnet_reach_mm", feel.fields.magnet_reach_mm},
                           {"contact_n", feel.transient.contact_n},
                           {"crossing_n", feel.transient.crossing_n},
                           {"firmness", QFile::decodeName(settings.firmness.c_str())},
                           {"window_silence_s", settings.window_silence_s},
                           {"bound_by_rate", settings.bound_by_rate},
                           {"holds_grip", settings.holds_grip},
                           {"limit_n", settings.limit_n},
                           {"introduction_shapes", settings.introduction_shapes},
                           {"guide_rounds", settings.guide_rounds},
                           {"felt_patterns", settings.felt_patterns},
                           {"grip_position", gripName(settings.grip)},
                           {"sound", settings.sound.on},
                           {"sound_volume_percent", settings.sound.volume_percent},
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
  const QJsonArray by_detail = object["detail_stiffness_n_per_mm"].toArray();
  for (int i = 0; i < by_detail.size() && i < static_cast<int>(feel.detail_stiffness.size()); ++i) {
    double& k = feel.detail_stiffness[static_cast<std::size_t>(i)];
    k = within(by_detail[i], kLeastStiffness, kMostStiffness, k);
  }
  FieldOptions& fields = feel.fields;
  fields.softest_part = within(object["softest_part"], kLeastSoftPart, 1, fields.softest_part);
  fields.texture_mm = within(object["texture_mm"], 0, kMostTextureMm, fields.texture_mm);
  fields.magnet_n = within(object["magnet_n"], 0, kMostMagnetN, fields.magnet_n);
  fields.magnet_reach_mm =
      within(object["magnet_reach_mm"], kLeastReachMm, kMostReachMm, fields.magnet_reach_mm);
  TransientOptions& transient = feel.transient;
  transient.contact_n = within(object["contact_n"], 0, kMostContactN, transient.contact_n);
  transient.crossing_n = within(object["crossing_n"], 0, kMostCrossingN, transient.crossing_n);
  settings.firmness = QFile::encodeName(object["firmness"].toString()).toStdString();
  const QString device = object["device"].toString();
  if (!device.isEmpty()) settings.device = device.toStdString();
  settings.window_silence_s =
      within(object["window_silence_s"], kLeastSilenceS, kMostSilenceS, settings.window_silence_s);
  settings.bound_by_rate = object["bound_by_rate"].toBool(true);
  settings.holds_grip = object["holds_grip"].toBool(true);
  settings.limit_n = within(object["limit_n"], kLeastLimitN, settings.limit_n, settings.limit_n);
  settings.introduction_shapes =
      std::clamp(object["introduction_shapes"].toInt(kTrainingShapes), 1, kTrainingShapes);
  settings.guide_rounds = std::clamp(object["guide_rounds"].toInt(settings.guide_rounds), 1,
                                     static_cast<int>(kMostRounds));
  settings.felt_patterns = object["felt_patterns"].toBool(false);
  settings.grip = gripPosition(object["grip_position"].toString().toStdString())
                      .value_or(GripPosition::upright);
  settings.sound.on = object["sound"].toBool(false);
  settings.sound.volume_percent =
      std::clamp(object["sound_volume_percent"].toInt(settings.sound.volume_percent), 0, 100);
  const int proxy = object["proxy"].toInt(0);
  if (proxy >= 0 && proxy < kProxyKinds) feel.proxy = static_cast<ProxyKind>(proxy);
  const int surface = object["surface"].toInt(0);
  if (surface >= 0 && surface < kSurfaceKinds) feel.surface = static_cast<SurfaceKind>(surface);
  return settings;
}

}  // namespace relievo
