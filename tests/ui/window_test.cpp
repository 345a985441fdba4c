// SPDX-License-Identifier: BSD-3-Clause
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QSplitter>
#include <QToolButton>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/keys_sheet.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/status_fields.h"
#include "ui/plots/time_plot.h"
#include "ui/style/palette.h"

namespace relievo {
namespace {

class WindowTest : public GuiTest {
 protected:
  /// Every entry of every menu, separators aside.
  QList<QAction*> entries() {
    QList<QAction*> all;
    for (QMenu* menu : window().findChildren<QMenu*>()) {
      for (QAction* a : menu->actions()) {
        if (!a->isSeparator() && !a->objectName().startsWith("_q_")) all << a;
      }
    }
    EXPECT_GE(all.size(), kLeastEntries) << "judged by every test that asks for them";
    return all;
  }
  // Less is a window whose menus were not found.
  static constexpr int kLeastMenus = 6, kLeastEntries = 60;
};

TEST_F(WindowTest, EveryMenuAndEntryHasAMnemonic) {
  EXPECT_GE(window().menuBar()->actions().size(), kLeastMenus);
  for (const QAction* a : window().menuBar()->actions()) {
    EXPECT_TRUE(a->text().contains('&')) << a->text().toStdString();
  }
  for (const QAction* a : entries()) {
    EXPECT_TRUE(a->text().contains('&')) << a->text().toStdString();
  }
}

TEST_F(WindowTest, MnemonicsDoNotRepeatWithinAMenu) {
  int letters = 0;
  for (const QMenu* menu : window().findChildren<QMenu*>()) {
    QString seen;
    for (const QAction* a : menu->actions()) {
      const int at = a->text().indexOf('&');
      if (a->isSeparator() || at < 0) continue;
      const QChar letter = a->text()[at + 1].toLower();
      EXPECT_FALSE(seen.contains(letter)) << menu->title().toStdString() << ": "
                                          << seen.toStdString() << ", " << a->text().toStdString();
      seen += letter;
      ++letters;
    }
  }
  EXPECT_GE(letters, kLeastEntries);
}

TEST_F(WindowTest, EveryEntryHasATooltipThatNamesItsKey) {
  for (const QAction* a : entries()) {
    EXPECT_FALSE(a->toolTip().isEmpty()) << a->text().toStdString();
    if (a->shortcuts().isEmpty()) continue;
    EXPECT_TRUE(a->toolTip().contains(a->shortcuts().front().toString(QKeySequence::NativeText)))
        << a->toolTip().toStdString();
  }
}

TEST_F(WindowTest, NoShortcutIsABareLetterOrTakenTwice) {
  QStringList taken;
  for (const QAction* a : window().findChildren<QAction*>()) {
    for (const QKeySequence& key : a->shortcuts()) {
      const int code = key[0];
      const int plain = code & ~static_cast<int>(Qt::KeyboardModifierMask);
      const bool letter = plain >= Qt::Key_Space && plain <= Qt::Key_ydiaeresis;
      const int modifiers = code & static_cast<int>(Qt::ControlModifier | Qt::AltModifier);
      EXPECT_TRUE(!letter || modifiers != 0) << key.toString().toStdString();
      EXPECT_FALSE(taken.contains(key.toString())) << key.toString().toStdString();
      taken << key.toString();
    }
  }
  EXPECT_GE(taken.size(), 25);
}

TEST_F(WindowTest, MenusWithoutAnEntryAreNotShown) {
  ASSERT_GE(window().menuBar()->actions().size(), kLeastMenus);
  for (const QAction* a : window().menuBar()->actions()) {
    EXPECT_EQ(a->isVisible(), !a->menu()->actions().isEmpty()) << a->text().toStdString();
  }
}

TEST_F(WindowTest, AnEntryOfATouchModuleAppearsInItsMenuAndKeepsItsKey) {
  auto* forces = new QAction("&Forces on");
  forces->setObjectName("forces");
  forces->setShortcut(QKeySequence("F5"));
  forces->setCheckable(true);
  window().addToMenu("Touch", forces);
  openRelief();
  const auto menus = window().menuBar()->actions();
  const auto touch = std::find_if(menus.begin(), menus.end(),
                                  [](const QAction* a) { return a->text() == "&Touch"; });
  ASSERT_NE(touch, menus.end());
  EXPECT_TRUE((*touch)->isVisible());
  QTest::keyClick(&window().detailView(), Qt::Key_F5);
  EXPECT_TRUE(forces->isChecked());
  EXPECT_TRUE(window().runCommand("forces"));
  EXPECT_FALSE(forces->isChecked());
}

TEST_F(WindowTest, EscapeStopsForcesBeforeAnythingElse) {
  auto* off = new QAction("Forces &off now");
  off->setObjectName("forcesOff");
  bool stopped = false;
  QObject::connect(off, &QAction::triggered, off, [&] { stopped = true; });
  window().addToMenu("Touch", off);
  openRelief();
  TouchReadout readout;
  readout.forces_on = true;
  window().controllers().touch.show(readout);
  QTest::keyClick(&window().referenceView(), Qt::Key_Escape);
  EXPECT_TRUE(stopped);
}

TEST_F(WindowTest, CommandsRunByNameUnlessTheyAreOffOrUnknown) {
  openRelief();
  EXPECT_TRUE(window().runCommand("finer"));
  EXPECT_EQ(document().detail(), 2);
  EXPECT_TRUE(window().runCommand("whole"));
  EXPECT_FALSE(window().runCommand("coarser"));
  EXPECT_FALSE(window().runCommand("no_such_command"));
}

TEST_F(WindowTest, WithoutATouchModuleTheWindowSaysSoAndShowsNoPlots) {
  window().controllers().touch.showMissing("the haptics plugin was not found.");
  openRelief();
  EXPECT_FALSE(child<QWidget>("time_plot")->isVisible());
  EXPECT_FALSE(action("show_plots")->isVisible());
  window().controllers().touch.showMissing("the haptics plugin was not found.");
  EXPECT_EQ(child<QLabel>("status_message")->text(),
            "Touch is not available: the haptics plugin was not found. Viewing works.");
}

TEST_F(WindowTest, ALoopThatRunsAsItShouldIsNotInTheStatusBar) {
  openRelief();
  TouchReadout readout;
  readout.rate_hz = 1000;
  readout.late_ticks = 3;
  window().controllers().touch.show(readout);
  EXPECT_FALSE(child<QLabel>("status_force_rate")->isVisible());
  readout.rate_hz = 640;
  window().controllers().touch.show(readout);
  EXPECT_EQ(child<QLabel>("status_force_rate")->text(), "640/s, late 3");
  readout.rate_hz = 1000;
  readout.late_ticks = 200;
  window().controllers().touch.show(readout);
  EXPECT_EQ(child<QLabel>("status_force_rate")->text(), "1000/s, late 200") << "ticks came late";
  window().controllers().touch.show(readout);
  EXPECT_FALSE(child<QLabel>("status_force_rate")->isVisible()) << "and no more since";
}

TEST_F(WindowTest, RateAndRecordingAreShownOnceTouchReports) {
  openRelief();
  TouchReadout readout;
  readout.rate_hz = 810;
  readout.late_ticks = 3;
  readout.recording = true;
  readout.recorded_samples = 42;
  readout.realtime_note = "not permitted";
  window().controllers().touch.show(readout);
  EXPECT_EQ(child<QLabel>("status_force_rate")->text(), "810/s, late 3");
  EXPECT_TRUE(child<QLabel>("status_force_rate")->toolTip().contains("not permitted"));
  EXPECT_TRUE(child<QLabel>("status_recording")->text().contains("42"));
  EXPECT_TRUE(child<QWidget>("time_plot")->isVisible());
}

TEST_F(WindowTest, EveryControlAndBothViewsHaveAnAccessibleName) {
  openRelief();
  window().controllers().touch.show({});
  const auto interesting = [](const QWidget* w) {
    return qobject_cast<const QAbstractButton*>(w) != nullptr ||
           qobject_cast<const QComboBox*>(w) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(w) != nullptr ||
           qobject_cast<const QSlider*>(w) != nullptr ||
           qobject_cast<const SurfaceView*>(w) != nullptr || (w->focusPolicy() & Qt::TabFocus) != 0;
  };
  int named = 0;
  for (const QWidget* w : window().findChildren<QWidget*>()) {
    if (!interesting(w) || w->objectName().startsWith("qt_")) continue;
    // Parts that Qt makes inside a spin box or a combo box speak for their owner.
    const QWidget* owner = w->parentWidget();
    if (qobject_cast<const QAbstractSpinBox*>(owner) != nullptr) continue;
    if (w->window() != &window()) continue;
    EXPECT_FALSE(w->accessibleName().isEmpty())
        << w->metaObject()->className() << " " << w->objectName().toStdString();
    ++named;
  }
  EXPECT_GE(named, 30);
}

TEST_F(WindowTest, AViewsAccessibleValueSaysWhereOneIs) {
  openRelief();
  QAccessibleInterface* view = QAccessible::queryAccessibleInterface(&window().referenceView());
  ASSERT_NE(view, nullptr);
  EXPECT_EQ(view->text(QAccessible::Name), "Overview");
  EXPECT_TRUE(view->text(QAccessible::Value).contains("Resolution 1 of 3"));
}

TEST_F(WindowTest, PicturesAreWrittenAtTheChosenSize) {
  openRelief();
  const QSize size(321, 213);
  for (const ImageSource source :
       {ImageSource::reference, ImageSource::detail, ImageSource::window}) {
    const QString file = path("picture.png");
    QFile::remove(file);
    window().saveImage(source, size, file);
    ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
    const QImage image(file);
    EXPECT_EQ(image.size(), size);
    EXPECT_NE(image.pixel(160, 106), image.pixel(2, 2)) << "a picture, not one colour";
  }
}

TEST_F(WindowTest, PicturesThatAreAskedForTogetherAreAllWrittenBeforeTheWindowCloses) {
  openRelief();
  for (const char* name : {"1.png", "2.png", "3.png"}) {
    window().saveImage(ImageSource::detail, {64, 48}, path(name));
  }
  window().close();
  ASSERT_TRUE(waitFor([&] { return !window().isVisible(); }));
  for (const char* name : {"1.png", "2.png", "3.png"}) {
    EXPECT_EQ(QImage(path(name)).size(), QSize(64, 48)) << name;
  }
}

TEST_F(WindowTest, APictureThatCannotBeWrittenIsAnError) {
  openRelief();
  window().saveImage(ImageSource::detail, {64, 64}, path("no/such/folder/p.png"));
  ASSERT_TRUE(waitFor([&] { return !window().message().isEmpty(); }));
  EXPECT_TRUE(window().message().contains("Cannot write the picture"))
      << window().message().toStdString();
}

TEST_F(WindowTest, TheImageDialogAsksForPictureSizeAndPlaceAndSavesIt) {
  openRelief();
  QTest::keyClick(&window().detailView(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = child<QDialog>("image_dialog");
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(dialog->isVisible());
  dialog->findChild<QSpinBox*>("image_width")->setValue(200);
  dialog->findChild<QSpinBox*>("image_height")->setValue(120);
  dialog->findChild<QLineEdit*>("image_file")->setText(path("new folder/dome"));
  auto* buttons = dialog->findChild<QDialogButtonBox*>();
  QTest::mouseClick(buttons->button(QDialogButtonBox::Save), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
  EXPECT_EQ(QImage(path("new folder/dome.png")).size(), QSize(200, 120));
  EXPECT_TRUE(child<QLabel>("status_message")->text().contains("dome.png"));
}

TEST_F(WindowTest, ThePictureOfADetailIsSavedWithTheTwoOfTheEyes) {
  openRelief();
  window().runCommand("image");
  auto* dialog = child<QDialog>("image_dialog");
  ASSERT_NE(dialog, nullptr);
  auto* eyes = dialog->findChild<QCheckBox*>("image_both_eyes");
  auto* source = dialog->findChild<QComboBox*>("image_source");
  eyes->setChecked(true);
  source->setCurrentIndex(1);
  EXPECT_FALSE(eyes->isEnabled()) << "of the detail only";
  source->setCurrentIndex(0);
  ASSERT_TRUE(eyes->isEnabled());
  dialog->findChild<QLineEdit*>("image_file")->setText(path("pair.png"));
  QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save),
                    Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
  const QImage both(path("pair.png")), left(path("pair.left.png")), right(path("pair.right.png"));
  ASSERT_FALSE(both.isNull() || left.isNull() || right.isNull());
  EXPECT_EQ(left.size(), both.size());
  EXPECT_NE(left, right);
  EXPECT_NE(left, both);
}

/// Counts the layouts that are asked for anywhere in the program.
class LayoutCount : public QObject {
 public:
  LayoutCount() { QApplication::instance()->installEventFilter(this); }
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) ++count;
    return false;
  }
  int count = 0;
};

TEST_F(WindowTest, EveryCommandOfTheTableDoesSomething) {
  for (const CommandRow& row : CommandTable::rows()) {
    EXPECT_TRUE(window().commands().isDone(row.command)) << row.name;
  }
}

TEST_F(WindowTest, AWindowAtRestLaysNothingOutAndWorkMovesNoView) {
  openRelief();
  // Sooner or later it comes to rest: then time goes by without a layout.
  EXPECT_TRUE(waitFor([] {
    const LayoutCount layouts;
    QTest::qWait(300);
    return layouts.count <= 3;
  }));
  const QSize view = window().detailView().size();
  StatusFields& status = *window().findChild<StatusFields*>();
  status.beginWork();
  status.showWork("Reading a large file with a long name", 0.5);
  ASSERT_TRUE(waitFor([&] { return status.cancelButton()->isVisible(); }));
  QApplication::processEvents();
  EXPECT_EQ(window().detailView().size(), view);
  status.endWork();
  QApplication::processEvents();
  EXPECT_EQ(window().detailView().size(), view);
}

/// A list of texts that is one too short leaves a command without any.
TEST_F(WindowTest, EveryCommandHasATextAndATip) {
  for (const QAction* action :
       window().findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (action->objectName().isEmpty()) continue;
    EXPECT_FALSE(action->text().isEmpty()) << action->objectName().toStdString();
    EXPECT_FALSE(action->toolTip().isEmpty()) << action->objectName().toStdString();
  }
}

TEST_F(WindowTest, ThePlotKeepsTheLastTenSeconds) {
  TimePlot plot;
  std::vector<ForcePoint> points(15001);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].t_s = 0.001 * static_cast<double>(i);
  plot.add(points);
  EXPECT_NEAR(static_cast<double>(plot.points()), 10001, 2);
  plot.add(std::span(points).first(10));
  EXPECT_EQ(plot.points(), 10U) << "a loop that starts again begins a new plot";
}

TEST_F(WindowTest, AHandThatRestsDrawsNoPlot) {
  TimePlot plot;
  plot.resize(600, 140);
  plot.show();
  double t = 0;
  const auto rest = [&](double seconds, double height_mm) {
    std::vector<ForcePoint> points;
    for (const double end = t + seconds; t < end; t += 0.004) {
      points.push_back({t, height_mm, height_mm, 0});
    }
    plot.add(points);
  };
  const auto drawn = [&] { return waitFor([&] { return !plot.isStale(); }); };
  rest(5, 3);
  EXPECT_TRUE(plot.isStale());
  ASSERT_TRUE(drawn());
  rest(1, 3);
  EXPECT_TRUE(plot.isStale()) << "the curve still grows";
  rest(5, 3);
  ASSERT_TRUE(drawn());
  rest(1, 3);
  EXPECT_FALSE(plot.isStale()) << "a level line stays as it is";
  rest(1, 3.001);
  EXPECT_TRUE(plot.isStale()) << "a step of a fiftieth of the least range is seen";
  ASSERT_TRUE(drawn());
  rest(1, 3.001);
  EXPECT_TRUE(plot.isStale()) << "the step wanders";
}

TEST_F(WindowTest, EveryStopOfF6ShowsThatItHasTheFocus) {
  openRelief();
  window().controllers().touch.show({});  // With the plots.
  window().showMessage("A message.");
  QTest::keyClick(&window().detailView(), Qt::Key_F6);
  const QWidget* const first = QApplication::focusWidget();
  int stops = 0;
  do {
    QWidget* stop = QApplication::focusWidget();
    ASSERT_NE(stop, nullptr);
    const QImage focused = stop->grab().toImage().convertToFormat(QImage::Format_RGB32);
    stop->clearFocus();
    QApplication::processEvents();
    const QImage plain = stop->grab().toImage().convertToFormat(QImage::Format_RGB32);
    int changed = 0;
    for (int y = 0; y < plain.height(); ++y) {
      for (int x = 0; x < plain.width(); ++x) {
        if (std::abs(qGray(plain.pixel(x, y)) - qGray(focused.pixel(x, y))) > 20) ++changed;
      }
    }
    EXPECT_GE(changed, stop->width())
        << stop->objectName().toStdString() << ", " << stop->metaObject()->className();
    stop->setFocus();
    QTest::keyClick(stop, Qt::Key_F6);
  } while (++stops < 12 && QApplication::focusWidget() != first);
  EXPECT_EQ(stops, 7);
}

TEST_F(WindowTest, NoLetterIsMarkedByAnAmpersandThatIsShown) {
  openRelief();
  for (const char* dialog : {"image", "export", "figure", "package", "depth_map"}) {
    ASSERT_TRUE(window().runCommand(dialog)) << dialog;
    for (QDialog* shown : window().findChildren<QDialog*>()) {
      for (const QLabel* label : shown->findChildren<QLabel*>()) {
        const bool marked = QString(label->text()).remove(QLatin1String("&&")).contains('&');
        EXPECT_TRUE(!marked || label->buddy() != nullptr)
            << dialog << ": " << label->text().toStdString();
      }
      shown->close();
    }
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_F(WindowTest, TheIntroductionIsShownWhole) {
  openRelief();
  ASSERT_TRUE(window().runCommand("introduction"));
  EXPECT_TRUE(window().message().contains("F5 switches forces on"))
      << window().message().toStdString();
}

TEST_F(WindowTest, AStepThatIsUndoneIsNotSaidAnyLonger) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  ASSERT_TRUE(window().runCommand("move_right"));
  const auto* said = child<QLabel>("status_message");
  ASSERT_TRUE(said->text().startsWith("Right. Window at")) << said->text().toStdString();
  ASSERT_TRUE(window().runCommand("undo"));
  EXPECT_EQ(said->text(), "Undone: Move window");
  ASSERT_TRUE(window().runCommand("redo"));
  EXPECT_EQ(said->text(), "Done again: Move window");
}

TEST_F(WindowTest, LargeTextOfAMessageLeavesRoomForTheViews) {
  window().resize(1440, 900);
  openRelief();
  TouchReadout touch;
  touch.rate_hz = 1000;
  window().controllers().touch.show(touch);
  const auto* plots = child<QWidget>("time_plot");
  EXPECT_TRUE(plots->isVisible());
  window().settings().setChoice("text_percent", 300);
  applyTextSize(300);
  child<MessageStrip>("message_strip")
      ->show(QStringLiteral("Die Punkte haben keine Einheit. 39 \u00d7 39 \u00d7 3 \u2013 in "
                            "Millimetern 39,00 \u00d7 39,00 \u00d7 3,00 mm; in Zentimetern 390,0 "
                            "\u00d7 390,0 \u00d7 30,0 mm; in Metern 39,00 \u00d7 39,00 \u00d7 "
                            "3,00 m. Als Millimeter gezeigt, bis Sie es sagen. (E103)"),
             {{"Millimeter", {}}, {"Zentimeter", {}}, {"Meter", {}}});
  QApplication::processEvents();
  EXPECT_FALSE(plots->isVisible()) << "they yield first";
  EXPECT_GE(window().detailView().height(), 200);
  child<MessageStrip>("message_strip")->close();
  applyTextSize(kLeastTextPercent);
  EXPECT_TRUE(waitFor([plots] { return plots->isVisible(); })) << "as they were chosen";
  EXPECT_TRUE(action("show_plots")->isChecked());
}

TEST_F(WindowTest, ControlAndLGoesToTheOtherView) {
  openRelief();
  window().detailView().setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_L, Qt::ControlModifier);
  EXPECT_EQ(QApplication::focusWidget(), &window().referenceView());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_L, Qt::ControlModifier);
  EXPECT_EQ(QApplication::focusWidget(), &window().detailView());
}

