// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QString>
#include <vector>

namespace relievo {

/// A plug-in for devices, as people decide about it.
struct DevicePluginRow {
  QString name, file;
  QString note = {};  ///< Why it may not run; empty: it may.
  bool allowed = false;
  bool can_change = false;  ///< It is the user's own, and nothing else keeps it from running.
};

/// Which plug-ins for devices may run: kept elsewhere, for the command line, too. Without `list`
/// nobody is asked.
struct DeviceTrust {
  std::function<std::vector<DevicePluginRow>()> list;  ///< [worker]
  /// [worker] @return why not, in a sentence; empty: it is so from now on
  std::function<QString(const QString& file, bool allowed)> allow;
  QString folder;  ///< Where the user's own lie.
};

}  // namespace relievo
