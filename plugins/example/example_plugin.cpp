// SPDX-License-Identifier: BSD-3-Clause
// The smallest plugin: one panel that says which window is shown.
#include <memory>
#include <QLabel>
#include <QObject>

#include "plugins/api/plugin.h"

class ExamplePlugin : public QObject, public relievo::Plugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID RELIEVO_PLUGIN_IID FILE "example_plugin.json")
  Q_INTERFACES(relievo::Plugin)

 public:
  void attach(relievo::Host& host) override {
    auto* label = new QLabel(tr("No window yet."));
    label->setObjectName(QStringLiteral("exampleLabel"));
    label->setAccessibleName(tr("Shown window"));
    host.controls.addPanel(tr("Example"), label);  // The window owns it from here on.
    const auto say = [label](const std::shared_ptr<const relievo::RegionWindow>& window) {
      if (window)
        label->setText(tr("Window of %1 x %1 mm.").arg(window->region.side_mm, 0, 'f', 1));
    };
    connection_ = connect(&host.view, &relievo::ShownWindow::windowShown, label, say);
  }
  void detach() noexcept override { disconnect(connection_); }

 private:
  QMetaObject::Connection connection_;
};

#include "example_plugin.moc"