TEST_F(WindowTest, RecentFilesOfOneNameAreToldApartAndNoneIsAnEmptyPicture) {
  QDir().mkpath(path("elsewhere"));
  window().settings().addRecentFile(path("dome.relievo.json"));
  window().settings().addRecentFile(path("elsewhere/dome.relievo.json"));
  restart();
  const auto* recent = child<QListWidget>("start_recent");
  ASSERT_EQ(recent->count(), 2);
  EXPECT_NE(recent->item(0)->text(), recent->item(1)->text());
  EXPECT_TRUE(recent->item(0)->text().endsWith("elsewhere")) << "its folder";
  const QImage picture = recent->item(0)->icon().pixmap(80, 60).toImage();
  int drawn = 0;
  for (int x = 0; x < picture.width(); ++x) {
    if (qAlpha(picture.pixel(x, picture.height() / 2)) > 0) ++drawn;
  }
  EXPECT_GT(drawn, 0);
}

TEST_F(WindowTest, TheLayoutIsRememberedAcrossARestart) {
  openRelief();
  window().resize(900, 600);
  action("show_panels")->setChecked(false);
  QApplication::processEvents();
  restart();
  EXPECT_EQ(window().size(), QSize(900, 600));
  EXPECT_FALSE(action("show_panels")->isChecked());
  openRelief();
  EXPECT_FALSE(child<QWidget>("side_panels")->isVisible());
}

