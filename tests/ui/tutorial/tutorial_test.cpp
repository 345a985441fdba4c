// SPDX-License-Identifier: BSD-3-Clause
// docs/user/tutorial.md, done literally: each key, menu and control that a sentence names is used
// by its name, and what the sentence promises is seen.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QProgressBar>
#include <QtTest/QTest>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "tests/ui/gui_fixture.h"
#include "tests/ui/tutorial/tutorial_page.h"
#include "ui/dialogs/keys_sheet.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/frame/side_panels.h"
#include "ui/frame/start_page.h"
#include "ui/panels/measure_panel.h"
#include "ui/plots/profile_strip.h"
#include "ui/style/mnemonic.h"
#include "ui/views/overlays/light_ball.h"

namespace relievo {
namespace {

/// As the window names it: "Test glasses...", "Auto&matic depth" is "Automatic depth".
QString plainName(const QString& text) {
  return withoutMnemonic(text).replace(u'\u2026', QStringLiteral("..."));
}

/// What the program does at its start.
class LoadedPlugins {
 public:
  explicit LoadedPlugins(MainWindow& window) : host_(window), loader_(host_, window.settings()) {
    loader_.load();
  }
  bool has(const char* name) const { return loader_.has(QString::fromLatin1(name)); }

 private:
  WindowHost host_;
  PluginLoader loader_;
};

class TutorialTest : public GuiTest {
 protected:
  TutorialTest() : page_(QStringLiteral(RELIEVO_SOURCE_DIR "/docs/user/tutorial.md")) {
    qputenv("HOME", path("home").toLocal8Bit());
    QDir().mkpath(path("home/Documents"));
    window().resize(1280, 900);
  }

  DetailView& detail() { return window().detailView(); }
  ReferenceView& overview() { return window().referenceView(); }
  const Region& region() { return document().project().region; }
  static QPointF middleOf(const QWidget& widget) { return QRectF(widget.rect()).center(); }
  QString status() { return child<QLabel>("status_message")->text(); }
  /// In the overview, of which the object fills nearly all.
  QPointF at(double x, double y) { return {x * overview().width(), y * overview().height()}; }

  /// As somebody presses it, wherever the keyboard is.
  void key(const QString& name) {
    page_.usesKey(name);
    QString known = name;  // Qt calls some of them otherwise.
    known.replace("Esc", "Escape").replace("Plus", "+").replace("Minus", "-");
    const QKeySequence keys(known);
    ASSERT_EQ(keys.count(), 1) << name.toStdString() << " is no key";
    const int code = keys[0] & ~static_cast<int>(Qt::KeyboardModifierMask);
    ASSERT_NE(code, static_cast<int>(Qt::Key_unknown)) << name.toStdString();
    const auto modifiers =
        Qt::KeyboardModifiers(keys[0] & static_cast<int>(Qt::KeyboardModifierMask));
    QWidget* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr) << "nothing has the keyboard for " << name.toStdString();
    QTest::keyClick(focus, static_cast<Qt::Key>(code), modifiers);
    QApplication::processEvents();
  }

  /// "View > Relief image > Openness", from the menu bar.
  void choose(const QString& menu_path) {
    page_.usesControl(menu_path);
    QList<QAction*> entries = window().menuBar()->actions();
    QAction* chosen = nullptr;
    for (const QString& name : menu_path.split(QStringLiteral(" > "))) {
      chosen = nullptr;
      for (QAction* entry : entries) {
        if (entry->isVisible() && plainName(entry->text()) == name) chosen = entry;
      }
      ASSERT_NE(chosen, nullptr) << "no " << name.toStdString() << " of "
                                 << menu_path.toStdString();
      ASSERT_TRUE(chosen->isEnabled()) << menu_path.toStdString();
      if (chosen->menu() != nullptr) {
        Q_EMIT chosen->menu()->aboutToShow();
        entries = chosen->menu()->actions();
      }
    }
    ASSERT_EQ(chosen->menu(), nullptr) << menu_path.toStdString() << " is a menu";
    chosen->trigger();
    QApplication::processEvents();
  }

