// SPDX-License-Identifier: BSD-3-Clause
// Journey U2: a researcher with a mouse, or with a keyboard alone, from a scan to a figure and
// back: window, host, haptics plugin and command line as they are built. Pictures of the window at
// each step are kept in screenshots/ of the build folder.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QToolBar>
#include <QtTest/QTest>

#include "core/project/recording.h"
#include "data/generate/relief_f.h"
#include "tests/app/command.h"
#include "tests/app/journeys/journey.h"
#include "tests/emulator/mock_hid.h"
#include "tests/emulator/mock_usb.h"
#include "tests/emulator/stall_watch.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/replay_panel.h"

namespace relievo {
namespace {

enum class By { mouse, keys };

class JourneyTest : public Journey, public ::testing::WithParamInterface<By> {
 protected:
  JourneyTest() : Journey(GetParam() == By::keys ? "u2_keys" : "u2_mouse") {}
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    window().resize(1200, 800);
    attach();
    ASSERT_TRUE(QFile::copy(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply", path("F.ply")));
  }

  bool byKeys() const { return GetParam() == By::keys; }
  MeasurePanel& measure() { return *window().findChild<MeasurePanel*>(); }
  static void keys(QWidget& to, int key, int times = 1, Qt::KeyboardModifiers with = {}) {
    for (int i = 0; i < times; ++i) QTest::keyClick(&to, static_cast<Qt::Key>(key), with);
  }
  /// Ctrl and a key. Without a window manager nobody makes the window active again.
  void shortcut(int key) {
    QApplication::setActiveWindow(&window());
    keys(window(), key, 1, Qt::ControlModifier);
  }
  /// A command as its user reaches it: a click on its menu entry, or its words in the search.
  void choose(const char* name, const QString& words) {
    if (!byKeys()) {
      QAction* command = action(name);
      ASSERT_TRUE(command->isEnabled()) << name;
      QMenu* menu = menuOf(command);
      ASSERT_NE(menu, nullptr) << name;
      menu->popup(window().mapToGlobal({10, 10}));
      QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(command).center());
      return;
    }
    shortcut(Qt::Key_K);
    QLineEdit* line = nullptr;
    for (auto* one : window().findChildren<QLineEdit*>("command_words")) {
      if (one->isVisible()) line = one;
    }
    ASSERT_NE(line, nullptr);
    QTest::keyClicks(line, words);
    QTest::keyClick(line, Qt::Key_Return);
    QApplication::processEvents();
  }
  QMenu* menuOf(QAction* command) {
    for (auto* menu : window().findChildren<QMenu*>()) {
      if (menu->actions().contains(command) && menu->parentWidget() != nullptr) return menu;
    }
    return nullptr;
  }
  void pick(double x_mm, double y_mm) {
    if (byKeys()) {
      carryHand(x_mm, y_mm);
      keys(detail(), Qt::Key_Return);
    } else {
      press(detail(), over(x_mm, y_mm));
    }
  }
  /// Forces on with the hand over a place, and down on the surface there. A busy computer may stop
  /// the forces for safety; then a person lifts the hand and begins again.
  /// @param felt  what is to be seen then
  void pressDown(
      double x_mm, double y_mm, const std::function<bool()>& felt = [] { return true; }) {
    int tries = 0;
    EXPECT_TRUE(stalls_.repeatAfterStalls(5,
                                          [&] {
                                            if (tries++ > 0) lift(x_mm, y_mm);
                                            return pressed(x_mm, y_mm) && soon(felt);
                                          }))
        << "pressing in is felt; " << said().toStdString();
  }
  bool pressed(double x_mm, double y_mm) {
    detail().setFocus();
    if (byKeys()) {
      carryHand(x_mm, y_mm);
    } else {
      move(detail(), over(x_mm, y_mm));
    }
    if (!action("forces")->isChecked()) key(Qt::Key_F5);
    if (!soon([this] { return probe() && probe()->forces_on; })) return false;
    // The hand glides to where it was sent; pressed on the way, it would draw a stroke.
    const bool arrived = soon([&] {
      const auto now = probe();
      return now && !now->touching && std::hypot(now->hip.x - x_mm, now->hip.y - y_mm) < 1;
    });
    if (!arrived) return false;
    if (byKeys()) {
      keys(detail(), Qt::Key_PageDown, 4);
    } else {
      press(detail(), over(x_mm, y_mm));
    }
    return soon([this] { return forceShown() > 0.1; });
  }
  void lift(double x_mm, double y_mm) {
    if (byKeys()) {
      keys(detail(), Qt::Key_PageUp, 4);
    } else {
      release(detail(), over(x_mm, y_mm));
    }
    EXPECT_TRUE(eventually([this] { return probe() && !probe()->touching; }));
  }
  emulator::MockHid hid_;
  emulator::StallWatch stalls_;
  std::filesystem::path log_;  ///< What was recorded.
  bool crossed_ = false;       ///< The hand went over the step.

