// SPDX-License-Identifier: BSD-3-Clause
// A plugin of the version before, and one that would be noticed if it ran.
#include <QObject>

#include "plugins/api/plugin.h"

namespace relievo::test {

class OldPlugin : public QObject, public Plugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "org.relievo.Plugin/1")
  Q_INTERFACES(relievo::Plugin)

 public:
  OldPlugin() { qputenv("RELIEVO_TEST_OLD_PLUGIN", "ran"); }
  void attach(Host& /*host*/) override {}
  void detach() noexcept override {}
};

}  // namespace relievo::test

#include "old_plugin.moc"
