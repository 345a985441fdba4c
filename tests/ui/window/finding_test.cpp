// SPDX-License-Identifier: BSD-3-Clause
// Ctrl+K and F1: what somebody looks for, by the words of other programs.
#include <array>
#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTableWidget>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/keys_sheet.h"
#include "ui/window/command_words.h"

namespace relievo {
namespace {

class FindingTest : public GuiTest {
 protected:
  QDialog& search() {
    if (auto* open = child<QDialog>("command_search")) return *open;
    EXPECT_TRUE(window().runCommand("search_commands"));
    return *child<QDialog>("command_search");
  }
  /// What Enter would run.
  QString firstFor(const QString& words) {
    search().findChild<QLineEdit*>("command_words")->setText(words);
    const auto* list = search().findChild<QListWidget*>("command_list");
    return list->count() == 0 ? QString()
                              : list->item(0)->text().section(u'\u2013', 0, 0).trimmed();
  }
  QStringList allFor(const QString& words) {
    firstFor(words);
    const auto* list = search().findChild<QListWidget*>("command_list");
    QStringList all;
    for (int row = 0; row < list->count(); ++row) {
      all << list->item(row)->text().section(u'\u2013', 0, 0).trimmed();
    }
    return all;
  }
};

TEST_F(FindingTest, WordsOfOtherProgramsFindTheCommand) {
  const std::array<std::pair<const char*, const char*>, 11> asked{{{"export", "Export"},
                                                                   {"crop", "Prepare"},
                                                                   {"clean", "Prepare"},
                                                                   {"align", "Prepare"},
                                                                   {"zoom in", "Finer"},
                                                                   {"rotate", "Turn left"},
                                                                   {"screenshot", "Image"},
                                                                   {"handbook", "Manual"},
                                                                   {"STL", "Export"},
                                                                   {"detail", "Finer"},
                                                                   {"place name", "Add bookmark"}}};
  for (const auto& [words, wanted] : asked) {
    EXPECT_TRUE(allFor(words).contains(wanted))
        << words << " finds " << allFor(words).join(", ").toStdString();
  }
  EXPECT_EQ(firstFor("export"), "Export") << "its own name comes first";
}

TEST_F(FindingTest, NoCommandIsExplainedByItsOwnName) {
  firstFor(QString());
  const auto* list = search().findChild<QListWidget*>("command_list");
  ASSERT_GT(list->count(), 100);
  for (int row = 0; row < list->count(); ++row) {
    const QString name = list->item(row)->text().section(u'\u2013', 0, 0).trimmed();
    EXPECT_NE(list->item(row)->text().section(u'\u2013', 1).section("  (", 0, 0).trimmed(), name)
        << name.toStdString();
  }
  firstFor("undo");
  EXPECT_EQ(list->item(0)->text().toStdString(), "Undo  (Ctrl+Z)");
}

TEST_F(FindingTest, OtherWordsAreOfCommandsThatExist) {
  for (const QString& name : commandsWithOtherWords()) {
    EXPECT_NE(window().findChild<QAction*>(name, Qt::FindDirectChildrenOnly), nullptr)
        << name.toStdString() << " is no command";
    EXPECT_FALSE(otherWords(name).trimmed().isEmpty()) << name.toStdString();
  }
  EXPECT_EQ(commandsWithOtherWords().removeDuplicates(), 0);
  EXPECT_TRUE(otherWords("no_such_command").isEmpty());
}

TEST_F(FindingTest, WhereNothingIsFoundASentenceSaysSo) {
  EXPECT_TRUE(firstFor("xyzzy").isEmpty());
  auto* nothing = search().findChild<QLabel*>("command_nothing");
  EXPECT_TRUE(nothing->isVisible());
  EXPECT_TRUE(nothing->text().contains("F1"));
  EXPECT_FALSE(firstFor("manual").isEmpty());
  EXPECT_FALSE(nothing->isVisible());
}

TEST_F(FindingTest, TheKeysStandUnderTheirMenusAndAreSearched) {
  ASSERT_TRUE(window().runCommand("keys"));
  auto* sheet = window().findChild<KeysSheet*>();
  ASSERT_NE(sheet, nullptr);
  const auto* table = sheet->findChild<QTableWidget*>("keys_table");
  QStringList groups;
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->item(row, 1) == nullptr) groups << table->item(row, 0)->text();
  }
  EXPECT_EQ(groups.mid(0, 4), QStringList({"File", "Edit", "View", "Surface"}))
      << "as in the menu bar: " << groups.join(", ").toStdString();
  EXPECT_EQ(groups.removeDuplicates(), 0);
  sheet->findChild<QLineEdit*>("keys_words")->setText("undo");
  QStringList shown;
  for (int row = 0; row < table->rowCount(); ++row) {
    if (!table->isRowHidden(row)) shown << table->item(row, 0)->text();
  }
  EXPECT_EQ(shown, QStringList({"Edit", "Ctrl+Z"}));
  sheet->findChild<QLineEdit*>("keys_words")->setText("xyzzy");
  EXPECT_TRUE(sheet->findChild<QLabel*>("keys_nothing")->isVisible());
}

/// What the sheet says that keys do.
QString rowOf(const KeysSheet& sheet, const QString& keys) {
  const auto* table = sheet.findChild<QTableWidget*>("keys_table");
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->item(row, 1) != nullptr && table->item(row, 0)->text() == keys) {
      return table->item(row, 1)->text();
    }
  }
  return QStringLiteral("no row ") + keys;
}

TEST_F(FindingTest, SheetAndExplanationsNameTheButtonsAsPreferencesSay) {
  ASSERT_TRUE(window().runCommand("keys"));
  auto* sheet = window().findChild<KeysSheet*>();
  EXPECT_EQ(rowOf(*sheet, "Detail view: left button"),
            "Look: turn the view. Touch: press the hand in");
  EXPECT_EQ(rowOf(*sheet, "Detail view: right button"),
            "Look: move the window. Touch: move the window");
  EXPECT_TRUE(window().detailView().whatsThis().contains("Look: left turns, right moves"))
      << window().detailView().whatsThis().toStdString();
  delete sheet;
  window().settings().setChoice("look_left", "zoom");
  window().settings().setChoice("look_right", "none");
  window().settings().setChoice("touch_middle", "move");
  window().settings().setChoice("wheel_forward", false);
  restart();
  ASSERT_TRUE(window().runCommand("keys"));
  sheet = window().findChild<KeysSheet*>();
  EXPECT_EQ(rowOf(*sheet, "Detail view: left button"), "Look: zoom. Touch: press the hand in");
  EXPECT_EQ(rowOf(*sheet, "Detail view: middle button"),
            "Look: turn the view. Touch: move the window");
  EXPECT_EQ(rowOf(*sheet, "Detail view: right button"), "Look: nothing. Touch: move the window");
  EXPECT_EQ(rowOf(*sheet, "Detail view: wheel"), "Zoom about the pointer; towards you is closer");
  const QString told = window().detailView().whatsThis();
  EXPECT_TRUE(told.contains("Look: left zooms, middle turns")) << told.toStdString();
  EXPECT_TRUE(told.contains("middle moves")) << told.toStdString();
  EXPECT_FALSE(told.contains("Right drag")) << told.toStdString();
  EXPECT_EQ(action("pointer_look")->whatsThis(), "Look: left zooms, middle turns, wheel zooms");
}

}  // namespace
}  // namespace relievo
