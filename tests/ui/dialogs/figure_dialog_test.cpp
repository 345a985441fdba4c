// SPDX-License-Identifier: BSD-3-Clause
// The figure dialog offers what `relievo figure` does: the same record, the same files.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QtTest/QTest>
#include <set>
#include <thread>

#include "core/base/error.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/dialogs/figure/figure_preview.h"
#include "ui/figure/figure.h"

namespace relievo {
namespace {

QByteArray bytesOf(const QString& name) {
  QFile file(name);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
  return file.readAll();
}

class FigureDialogTest : public GuiTest {
 protected:
  void SetUp() override { openRelief(); }

  FigureDialog& openDialog() {
    EXPECT_TRUE(window().runCommand("figure"));
    dialog_ = window().findChildren<FigureDialog*>().last();
    QApplication::setActiveWindow(dialog_);
    EXPECT_TRUE(waitFor([this] { return !caption().isEmpty(); }));
    return *dialog_;
  }
  template <class Widget>
  Widget& the(const char* name) const {
    auto* widget = dialog_->findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(widget, nullptr) << name;
    return *widget;
  }
  QString caption() const { return the<QPlainTextEdit>("figure_caption").toPlainText(); }
  QString problem() const {
    const auto& label = the<QLabel>("figure_problem");
    return label.isVisible() ? label.text() : QString();
  }
  void choose(const char* name, int index) {
    auto& box = the<QComboBox>(name);
    box.setFocus();
    for (int i = 0; i < box.count(); ++i) QTest::keyClick(&box, Qt::Key_Up);
    for (int i = 0; i < index; ++i) QTest::keyClick(&box, Qt::Key_Down);
    EXPECT_EQ(box.currentIndex(), index) << name;
  }
  void tick(const char* name, bool on) {
    auto& box = the<QCheckBox>(name);
    EXPECT_TRUE(box.isEnabled()) << name;
    if (box.isChecked() != on) QTest::keyClick(&box, Qt::Key_Space);
    EXPECT_EQ(box.isChecked(), on) << name;
  }
  void type(const char* name, const QString& words) {
    auto& field = the<QWidget>(name);
    EXPECT_TRUE(field.isEnabled()) << name;
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, words);
    QTest::keyClick(&field, Qt::Key_Tab);
  }
  void saveInto(const QString& folder) {
    QDir().mkpath(path(folder));
    type("figure_file", path(folder + "/f.png"));
    auto& save = the<QPushButton>("figure_save");
    ASSERT_TRUE(waitFor([&] { return save.isEnabled(); }));
    QTest::mouseClick(&save, Qt::LeftButton);
    ASSERT_TRUE(waitFor([this] { return !dialog_->isVisible(); })) << problem().toStdString();
  }
  /// Writes by the function that the command line calls; not on the window's thread.
  void writeElsewhere(const FigureRequest& request, FigureFiles files) {
    Project project = window().project();
    project.figure = request;
    QDir().mkpath(path("other"));
    files.figure = path("other/f.png").toStdString();
    std::thread([&] { writeFigureFiles(*document().surface(), project, files); }).join();
  }
  void expectSame(const std::vector<const char*>& names) {
    EXPECT_EQ(QDir(path("dialog")).entryList(QDir::Files).size(), static_cast<int>(names.size()));
    for (const char* name : names) {
      EXPECT_EQ(bytesOf(path("dialog/") + name), bytesOf(path("other/") + name)) << name;
    }
  }
  static std::string words(const FigureRequest& request) {
    Project project;
    project.figure = request;
    return projectJson(project);
  }

