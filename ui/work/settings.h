// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

#include "core/base/unit.h"
#include "ui/work/device_trust.h"

namespace relievo {

/// What is remembered between runs, in the XDG places: choices in $XDG_CONFIG_HOME/relievo,
/// recent files and the window's layout in $XDG_STATE_HOME/relievo. [GUI thread]
class Settings {
 public:
  enum class Mode { remembered, safe };
  /// safe: reads nothing and keeps nothing.
  explicit Settings(Mode mode = Mode::remembered);

  QStringList recentFiles() const;
  void addRecentFile(const QString& file);  ///< Of a map from the web, its address.
  void clearRecentFiles();
  /// Another list of recent files, which other programs share; of the web's maps nothing goes
  /// there. Not in safe mode.
  struct SharedRecent {
    std::function<void(const QString& file)> add;  ///< Absolute.
    std::function<void()> clear;
  };
  void shareRecentFiles(SharedRecent list);

  /// The unit said for the files of one folder.
  std::optional<LengthUnit> unitOfFolder(const QString& file) const;
  void rememberUnit(const QString& file, LengthUnit unit);

  /// A folder of ours for what is kept between runs; empty in safe mode.
  QString stateFolder(const QString& name) const;

  QVariant choice(const QString& key, const QVariant& fallback) const;
  void setChoice(const QString& key, const QVariant& value);
  /// A choice that other programs share: from now on it is read and written there, and what was
  /// chosen here before goes there if nothing was chosen there. Not in safe mode.
  struct Elsewhere {
    std::function<QVariant()> read;
    std::function<void(const QVariant&)> write;
  };
  void keepElsewhere(const QString& key, const Elsewhere& place);

  /// Which plug-ins for devices may run, for whoever shows it. Not in safe mode.
  void keepDeviceTrust(DeviceTrust trust);
  const DeviceTrust& deviceTrust() const { return device_trust_; }

  QVariant layout(const QString& key) const;
  void setLayout(const QString& key, const QVariant& value);

 private:
  bool safe_;
  std::map<QString, Elsewhere> elsewhere_;
  SharedRecent shared_recent_;
  DeviceTrust device_trust_;
  mutable QSettings config_, state_;
};

inline constexpr int kRecentFiles = 10;

}  // namespace relievo
