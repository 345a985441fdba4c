// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "plugins/api/plugin.h"

class QLabel;

namespace relievo {

/// The smallest plugin: one panel that says which window is shown.
class ExamplePlugin : public QObject, public Plugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID RELIEVO_PLUGIN_IID FILE "example_plugin.json")
  Q_INTERFACES(relievo::Plugin)

 public:
  void attach(Host& host) override;
  void detach() noexcept override;

 private:
  QMetaObject::Connection connection_;
};

}  // namespace relievo
