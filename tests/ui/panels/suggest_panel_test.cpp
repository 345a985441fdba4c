// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/suggest_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/views/overlays/suggestion_frames.h"

namespace relievo {
namespace {

class SuggestPanelTest : public GuiTest {
 protected:
  SuggestPanelTest() { openRelief(); }
  SuggestPanel& panel() { return *window().findChild<SuggestPanel*>(); }
  QListWidget& list() { return *child<QListWidget>("suggest_list"); }
  const std::vector<SuggestedFrame>& frames() {
    return window().referenceView().findChild<SuggestionFrames*>()->frames();
  }
  void find() {
    ASSERT_TRUE(window().runCommand("suggest_windows"));
    ASSERT_TRUE(waitFor([this] { return !panel().busy() && list().count() > 0; }));
  }
};

TEST_F(SuggestPanelTest, ListsWhatTheCommandLineRanksAndSaysHow) {
  find();
  const Surface& surface = *document().surface();
  const auto ranked = feelableWindows(surface.map, surface.pyramid, {});
  ASSERT_EQ(list().count(), static_cast<int>(ranked.size()));
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    EXPECT_EQ(panel().windows()[i].region, ranked[i].region) << i;
  }
  EXPECT_TRUE(list().item(0)->text().startsWith("1. Resolution "));
  EXPECT_TRUE(child<QLabel>("suggest_method")->text().contains("Louw"));
  EXPECT_TRUE(child<QLabel>("suggest_method")->text().contains("estimate"));
}

TEST_F(SuggestPanelTest, ChoosingOneShowsItAtItsDetailAndCanBeUndone) {
  find();
  const Region before = document().project().region;
  const int last = list().count() - 1;
  list().setCurrentRow(last);
  QTest::keyClick(&list(), Qt::Key_Return);
  const Region wanted = panel().windows()[static_cast<std::size_t>(last)].region;
  EXPECT_EQ(document().project().region, wanted);
  ASSERT_FALSE(wanted == before) << "the last of the list is elsewhere";
  EXPECT_TRUE(document().history().undoText().startsWith("Suggested window"));
  action("undo")->trigger();
  EXPECT_EQ(document().project().region, before);
}

TEST_F(SuggestPanelTest, TheOverviewFramesThemUntilNobodyWantsIt) {
  EXPECT_TRUE(frames().empty());
  find();
  ASSERT_EQ(frames().size(), panel().windows().size());
  list().setCurrentRow(0);
  EXPECT_TRUE(frames()[0].is_current);
  child<QCheckBox>("suggest_overlay")->setChecked(false);
  EXPECT_TRUE(frames().empty());
}

TEST_F(SuggestPanelTest, AnotherSurfaceHasNoneOfThem) {
  find();
  document().choices().setView({"bottom", {}});
  ASSERT_TRUE(waitFor([this] { return !document().loader().busy(); }));
  EXPECT_TRUE(panel().windows().empty());
  EXPECT_TRUE(frames().empty());
  EXPECT_FALSE(list().isVisible());
}

TEST_F(SuggestPanelTest, EscapeEndsTheSearch) {
  ASSERT_TRUE(window().runCommand("suggest_windows"));
  ASSERT_TRUE(panel().busy());
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_FALSE(panel().busy());
  EXPECT_EQ(child<QLabel>("status_message")->text(), "Cancelled. Nothing was suggested.");
  EXPECT_TRUE(panel().windows().empty());
}

}  // namespace
}  // namespace relievo