  FigureDialog* dialog_ = nullptr;
};

TEST_F(FigureDialogTest, ColourRangeHeightsAndCaptionAreWrittenAsByTheCommandLine) {
  openDialog();
  choose("figure_layout", static_cast<int>(FigureLayout::detail));
  type("figure_dpi", "60");
  choose("figure_relief", static_cast<int>(ReliefKind::slope));
  tick("figure_range_on", true);
  type("figure_range_low", "5");
  type("figure_range_high", "12.5");
  tick("figure_heights_on", true);
  tick("figure_caption_on", true);
  saveInto("dialog");
  FigureRequest request;
  request.layout = FigureLayout::detail;
  request.dpi = 60;
  request.look.kind = ReliefKind::slope;
  request.look.range = {{5, 12.5}};
  writeElsewhere(request, {.heights = path("other/f-heights.tif").toStdString(),
                           .caption = path("other/f.txt").toStdString()});
  expectSame({"f.png", "f-heights.tif", "f.txt"});
  EXPECT_TRUE(bytesOf(path("dialog/f.txt")).contains("Slope"));
}

TEST_F(FigureDialogTest, ZeroPlaneAndBothEyesAreWrittenAsByTheCommandLine) {
  openDialog();
  choose("figure_layout", static_cast<int>(FigureLayout::detail));
  type("figure_dpi", "60");
  choose("figure_stereo", static_cast<int>(StereoPrint::side_by_side));
  type("figure_eye", "6");
  tick("figure_comfort", false);
  tick("figure_zero_plane_on", true);
  type("figure_zero_plane", "-3.25");
  tick("figure_swap", true);
  tick("figure_both_eyes", true);
  saveInto("dialog");
  FigureRequest request;
  request.layout = FigureLayout::detail;
  request.dpi = 60;
  request.stereo = StereoPrint::side_by_side;
  request.eye_angle_deg = 6;
  request.limit_parallax = false;
  request.zero_plane_mm = -3.25;
  request.swap_eyes = true;
  writeElsewhere(request, {.both_eyes = true});
  expectSame({"f.png", "f.left.png", "f.right.png"});
  EXPECT_NE(bytesOf(path("dialog/f.left.png")), bytesOf(path("dialog/f.right.png")));
}

TEST_F(FigureDialogTest, RadiusScaleAndMarksAreWrittenAsByTheCommandLine) {
  openDialog();
  tick("figure_to_scale", true);
  type("figure_scale", "2.5");
  type("figure_dpi", "50.5");
  choose("figure_relief", static_cast<int>(ReliefKind::local_relief));
  choose("figure_colours", static_cast<int>(ColourMap::batlow));
  type("figure_radius", "4.125");
  tick("figure_letters", false);
  tick("figure_outline", false);
  tick("figure_transparent", true);
  saveInto("dialog");
  FigureRequest request;
  request.scale_1_to = 2.5;
  request.dpi = 50.5;
  request.look = {.kind = ReliefKind::local_relief, .colours = ColourMap::batlow};
  request.look.radius_mm = 4.125;
  request.letters = request.window_outline = false;
  request.transparent = true;
  writeElsewhere(request, {});
  expectSame({"f.png"});
}

TEST_F(FigureDialogTest, TheRecordingIsBrowsedForAndPlottedAsByTheCommandLine) {
  const QString run = path("run.csv");
  QFile csv(run);
  ASSERT_TRUE(csv.open(QIODevice::WriteOnly));
  csv.write("t_s,hip_z_mm,proxy_z_mm,f_x_N,f_y_N,f_z_N\n0,1,1,0,0,0\n1,-1,0,0,0,2\n2,1,1,0,0,0\n");
  csv.close();
  openDialog();
  auto& browse = the<QPushButton>("figure_recording_browse");
  EXPECT_FALSE(browse.isEnabled());
  type("figure_dpi", "60");
  choose("figure_layout", static_cast<int>(FigureLayout::plot));
  ASSERT_TRUE(browse.isEnabled());
  ASSERT_TRUE(waitFor([this] { return problem().contains("needs a recording"); }));
  QTest::keyClick(&browse, Qt::Key_Space);
  auto& files = the<QFileDialog>("figure_recording_dialog");
  EXPECT_EQ(files.fileMode(), QFileDialog::ExistingFile);
  EXPECT_EQ(files.directory(), QDir(path(""))) << "beside the scan";
  files.selectFile(run);
  files.findChild<QLineEdit*>()->setText(run);
  QMetaObject::invokeMethod(&files, "accept");
  EXPECT_EQ(the<QLineEdit>("figure_recording").text(), run);
  ASSERT_TRUE(waitFor([this] { return problem().isEmpty(); }));
  saveInto("dialog");
  FigureRequest request;
  request.layout = FigureLayout::plot;
  request.dpi = 60;
  request.recording = run.toStdString();
  writeElsewhere(request, {});
  expectSame({"f.png"});
}

TEST_F(FigureDialogTest, WhatAProjectKeepsOfAFigureIsShownAgainUntouched) {
  Project project = window().project();
  FigureRequest& f = project.figure;
  f.layout = FigureLayout::detail;
  f.width_mm = 85.123456789;
  f.dpi = 299.5;
  f.look = {.kind = ReliefKind::openness, .colours = ColourMap::cividis};
  f.look.light = {-45, 0};
  f.look.radius_mm = 3.25;
  f.look.range = {{60.5, 90}};
  f.stereo = StereoPrint::dubois;
  f.eye_angle_deg = 0.025;
  f.zero_plane_mm = 7.5;
  f.swap_eyes = true;
  f.measurements = false;
  writeProject(path("kept.relievo.json").toStdString(), project);
  window().open(path("kept.relievo.json"));
  ASSERT_TRUE(waitFor([this] { return window().project().figure.dpi == 299.5; }));
  const FigureRequest stored = window().project().figure;
  EXPECT_EQ(words(openDialog().request()), words(stored));
  EXPECT_EQ(the<QComboBox>("figure_relief").currentIndex(), static_cast<int>(f.look.kind));
  EXPECT_TRUE(the<QCheckBox>("figure_range_on").isChecked());
  EXPECT_EQ(the<QDoubleSpinBox>("figure_range_low").cleanText(), "60.5");
  EXPECT_EQ(the<QDoubleSpinBox>("figure_range_high").cleanText(), "90.0");
  EXPECT_EQ(the<QDoubleSpinBox>("figure_azimuth").value(), 315);
  EXPECT_TRUE(the<QCheckBox>("figure_zero_plane_on").isChecked());
  EXPECT_EQ(the<QDoubleSpinBox>("figure_zero_plane").value(), 7.5);
  dialog_->reject();
  // What was chosen in the dialog stays, too, until the view is painted anew.
  openDialog();
  choose("figure_relief", static_cast<int>(ReliefKind::slope));
  dialog_->reject();
  EXPECT_EQ(openDialog().request().look.kind, ReliefKind::slope);
  dialog_->reject();
  window().runCommand("relief_height");
  EXPECT_EQ(openDialog().request().look.kind, ReliefKind::height);
}

TEST_F(FigureDialogTest, FieldsThatAreOffShowWhatIsDrawnAndStartThere) {
  openDialog();
  choose("figure_relief", static_cast<int>(ReliefKind::height));
  auto& high = the<QDoubleSpinBox>("figure_range_high");
  ASSERT_TRUE(waitFor([&] { return high.suffix() == " mm" && high.value() > 10; }));
  EXPECT_LE(high.value(), 20.001) << "the dome";
  EXPECT_FALSE(dialog_->request().look.range);
  tick("figure_range_on", true);
  ASSERT_TRUE(dialog_->request().look.range);
  EXPECT_EQ((*dialog_->request().look.range)[1], high.value());
  EXPECT_NEAR(the<QDoubleSpinBox>("figure_zero_plane").value(), 10, 0.01) << "mid height";
  choose("figure_relief", static_cast<int>(ReliefKind::slope));
  EXPECT_FALSE(dialog_->request().look.range) << "millimetres are no degrees";
}

TEST_F(FigureDialogTest, ThePreviewGrowsWithTheDialogAndIsDrawnFinerThere) {
  FigureDialog& dialog = openDialog();
  auto& preview = the<FigurePreview>("figure_preview");
  const auto shown = [&] { return preview.pixmap(Qt::ReturnByValue).toImage(); };
  ASSERT_TRUE(waitFor([&] { return !shown().isNull(); }));
  const QSize before = shown().size();
  dialog.resize(1560, 1100);
  QApplication::processEvents();
  EXPECT_GT(shown().width(), before.width() + 100);
  ASSERT_GT(preview.longestPx(), 950) << "more than the first preview has";
  Project project = window().project();
  project.figure = dialog.request();
  Figure figure;
  std::thread([&] {
    figure = previewFigure(*document().surface(), project, preview.longestPx());
  }).join();
  const QImage whole(figure.image.rgba.data(), figure.image.width, figure.image.height,
                     4 * figure.image.width, QImage::Format_RGBA8888_Premultiplied);
  const QImage fitted = QPixmap::fromImage(whole.scaled(preview.size(), Qt::KeepAspectRatio,
                                                        Qt::SmoothTransformation))
                            .toImage();
  EXPECT_TRUE(waitFor([&] { return shown() == fitted; }))
      << shown().width() << " of " << fitted.width() << " pixels";
  dialog.resize(900, 600);
  QApplication::processEvents();
  EXPECT_LT(shown().width(), fitted.width());
}

TEST_F(FigureDialogTest, EveryControlHasANameATooltipAndALetterOfItsOwn) {
  openDialog();
  std::set<QString> names;
  QString letters;
  const auto note = [&](const QString& text) {
    const int at = text.indexOf('&');
    if (at < 0) return;
    EXPECT_FALSE(letters.contains(text[at + 1].toLower())) << text.toStdString();
    letters += text[at + 1].toLower();
  };
  for (const QWidget* w : dialog_->findChildren<QWidget*>()) {
    if (!w->objectName().startsWith("figure_") || w->focusPolicy() == Qt::NoFocus) continue;
    EXPECT_FALSE(w->accessibleName().isEmpty() && w->objectName() != "figure_save")
        << w->objectName().toStdString();
    EXPECT_FALSE(w->toolTip().isEmpty() && w->objectName() != "figure_save")
        << w->objectName().toStdString();
    if (!w->accessibleName().isEmpty()) {
      EXPECT_TRUE(names.insert(w->accessibleName()).second) << w->accessibleName().toStdString();
    }
  }
  for (const auto* button : dialog_->findChildren<QAbstractButton*>()) note(button->text());
  for (const auto* label : dialog_->findChildren<QLabel*>()) {
    if (label->buddy() == nullptr) continue;
    note(label->text());
    EXPECT_EQ(label->buddy()->accessibleName(), label->text().remove('&'));
  }
  EXPECT_GE(letters.size(), 10);
  for (const char* name :
       {"Own ends of the colours", "Colours from", "Colours to", "Own zero plane", "Zero plane",
        "Both eyes as files", "Save heights too", "Heights", "Browse: Heights",
        "Save caption as text", "Caption's file", "Browse: Caption's file", "Browse: Recording"}) {
    EXPECT_EQ(names.count(name), 1U) << name;
  }
}

TEST_F(FigureDialogTest, WhatIsOfNoUseIsOffAndSaysWhy) {
  openDialog();
  const auto off = [this](const char* name, const char* why) {
    const auto& field = the<QWidget>(name);
    EXPECT_FALSE(field.isEnabled()) << name;
    EXPECT_TRUE(field.toolTip().contains(QLatin1String(why)))
        << name << ": " << field.toolTip().toStdString();
  };
  off("figure_range_on", "Shaded reliefs");
  off("figure_range_low", "Shaded reliefs");
  off("figure_radius", "does not depend");
  off("figure_zero_plane_on", "stereo");
  off("figure_recording", "force plots");
  off("figure_recording_browse", "force plots");
  off("figure_heights", "Save heights too");
  off("figure_caption_file", "Save caption as text");
  off("figure_scale", "To scale");
  tick("figure_both_eyes", true);
  EXPECT_TRUE(the<QWidget>("figure_zero_plane_on").isEnabled()) << "the eyes' files have one";
  off("figure_zero_plane", "Own zero plane");
  choose("figure_relief", static_cast<int>(ReliefKind::sky_view));
  EXPECT_TRUE(the<QWidget>("figure_radius").isEnabled());
  EXPECT_FALSE(the<QWidget>("figure_radius").toolTip().contains("does not depend"));
  off("figure_range_low", "Own ends");
  off("figure_azimuth", "lamp");
  choose("figure_stereo", static_cast<int>(StereoPrint::grey));
  off("figure_transparent", "background");
}

TEST_F(FigureDialogTest, ItRefusesWithTheSentencesOfTheCommandLine) {
  openDialog();
  const auto sentence = [](const auto& work) {
    try {
      work();
    } catch (const ArgumentError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was refused");
  };
  const auto refused = [&](const FigureRequest& request) {
    Project project = window().project();
    project.figure = request;
    std::string said;
    std::thread([&] {
      said = sentence([&] { drawFigure(*document().surface(), project); });
    }).join();
    EXPECT_TRUE(waitFor([&] { return problem().toStdString() == said; }))
        << problem().toStdString() << " | " << said;
    EXPECT_FALSE(the<QPushButton>("figure_save").isEnabled());
  };
  FigureRequest request;
  request.look.kind = ReliefKind::height;
  request.look.range = {{9, 2}};
  choose("figure_relief", static_cast<int>(ReliefKind::height));
  tick("figure_range_on", true);
  type("figure_range_low", "9");
  type("figure_range_high", "2");
  refused(request);
  tick("figure_range_on", false);
  request.look.range.reset();
  request.stereo = StereoPrint::grey;
  request.zero_plane_mm = 90000;
  choose("figure_stereo", static_cast<int>(StereoPrint::grey));
  tick("figure_zero_plane_on", true);
  type("figure_zero_plane", "90000");
  refused(request);
  choose("figure_stereo", static_cast<int>(StereoPrint::off));
  tick("figure_zero_plane_on", false);  // Though it is of no use now.

  auto& save = the<QPushButton>("figure_save");
  ASSERT_TRUE(waitFor([&] { return save.isEnabled() && problem().isEmpty(); }));
  type("figure_file", path("f.png"));
  tick("figure_heights_on", true);
  type("figure_heights", path("h.png"));
  QTest::mouseClick(&save, Qt::LeftButton);
  FigureFiles files{.figure = path("f.png").toStdString(), .heights = path("h.png").toStdString()};
  EXPECT_EQ(problem().toStdString(), sentence([&] { check(files); }));
  tick("figure_heights_on", false);
  tick("figure_caption_on", true);
  type("figure_caption_file", path("f.png"));
  QTest::mouseClick(&save, Qt::LeftButton);
  files = {.figure = path("f.png").toStdString(), .caption = path("f.png").toStdString()};
  EXPECT_EQ(problem().toStdString(), sentence([&] { check(files); }));
  EXPECT_FALSE(QFile::exists(path("f.png")));
}

TEST_F(FigureDialogTest, WhyNothingWasSavedStaysWhateverIsDrawnMeanwhileAndIsAnnounced) {
  FigureDialog& dialog = openDialog();
  auto& file = the<QLineEdit>("figure_file");
  EXPECT_EQ(file.selectedText(), file.text()) << "a name that is typed takes its place";
  auto& preview = the<FigurePreview>("figure_preview");
  const auto shown = [&] { return preview.pixmap(Qt::ReturnByValue).toImage(); };
  ASSERT_TRUE(waitFor([&] { return !shown().isNull(); }));
  type("figure_file", path("no/such/f.png"));
  QTest::keyClick(&file, Qt::Key_Return);
  const QString why = problem();
  EXPECT_TRUE(why.startsWith("There is no folder")) << why.toStdString();
  EXPECT_EQ(child<QLabel>("status_message")->text(), why);
  const qint64 before = shown().cacheKey();
  dialog.resize(1560, 1100);
  ASSERT_TRUE(waitFor([&] { return preview.longestPx() > 950; }));
  waitFor([&] { return shown().width() > 950 && shown().cacheKey() != before; });
  QTest::qWait(500);  // The finer picture has been drawn.
  EXPECT_EQ(problem(), why);
  type("figure_file", path("f.png"));
  EXPECT_TRUE(waitFor([&] { return problem().isEmpty(); })) << "another name, another try";
}

TEST_F(FigureDialogTest, FilesBesideTheFigureFollowItsNameAndAreNotReplacedUnasked) {
  openDialog();
  type("figure_dpi", "60");
  type("figure_file", path("first.png"));
  EXPECT_EQ(the<QLineEdit>("figure_heights").text(), path("first-heights.tif"));
  tick("figure_caption_on", true);
  type("figure_caption_file", path("mine.txt"));
  type("figure_file", path("f.png"));
  EXPECT_EQ(the<QLineEdit>("figure_heights").text(), path("f-heights.tif"));
  EXPECT_EQ(the<QLineEdit>("figure_caption_file").text(), path("mine.txt")) << "a name of its own";
  QFile mine(path("mine.txt"));
  ASSERT_TRUE(mine.open(QIODevice::WriteOnly));
  mine.write("mine");
  mine.close();
  auto& save = the<QPushButton>("figure_save");
  ASSERT_TRUE(waitFor([&] { return save.isEnabled(); }));
  QTest::mouseClick(&save, Qt::LeftButton);
  auto& asked = the<QMessageBox>("figure_replace");
  EXPECT_TRUE(asked.text().contains("mine.txt")) << asked.text().toStdString();
  asked.reject();
  EXPECT_EQ(bytesOf(path("mine.txt")), "mine");
  EXPECT_FALSE(QFile::exists(path("f.png")));
}

}  // namespace
}  // namespace relievo