 public:  // Named by the test below.
  void openScan();
  void touch();
  void drawWindow();
  void changeDetail();
  void seeRelief();
  void measureStep();
  void measureByTouch();
  void recordStroke();
  void recordOnce();
  double heightFelt();
  void seeReplay();
  void steerBySpaceMouse();
  void keepWork();
  void makeFigure();
  void meetBrokenFile();
};

void JourneyTest::openScan() {
  OpenRequest request;  // As `relievo F.ply --unit mm --view top`.
  request.file = path("F.ply");
  request.unit = LengthUnit::mm;
  request.view = ViewChoice{"top", {}};
  window().open(request);
  ASSERT_TRUE(eventually([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << "nothing stands in the way";
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  EXPECT_EQ(document().project().region, wholeRegion(document().surface()->ladder));
  EXPECT_EQ(document().surface()->holes.size(), 3U);
  picture("1_open");
}

void JourneyTest::touch() {
  pressDown(90, 100, [this] {  // On the dome.
    return probe() && probe()->touching && probe()->hip.z < probe()->proxy.z &&
           std::abs(probe()->proxy.z - samples::kReliefFCapHeightMm) < 1;
  });
  picture("2_touch");
  key(Qt::Key_Escape);
  EXPECT_TRUE(eventually([this] { return !action("forces")->isChecked(); })) << "Escape stops them";
  lift(90, 100);
}

void JourneyTest::drawWindow() {
  if (byKeys()) {
    keys(detail(), Qt::Key_L, 1, Qt::ControlModifier);
    ASSERT_TRUE(reference().hasFocus());
    keys(reference(), Qt::Key_Space);
    keys(reference(), Qt::Key_Right, 4);
    keys(reference(), Qt::Key_Up, 4);
    picture("3_drawing");
    keys(reference(), Qt::Key_Return);
  } else {
    // Inside the pink window a drag would move it: drawing begins outside.
    document().region().setRect({20, 20, 60, 60});
    drag(reference(), reference().pointOf(160, 60), reference().pointOf(230, 130));
    picture("3_drawing");
  }
  EXPECT_EQ(document().history().undoText(), "Draw window");
  EXPECT_LT(document().project().region.side_mm, 150);
  // Then exactly, by typing.
  shortcut(Qt::Key_G);
  const std::array<std::pair<const char*, const char*>, 3> numbers{
      {{"region_side", "100"}, {"region_x", "150"}, {"region_y", "50"}}};
  for (const auto& [name, number] : numbers) {
    auto* box = child<QDoubleSpinBox>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, number);
    keys(*box, Qt::Key_Return);
  }
  EXPECT_NEAR(document().project().region.x_mm, 150, 1e-9);
  EXPECT_NEAR(document().project().region.y_mm, 50, 1e-9);
  EXPECT_NEAR(document().project().region.side_mm, 100, 1e-9);
  picture("3_window");
}

void JourneyTest::changeDetail() {
  const Region before = document().project().region;
  const int detail_before = document().detail();
  const auto step = [this](const char* name, int key) {
    if (byKeys()) {
      shortcut(key);
    } else {
      auto* tools = child<QToolBar>("tools");
      QTest::mouseClick(tools->widgetForAction(action(name)), Qt::LeftButton);
    }
  };
  step("finer", Qt::Key_Plus);
  EXPECT_EQ(document().detail(), detail_before + 1);
  step("coarser", Qt::Key_Minus);
  step("coarser", Qt::Key_Minus);
  const DocumentState after = document().state();
  EXPECT_EQ(document().history().undoText(),
            QStringLiteral("Resolution %1 \u2192 %2").arg(detail_before).arg(detail_before - 1));
  for (int i = 0; i < 3; ++i) shortcut(Qt::Key_Z);
  EXPECT_EQ(document().project().region, before);
  for (int i = 0; i < 3; ++i) shortcut(Qt::Key_Y);
  EXPECT_TRUE(document().state() == after) << "undo and redo end where they began";
  for (int i = 0; i < 3; ++i) shortcut(Qt::Key_Z);
}

void JourneyTest::seeRelief() {
  choose("relief_multi", "four lights");
  EXPECT_EQ(detail().sceneState().look.kind, ReliefKind::multi_hillshade);
  auto* height = child<QSlider>("light_elevation");
  if (byKeys()) {
    height->setFocus(Qt::TabFocusReason);
    keys(*height, Qt::Key_Left, 15);
  } else {
    height->setValue(30);
  }
  EXPECT_EQ(detail().sceneState().light.elevation_deg, 30);
  picture("4_relief");
}

void JourneyTest::measureStep() {
  choose("measure_depth", "difference");
  detail().setFocus();
  ASSERT_TRUE(measure().measuring());
  pick(190, 90);
  pick(210, 90);
  ASSERT_EQ(measure().measurements().size(), 1U);
  const auto& places = measure().measurements()[0].places;
  // The window lies at x 150: the map's first sample is half a point's distance inside the plate.
  const double truth = samples::reliefFHeightMm(places[1].x + 0.125, places[1].y + 0.125) -
                       samples::reliefFHeightMm(places[0].x + 0.125, places[0].y + 0.125);
  EXPECT_NEAR(truth, samples::kReliefFStepMm, 0.05);
  EXPECT_NEAR(read(document().surface()->map, measure().measurements()[0]).quantities[0].value,
              truth, 0.05);
  choose("measure_profile", "profile");
  detail().setFocus();
  pick(190, 80);
  pick(210, 80);
  keys(detail(), Qt::Key_F);
  ASSERT_EQ(measure().measurements().size(), 2U);
  measure().findChild<QTableWidget*>("measure_list")->setCurrentCell(1, 0);
  measure().writeSelected(path("step.csv"));
  measure().writeSelected(path("step.svg"));
  EXPECT_GT(QFile(path("step.csv")).size(), 100);
  EXPECT_GT(QFile(path("step.svg")).size(), 100);
  picture("5_measure");
}

/// One tap on each side of the step.
void JourneyTest::measureByTouch() {
  choose("measure_touch", "by touch");
  ASSERT_TRUE(measure().byTouch());
  for (const double x : {190.0, 210.0}) {
    pressDown(x, 90);
    lift(x, 90);
  }
  ASSERT_TRUE(eventually([this] { return measure().measurements().size() == 3; }));
  const double felt =
      read(document().surface()->map, measure().measurements()[2]).quantities[0].value;
  EXPECT_NEAR(felt, samples::kReliefFStepMm, document().surface()->map.frame.spacing_mm);
  picture("5_by_touch");
  for (int i = 0; i < 2; ++i) key(Qt::Key_Escape);
  EXPECT_FALSE(action("forces")->isChecked());
  EXPECT_FALSE(measure().byTouch());
}

/// A stroke over the step, recorded as with a Falcon; again where a busy computer stopped it.
void JourneyTest::recordStroke() {
  EXPECT_TRUE(stalls_.repeatAfterStalls(5, [this] {
    recordOnce();
    return !HasFatalFailure() && crossed_ && std::abs(heightFelt() - samples::kReliefFStepMm) < 0.3;
  })) << "the step was felt";
}

void JourneyTest::recordOnce() {
  const std::size_t before = recordings().size();
  shortcut(Qt::Key_R);
  ASSERT_TRUE(eventually([this] { return action("record")->isChecked(); }));
  pressDown(190, 90);
  if (byKeys()) {
    keys(detail(), Qt::Key_Right, 4, Qt::ShiftModifier);
  } else {
    for (double x = 190; x < 210; x += 0.5) {
      move(detail(), over(x, 90), Qt::LeftButton);
      QTest::qWait(15);
    }
  }
  crossed_ = soon([this] { return probe() && probe()->proxy.x > 205; });
  picture("6_recording");
  lift(byKeys() ? 210 : 209.5, 90);
  key(Qt::Key_Escape);
  shortcut(Qt::Key_R);
  ASSERT_TRUE(eventually([&] { return recordings().size() == before + 1; }));
  ASSERT_TRUE(hears("Recording saved"));
  ASSERT_TRUE(eventually([this] { return child<QLabel>("status_recording")->text().isEmpty(); }));
  log_ = recordings().back();
}

/// Between the lowest and the highest place that the last recording touched, mm.
double JourneyTest::heightFelt() {
  const TouchRecording recording = relievo::readRecording(log_);
  EXPECT_EQ(recording.input_sha256, document().fileSha256().toStdString());
  double low = 1e9;
  double high = -1e9;
  for (const TouchRow& row : recording.rows) {
    if (!row.contact) continue;
    low = std::min(low, row.proxy.z);
    high = std::max(high, row.proxy.z);
  }
  return high - low;
}

/// Played at full and at quarter speed; the same time shows the same picture.
void JourneyTest::seeReplay() {
  window().replay(QString::fromStdString(log_.string()));
  ASSERT_TRUE(eventually([this] { return window().controllers().replays.control().showing(); }))
      << window().message().toStdString();
  ReplayPlayer& player = window().controllers().replays.control().player();
  keys(*window().controllers().replays.control().panel(), Qt::Key_Space);
  EXPECT_TRUE(player.playing());
  EXPECT_TRUE(eventually([&] { return player.timeS() > 0.3; }));
  keys(*window().controllers().replays.control().panel(), Qt::Key_Space);
  EXPECT_FALSE(player.playing());
  auto* speed = child<QComboBox>("replay_speed");
  Journey::choose(*speed, speed->findData(0.25));
  player.setTime(0);
  player.advance(2);
  EXPECT_DOUBLE_EQ(player.timeS(), 0.5);
  const TouchRecording& recording = *player.recording();
  const auto felt = std::max_element(
      recording.rows.begin(), recording.rows.end(),
      [](const TouchRow& a, const TouchRow& b) { return norm(a.force) < norm(b.force); });
  ASSERT_NE(felt, recording.rows.end());
  const double time = felt->t_s - recording.startS();
  player.setTime(time);
  const Probe once = *probe();
  const double force = forceShown();
  EXPECT_TRUE(once.touching);
  player.setTime(0);
  player.setTime(time);
  EXPECT_EQ(probe()->proxy, once.proxy);
  EXPECT_EQ(probe()->hip, once.hip);
  EXPECT_EQ(forceShown(), force);
  picture("7_replay");
  choose("replay_close", "close replay");
  EXPECT_FALSE(window().controllers().replays.control().showing());
  // The command line repeats it, every bit.
  const auto again = test::runRelievo(
      {"replay", log_.string(), "--verify", "--input", document().file().toStdString()});
  EXPECT_EQ(again.exit_code, 0) << again.err << again.out;
}

/// A SpaceMouse moves the hand, its button the detail, whatever has the focus.
void JourneyTest::steerBySpaceMouse() {
  const std::vector<std::uint8_t> multi_axis{0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0x85,
                                             0x01, 0x75, 0x10, 0x95, 0x03, 0x09, 0x30,
                                             0x09, 0x31, 0x09, 0x32, 0x81, 0x06, 0xc0};
  hid_.plugIn(0, 0x256f, 0xc635, "SpaceMouse Compact", multi_axis);
  ASSERT_TRUE(hears("SpaceMouse Compact connected"));
  if (byKeys()) {
    carryHand(200, 100);
  } else {
    move(detail(), over(200, 100));
  }
  child<QListWidget>("places_list")->setFocus();
  ASSERT_TRUE(eventually([this] { return probe().has_value(); }));
  const double from = probe()->hip.x;
  hid_.hold(0, {1, 0xa2, 0xfe, 0, 0, 0, 0});  // Full deflection to the left.
  EXPECT_TRUE(eventually([&] { return probe()->hip.x < from - 5; }));
  hid_.send(0, {1, 0, 0, 0, 0, 0, 0});
  // Without a window manager the window itself need not be the active one.
  EXPECT_EQ(window().focusWidget(), child<QListWidget>("places_list"));
  const int before = document().detail();
  hid_.send(0, {3, 2, 0});
  hid_.send(0, {3, 0, 0});
  EXPECT_TRUE(eventually([&] { return document().detail() == before + 1; })) << "its button";
  picture("8_space_mouse");
  auto* moves = child<QComboBox>("spaceMouse");
  moves->setCurrentIndex(1);
  hid_.hold(0, {2, 0x5e, 0x01, 0, 0, 0x5e, 0x01});  // Its top toward the user, and twisted right.
  EXPECT_TRUE(eventually([this] { return document().project().azimuth_deg > 10; }));
  EXPECT_GT(document().project().elevation_deg, 5);
  hid_.send(0, {2, 0, 0, 0, 0, 0, 0});
  picture("8_space_mouse_turned");
  moves->setCurrentIndex(0);
  window().detailView().straighten();
  hid_.unplug(0);
  EXPECT_TRUE(hears("SpaceMouse")) << "is missed";
  for (int i = 0; i < 3; ++i) shortcut(Qt::Key_Z);  // Straightened, turned, finer.
  EXPECT_EQ(document().detail(), before);
  EXPECT_FALSE(detail().isTurned());
}

void JourneyTest::keepWork() {
  choose("name_place", "add bookmark");
  ASSERT_EQ(window().findChild<PlacesPanel*>()->places().size(), 1U);
  auto* editor = child<QListWidget>("places_list")->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClicks(editor, "the step");
  keys(*editor, Qt::Key_Return);
  QApplication::processEvents();  // The list takes the name later.
  const Region region = document().project().region;
  window().saveProject(path("F.relievo.json"));
  document().region().whole();
  window().open(path("F.relievo.json"));
  ASSERT_TRUE(eventually(
      [&] { return !document().loader().busy() && document().project().region == region; }));
  EXPECT_EQ(window().findChild<PlacesPanel*>()->places()[0].name, "the step");
  EXPECT_EQ(measure().measurements().size(), 3U);
  EXPECT_EQ(detail().sceneState().look.kind, ReliefKind::multi_hillshade);
  EXPECT_EQ(detail().sceneState().light.elevation_deg, 30);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  picture("9_again");
}

void JourneyTest::makeFigure() {
  shortcut(Qt::Key_E);
  auto* dialog = window().findChild<FigureDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* caption = dialog->findChild<QPlainTextEdit*>("figure_caption");
  ASSERT_TRUE(eventually([&] { return !caption->toPlainText().isEmpty(); }));
  EXPECT_TRUE(caption->toPlainText().contains("Hillshade of four lights 30"))
      << caption->toPlainText().toStdString();
  auto* file = dialog->findChild<QLineEdit*>("figure_file");
  file->setText(path("fig.png"));
  auto* save = dialog->findChild<QPushButton*>("figure_save");
  if (byKeys()) {
    save->setFocus(Qt::TabFocusReason);
    keys(*save, Qt::Key_Space);
  } else {
    QTest::mouseClick(save, Qt::LeftButton);
  }
  ASSERT_TRUE(eventually([&] { return QFile::exists(path("fig.png")); }));
  ASSERT_TRUE(eventually([&] { return save->isEnabled() || !dialog->isVisible(); }));
  dialog->close();
  // The command line makes the same pixels, without this window's screen.
  const auto again = test::runRelievo({"figure", "--from-image", path("fig.png").toStdString(),
                                       "-o", path("again.png").toStdString()},
                                      {"DISPLAY"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(QImage(path("fig.png")), QImage(path("again.png")));
  EXPECT_EQ(QImage(path("fig.png")).width(), 2126) << "180 mm at 300 dots per inch";
}

void JourneyTest::meetBrokenFile() {
  const auto surface = document().surface();
  window().open(QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/relief_f_truncated.ply"));
  ASSERT_TRUE(eventually([&] { return !window().message().isEmpty(); }));
  EXPECT_TRUE(window().message().contains("E101")) << window().message().toStdString();
  EXPECT_EQ(document().surface(), surface) << "what was open stays";
  picture("10_broken");
}

TEST_P(JourneyTest, FromAScanToAFigureAndBack) {
  using Step = void (JourneyTest::*)();
  for (const Step step :
       {&JourneyTest::openScan, &JourneyTest::touch, &JourneyTest::drawWindow,
        &JourneyTest::changeDetail, &JourneyTest::seeRelief, &JourneyTest::measureStep,
        &JourneyTest::measureByTouch, &JourneyTest::recordStroke, &JourneyTest::seeReplay,
        &JourneyTest::steerBySpaceMouse, &JourneyTest::keepWork, &JourneyTest::makeFigure,
        &JourneyTest::meetBrokenFile}) {
    (this->*step)();
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Hands, JourneyTest, ::testing::Values(By::mouse, By::keys),
                         [](const auto& hand) {
                           return std::string(hand.param == By::keys ? "Keys" : "Mouse");
                         });

}  // namespace
}  // namespace relievo
