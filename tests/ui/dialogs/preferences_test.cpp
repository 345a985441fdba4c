// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QStyleFactory>
#include <QStyleOption>
#include <QtTest/QTest>

#include "core/relief/stereo.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/panels/stereo_panel.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

class PreferencesTest : public GuiTest {
 protected:
  ~PreferencesTest() override {
    applyTextSize(100);
    setSizeUnit({});
  }
  PreferencesDialog& openDialog() {
    QTest::keyClick(&window(), Qt::Key_Comma, Qt::ControlModifier);
    return *window().findChild<PreferencesDialog*>();
  }
};

TEST_F(PreferencesTest, EverySettingHasANameAnExplanationAndIsReachedByTab) {
  PreferencesDialog& dialog = openDialog();
  int settings = 0;
  for (auto* field : dialog.findChildren<QWidget*>()) {
    if (!field->objectName().startsWith("pref_")) continue;
    ++settings;
    EXPECT_FALSE(field->accessibleName().isEmpty()) << field->objectName().toStdString();
    EXPECT_FALSE(field->toolTip().isEmpty()) << field->objectName().toStdString();
    const QWidget* focus = field->focusProxy() != nullptr ? field->focusProxy() : field;
    EXPECT_NE(focus->focusPolicy() & Qt::TabFocus, 0) << field->objectName().toStdString();
  }
  EXPECT_GE(settings, 11);
}

