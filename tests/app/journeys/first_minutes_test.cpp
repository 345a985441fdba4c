// SPDX-License-Identifier: BSD-3-Clause
// A person's first ten minutes, once with nothing but the mouse and once with nothing but keys:
// open, turn, look at the points, choose a window, press, change the resolution while pressing,
// measure a depth, see a profile, make a figure, save, quit. Events go to what is on the screen;
// no function of the program is called for the person.
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QtTest/QTest>

#include "data/generate/relief_f.h"
#include "tests/app/journeys/journey.h"
#include "tests/emulator/stall_watch.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/panels/measure_readings.h"
#include "ui/plots/profile_strip.h"
#include "ui/style/mnemonic.h"
#include "ui/views/cloud_view.h"
#include "ui/views/scan_view.h"

namespace relievo {
namespace {

enum class By { mouse, keys };

class FirstMinutesTest : public Journey, public ::testing::WithParamInterface<By> {
 protected:
  FirstMinutesTest() : Journey(GetParam() == By::keys ? "first_keys" : "first_mouse") {}
  void SetUp() override {
    const QString folder = path("home/Documents");
    ASSERT_TRUE(QFile::copy(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply", folder + "/F.ply"));
    before_ = QDir::currentPath();
    QDir::setCurrent(folder);  // As whoever starts the program there.
    window().resize(1300, 860);
    attach();
  }
  void TearDown() override {
    Journey::TearDown();
    QDir::setCurrent(before_);
  }

  static bool byKeys() { return GetParam() == By::keys; }

  /// To whatever has the keyboard. Xvfb has no window manager that would make a window active.
  void pressKey(int key, Qt::KeyboardModifiers with = {}, int times = 1) {
    for (int i = 0; i < times; ++i) {
      if (QApplication::activeWindow() == nullptr) QApplication::setActiveWindow(&window());
      QWidget* to = QApplication::activePopupWidget();
      if (to == nullptr) to = QApplication::focusWidget();
      ASSERT_NE(to, nullptr);
      QTest::keyClick(to, static_cast<Qt::Key>(key), with);
    }
  }
  /// A dialog that was opened. Xvfb has no window manager that would make it active.
  static void hasKeyboard(QWidget& dialog) {
    ASSERT_TRUE(soon([&] { return dialog.isVisible(); }));
    QApplication::setActiveWindow(&dialog);
    ASSERT_NE(QApplication::focusWidget(), nullptr);
  }
  /// Chooses a command by its words, and goes to the detail view.
  void find(const QString& words) {
    pressKey(Qt::Key_K, Qt::ControlModifier);
    QLineEdit* line = nullptr;
    ASSERT_TRUE(soon([&] {
      for (auto* one : window().findChildren<QLineEdit*>("command_words")) {
        if (one->isVisible()) line = one;
      }
      return line != nullptr;
    }));
    hasKeyboard(*line->window());
    ASSERT_TRUE(line->hasFocus());
    QTest::keyClicks(line, words);
    pressKey(Qt::Key_Return);
    QApplication::processEvents();
    toDetail();
  }
  void toDetail() {
    constexpr int kMostParts = 10;
    for (int i = 0; i < kMostParts && !detail().hasFocus(); ++i) pressKey(Qt::Key_F6);
    ASSERT_TRUE(detail().hasFocus());
  }
  void tabTo(const QWidget* wanted) {
    constexpr int kMostStops = 200;
    for (int i = 0; i < kMostStops && QApplication::focusWidget() != wanted; ++i) {
      pressKey(Qt::Key_Tab);
    }
    ASSERT_EQ(QApplication::focusWidget(), wanted);
  }
  static void click(QWidget& on, const QPoint& at) {
    QTest::mouseClick(&on, Qt::LeftButton, Qt::NoModifier, at);
    QApplication::processEvents();
  }
  static void click(QWidget& on) { click(on, on.rect().center()); }
  static QAction* entry(const QWidget& of, const QString& words) {
    for (QAction* one : of.actions()) {
      if (withoutMnemonic(one->text()) == words) return one;
    }
    return nullptr;
  }
  /// Opens a menu of the menu bar, and clicks an entry of it.
  void menu(const QString& title, const QString& words) {
    QMenuBar* bar = window().menuBar();
    QAction* top = entry(*bar, title);
    ASSERT_NE(top, nullptr) << title.toStdString();
    click(*bar, bar->actionGeometry(top).center());
    auto* shown = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(shown, nullptr) << title.toStdString();
    QAction* chosen = entry(*shown, words);
    ASSERT_NE(chosen, nullptr) << words.toStdString();
    ASSERT_TRUE(chosen->isEnabled()) << words.toStdString();
    click(*shown, shown->actionGeometry(chosen).center());
  }
  void tool(const char* command) {
    QWidget* button = child<QToolBar>("tools")->widgetForAction(action(command));
    ASSERT_NE(button, nullptr) << command;
    click(*button);
  }
  QFileDialog& fileDialog(const char* name) {
    EXPECT_TRUE(soon([&] {
      auto* dialog = child<QFileDialog>(name);
      return dialog != nullptr && dialog->isVisible();
    })) << name;
    return *child<QFileDialog>(name);
  }
  static void clickFile(QFileDialog& dialog, const QString& name) {
    auto* list = dialog.findChild<QListView*>("listView");
    QModelIndex found;
    ASSERT_TRUE(soon([&] {
      const QAbstractItemModel& model = *list->model();
      for (int row = 0; row < model.rowCount(list->rootIndex()); ++row) {
        const QModelIndex at = model.index(row, 0, list->rootIndex());
        if (at.data().toString() == name) found = at;
      }
      return found.isValid();
    })) << name.toStdString();
    click(*list->viewport(), list->visualRect(found).center());
  }
  static void clickButton(QDialog& dialog, QDialogButtonBox::StandardButton which) {
    QPushButton* button = dialog.findChild<QDialogButtonBox*>()->button(which);
    ASSERT_TRUE(soon([button] { return button->isEnabled(); }));
    click(*button);
  }
  void pick(double x_mm, double y_mm) {
    if (byKeys()) {
      ASSERT_TRUE(detail().hasFocus());
      carryHand(x_mm, y_mm);
      pressKey(Qt::Key_Return);
    } else {
      click(detail(), over(x_mm, y_mm).toPoint());
    }
  }
  bool pressed(double x_mm, double y_mm);
  void lift(double x_mm, double y_mm);

 public:  // Named by the test below.
  void open();
  void turn();
  void seePoints();
  void chooseWindow();
  void touch();
  void measureDepth();
  void seeProfile();
  void makeFigure();
  void save();
  void quit();

 private:
  emulator::StallWatch stalls_;
  QString before_, figure_;
};

void FirstMinutesTest::open() {
  if (byKeys()) {
    pressKey(Qt::Key_O, Qt::ControlModifier);
    QFileDialog& dialog = fileDialog("open_dialog");
    hasKeyboard(dialog);
    QTest::keyClicks(QApplication::focusWidget(), "F.ply");
    pressKey(Qt::Key_Return);
  } else {
    menu("File", QStringLiteral("Open\u2026"));
    QFileDialog& dialog = fileDialog("open_dialog");
    clickFile(dialog, "F.ply");
    clickButton(dialog, QDialogButtonBox::Open);
  }
  ASSERT_TRUE(settled());
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  EXPECT_EQ(document().surface()->view_name, "top") << "its best side";
  picture("1_open");
}

void FirstMinutesTest::turn() {
  if (byKeys()) {
    pressKey(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier, 3);
    pressKey(Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
  } else {
    const QPointF middle = QRectF(detail().rect()).center();
    drag(detail(), middle, middle + QPointF(70, 40));
  }
  EXPECT_TRUE(detail().isTurned());
  picture("2_turned");
  if (byKeys()) {
    pressKey(Qt::Key_Z, Qt::ControlModifier);
  } else {
    menu("Edit", action("undo")->text().remove('&'));
  }
  EXPECT_FALSE(detail().isTurned()) << "undo brings the view back";
}

void FirstMinutesTest::seePoints() {
  const auto change = [this] {
    if (byKeys()) {
      pressKey(Qt::Key_F8);
    } else {
      click(*child<QToolButton>("scan_switch"));
    }
  };
  change();
  auto& scan = *child<ScanView>("scan_view");
  ASSERT_TRUE(eventually([&] { return scan.isVisible() && scan.isReady(); }));
  auto& points = *scan.findChild<CloudView*>();
  if (byKeys()) {
    ASSERT_TRUE(points.hasFocus());
    pressKey(Qt::Key_Right, {}, 6);
    pressKey(Qt::Key_Up, {}, 2);
  } else {
    drag(points, {100, 120}, {170, 90});
  }
  EXPECT_GT(scan.turnedDeg(), 10);
  picture("3_points");
  change();
  EXPECT_TRUE(soon([this] { return reference().isVisible(); }));
}

/// About the step of the F at x = 200 mm.
void FirstMinutesTest::chooseWindow() {
  if (byKeys()) {
    if (!reference().hasFocus()) pressKey(Qt::Key_L, Qt::ControlModifier);
    ASSERT_TRUE(reference().hasFocus());
    pressKey(Qt::Key_Space);
    pressKey(Qt::Key_Right, {}, 4);
    pressKey(Qt::Key_Up, {}, 4);
    pressKey(Qt::Key_Return);
    // Then by numbers.
    for (const auto& [name, number] :
         {std::pair{"region_side", "100"}, {"region_x", "150"}, {"region_y", "50"}}) {
      pressKey(Qt::Key_G, Qt::ControlModifier);
      tabTo(child<QWidget>(name));
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
      QTest::keyClicks(QApplication::focusWidget(), number);
      pressKey(Qt::Key_Return);
    }
  } else {
    drag(reference(), reference().pointOf(150, 50), reference().pointOf(250, 150));
  }
  const Region& r = document().project().region;
  EXPECT_NEAR(r.x_mm, 150, 2);
  EXPECT_NEAR(r.y_mm, 50, 2);
  EXPECT_NEAR(r.side_mm, 100, 4);
  picture("4_window");
}

bool FirstMinutesTest::pressed(double x_mm, double y_mm) {
  if (byKeys()) {
    toDetail();
    carryHand(x_mm, y_mm);
    if (!action("forces")->isChecked()) pressKey(Qt::Key_F5);
  } else {
    move(detail(), over(x_mm, y_mm));
    if (!action("forces")->isChecked()) tool("forces");
    move(detail(), over(x_mm, y_mm));
  }
  if (!soon([this] { return probe() && probe()->forces_on; })) return false;
  const bool arrived = soon([&] {
    const auto now = probe();
    return now && !now->touching && std::hypot(now->hip.x - x_mm, now->hip.y - y_mm) < 1;
  });
  if (!arrived) return false;
  if (byKeys()) {
    pressKey(Qt::Key_PageDown, {}, 4);
  } else {
    press(detail(), over(x_mm, y_mm));
  }
  return soon([this] { return forceShown() > 0.1; });
}

void FirstMinutesTest::lift(double x_mm, double y_mm) {
  if (byKeys()) {
    pressKey(Qt::Key_PageUp, {}, 4);
  } else {
    release(detail(), over(x_mm, y_mm));
  }
  EXPECT_TRUE(eventually([this] { return probe() && !probe()->touching; }));
}

void FirstMinutesTest::touch() {
  constexpr double kX = 230, kY = 100;  // On the plate beside the step.
  const int before = document().detail();
  int tries = 0;
  EXPECT_TRUE(stalls_.repeatAfterStalls(5, [&] {
    if (tries++ > 0) {
      lift(kX, kY);
      while (document().detail() > before) {
        byKeys() ? pressKey(Qt::Key_Minus, Qt::ControlModifier) : tool("coarser");
      }
    }
    if (!pressed(kX, kY)) return false;
    picture("5_pressed");
    const double side = document().project().region.side_mm;
    if (byKeys()) {
      pressKey(Qt::Key_Plus, Qt::ControlModifier);
    } else {
      // The left button stays down; the right one is held, too, while the wheel turns.
      press(detail(), over(kX, kY), Qt::RightButton);
      wheel(detail(), over(kX, kY), 1);
      release(detail(), over(kX, kY), Qt::RightButton);
    }
    EXPECT_EQ(document().detail(), before + 1);
    EXPECT_LT(document().project().region.side_mm, 0.6 * side);
    EXPECT_TRUE(detail().pressing()) << "the hand stays down";
    return soon([&] {
      return probe() && probe()->touching && probe()->forces_on && forceShown() > 0.1 &&
             std::hypot(probe()->proxy.x - kX, probe()->proxy.y - kY) < 2;
    });
  })) << said().toStdString();
  picture("6_finer");
  lift(kX, kY);
  if (byKeys()) {
    pressKey(Qt::Key_Escape);
    pressKey(Qt::Key_Minus, Qt::ControlModifier);
  } else {
    tool("forces");
    tool("coarser");
  }
  EXPECT_TRUE(soon([this] { return !action("forces")->isChecked(); }));
  EXPECT_EQ(document().detail(), before);
  EXPECT_FALSE(document().region().inGesture());
}

void FirstMinutesTest::measureDepth() {
  if (byKeys()) {
    find("difference");
  } else {
    menu("Measure", "Depth difference");
  }
  pick(190, 100);
  pick(210, 100);
  const auto& made = document().project().measurements;
  ASSERT_EQ(made.size(), 1U);
  EXPECT_NEAR(read(document().surface()->map, made[0]).quantities[0].value, samples::kReliefFStepMm,
              0.1);
  picture("7_depth");
}

void FirstMinutesTest::seeProfile() {
  if (byKeys()) {
    find("profile");
  } else {
    menu("Measure", "Profile");
  }
  pick(180, 90);
  if (byKeys()) {
    pick(220, 90);
    pressKey(Qt::Key_F);
  } else {
    click(detail(), over(220, 90).toPoint());
    QTest::mouseDClick(&detail(), Qt::LeftButton, Qt::NoModifier, over(220, 90).toPoint());
  }
  ASSERT_EQ(document().project().measurements.size(), 2U);
  auto* strip = window().findChild<ProfileStrip*>();
  EXPECT_TRUE(soon([strip] { return strip->isVisible() && !strip->isEmpty(); }));
  EXPECT_FALSE(strip->readout().isEmpty());
  picture("8_profile");
}

void FirstMinutesTest::makeFigure() {
  if (byKeys()) {
    pressKey(Qt::Key_E, Qt::ControlModifier);
  } else {
    menu("File", QStringLiteral("Figure\u2026"));
  }
  QPointer<FigureDialog> open = window().findChild<FigureDialog*>();
  ASSERT_NE(open, nullptr);
  const FigureDialog* dialog = open;
  auto* caption = dialog->findChild<QPlainTextEdit*>("figure_caption");
  ASSERT_TRUE(eventually([&] { return !caption->toPlainText().isEmpty(); }));
  figure_ = dialog->file();
  auto* save = dialog->findChild<QPushButton*>("figure_save");
  ASSERT_TRUE(eventually([save] { return save->isEnabled(); }));
  if (byKeys()) {
    hasKeyboard(*open);
    tabTo(save);
    pressKey(Qt::Key_Space);
  } else {
    click(*save);
  }
  // It closes by itself when all is written.
  ASSERT_TRUE(eventually([&] { return !open || !open->isVisible(); }));
  EXPECT_GT(QImage(figure_).width(), 1000) << figure_.toStdString();
}

void FirstMinutesTest::save() {
  if (byKeys()) {
    pressKey(Qt::Key_S, Qt::ControlModifier);
    hasKeyboard(fileDialog("project_dialog"));
    pressKey(Qt::Key_Return);
  } else {
    menu("File", "Save project");
    clickButton(fileDialog("project_dialog"), QDialogButtonBox::Save);
  }
  EXPECT_TRUE(soon([this] { return QFile::exists(path("home/Documents/F.relievo.json")); }));
  EXPECT_FALSE(window().hasUnsavedWork());
}

void FirstMinutesTest::quit() {
  if (byKeys()) {
    pressKey(Qt::Key_Q, Qt::ControlModifier);
  } else {
    menu("File", "Quit");
  }
  EXPECT_TRUE(soon([this] { return !window().isVisible(); })) << "no question is left";
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  const Project kept = readProject(path("home/Documents/F.relievo.json").toStdString());
  EXPECT_EQ(kept.measurements.size(), 2U);
  EXPECT_EQ(kept.figures, std::vector<std::string>{figure_.toStdString()});
}

TEST_P(FirstMinutesTest, OpenTurnLookTouchMeasureDrawSaveQuit) {
  using Step = void (FirstMinutesTest::*)();
  for (const Step step :
       {&FirstMinutesTest::open, &FirstMinutesTest::turn, &FirstMinutesTest::seePoints,
        &FirstMinutesTest::chooseWindow, &FirstMinutesTest::touch, &FirstMinutesTest::measureDepth,
        &FirstMinutesTest::seeProfile, &FirstMinutesTest::makeFigure, &FirstMinutesTest::save,
        &FirstMinutesTest::quit}) {
    (this->*step)();
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Hands, FirstMinutesTest, ::testing::Values(By::mouse, By::keys),
                         [](const auto& hand) {
                           return std::string(hand.param == By::keys ? "Keys" : "Mouse");
                         });

}  // namespace
}  // namespace relievo
