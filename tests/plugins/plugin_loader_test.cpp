// SPDX-License-Identifier: BSD-3-Clause
// The program's loader with its window: what is loaded, what is refused, and what fails on the way.
// What is left out is named in a sentence, and nothing of it stays in the window.
#include "app/plugin_loader.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>

#include "app/host.h"
#include "tests/ui/gui_fixture.h"
#include "ui/frame/side_panels.h"

namespace relievo {
namespace {

class PluginLoaderTest : public GuiTest {
 protected:
  PluginLoaderTest() { qputenv("RELIEVO_PLUGIN_PATH", path("plugins").toLocal8Bit()); }
  ~PluginLoaderTest() override {
    for (const char* variable : {"RELIEVO_PLUGIN_PATH", "RELIEVO_TEST_THROW",
                                 "RELIEVO_TEST_DETACHED", "RELIEVO_TEST_OLD_PLUGIN"}) {
      qunsetenv(variable);
    }
  }
  /// Into the folder that is searched first. A copy of its own each: a module once loaded stays
  /// as it is.
  void putThere(const QString& built) {
    QDir().mkpath(path("plugins"));
    const QString file = QStringLiteral(RELIEVO_BINARY_DIR "/") + built;
    ASSERT_TRUE(QFile::copy(file, path("plugins/") + QFileInfo(file).fileName()));
  }
  void load() {
    host_ = std::make_unique<WindowHost>(window());
    loader_ = std::make_unique<PluginLoader>(*host_, window().settings());
    loader_->load();
  }
  void keepState(const QByteArray& state) { window().settings().setChoice(key_, state.toBase64()); }
  QByteArray keptState() {
    return QByteArray::fromBase64(window().settings().choice(key_, {}).toByteArray());
  }
  /// Of all that were found; the haptics plugin, which was built beside the test, has none.
  QString problems() const { return loader_->problems().join('\n'); }
  QStringList panels() const { return child<SidePanels>("side_panels")->titles(); }
  void throwsIn(const char* place) {
    putThere("tests/plugins_throwing_plugin/throwing_plugin.so");
    qputenv("RELIEVO_TEST_THROW", place);
    load();
  }
  void expectNothingOfItLeft() {
    EXPECT_FALSE(loader_->has("throwing_plugin"));
    EXPECT_FALSE(panels().contains("Throwing"));
    EXPECT_EQ(action("throw"), nullptr);
    EXPECT_EQ(qgetenv("RELIEVO_TEST_DETACHED"), "yes");
    Q_EMIT host_->handMoved({});
    EXPECT_EQ(qgetenv("RELIEVO_TEST_HEARD"), "") << "it hears the host no more";
  }

  const QString key_ = QStringLiteral("plugins/throwing_plugin");
  std::unique_ptr<WindowHost> host_;
  std::unique_ptr<PluginLoader> loader_;
};

TEST_F(PluginLoaderTest, TheExampleIsAttachedAndSpeaks) {
  putThere("plugins_example/example_plugin.so");
  load();
  EXPECT_TRUE(loader_->has("example_plugin"));
  EXPECT_EQ(problems(), "");
  EXPECT_TRUE(panels().contains("Example"));
  openRelief();
  EXPECT_TRUE(child<QLabel>("exampleLabel")->text().startsWith("Window of "));
}

TEST_F(PluginLoaderTest, AnotherVersionOfTheInterfaceIsRefusedWithoutRunningIt) {
  putThere("tests/plugins_old_plugin/old_plugin.so");
  load();
  EXPECT_FALSE(loader_->has("old_plugin"));
  EXPECT_EQ(problems(),
            "old_plugin.so was built for version 1 of the plugin interface, and this relievo has "
            "version " RELIEVO_PLUGIN_VERSION
            ". It was not loaded. Build it again with the "
            "headers of this relievo.");
  EXPECT_TRUE(qgetenv("RELIEVO_TEST_OLD_PLUGIN").isEmpty());
}

TEST_F(PluginLoaderTest, APluginOfAnotherProgramIsRefused) {
  putThere("tests/plugins_foreign_plugin/foreign_plugin.so");
  load();
  EXPECT_EQ(problems(),
            "foreign_plugin.so is no plugin of relievo. It was not loaded. Take it out of the "
            "folder of plugins.");
}

TEST_F(PluginLoaderTest, AFileThatIsNoLibraryIsRefused) {
  QDir().mkpath(path("plugins"));
  QFile file(path("plugins/broken.so"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is not a library");
  file.close();
  load();
  EXPECT_TRUE(problems().startsWith("broken.so is no plugin of relievo."))
      << problems().toStdString();
}

TEST_F(PluginLoaderTest, OneThatThrowsInAttachIsLeftOutAndNamed) {
  throwsIn("attach error");
  EXPECT_EQ(problems(),
            "The plugin throwing_plugin could not start and was left out: the cable is cut. All "
            "else works.");
  expectNothingOfItLeft();
}

TEST_F(PluginLoaderTest, OneThatThrowsWhatIsNoErrorIsLeftOutAndNamed) {
  throwsIn("attach int");
  EXPECT_EQ(problems(),
            "The plugin throwing_plugin could not start and was left out: it threw something that "
            "says no reason. All else works.");
  expectNothingOfItLeft();
}

TEST_F(PluginLoaderTest, OneThatCannotBeMadeIsLeftOutAndNamed) {
  throwsIn("constructor int");
  EXPECT_TRUE(problems().startsWith("The plugin throwing_plugin could not start"))
      << problems().toStdString();
  EXPECT_FALSE(loader_->has("throwing_plugin"));
}

TEST_F(PluginLoaderTest, OneThatThrowsInRestoreStateIsLeftOutAndKeepsItsSettings) {
  keepState("old");
  throwsIn("restore error");
  EXPECT_EQ(problems(),
            "The plugin throwing_plugin could not take its settings back and was left out: the "
            "cable is cut. Its settings were kept; all else works.");
  expectNothingOfItLeft();
  loader_->detachAll();
  EXPECT_EQ(keptState(), "old");
}

TEST_F(PluginLoaderTest, OneThatThrowsWhatIsNoErrorInRestoreStateIsLeftOut) {
  keepState("old");
  throwsIn("restore int");
  EXPECT_TRUE(problems().contains("its settings back and was left out: it threw something"))
      << problems().toStdString();
  expectNothingOfItLeft();
  loader_->detachAll();
  EXPECT_EQ(keptState(), "old");
}

TEST_F(PluginLoaderTest, OneThatThrowsInSaveStateKeepsTheSettingsItHad) {
  keepState("old");
  throwsIn("save int");
  EXPECT_TRUE(loader_->has("throwing_plugin"));
  loader_->detachAll();
  EXPECT_EQ(problems(),
            "The plugin throwing_plugin could not tell its settings: it threw something that says "
            "no reason. Those it had before were kept.");
  EXPECT_EQ(qgetenv("RELIEVO_TEST_DETACHED"), "yes");
  EXPECT_EQ(keptState(), "old");
}

TEST_F(PluginLoaderTest, ThoseAfterOneThatThrewAreLoaded) {
  putThere("plugins_example/example_plugin.so");
  ASSERT_TRUE(QFile::rename(path("plugins/example_plugin.so"), path("plugins/zz_example.so")));
  throwsIn("attach int");
  EXPECT_TRUE(loader_->has("zz_example"));
  EXPECT_TRUE(panels().contains("Example"));
}

}  // namespace
}  // namespace relievo