TEST_F(PreferencesTest, DialogsStayOnTheScreenAtTheLargestText) {
  openRelief();
  applyTextSize(kMostTextPercent);
  const QSize screen = window().screen()->availableGeometry().size();
  for (const char* command : {"preferences", "keys", "search_commands", "figure", "depth_map"}) {
    ASSERT_TRUE(window().runCommand(QString::fromLatin1(command))) << command;
    QDialog* dialog = nullptr;
    for (auto* one : window().findChildren<QDialog*>()) {
      if (one->isVisible()) dialog = one;
    }
    ASSERT_NE(dialog, nullptr) << command;
    EXPECT_EQ(dialog->size().boundedTo(screen), dialog->size()) << command;
    dialog->close();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_F(PreferencesTest, WordsFindASettingOnAnyPage) {
  PreferencesDialog& dialog = openDialog();
  auto* words = dialog.findChild<QLineEdit*>("preferences_words");
  auto* pages = dialog.findChild<QListWidget*>("preferences_pages");
  QStringList said;
  QObject::connect(&dialog, &PreferencesDialog::said,
                   [&said](const QString& text) { said << text; });
  QTest::keyClicks(words, "red filter");
  EXPECT_TRUE(dialog.findChild<QCheckBox*>("pref_stereo_swap")->isVisible());
  EXPECT_FALSE(dialog.findChild<QComboBox*>("pref_stereo_kind")->isVisible());
  EXPECT_TRUE(pages->item(0)->isHidden());
  EXPECT_TRUE(waitFor([&] { return !said.isEmpty(); }));
  EXPECT_EQ(said, QStringList{"Settings found: 1"}) << "once, not with every letter";
  const QRect place = pages->geometry();
  words->setText("nothing of the kind");
  QApplication::processEvents();
  EXPECT_EQ(pages->x(), place.x()) << "the list of pages stays where it is";
  EXPECT_EQ(pages->width(), place.width());
  for (int i = 0; i < pages->count(); ++i) EXPECT_TRUE(pages->item(i)->isHidden());
  EXPECT_TRUE(waitFor([&] { return said.size() == 2; }));
  EXPECT_EQ(said.back(), "No setting has these words.");
  words->clear();
  for (int i = 0; i < pages->count(); ++i) EXPECT_FALSE(pages->item(i)->isHidden());
}

TEST_F(PreferencesTest, TextGrowsAtOnceAndStaysSoAtTheNextStart) {
  openRelief();
  const double before = window().font().pointSizeF();
  openDialog().findChild<QDoubleSpinBox*>("pref_text_percent")->setValue(200);
  EXPECT_NEAR(child<QLabel>("reference_note")->font().pointSizeF(), 2 * before, 0.1);
  applyTextSize(100);
  restart();
  EXPECT_NEAR(QApplication::font().pointSizeF(), 2 * before, 0.1);
  PreferencesDialog& dialog = openDialog();
  QTest::mouseClick(dialog.findChild<QPushButton*>("preferences_reset"), Qt::LeftButton);
  EXPECT_NEAR(QApplication::font().pointSizeF(), before, 0.1);
}

TEST_F(PreferencesTest, MarksGrowWithTheTextAndAreFusionsOwnAtFirst) {
  const QStyle& style = *QApplication::style();
  const QScopedPointer<QStyle> fusion(QStyleFactory::create("Fusion"));
  QComboBox combo;
  QStyleOptionComboBox option;
  option.initFrom(&combo);
  option.rect = QRect(0, 0, 300, 60);
  const auto arrow = [&] {
    return style.subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxArrow, &combo)
        .width();
  };
  const int arrow_before = arrow();
  for (const QStyle::PixelMetric mark : {QStyle::PM_IndicatorWidth, QStyle::PM_ButtonIconSize,
                                         QStyle::PM_SliderLength, QStyle::PM_SmallIconSize}) {
    EXPECT_EQ(style.pixelMetric(mark), fusion->pixelMetric(mark)) << mark;
  }
  applyTextSize(300);
  for (const QStyle::PixelMetric mark : {QStyle::PM_IndicatorWidth, QStyle::PM_ButtonIconSize,
                                         QStyle::PM_SliderLength, QStyle::PM_SmallIconSize}) {
    EXPECT_NEAR(style.pixelMetric(mark), 3 * fusion->pixelMetric(mark), 2) << mark;
  }
  EXPECT_NEAR(arrow(), 3 * arrow_before, 3);
}

TEST_F(PreferencesTest, TheScaleBarOfAViewGrowsWithTheText) {
  window().resize(1440, 900);  // In a small view the bar gets shorter as its words grow.
  openRelief();
  const auto light = [this] {  // Pixels of the bar and its words.
    const QImage shot = window().detailView().shot().convertToFormat(QImage::Format_RGB32);
    int count = 0;
    for (int y = shot.height() * 3 / 4; y < shot.height(); ++y) {
      for (int x = 0; x < shot.width() / 2; ++x) count += shot.pixel(x, y) == qRgb(245, 245, 245);
    }
    return count;
  };
  const int before = light();
  ASSERT_GT(before, 20);
  applyTextSize(200);
  EXPECT_TRUE(waitFor([&] { return light() > 1.7 * before; })) << before << " then " << light();
}

TEST_F(PreferencesTest, AnOpenDialogGrowsWithItsText) {
  PreferencesDialog& dialog = openDialog();
  const QSize before = dialog.size();
  auto* pages = dialog.findChild<QListWidget*>("preferences_pages");
  dialog.findChild<QDoubleSpinBox*>("pref_text_percent")->setValue(150);
  ASSERT_TRUE(waitFor([&] { return dialog.width() > 1.3 * before.width(); }));
  EXPECT_GT(dialog.height(), 1.3 * before.height());
  QApplication::processEvents();
  EXPECT_GE(pages->viewport()->width(), pages->sizeHintForColumn(0)) << "page names are not cut";
}

TEST_F(PreferencesTest, LargeTextHidesNoFieldOfTheStatusAndNoCommandOfTheTools) {
  window().resize(1440, 900);
  openRelief();
  const int row = child<QLabel>("status_message")->height();
  applyTextSize(300);
  window().resize(1439, 900);
  QApplication::processEvents();
  ASSERT_TRUE(waitFor([&] { return child<QLabel>("status_message")->height() > 2 * row; }));
  for (const char* name : {"status_position", "status_kind_of_surface", "status_detail"}) {
    auto* field = child<QLabel>(name);
    EXPECT_TRUE(waitFor([field] {
      return field->isHidden() || field->width() >= field->sizeHint().width();
    })) << name;
  }
  EXPECT_TRUE(waitFor([this] { return child<QLabel>("status_message")->width() > 400; }));
  const auto* more = child<QWidget>("tools")->findChild<QWidget*>("qt_toolbar_ext_button");
  ASSERT_NE(more, nullptr);
  EXPECT_TRUE(waitFor([more] { return !more->isVisible(); }))
      << "commands behind the tool bar's end";
  EXPECT_TRUE(child<QLabel>("detail_note")->isVisible());
}

/// WCAG 2.1's contrast of two colours, 1 .. 21.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& c) {
    const auto linear = [](double v) {
      return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
  };
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

TEST_F(PreferencesTest, FramesOfFieldsAndBoxesAreSeenInEveryPalette) {
  for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
    applyTheme(*qApp, theme);
    QCheckBox check;
    QRadioButton radio;
    QLineEdit line;
    QComboBox combo;
    QDoubleSpinBox spin;
    for (QWidget* field : std::initializer_list<QWidget*>{&check, &radio, &line, &combo, &spin}) {
      field->resize(120, 40);
      const QImage seen = field->grab().toImage();
      double most = 0;  // Of the outline, somewhere in the first pixels of the middle row.
      for (int x = 0; x < 4; ++x) {
        most = std::max(most, contrast(seen.pixelColor(x, 20), currentColours().window));
      }
      EXPECT_GE(most, 3) << field->metaObject()->className() << " in theme "
                         << static_cast<int>(theme);
    }
  }
  applyTheme(*qApp, Theme::light);
}

