// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "app/exhibit/heartbeat.h"
#include "app/host.h"
#include "app/plugin_loader.h"
#include "core/exhibit/exhibit.h"
#include "ui/exhibit/exhibit_control.h"

namespace relievo {

/// Languages in which an exhibit can be: those of the program.
std::vector<std::string> exhibitLanguages();

/// An exhibit in the program's window: joins its control with the plugins for voice and touch, and
/// with the supervisor. Made once plugins are loaded. [GUI thread]
class ExhibitWindow : public QObject {
  Q_OBJECT
 public:
  ExhibitWindow(MainWindow& window, WindowHost& host, PluginLoader& plugins,
                const Exhibit& exhibit);
  ~ExhibitWindow() override;

  ExhibitControl& control() { return control_; }
  /// The computer says that the program must end.
  void endAtOnce() { control_.endAtOnce(); }

 private:
  ExhibitWays waysOf(PluginLoader& plugins, const Exhibit& exhibit);

  WindowHost& host_;
  ExhibitControl control_;
  Heartbeat heartbeat_;
};

}  // namespace relievo
