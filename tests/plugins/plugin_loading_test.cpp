// SPDX-License-Identifier: BSD-3-Clause
// What the loader says of files that are plugins, plugins of others, and no plugins at all.
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QPluginLoader>
#include <QTemporaryDir>

#include "tests/haptics/haptic_fixture.h"
#include "tests/plugins/test_host.h"

namespace relievo {
namespace {

TEST(PluginLoading, TheExampleLoadsAndSpeaks) {
  QPluginLoader loader(QStringLiteral(RELIEVO_BINARY_DIR "/plugins_example/example_plugin.so"));
  ASSERT_TRUE(loader.load()) << loader.errorString().toStdString();
  auto* plugin = qobject_cast<Plugin*>(loader.instance());
  ASSERT_NE(plugin, nullptr);
  {
    test::TestHost host;
    plugin->attach(host);
    auto* label = qobject_cast<QLabel*>(host.panels.at("Example").data());
    ASSERT_NE(label, nullptr);
    host.showWindow(
        std::make_shared<RegionWindow>(test::windowOf(12.5, [](double, double) { return 0.0; })));
    EXPECT_EQ(label->text(), "Window of 12.5 x 12.5 mm.");
    plugin->detach();
  }
  loader.unload();
}

TEST(PluginLoading, AFileThatIsNoLibraryIsRefusedInWords) {
  QTemporaryDir folder;
  const QString name = folder.filePath("haptics_plugin.so");
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is not a library");
  file.close();
  QPluginLoader loader(name);
  EXPECT_EQ(loader.instance(), nullptr);
  EXPECT_FALSE(loader.errorString().isEmpty());
  EXPECT_TRUE(loader.errorString().contains("haptics_plugin.so"));
}

TEST(PluginLoading, AMissingFileIsRefusedInWords) {
  QPluginLoader loader(QStringLiteral("/nowhere/haptics_plugin.so"));
  EXPECT_FALSE(loader.load());
  EXPECT_FALSE(loader.errorString().isEmpty());
}

TEST(PluginLoading, APluginOfAnotherInterfaceShowsItsIidAndIsNoPluginOfOurs) {
  QPluginLoader loader(
      QStringLiteral(RELIEVO_BINARY_DIR "/tests/plugins_foreign_plugin/foreign_plugin.so"));
  EXPECT_NE(loader.metaData()["IID"].toString(), QStringLiteral(RELIEVO_PLUGIN_IID));
  EXPECT_FALSE(loader.metaData()["IID"].toString().isEmpty());
  ASSERT_NE(loader.instance(), nullptr) << loader.errorString().toStdString();
  EXPECT_EQ(qobject_cast<Plugin*>(loader.instance()), nullptr);
}

}  // namespace
}  // namespace relievo