TEST_F(PreferencesTest, PaletteUnitsAndStereoFollowTheirSettings) {
  openRelief();
  PreferencesDialog& dialog = openDialog();
  dialog.findChild<QComboBox*>("pref_theme")->setCurrentIndex(3);
  EXPECT_EQ(QApplication::palette().color(QPalette::Window), QColor(Qt::black));
  EXPECT_TRUE(child<QLabel>("reference_note")->text().endsWith("mm"));
  dialog.findChild<QComboBox*>("pref_size_unit")->setCurrentIndex(2);
  EXPECT_TRUE(child<QLabel>("reference_note")->text().endsWith("cm"))
      << child<QLabel>("reference_note")->text().toStdString();
  dialog.findChild<QComboBox*>("pref_stereo_kind")->setCurrentIndex(2);
  dialog.findChild<QCheckBox*>("pref_stereo_swap")->setChecked(true);
  window().runCommand("stereo");
  EXPECT_EQ(window().detailView().sceneState().stereo.mode, StereoMode::dubois);
  EXPECT_TRUE(window().detailView().sceneState().stereo.swap_eyes);
}

TEST_F(PreferencesTest, TheKindOfRecordingIsChosenHereOrInTheMenuAndKept) {
  EXPECT_EQ(window().controllers().replays.ending(), "csv");
  EXPECT_TRUE(action("record_csv")->isChecked());
  PreferencesDialog& dialog = openDialog();
  auto* kind = dialog.findChild<QComboBox*>("pref_recording_kind");
  ASSERT_NE(kind, nullptr);
  kind->setCurrentIndex(1);
  EXPECT_EQ(window().controllers().replays.ending(), "h5");
  EXPECT_TRUE(action("record_h5")->isChecked());
  restart();
  EXPECT_EQ(window().controllers().replays.ending(), "h5");
  EXPECT_TRUE(action("record_h5")->isChecked());
  action("record_csv")->trigger();
  EXPECT_EQ(window().controllers().replays.ending(), "csv");
  EXPECT_EQ(openDialog().findChild<QComboBox*>("pref_recording_kind")->currentIndex(), 0);
}

TEST_F(PreferencesTest, TheFolderOfRecordingsIsAskedForAfterTheFirstAndKept) {
  qputenv("HOME", path("home").toLocal8Bit());
  const QString usual = path("home/Documents/relievo");
  EXPECT_EQ(window().controllers().replays.folder(), usual);
  openRelief();
  window().controllers().replays.noteRecording(writeRelief("first.csv"));
  EXPECT_TRUE(window().message().contains("Recordings are kept in " + usual))
      << window().message().toStdString();
  auto* strip = child<MessageStrip>("message_strip");
  ASSERT_TRUE(strip->triggerDefaultAction());
  auto* dialog = child<QFileDialog>("recording_folder_dialog");
  ASSERT_NE(dialog, nullptr);
  QDir().mkpath(path("survey"));
  Q_EMIT dialog->fileSelected(path("survey"));
  EXPECT_EQ(window().controllers().replays.folder(), path("survey"));
  restart();
  EXPECT_EQ(window().controllers().replays.folder(), path("survey"));
  openRelief();
  window().controllers().replays.noteRecording(writeRelief("second.csv"));
  EXPECT_EQ(window().message(), "") << "once";
  auto* field = openDialog().findChild<QLineEdit*>("pref_recording_folder_path");
  ASSERT_NE(field, nullptr);
  EXPECT_EQ(field->text(), path("survey"));
  field->clear();
  Q_EMIT field->editingFinished();
  EXPECT_EQ(window().controllers().replays.folder(), usual);
}

TEST_F(PreferencesTest, AFaultThatIsToldIsNotHiddenByTheQuestionForAFolder) {
  openRelief();
  window().messages().showError("The recording may be incomplete.", "E401");
  window().controllers().replays.noteRecording(writeRelief("first.csv"));
  EXPECT_TRUE(window().message().contains("E401")) << window().message().toStdString();
}

