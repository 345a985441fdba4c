// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/example/example_plugin.h"

#include <QLabel>

namespace relievo {

void ExamplePlugin::attach(Host& host) {
  auto* label = new QLabel(tr("No window yet."));
  label->setObjectName(QStringLiteral("exampleLabel"));
  label->setAccessibleName(tr("Shown window"));
  host.addPanel(tr("Example"), label);  // The host owns it from here on.
  connection_ = connect(&host, &Host::windowShown, label,
                        [label](const std::shared_ptr<const RegionWindow>& window) {
                          if (!window) return;
                          const double side = window->region.side_mm;
                          label->setText(tr("Window of %1 x %1 mm.").arg(side, 0, 'f', 1));
                        });
}

void ExamplePlugin::detach() noexcept {
  disconnect(connection_);
}

}  // namespace relievo
