// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QUrl>
#include <utility>

#include "ui/work/file_names.h"

namespace relievo {
namespace {

/// $variable/relievo/file, or below home as the XDG base directory specification says.
QString place(const char* variable, const QString& below_home, const QString& file) {
  QString root = QString::fromLocal8Bit(qgetenv(variable));
  if (!QDir::isAbsolutePath(root)) root = QDir::homePath() + below_home;
  return root + QLatin1String("/relievo/") + file;
}

/// Slashes would make groups of a folder's name.
QString folderKey(const QString& file) {
  const QString folder = QFileInfo(file).absolutePath();
  return QLatin1String("units/") + QString::fromLatin1(QUrl::toPercentEncoding(folder));
}

}  // namespace

Settings::Settings(Mode mode)
    : safe_(mode == Mode::safe),
      config_(safe_ ? QString()
                    : place("XDG_CONFIG_HOME", QStringLiteral("/.config"),
                            QStringLiteral("relievo.ini")),
              QSettings::IniFormat),
      state_(safe_ ? QString()
                   : place("XDG_STATE_HOME", QStringLiteral("/.local/state"),
                           QStringLiteral("state.ini")),
             QSettings::IniFormat) {}

QStringList Settings::recentFiles() const {
  return safe_ ? QStringList() : state_.value(QStringLiteral("recent")).toStringList();
}

void Settings::addRecentFile(const QString& file) {
  if (safe_) return;
  const QString place = addressOrPath(file);
  const QString path = isAddress(place) ? place : QFileInfo(file).absoluteFilePath();
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  while (files.size() > kRecentFiles) files.removeLast();
  state_.setValue(QStringLiteral("recent"), files);
  if (shared_recent_.add && !isAddress(place)) shared_recent_.add(path);
}

void Settings::clearRecentFiles() {
  if (safe_) return;
  state_.remove(QStringLiteral("recent"));
  if (shared_recent_.clear) shared_recent_.clear();
}

void Settings::shareRecentFiles(SharedRecent list) {
  if (!safe_) shared_recent_ = std::move(list);
}

std::optional<LengthUnit> Settings::unitOfFolder(const QString& file) const {
  return lengthUnit(choice(folderKey(file), QString()).toString().toStdString());
}

void Settings::rememberUnit(const QString& file, LengthUnit unit) {
  setChoice(folderKey(file), QString::fromUtf8(name(unit).data()));
}

QString Settings::stateFolder(const QString& name) const {
  if (safe_) return {};
  return place("XDG_STATE_HOME", QStringLiteral("/.local/state"), name);
}

QVariant Settings::choice(const QString& key, const QVariant& fallback) const {
  const auto place = elsewhere_.find(key);
  if (place != elsewhere_.end()) return place->second.read();
  return safe_ ? fallback : config_.value(key, fallback);
}

void Settings::setChoice(const QString& key, const QVariant& value) {
  const auto place = elsewhere_.find(key);
  if (place != elsewhere_.end()) return place->second.write(value);
  if (!safe_) config_.setValue(key, value);
}

void Settings::keepElsewhere(const QString& key, const Elsewhere& place) {
  if (safe_) return;
  const QString before = config_.value(key).toString();
  config_.remove(key);
  if (!before.isEmpty() && place.read().toString().isEmpty()) place.write(before);
  elsewhere_[key] = place;
}

void Settings::keepDeviceTrust(DeviceTrust trust) {
  if (!safe_) device_trust_ = std::move(trust);
}

QVariant Settings::layout(const QString& key) const {
  return safe_ ? QVariant() : state_.value(key);
}

void Settings::setLayout(const QString& key, const QVariant& value) {
  if (!safe_) state_.setValue(key, value);
}

}  // namespace relievo