TEST_F(PreferencesTest, AUnitForFilesWithoutOneIsNotAskedFor) {
  openDialog().findChild<QComboBox*>("pref_unit_without")->setCurrentIndex(2);  // Centimetres.
  window().open(writeRelief());
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(document().surface()->unit, LengthUnit::cm);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
}

TEST_F(PreferencesTest, AChoiceThatOthersShareIsReadAndWrittenWhereTheyDo) {
  QVariant shared;
  Settings& settings = window().settings();
  settings.setChoice("falcon_firmware", "/chosen/before.bin");
  const Settings::Elsewhere place{[&shared] { return shared; },
                                  [&shared](const QVariant& value) { shared = value; }};
  settings.keepElsewhere("falcon_firmware", place);
  EXPECT_EQ(shared.toString(), "/chosen/before.bin") << "carried over once";
  shared = "/by/the/set-up.bin";
  settings.keepElsewhere("falcon_firmware", place);
  EXPECT_EQ(shared.toString(), "/by/the/set-up.bin");
  auto* path = openDialog().findChild<QLineEdit*>("pref_falcon_firmware_path");
  EXPECT_EQ(path->text(), "/by/the/set-up.bin");
  path->setText("/by/preference.bin");
  Q_EMIT path->editingFinished();
  EXPECT_EQ(shared.toString(), "/by/preference.bin");
}

TEST_F(PreferencesTest, PlugInsForDevicesAreAllowedAndTakenBackHere) {
  std::map<QString, bool> may{{"/own/mine.so", false}, {"/given/theirs.so", true}};
  QString refusal;
  window().settings().keepDeviceTrust(
      {[&may] {
         std::vector<DevicePluginRow> rows;
         rows.push_back({"theirs", "/given/theirs.so", {}, true, false});
         rows.push_back({"mine", "/own/mine.so", {}, may.at("/own/mine.so"), true});
         rows.push_back({"open", "/own/open.so", "Others may change it.", false, false});
         return rows;
       },
       [&may, &refusal](const QString& file, bool allowed) {
         if (refusal.isEmpty()) may.at(file) = allowed;
         return refusal;
       },
       "/own"});
  PreferencesDialog& dialog = openDialog();
  const auto box = [&dialog](const char* name) {
    return dialog.findChild<QCheckBox*>(QLatin1String("device_plugin_") + QLatin1String(name));
  };
  ASSERT_TRUE(waitFor([&] { return box("open") != nullptr; }));
  EXPECT_TRUE(box("theirs")->isChecked());
  EXPECT_FALSE(box("theirs")->isEnabled()) << "its folder is trusted";
  EXPECT_FALSE(box("open")->isEnabled());
  EXPECT_EQ(box("open")->accessibleDescription(), "Others may change it.");
  EXPECT_EQ(box("mine")->accessibleName(), "mine may run");
  EXPECT_FALSE(box("mine")->isChecked());
  QCheckBox* const mine = box("mine");
  mine->setFocus();
  mine->click();
  ASSERT_TRUE(waitFor([&] { return may.at("/own/mine.so"); }));
  ASSERT_TRUE(waitFor([&] {
    return child<QLabel>("status_message")->text().contains("mine may run from now on");
  })) << child<QLabel>("status_message")->text().toStdString();
  EXPECT_EQ(box("mine"), mine) << "the one that was pressed is there still";
  dialog.findChild<QListWidget*>("preferences_pages")->setCurrentRow(4);
  dialog.findChild<QPushButton*>("preferences_reset")->click();
  EXPECT_TRUE(waitFor([&] { return !may.at("/own/mine.so"); })) << "as at first";
  refusal = "The disk is full.";
  mine->click();
  EXPECT_TRUE(waitFor([&] { return !mine->isChecked(); })) << "it shows what is so";
  EXPECT_TRUE(waitFor(
      [&] { return child<QLabel>("status_message")->text().contains("The disk is full."); }));
}

TEST_F(PreferencesTest, TheMeterSaysTheParallaxAndTheLimitKeepsIt) {
  StereoPanel panel;
  panel.setComfort(false);
  panel.setShown({0, 20, 1});
  panel.setOn(true);
  auto* angle = panel.findChild<QDoubleSpinBox*>("eye_angle");
  angle->setValue(4);
  auto* meter = panel.findChild<QProgressBar*>("parallax_meter");
  // 10 mm from the plane, 4 degrees: 0.698 mm on the screen, 0.067 degrees from 60 cm.
  EXPECT_TRUE(meter->format().startsWith("0.1")) << meter->format().toStdString();
  panel.setShown({0, 20, 30});  // Thirty times larger on the screen: 2 degrees.
  EXPECT_TRUE(meter->format().startsWith("2.0")) << meter->format().toStdString();
  panel.setComfort(true);
  EXPECT_TRUE(meter->format().startsWith("1.0")) << meter->format().toStdString();
  EXPECT_NEAR(panel.options().eye_angle_deg, 2, 0.05);
  EXPECT_EQ(angle->value(), 4) << "the choice stays for where it fits";
}

