// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/manual.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <QAction>
#include <QDesktopServices>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTextBrowser>
#include <utility>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

class ManualTest : public GuiTest {
 protected:
  ManualTest() {
    qputenv("RELIEVO_MANUAL_PATH", QFile::encodeName(path("html")));
    QDesktopServices::setUrlHandler("file", &browser_, "setSource");
  }
  ~ManualTest() override {
    QDesktopServices::unsetUrlHandler("file");
    qunsetenv("RELIEVO_MANUAL_PATH");
  }

  void write(const QString& name) const {
    QDir().mkpath(QFileInfo(path(name)).path());
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("<html></html>");
  }
  /// The site's first page and those of the parts of the window.
  void writePages() const {
    write("html/index.html");
    for (const ManualTopic& topic : manualTopics()) write(page(topic.page));
  }
  static QString page(const char* name) {
    return QStringLiteral("html/docs/user/%1.html").arg(name);
  }
  QString opened() const { return browser_.source().toLocalFile(); }

 private:
  QTextBrowser browser_;  ///< Stands for the desktop's.
};

TEST_F(ManualTest, EveryPartHasAPageAndIsAPart) {
  std::string classes;
  for (const char* folder : {"/ui", "/plugins"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(RELIEVO_SOURCE_DIR + std::string(folder))) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      classes.append(std::istreambuf_iterator<char>(in), {});
    }
  }
  for (const ManualTopic& topic : manualTopics()) {
    EXPECT_TRUE(fs::exists(RELIEVO_SOURCE_DIR "/docs/user/" + std::string(topic.page) + ".md"))
        << topic.page;
    EXPECT_NE(classes.find("class " + std::string(topic.part) + " : public "), std::string::npos)
        << topic.part;
  }
}

TEST_F(ManualTest, OpensAtThePageForWhatHasTheKeyboard) {
  writePages();
  openRelief();
  window().detailView().setFocus();
  ASSERT_TRUE(window().runCommand("manual"));
  EXPECT_EQ(opened().toStdString(), path(page("touch")).toStdString());
  child<QWidget>("stereo_on")->setFocus();
  EXPECT_EQ(action("manual")->shortcut(), QKeySequence("Shift+F1"));
  ASSERT_TRUE(window().runCommand("manual"));
  EXPECT_EQ(opened().toStdString(), path(page("stereo")).toStdString());
}

// Asked straight: an event that is sent goes through the shortcuts of whichever window is active.
TEST_F(ManualTest, TheKeyWorksInADialogAndIsAboutIt) {
  openRelief();
  QStringList topics;
  ManualKey filter([&](const QWidget* about) { topics << manualTopic(about); }, nullptr);
  QKeyEvent key(QEvent::KeyPress, Qt::Key_F1, Qt::ShiftModifier);
  QKeyEvent other(QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier);
  for (const auto& [command, name] : {std::pair{"depth_map", "depth_map_dialog"},
                                      std::pair{"preferences", "preferences_dialog"}}) {
    ASSERT_TRUE(window().runCommand(command));
    auto* shown = child<QDialog>(name);
    ASSERT_NE(shown, nullptr);
    auto* button = shown->findChild<QPushButton*>();
    EXPECT_TRUE(filter.eventFilter(button, &key));
    EXPECT_FALSE(filter.eventFilter(button, &other));
    shown->close();
  }
  EXPECT_FALSE(filter.eventFilter(&window().detailView(), &key)) << "the window's own command";
  EXPECT_EQ(topics, (QStringList{"depth_map", "window"}));
}

TEST_F(ManualTest, IsFoundAmongTheCommandsByItsWords) {
  for (const char* word : {"manual", "help", "guide", "documentation"}) {
    ASSERT_TRUE(window().runCommand("search_commands"));
    auto* search = child<QDialog>("command_search");
    ASSERT_NE(search, nullptr);
    search->findChild<QLineEdit*>("command_words")->setText(word);
    const auto* list = search->findChild<QListWidget*>("command_list");
    bool found = false;
    for (int row = 0; row < list->count(); ++row) {
      found = found || list->item(row)->text().startsWith("Manual");
    }
    EXPECT_TRUE(found) << word;
    delete search;
  }
}

TEST_F(ManualTest, APartWithoutAPageOpensTheFirstOne) {
  write("html/index.html");
  EXPECT_EQ(manualPage("touch", {path("nowhere"), path("html")}), path("html/index.html"));
  EXPECT_EQ(manualPage({}, {path("html")}), path("html/index.html"));
  EXPECT_EQ(manualPage("touch", {path("nowhere")}), QString());
}

TEST_F(ManualTest, WithoutPagesOrBrowserASentenceSaysWhatToDo) {
  const ManualOpening none =
      openManual("touch", {path("nowhere")}, [](const QUrl&) { return true; });
  EXPECT_FALSE(none.opened);
  EXPECT_TRUE(none.sentence.contains("--target site")) << none.sentence.toStdString();
  writePages();
  const ManualOpening unread =
      openManual("touch", {path("html")}, [](const QUrl&) { return false; });
  EXPECT_FALSE(unread.opened);
  EXPECT_TRUE(unread.sentence.contains(path(page("touch")))) << unread.sentence.toStdString();
}

}  // namespace
}  // namespace relievo