  /// A button of the window, or of a dialog over it, that can be seen.
  QAbstractButton* button(const QString& name) {
    for (QWidget* top : QApplication::topLevelWidgets()) {
      for (auto* one : top->findChildren<QAbstractButton*>()) {
        if (one->isVisible() && plainName(one->text()) == name) return one;
      }
    }
    return nullptr;
  }
  void click(const QString& name) {
    page_.usesControl(name);
    QAbstractButton* one = button(name);
    ASSERT_NE(one, nullptr) << "no control " << name.toStdString() << " is seen";
    ASSERT_TRUE(one->isEnabled()) << name.toStdString();
    // A person clicks on the box; the middle of a wide panel may be beside it and its words.
    constexpr int kInTheBox = 8;
    const bool is_box = qobject_cast<QCheckBox*>(one) != nullptr;
    QTest::mouseClick(one, Qt::LeftButton, {},
                      is_box ? QPoint(kInTheBox, one->height() / 2) : QPoint());
    QApplication::processEvents();
  }
  /// The section of the side panels.
  void unfold(const QString& title) {
    page_.usesControl(title);
    ASSERT_TRUE(child<SidePanels>("side_panels")->titles().contains(title)) << title.toStdString();
    for (auto* header : child<SidePanels>("side_panels")->findChildren<QAbstractButton*>()) {
      if (header->text() == title && header->accessibleDescription() == "folded") header->click();
    }
    QApplication::processEvents();
  }

  template <class Dialog>
  Dialog* shown(const char* name) {
    Dialog* dialog = nullptr;
    EXPECT_TRUE(waitFor([&] {
      dialog = window().findChild<Dialog*>(QString::fromLatin1(name));
      return dialog != nullptr && dialog->isVisible();
    })) << name;
    return dialog;
  }
  /// And the keyboard is the window's again; Xvfb has no window manager that would see to it.
  void closeDialog(QWidget* dialog) {
    ASSERT_NE(dialog, nullptr);
    dialog->close();
    QApplication::processEvents();
    QApplication::setActiveWindow(&window());
    detail().setFocus();
  }
  bool becomesOpen() {
    return waitFor([this] { return document().isOpen() && !document().loader().busy(); });
  }
  double force() {
    const auto& probe = detail().sceneState().probe;
    return probe ? norm(probe->force) : 0;
  }

  void open();
  void look();
  void chooseWindow();
  void namePlaces();
  void touch();
  void makeMap();
  void light();
  void stereo();
  void measure();
  void draw();
  void keep();
  void find();
  void doAll();