TEST_F(WindowTest, TheThemeIsRememberedAndReachesTheViews) {
  action("theme_contrast")->trigger();
  const QColor black = window().detailView().sceneState().background;
  restart();
  EXPECT_TRUE(action("theme_contrast")->isChecked());
  EXPECT_EQ(window().detailView().sceneState().background, black);
  action("theme_light")->trigger();
  EXPECT_NE(window().detailView().sceneState().background, black);
}

TEST_F(WindowTest, TheKeySheetListsEveryShortcut) {
  QTest::keyClick(&window(), Qt::Key_F1);
  auto* sheet = window().findChild<KeysSheet*>();
  ASSERT_NE(sheet, nullptr);
  EXPECT_TRUE(sheet->isVisible());
  sheet->close();
}

TEST_F(WindowTest, TheRecordingHeaderNamesInputUnitViewAndRegion) {
  openRelief();
  const QString header = recordingHeader(window().document(), path("log.csv"));
  for (const QString& line : header.split('\n')) EXPECT_TRUE(line.startsWith("# "));
  for (const char* key : {"input: relief.ply", "input_sha256", "unit: mm (given)", "view: top",
                          "region_mm", "level: 2"}) {
    EXPECT_TRUE(header.contains(key)) << key;
  }
}

TEST_F(WindowTest, F11ShowsTheDetailAloneWithItsPlaceAndEscapeComesBack) {
  openRelief();
  QTest::keyClick(&window().detailView(), Qt::Key_F11);
  EXPECT_FALSE(window().referenceView().isVisible());
  EXPECT_FALSE(child<QWidget>("side_panels")->isVisible());
  EXPECT_TRUE(child<QWidget>("overview_inset")->isVisible());
  EXPECT_TRUE(child<QLabel>("status_message")->isVisible());
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_TRUE(window().referenceView().isVisible());
  EXPECT_FALSE(child<QWidget>("overview_inset")->isVisible());
}

TEST_F(WindowTest, F6WalksThroughThePartsAndBack) {
  openRelief();
  window().referenceView().setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
  EXPECT_EQ(QApplication::focusWidget(), &window().detailView());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
  EXPECT_EQ(QApplication::focusWidget(), &window().referenceView());
}

}  // namespace
}  // namespace relievo
