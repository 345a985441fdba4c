// SPDX-License-Identifier: BSD-3-Clause
// A researcher with a mouse, or with a keyboard alone, from a scan to a figure and back: window,
// host, haptics plugin and command line as they are built. RELIEVO_JOURNEY_PICTURES=FOLDER keeps a
// picture of the window at each step.
#include <QAction>
#include <QApplication>
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

#include "app/host.h"
#include "app/plugin_loader.h"
#include "data/generate/relief_f.h"
#include "tests/app/command.h"
#include "tests/ui/gui_fixture.h"
#include "ui/figure_dialog.h"
#include "ui/measure_panel.h"
#include "ui/places_panel.h"

namespace relievo {
namespace {

enum class By { mouse, keys };

class JourneyTest : public GuiTest, public ::testing::WithParamInterface<By> {
 protected:
  void SetUp() override {
    window().resize(1200, 800);
    host_ = std::make_unique<WindowHost>(window());
    plugins_ = std::make_unique<PluginLoader>(*host_, window().settings());
    plugins_->load();
    ASSERT_TRUE(plugins_->has("haptics")) << plugins_->problems().join(' ').toStdString();
    ASSERT_TRUE(QFile::copy(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply", path("F.ply")));
  }
  void TearDown() override { plugins_->detachAll(); }

  bool byKeys() const { return GetParam() == By::keys; }
  DetailView& detail() { return window().detailView(); }
  ReferenceView& reference() { return window().referenceView(); }
  MeasurePanel& measure() { return *window().findChild<MeasurePanel*>(); }
  void picture(const char* step) {
    const QByteArray folder = qgetenv("RELIEVO_JOURNEY_PICTURES");
    if (folder.isEmpty()) return;
    QApplication::processEvents();
    window().grab().save(QStringLiteral("%1/%2-%3.png")
                             .arg(QString::fromLocal8Bit(folder),
                                  byKeys() ? QStringLiteral("keys") : QStringLiteral("mouse"),
                                  QString::fromLatin1(step)));
  }
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
  /// Point of the untilted detail view over a place.
  QPointF over(double x_mm, double y_mm) {
    const Region& r = document().state().region;
    const double mm = r.side_mm / std::min(detail().width() - 4, detail().height() - 4);
    return {0.5 * detail().width() + (x_mm - r.centreX()) / mm,
            0.5 * detail().height() - (y_mm - r.centreY()) / mm};
  }
  /// Moves the hand by arrows to within half a cell of a place of the window.
  void handByKeys(double x_mm, double y_mm) {
    const double cell = document().window()->spacingMm();
    keys(detail(), Qt::Key_Right);  // A hand that was elsewhere comes into this window.
    for (const bool along_x : {true, false}) {
      const auto from = detail().hand();
      ASSERT_TRUE(from);
      const int cells =
          static_cast<int>(std::lround((along_x ? x_mm - from->x : y_mm - from->y) / cell));
      const int key = along_x ? (cells > 0 ? Qt::Key_Right : Qt::Key_Left)
                              : (cells > 0 ? Qt::Key_Up : Qt::Key_Down);
      keys(detail(), key, std::abs(cells) / 10, Qt::ShiftModifier);
      keys(detail(), key, std::abs(cells) % 10);
    }
    EXPECT_NEAR(detail().hand()->x, x_mm, cell);
    EXPECT_NEAR(detail().hand()->y, y_mm, cell);
  }
  void pick(double x_mm, double y_mm) {
    if (byKeys()) {
      handByKeys(x_mm, y_mm);
      keys(detail(), Qt::Key_Return);
    } else {
      press(detail(), over(x_mm, y_mm));
    }
  }
  double forceShown() {
    const QString text = child<QLabel>("status_force")->text();
    return text.endsWith("N") ? text.section('/', 0, 0).toDouble() : 0;
  }

  std::unique_ptr<WindowHost> host_;
  std::unique_ptr<PluginLoader> plugins_;

 public:  // Named by the test below.
  void openScan();
  void touch();
  void drawWindow();
  void changeDetail();
  void seeRelief();
  void measureStep();
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
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().busy(); }));
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << "nothing stands in the way";
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  EXPECT_EQ(document().state().region, wholeRegion(document().surface()->ladder));
  EXPECT_EQ(document().surface()->holes.size(), 3U);
  picture("1-open");
}

void JourneyTest::touch() {
  detail().setFocus();
  if (byKeys()) {
    handByKeys(90, 100);
  } else {
    move(detail(), over(90, 100));
  }
  keys(detail(), Qt::Key_F5);
  ASSERT_TRUE(waitFor([this] {
    const auto& probe = detail().sceneState().probe;
    return probe && probe->forces_on;
  }));
  if (byKeys()) {
    keys(detail(), Qt::Key_PageDown, 4);
  } else {
    press(detail(), over(90, 100));
  }
  EXPECT_TRUE(waitFor([this] { return forceShown() > 0.1; })) << "pressing in is felt";
  EXPECT_TRUE(waitFor([this] {
    const auto& probe = detail().sceneState().probe;
    return probe && probe->touching && probe->hip.z < probe->proxy.z &&
           std::abs(probe->proxy.z - samples::kReliefFCapHeightMm) < 1;
  })) << "on the dome";
  picture("2-touch");
  keys(detail(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([this] { return !action("forces")->isChecked(); })) << "Escape stops them";
  if (!byKeys()) release(detail(), over(90, 100));
  if (byKeys()) keys(detail(), Qt::Key_PageUp, 4);
}

void JourneyTest::drawWindow() {
  if (byKeys()) {
    keys(detail(), Qt::Key_L, 1, Qt::ControlModifier);
    ASSERT_TRUE(reference().hasFocus());
    keys(reference(), Qt::Key_Space);
    keys(reference(), Qt::Key_Right, 4);
    keys(reference(), Qt::Key_Up, 4);
    picture("3-drawing");
    keys(reference(), Qt::Key_Return);
  } else {
    // Inside the pink window a drag would move it: drawing begins outside.
    document().setRect({20, 20, 60, 60});
    drag(reference(), reference().pointOf(160, 60), reference().pointOf(230, 130));
    picture("3-drawing");
  }
  EXPECT_EQ(document().history().undoText(), "Draw window");
  EXPECT_LT(document().state().region.side_mm, 150);
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
  EXPECT_NEAR(document().state().region.x_mm, 150, 1e-9);
  EXPECT_NEAR(document().state().region.y_mm, 50, 1e-9);
  EXPECT_NEAR(document().state().region.side_mm, 100, 1e-9);
  picture("3-window");
}

void JourneyTest::changeDetail() {
  const Region before = document().state().region;
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
            QStringLiteral("Detail %1 \u2192 %2").arg(detail_before).arg(detail_before - 1));
  for (int i = 0; i < 3; ++i) shortcut(Qt::Key_Z);
  EXPECT_EQ(document().state().region, before);
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
  picture("4-relief");
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
  measure().writeProfile(path("step.csv"));
  measure().writeProfile(path("step.svg"));
  EXPECT_GT(QFile(path("step.csv")).size(), 100);
  EXPECT_GT(QFile(path("step.svg")).size(), 100);
  picture("5-measure");
}

void JourneyTest::keepWork() {
  choose("name_place", "name this");
  ASSERT_EQ(window().findChild<PlacesPanel*>()->places().size(), 1U);
  auto* editor = child<QListWidget>("places_list")->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClicks(editor, "the step");
  keys(*editor, Qt::Key_Return);
  QApplication::processEvents();  // The list takes the name later.
  const Region region = document().state().region;
  window().saveProject(path("F.relievo.json"));
  document().whole();
  window().open(path("F.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return !document().busy() && document().state().region == region; }));
  EXPECT_EQ(window().findChild<PlacesPanel*>()->places()[0].name, "the step");
  EXPECT_EQ(measure().measurements().size(), 2U);
  EXPECT_EQ(detail().sceneState().look.kind, ReliefKind::multi_hillshade);
  EXPECT_EQ(detail().sceneState().light.elevation_deg, 30);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  picture("6-again");
}

void JourneyTest::makeFigure() {
  shortcut(Qt::Key_E);
  auto* dialog = window().findChild<FigureDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* caption = dialog->findChild<QPlainTextEdit*>("figure_caption");
  ASSERT_TRUE(waitFor([&] { return !caption->toPlainText().isEmpty(); }));
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
  ASSERT_TRUE(waitFor([&] { return QFile::exists(path("fig.png")); }));
  ASSERT_TRUE(waitFor([&] { return save->isEnabled() || !dialog->isVisible(); }));
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
  ASSERT_TRUE(waitFor([&] { return !window().message().isEmpty(); }));
  EXPECT_TRUE(window().message().contains("E101")) << window().message().toStdString();
  EXPECT_EQ(document().surface(), surface) << "what was open stays";
  picture("7-broken");
}

TEST_P(JourneyTest, FromAScanToAFigureAndBack) {
  using Step = void (JourneyTest::*)();
  for (const Step step :
       {&JourneyTest::openScan, &JourneyTest::touch, &JourneyTest::drawWindow,
        &JourneyTest::changeDetail, &JourneyTest::seeRelief, &JourneyTest::measureStep,
        &JourneyTest::keepWork, &JourneyTest::makeFigure, &JourneyTest::meetBrokenFile}) {
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
