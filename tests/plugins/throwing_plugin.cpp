// SPDX-License-Identifier: BSD-3-Clause
// A plugin that throws where RELIEVO_TEST_THROW says ("attach error": an exception with a reason;
// "attach int": what no catch clause would name) and counts what is asked of it.
#include <QAction>
#include <QLabel>
#include <QObject>
#include <stdexcept>

#include "plugins/api/plugin.h"

namespace relievo::test {

class ThrowingPlugin : public QObject, public Plugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID RELIEVO_PLUGIN_IID)
  Q_INTERFACES(relievo::Plugin)

 public:
  ThrowingPlugin() { throwIf("constructor"); }
  void attach(Host& host) override {
    qputenv("RELIEVO_TEST_HEARD", "");
    host.controls.addPanel(QStringLiteral("Throwing"), new QLabel(QStringLiteral("half")));
    auto* action = new QAction(QStringLiteral("Throw"));
    action->setObjectName(QStringLiteral("throw"));
    host.controls.addAction(QStringLiteral("Touch"), action);
    // On purpose not disconnected by detach().
    connect(&host.view, &ShownWindow::handMoved, this,
            [](const HandTarget&) { qputenv("RELIEVO_TEST_HEARD", "handMoved"); });
    throwIf("attach");
  }
  void detach() noexcept override { qputenv("RELIEVO_TEST_DETACHED", "yes"); }
  QByteArray saveState() const override {
    throwIf("save");
    return "new";
  }
  void restoreState(const QByteArray& /*state*/) override { throwIf("restore"); }

 private:
  static void throwIf(const QByteArray& place) {
    const QByteArray where = qgetenv("RELIEVO_TEST_THROW");
    if (where == place + " error") throw std::runtime_error("the cable is cut.");
    if (where == place + " int") throw 7;
  }
};

}  // namespace relievo::test

#include "throwing_plugin.moc"
