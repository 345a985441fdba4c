// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/side_panels.h"

#include <QAction>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class SidePanelsTest : public GuiTest {
 protected:
  SidePanels& panels() { return *child<SidePanels>("side_panels"); }
  QToolButton& header(const QString& title) {
    for (auto* button : panels().findChildren<QToolButton*>()) {
      if (button->text() == title && button->accessibleName().endsWith("panel")) return *button;
    }
    ADD_FAILURE() << "no section " << title.toStdString();
    return *panels().findChild<QToolButton*>();
  }
  bool isOpen(const char* panel) { return !child<QWidget>(panel)->isHidden(); }
};

TEST_F(SidePanelsTest, WhatEverybodyNeedsIsFirstAndOpen) {
  EXPECT_EQ(panels().titles(), QStringList({"Scan", "View", "Window", "Light", "Measure", "Stereo",
                                            "Bookmarks", "Suggestions"}));
  for (const char* panel :
       {"surface_panel", "view_panel", "region_panel", "light_panel", "measure_panel"}) {
    EXPECT_TRUE(isOpen(panel)) << panel;
  }
  for (const char* panel : {"stereo_panel", "places_panel", "suggest_panel"}) {
    EXPECT_FALSE(isOpen(panel)) << panel;
  }
}

TEST_F(SidePanelsTest, WhatSomebodyOpensOrFoldsStaysSoAtTheNextStart) {
  openRelief();
  QTest::mouseClick(&header("Stereo"), Qt::LeftButton);
  header("Light").setFocus();
  QTest::keyClick(&header("Light"), Qt::Key_Space);
  EXPECT_TRUE(isOpen("stereo_panel"));
  EXPECT_EQ(header("Stereo").accessibleDescription(), "open");
  EXPECT_FALSE(isOpen("light_panel"));
  EXPECT_EQ(header("Light").accessibleDescription(), "folded");
  restart();
  EXPECT_TRUE(isOpen("stereo_panel"));
  EXPECT_FALSE(isOpen("light_panel"));
  EXPECT_TRUE(isOpen("view_panel"));
  EXPECT_FALSE(isOpen("places_panel"));
}

TEST_F(SidePanelsTest, ACommandOpensItsPanelForThisTimeOnly) {
  openRelief();
  window().runCommand("suggest_windows");
  EXPECT_TRUE(isOpen("suggest_panel"));
  restart();
  EXPECT_FALSE(isOpen("suggest_panel"));
}

TEST_F(SidePanelsTest, PanelsOfModulesComeAfterMeasureInTheirOrder) {
  for (const char* title : {"First", "Second"}) window().addPanel(title, new QLabel(title));
  auto* folded = new QLabel("folded");
  folded->setObjectName("third_panel");
  folded->setProperty(SidePanels::kFoldedAtFirst, true);
  window().addPanel("Third", folded);
  EXPECT_EQ(panels().titles().mid(4, 4), QStringList({"Measure", "First", "Second", "Third"}));
  EXPECT_FALSE(isOpen("third_panel"));
  window().removePanel(folded);
  window().addPanel("Fourth", new QLabel("4"));
  EXPECT_EQ(panels().titles().mid(4, 5),
            QStringList({"Measure", "First", "Second", "Fourth", "Stereo"}));
}

TEST_F(SidePanelsTest, TheyFitAWindowOf900Pixels) {
  window().resize(1440, 900);
  openRelief();
  QApplication::processEvents();
  EXPECT_EQ(panels().verticalScrollBar()->maximum(), 0)
      << panels().widget()->sizeHint().height() << " of " << panels().viewport()->height();
  EXPECT_EQ(panels().horizontalScrollBar()->maximum(), 0);
}

TEST_F(SidePanelsTest, NoLabelTouchesItsFieldInALowWindow) {
  constexpr int kLeastGap = 6;  // Pixels; less reads as one word with the number.
  window().resize(1440, 852);
  openRelief();
  QApplication::processEvents();
  int looked_at = 0;
  for (const QLabel* label : child<QWidget>("region_panel")->findChildren<QLabel*>()) {
    const QWidget* field = label->buddy();
    if (field == nullptr) continue;
    ++looked_at;
    const int text = label->fontMetrics().horizontalAdvance(label->text().remove('&'));
    EXPECT_GE(label->width(), text) << label->text().toStdString();
    EXPECT_GE(field->x() - (label->x() + text), kLeastGap) << label->text().toStdString();
    EXPECT_LE(field->geometry().right(), field->parentWidget()->width()) << "it is whole";
  }
  EXPECT_GE(looked_at, 5);
  EXPECT_EQ(panels().horizontalScrollBar()->maximum(), 0) << "nothing is beyond the edge";
}

}  // namespace
}  // namespace relievo
