// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QPluginLoader>
#include <QString>
#include <QStringList>
#include <vector>

#include "app/host.h"
#include "plugins/api/plugin.h"
#include "ui/work/settings.h"

namespace relievo {

/// Finds, loads and attaches the plugins, and detaches them before the program ends. Modules are
/// never unloaded. A plugin that fails, whatever it throws, is left out and named. [GUI thread]
class PluginLoader {
 public:
  /// Folders in the order they are searched: $RELIEVO_PLUGIN_PATH, ../plugins beside the program's
  /// folder, ../LIBDIR/relievo/plugins.
  static QStringList folders();

  PluginLoader(WindowHost& host, Settings& settings);
  ~PluginLoader();
  PluginLoader(const PluginLoader&) = delete;
  PluginLoader& operator=(const PluginLoader&) = delete;

  /// Loads what is in the folders; a name found twice is taken from the first folder.
  void load();
  void detachAll();

  /// Hands a state to one that is attached, as at its start. @return false: it is not there
  bool restore(const QString& name, const QByteArray& state);

  bool has(const QString& name) const;                ///< Attached: "haptics".
  QStringList problems() const { return problems_; }  ///< One sentence per plugin that failed.

 private:
  struct Loaded {
    QString name;
    std::unique_ptr<QPluginLoader> loader;
    Plugin* plugin;  ///< Owned by the loader.
  };
  void loadOne(const QString& file);
  bool attach(const Loaded& loaded);
  void leaveOut(const Loaded& loaded);

  WindowHost& host_;
  Settings& settings_;
  std::vector<Loaded> loaded_;
  QStringList problems_;
};

}  // namespace relievo
