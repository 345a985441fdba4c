// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QPluginLoader>
#include <QTemporaryDir>

#include "tests/haptics/haptic_fixture.h"
#include "tests/plugins/test_host.h"

namespace relievo::test {

/// Lets events run until something holds; false after a generous while.
inline bool eventually(const std::function<bool()>& holds) {
  const QDeadlineTimer give_up(240'000);
  while (!holds()) {
    if (give_up.hasExpired()) return false;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
  }
  return true;
}

/// A home of the test's own: nothing of the user's is read or written.
class PrivateHome {
 public:
  PrivateHome() {
    qputenv("HOME", folder_.path().toUtf8());
    qputenv("XDG_DATA_HOME", folder_.filePath("data").toUtf8());
    qputenv("XDG_CONFIG_HOME", folder_.filePath("config").toUtf8());
    qputenv("XDG_STATE_HOME", folder_.filePath("state").toUtf8());
    qunsetenv("RELIEVO_FALCON_FIRMWARE");
  }
  QString file(const QString& name) const { return folder_.filePath(name); }

 private:
  QTemporaryDir folder_;
};

/// The haptics plugin as the application sees it: a file, loaded; a Host, spoken to.
class PluginTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(loader_.load()) << loader_.errorString().toStdString();
    plugin_ = qobject_cast<Plugin*>(loader_.instance());
    ASSERT_NE(plugin_, nullptr);
  }
  void TearDown() override {
    if (plugin_ != nullptr) plugin_->detach();
    loader_.unload();
  }
  void attach() { plugin_->attach(host_); }
  template <class Widget>
  Widget* inPanel(const char* name, const char* panel = "Touch") {
    auto* widget =
        host_.panels.at(QString::fromLatin1(panel))->findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  /// Until the loop's newest sample satisfies something.
  bool probeBecomes(const std::function<bool(const Probe&)>& holds) {
    return eventually([&] { return !host_.probes.empty() && holds(host_.probes.back()); });
  }
  bool said(const QString& text) {
    return eventually([&] { return host_.announcements.contains(text); });
  }

  PrivateHome home_;
  TestHost host_;
  QPluginLoader loader_{QStringLiteral(RELIEVO_BINARY_DIR "/plugins/haptics_plugin.so")};
  Plugin* plugin_ = nullptr;
};

}  // namespace relievo::test