TEST_F(PreferencesTest, AutomaticDepthFillsTheComfortableRangeOfWhateverIsShown) {
  StereoPanel panel;
  panel.setOn(true);
  auto* meter = panel.findChild<QProgressBar*>("parallax_meter");
  for (const StereoPanel::Shown& shown : {StereoPanel::Shown{0, 3, 10}, {40, 80, 1}, {-1, 1, 30}}) {
    panel.setShown(shown);
    EXPECT_EQ(meter->format(), QString::fromUtf8("1.0\u00b0 of 1.0\u00b0, automatic"));
    const StereoOptions drawn = panel.options();
    EXPECT_TRUE(drawn.automatic_depth);
    const double half = 0.5 * (shown.high_mm - shown.low_mm);
    EXPECT_NEAR(parallax(half, drawn.eye_angle_deg, shown.screen_per_mm, 600).visual_deg, 1, 1e-6);
  }
  // The reference view shows other heights at another scale: it gets an angle of its own.
  EXPECT_NEAR(parallax(10, panel.optionsFor({0, 20, 2}).eye_angle_deg, 2, 600).visual_deg, 1, 1e-6);
  panel.setShown({0, 0.1, 1});  // Nothing could fill the range without hiding its flanks.
  EXPECT_EQ(panel.options().eye_angle_deg, kMostEyeAngleDeg);
  EXPECT_TRUE(meter->format().startsWith("0.0")) << meter->format().toStdString();
  panel.findChild<QDoubleSpinBox*>("eye_angle")->setValue(5);
  EXPECT_FALSE(panel.options().automatic_depth) << "a value of one's own ends it";
  EXPECT_EQ(panel.options().eye_angle_deg, 5);
  EXPECT_FALSE(meter->format().contains("automatic"));
}

TEST_F(PreferencesTest, TheGlassesPictureShowsEachEyeItsLetter) {
  GlassesDialog plain(false, nullptr), swapped(true, nullptr);
  const auto colours = [](const GlassesDialog& dialog) {
    const QImage image =
        dialog.findChild<QWidget*>(QString(), Qt::FindDirectChildrenOnly)->grab().toImage();
    std::array<std::array<int, 2>, 2> counts{};  // Half, red or cyan.
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        const auto half = static_cast<std::size_t>(x >= image.width() / 2 ? 1 : 0);
        if (c.red() > 200 && c.green() < 50) ++counts[half][0];
        if (c.red() < 50 && c.green() > 200) ++counts[half][1];
      }
    }
    return counts;
  };
  EXPECT_GT(colours(plain)[0][0], 100);
  EXPECT_EQ(colours(plain)[0][1], 0);
  EXPECT_GT(colours(plain)[1][1], 100);
  EXPECT_GT(colours(swapped)[0][1], 100);
}

TEST_F(PreferencesTest, TheScreenMixesEyesAsThePictureDoes) {
  openRelief();
  window().runCommand("relief_height");
  window().runCommand("stereo");
  for (const StereoMode mode :
       {StereoMode::anaglyph, StereoMode::half_colour, StereoMode::dubois}) {
    child<QComboBox>("stereo_kind")->setCurrentIndex(static_cast<int>(mode) - 1);
    const QImage shot = window().detailView().shot().convertToFormat(QImage::Format_RGB888);
    window().saveImage(ImageSource::detail, shot.size(), path("drawn.png"));
    ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
    const QImage drawn = QImage(path("drawn.png")).convertToFormat(QImage::Format_RGB888);
    ASSERT_EQ(drawn.size(), shot.size());
    double difference = 0;
    for (int y = 0; y < shot.height(); ++y) {
      for (int x = 0; x < 3 * shot.width(); ++x) {
        difference += std::abs(shot.constScanLine(y)[x] - drawn.constScanLine(y)[x]);
      }
    }
    difference /= 3.0 * shot.width() * shot.height();
    EXPECT_LT(difference, 3) << name(mode).data();
  }
}

}  // namespace
}  // namespace relievo