  TutorialPage page_;
};

void TutorialTest::open() {
  page_.says("Choose *Carved panel with undercuts* on the start page");
  page_.usesControl("Carved panel with undercuts");
  auto* samples = child<QListWidget>("start_samples");
  const auto found = samples->findItems("Carved panel with undercuts", Qt::MatchContains);
  ASSERT_EQ(found.size(), 1);
  QTest::mouseClick(samples->viewport(), Qt::LeftButton, Qt::NoModifier,
                    samples->visualItemRect(found.front()).center());
  ASSERT_TRUE(becomesOpen());
  page_.says(
      "The picture needs no adjustment: the relief is turned to face you, fitted, and lit "
      "from the upper left.");
  EXPECT_FALSE(detail().isTurned());
  EXPECT_EQ(document().project().look.light, LightOptions{});
  page_.says("Left is the whole object; right is what the pink window shows");
  EXPECT_LT(overview().mapToGlobal({}).x(), detail().mapToGlobal({}).x());
  EXPECT_TRUE(overview().isVisible());
  EXPECT_EQ(document().detail(), 1);
}

void TutorialTest::look() {
  page_.says(
      "Drag in the right view with the left button to turn it, turn the wheel to come "
      "closer.");
  drag(detail(), middleOf(detail()), middleOf(detail()) + QPointF(60, 20));
  EXPECT_TRUE(detail().isTurned());
  const double side = region().side_mm;
  wheel(detail(), middleOf(detail()), 2);
  EXPECT_LT(region().side_mm, side);
  page_.says("*View > Fit* looks straight down again.");
  choose("View > Fit");
  EXPECT_FALSE(detail().isTurned());
  page_.says(
      "The status bar says what the buttons do; **F7** changes between looking and "
      "touching.");
  auto* mouse = child<QLabel>("status_mouse");
  EXPECT_TRUE(mouse->text().startsWith("Look: left turns")) << mouse->text().toStdString();
  key("F7");
  EXPECT_TRUE(mouse->text().startsWith("Touch: left presses")) << mouse->text().toStdString();
  key("F7");
}

void TutorialTest::chooseWindow() {
  page_.says(
      "Drag over a part of the left view: the pink window is there, and the right view "
      "shows it.");
  document().region().whole();
  drag(overview(), at(0.3, 0.3), at(0.6, 0.6));
  const Region drawn = region();
  EXPECT_LT(drawn.side_mm, document().surface()->ladder.sideMm(1));
  EXPECT_EQ(document().window()->region, drawn);
  page_.says("Drag inside the pink window to move it, at its edges to resize it.");
  drag(overview(), at(0.45, 0.45), at(0.5, 0.5));
  EXPECT_NE(region(), drawn);
  EXPECT_NEAR(region().side_mm, drawn.side_mm, 1e-9);
  const RectMm& seen = overview().sceneState().camera.rect;
  const QPointF edge(overview().width() / 2.0 +
                         (region().x_mm + region().side_mm - seen.x_mm - 0.5 * seen.width_mm) /
                             overview().mmPerPixel(),
                     overview().height() / 2.0);
  drag(overview(), edge, edge + QPointF(12, 0));
  EXPECT_GT(region().side_mm, drawn.side_mm);

  page_.says(
      "By keys: **Ctrl+L** goes to the left view, **Space** begins a window, **Right** and "
      "the other arrows carry its other corner, **Enter** ends.");
  detail().setFocus();
  key("Ctrl+L");
  EXPECT_TRUE(overview().hasFocus());
  const Region before = region();
  key("Space");
  for (int i = 0; i < 6; ++i) key("Right");
  EXPECT_TRUE(document().region().inGesture());
  key("Enter");
  EXPECT_FALSE(document().region().inGesture());
  EXPECT_NE(region(), before);

  page_.says("**Ctrl+Plus** and **Ctrl+Minus** step through the resolutions about the hand.");
  document().region().whole();
  detail().setFocus();
  key("Ctrl+Plus");
  EXPECT_EQ(document().detail(), 2);
  key("Ctrl+Plus");
  EXPECT_EQ(document().detail(), 3);
  key("Ctrl+Minus");
  EXPECT_EQ(document().detail(), 2);
  page_.says("**Ctrl+0** shows the whole object.");
  key("Ctrl+0");
  EXPECT_EQ(document().detail(), 1);
  page_.says("**Ctrl+Z** takes back what was done.");
  key("Ctrl+Z");
  EXPECT_EQ(document().detail(), 2);
}

void TutorialTest::namePlaces() {
  page_.says(
      "A window worth coming back to gets a bookmark with **Ctrl+N**; **Ctrl+Page Down** goes to "
      "the next one.");
  const Region named = region();
  key("Ctrl+N");
  ASSERT_EQ(document().project().places.size(), 1U);
  auto* name = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(name, nullptr) << "its name is typed";
  QTest::keyClicks(name, "Rim");
  QTest::keyClick(name, Qt::Key_Return);
  EXPECT_TRUE(waitFor([this] { return document().project().places.front().name == "Rim"; }));
  detail().setFocus();
  document().region().whole();
  key("Ctrl+Page Down");
  EXPECT_EQ(region(), named);
  page_.says("With *With light and view* ticked, light and view are kept, too.");
  click("With light and view");
  action("name_place")->trigger();
  ASSERT_EQ(document().project().places.size(), 2U);
  EXPECT_FALSE(document().project().places[0].view);
  EXPECT_TRUE(document().project().places[1].view);
  detail().setFocus();
}

void TutorialTest::touch() {
  page_.says("Move the pointer over the right view: the hand floats above the surface.");
  move(detail(), middleOf(detail()));
  ASSERT_TRUE(detail().hand());
  EXPECT_FALSE(detail().pressing());
  page_.says("**F5** switches the forces on, gently.");
  key("F5");
  ASSERT_TRUE(waitFor([this] {
    const auto& probe = detail().sceneState().probe;
    return probe && probe->forces_on;
  }));
  page_.says("Hold the left button to press in; or use **Page Down** and, to lift, **Page Up**.");
  press(detail(), middleOf(detail()));
  EXPECT_TRUE(waitFor([this] { return force() > 0.1; }));
  release(detail(), middleOf(detail()));
  EXPECT_TRUE(waitFor([this] { return force() == 0; }));
  for (int i = 0; i < 4; ++i) key("Page Down");
  EXPECT_TRUE(waitFor([this] { return force() > 0.1; }));
  for (int i = 0; i < 4; ++i) key("Page Up");
  EXPECT_TRUE(waitFor([this] { return force() == 0; }));
  page_.says("**Esc** always stops the forces.");
  key("Esc");
  EXPECT_FALSE(action("forces")->isChecked());
  page_.says("**Ctrl+R** records, and ends the recording; the file says what was touched");
  key("Ctrl+R");
  EXPECT_TRUE(action("record")->isChecked()) << window().message().toStdString();
  key("Ctrl+R");
  EXPECT_TRUE(waitFor([this] { return !document().project().recordings.empty(); }));
  EXPECT_EQ(QDir(path("home/Documents/relievo")).entryList({"*.csv", "*.h5"}).size(), 1);
}

void TutorialTest::makeMap() {
  page_.says(
      "**Ctrl+D** opens everything between the scan and its map: unit, side, grid, which "
      "height a cell gets, what becomes of holes.");
  key("Ctrl+D");
  auto* dialog = shown<QDialog>("depth_map_dialog");
  closeDialog(dialog);
  ASSERT_TRUE(waitFor([this] { return !document().loader().busy(); }));
}

void TutorialTest::light() {
  page_.says(
      "Drag the small sphere in the corner of the detail view to its rim for raking light; "
      "**Alt+Shift+Left** and the other arrows do it by keys.");
  auto& ball = *child<LightBall>("light_ball");
  ASSERT_TRUE(ball.isVisible());
  drag(ball, middleOf(ball), middleOf(ball) + QPointF(0.5 * ball.width(), 0));
  const LightOptions raking = document().project().look.light;
  EXPECT_NEAR(raking.elevation_deg, kLeastLightDeg, 1e-9);
  detail().setFocus();
  key("Alt+Shift+Left");
  EXPECT_NE(document().project().look.light, raking);
  page_.says("*View > Key light > Usual light* brings the first one back.");
  choose("View > Key light > Usual light");
  EXPECT_EQ(document().project().look.light, LightOptions{});
  page_.says(
      "*View > Relief image > Openness* paints ridges bright and hollows dark in place of "
      "*View > Relief image > Shaded relief*");
  choose("View > Relief image > Openness");
  EXPECT_EQ(document().project().look.kind, ReliefKind::openness);
  choose("View > Relief image > Shaded relief");
  EXPECT_EQ(document().project().look.kind, ReliefKind::lit);
}

void TutorialTest::stereo() {
  page_.says("**Ctrl+3** and red and cyan glasses.");
  key("Ctrl+3");
  EXPECT_EQ(document().project().stereo.mode, StereoMode::anaglyph);
  page_.says(
      "In the panel *Stereo*, *Automatic depth* gives each view as much depth as is "
      "comfortable; the meter says how far apart your eyes see the farthest point.");
  unfold("Stereo");
  const bool automatic = document().project().stereo.automatic_depth;
  click("Automatic depth");
  EXPECT_NE(document().project().stereo.automatic_depth, automatic);
  click("Automatic depth");
  EXPECT_TRUE(child<QProgressBar>("parallax_meter")->isVisible());
  page_.says("*Test glasses...* shows whether red is at your left eye.");
  click("Test glasses...");
  closeDialog(shown<QDialog>("glasses_dialog"));
  action("stereo")->trigger();
}

void TutorialTest::measure() {
  page_.says("*Measure > Depth difference*, then two clicks, or arrows and **Enter** twice.");
  choose("Measure > Depth difference");
  press(detail(), middleOf(detail()));
  release(detail(), middleOf(detail()));
  press(detail(), middleOf(detail()) + QPointF(40, 0));
  release(detail(), middleOf(detail()) + QPointF(40, 0));
  ASSERT_EQ(document().project().measurements.size(), 1U);
  choose("Measure > Depth difference");
  QTest::keyClick(&detail(), Qt::Key_Right);
  key("Enter");
  QTest::keyClick(&detail(), Qt::Key_Right, Qt::ShiftModifier);
  key("Enter");
  ASSERT_EQ(document().project().measurements.size(), 2U);
  EXPECT_EQ(document().project().measurements[1].kind, MeasureKind::depth);
  page_.says("Each value comes with a bound of its uncertainty");
  EXPECT_TRUE(child<MeasurePanel>("measure_panel")->csv(path("list.csv")).contains("uncertainty"));
  page_.says("*Measure > Profile*, two clicks and **F**: the curve appears under the views");
  choose("Measure > Profile");
  for (const double x : {-60.0, 60.0}) {
    press(detail(), middleOf(detail()) + QPointF(x, 0));
    release(detail(), middleOf(detail()) + QPointF(x, 0));
  }
  key("F");
  ASSERT_EQ(document().project().measurements.size(), 3U);
  EXPECT_TRUE(waitFor([this] { return child<ProfileStrip>("profile_strip")->isVisible(); }));
  page_.says("drag along it to read length and depth of a piece.");
  auto& curve = *child<QWidget>("profile_curve");
  const QString whole = child<QLabel>("profile_readout")->text();
  drag(curve, QPointF(0.3 * curve.width(), 0.5 * curve.height()),
       QPointF(0.7 * curve.width(), 0.5 * curve.height()));
  EXPECT_NE(child<QLabel>("profile_readout")->text(), whole);
  detail().setFocus();
}

void TutorialTest::draw() {
  page_.says("**Ctrl+E** opens the figure.");
  key("Ctrl+E");
  closeDialog(shown<QDialog>("figure_dialog"));
}

void TutorialTest::keep() {
  page_.says("**Ctrl+S** writes a [project](projects.md)");
  key("Ctrl+S");
  auto* dialog = shown<QFileDialog>("project_dialog");
  ASSERT_NE(dialog, nullptr);
  Q_EMIT dialog->fileSelected(path("panel.relievo.json"));
  closeDialog(dialog);
  EXPECT_TRUE(QFile::exists(path("panel.relievo.json")));
  EXPECT_FALSE(window().hasUnsavedWork());
  page_.says("What was recorded in the window on this scan belongs to it.");
  EXPECT_EQ(document().stored().recordings.size(), 1U);
  page_.says("*File > Export archive package...* makes one zip that can be cited");
  choose("File > Export archive package...");
  closeDialog(shown<QDialog>("package_dialog"));
  page_.says(
      "*Edit > Copy view as text* puts where you look into the clipboard, to be sent to "
      "somebody with the same scan; **Ctrl+Shift+V** shows it.");
  document().region().setRect({20, 20, 60, 60});
  const Region copied = region();
  choose("Edit > Copy view as text");
  EXPECT_FALSE(QApplication::clipboard()->text().isEmpty());
  document().region().whole();
  key("Ctrl+Shift+V");
  EXPECT_EQ(region(), copied);
}

void TutorialTest::find() {
  page_.says("**Ctrl+K** finds a command by its words.");
  key("Ctrl+K");
  closeDialog(shown<QDialog>("command_search"));
  page_.says("**F1** shows all keys.");
  key("F1");
  closeDialog(shown<KeysSheet>("keys_sheet"));
  page_.says("**Ctrl+,** holds all settings and searches them.");
  key("Ctrl+,");
  closeDialog(window().findChild<PreferencesDialog*>());
  page_.says("**Ctrl+W** closes the scan and goes back to the start page.");
  window().saveProject(path("panel.relievo.json"));
  key("Ctrl+W");
  EXPECT_FALSE(document().isOpen());
  EXPECT_TRUE(child<StartPage>("start_page")->isVisible());
}

void TutorialTest::doAll() {
  for (const auto chapter :
       {&TutorialTest::open, &TutorialTest::look, &TutorialTest::chooseWindow,
        &TutorialTest::namePlaces, &TutorialTest::touch, &TutorialTest::makeMap,
        &TutorialTest::light, &TutorialTest::stereo, &TutorialTest::measure, &TutorialTest::draw,
        &TutorialTest::keep, &TutorialTest::find}) {
    (this->*chapter)();
    if (HasFatalFailure()) return;
  }
  page_.ends();
}

TEST_F(TutorialTest, SentencesAndWindowAgree) {
  const LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins.has("haptics_plugin"));
  doAll();
}

}  // namespace
}  // namespace relievo
