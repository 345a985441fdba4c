// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QtTest/QTest>

#include "core/relief/stereo.h"
#include "tests/ui/gui_fixture.h"
#include "ui/views/overlays/colour_bar.h"

namespace relievo {
namespace {

class ViewTest : public GuiTest {
 protected:
  void SetUp() override { openRelief(); }
  bool seenFrom(const std::string& name) {
    return waitFor(
        [&] { return !document().loader().busy() && document().surface()->view_name == name; });
  }
};

/// Share of pixels with a red or cyan tinge; the stone itself is nearly grey.
double colouredShare(const QImage& image) {
  int coloured = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      if (std::abs(qRed(p) - qGreen(p)) > 12) ++coloured;
    }
  }
  return static_cast<double>(coloured) / (image.width() * image.height());
}

TEST_F(ViewTest, AltAndADigitShowsEachOfTheSixSides) {
  const std::array<std::string, 6> views{"front", "back", "left", "right", "top", "bottom"};
  for (std::size_t i = 0; i < views.size(); ++i) {
    QTest::keyClick(&window().detailView(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i)),
                    Qt::AltModifier);
    EXPECT_TRUE(seenFrom(views[i])) << views[i];
  }
}

TEST_F(ViewTest, AChangeOfViewCanBeUndone) {
  const DocumentState top = document().state();
  QTest::mouseClick(child<QPushButton>("view_bottom"), Qt::LeftButton);
  ASSERT_TRUE(seenFrom("bottom"));
  EXPECT_TRUE(action("undo")->text().contains(QString::fromUtf8("top \u2192 bottom")))
      << action("undo")->text().toStdString();
  document().history().undo();
  EXPECT_EQ(document().state(), top);
}

TEST_F(ViewTest, AMiddleDragTurnsAndUseThisViewMakesTheReliefAnewFromThere) {
  auto& detail = window().detailView();
  EXPECT_FALSE(action("use_view")->isEnabled());
  drag(detail, {100, 100}, {140, 60}, Qt::MiddleButton);
  ASSERT_TRUE(detail.isTurned());
  const Rotation camera = detail.cameraRotation();
  // Its rows are right, up and toward the viewer: a turn, no mirror.
  const ReliefCamera& turned = detail.sceneState().camera;
  const double a = turned.azimuth_deg * M_PI / 180;
  const double e = turned.elevation_deg * M_PI / 180;
  const ViewMm right{camera[0], camera[1], camera[2]};
  const ViewMm up{camera[3], camera[4], camera[5]};
  const ViewMm toward{camera[6], camera[7], camera[8]};
  EXPECT_NEAR(norm(right - ViewMm{std::cos(a), 0, -std::sin(a)}), 0, 1e-12);
  const ViewMm across{right.y * up.z - right.z * up.y, right.z * up.x - right.x * up.z,
                      right.x * up.y - right.y * up.x};
  EXPECT_NEAR(norm(across - toward), 0, 1e-12);
  EXPECT_NEAR(toward.y, std::sin(e), 1e-12);
  EXPECT_NEAR(norm(up), 1, 1e-12);
  EXPECT_TRUE(action("use_view")->isEnabled());
  QTest::mouseClick(child<QPushButton>("use_this_view"), Qt::LeftButton);
  ASSERT_TRUE(seenFrom("free"));
  // From the top, view axes are file axes: the camera's rotation is the new view's.
  const auto& m = document().surface()->view_from_file.m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(m[4 * i + j], camera[3 * i + j], 1e-9);
  }
  EXPECT_FALSE(detail.isTurned()) << "the turned view is straight now";
}

TEST_F(ViewTest, KeysTurnTheDetailViewAsADragDoes) {
  auto& detail = window().detailView();
  QTest::keyClick(&detail, Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(detail.sceneState().camera.azimuth_deg, -15);
  QTest::keyClick(&detail, Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(detail.sceneState().camera.elevation_deg, -15);
  QTest::keyClick(&detail, Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::keyClick(&detail, Qt::Key_Down, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(detail.isTurned());
  drag(detail, {100, 100}, {140, 60}, Qt::MiddleButton);
  EXPECT_LT(detail.sceneState().camera.azimuth_deg, 0)
      << "to the right by drag is to the right by key";
  EXPECT_LT(detail.sceneState().camera.elevation_deg, 0);
}

TEST_F(ViewTest, FitLooksStraightDownAgain) {
  drag(window().detailView(), {100, 100}, {140, 60}, Qt::MiddleButton);
  ASSERT_TRUE(window().detailView().isTurned());
  action("fit")->trigger();
  EXPECT_FALSE(window().detailView().isTurned());
}

TEST_F(ViewTest, BothViewsDrawByThemselvesInTheirTurns) {
  // grab() takes what is there: the plain background until the first picture had its turn.
  for (SurfaceView* view : {static_cast<SurfaceView*>(&window().referenceView()),
                            static_cast<SurfaceView*>(&window().detailView())}) {
    EXPECT_TRUE(waitFor([&] {
      const QImage seen = view->grab().toImage();
      return qGray(seen.pixel(seen.rect().center())) > 90;
    })) << view->objectName().toStdString();
  }
}

TEST_F(ViewTest, TheAnaglyphSwitchesOnAndOffInBothViewsAndChangesTheirPixels) {
  auto& detail = window().detailView();
  // A steep flank, so that the eyes see different pictures.
  document().region().setRect({60, 60, 100, 100});
  const QImage mono = detail.shot();
  QTest::keyClick(&detail, Qt::Key_3, Qt::ControlModifier);
  EXPECT_TRUE(child<QCheckBox>("stereo_on")->isChecked());
  EXPECT_EQ(window().referenceView().sceneState().stereo.mode, StereoMode::anaglyph);
  const QImage stereo = detail.shot();
  EXPECT_NE(mono, stereo);
  EXPECT_GT(colouredShare(stereo), colouredShare(mono) + 0.002);
  QTest::keyClick(&detail, Qt::Key_3, Qt::ControlModifier);
  EXPECT_FALSE(child<QCheckBox>("stereo_on")->isChecked());
  EXPECT_EQ(detail.shot(), mono);
}

/// The left or right half of a picture.
QImage halfOf(const QImage& picture, int which) {
  const int half = picture.width() / 2;
  return picture.copy(which * (picture.width() - half), 0, half, picture.height());
}

/// How many pixels of two pictures differ by more than the eye would see.
double share(const QImage& a, const QImage& b) {
  int other = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 16) ++other;
    }
  }
  return static_cast<double>(other) / (a.width() * a.height());
}

TEST_F(ViewTest, SideBySideShowsEachEyeItsHalfAndThePointerReachesBoth) {
  auto& detail = window().detailView();
  document().region().setRect({60, 60, 100, 100});
  window().runCommand("relief_height");
  ASSERT_TRUE(waitFor([this] { return child<QWidget>("colour_bar")->isVisible(); }));
  const QImage mono = detail.shot();
  child<QComboBox>("stereo_kind")->setCurrentIndex(3);
  child<QCheckBox>("stereo_on")->setChecked(true);
  ASSERT_EQ(detail.sceneState().stereo.mode, StereoMode::side_by_side);
  const QImage pair = detail.shot();
  EXPECT_EQ(pair.size(), mono.size());
  EXPECT_LT(share(halfOf(pair, 0), halfOf(pair, 1)), 0.4) << "the same place";
  EXPECT_GT(share(halfOf(pair, 0), halfOf(pair, 1)), 0.002) << "seen by two eyes";
  const QImage squeezed =
      mono.scaled(mono.width() / 2, mono.height(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  EXPECT_LT(share(halfOf(pair, 0), squeezed), 0.4);
  EXPECT_EQ(window().referenceView().sceneState().stereo.mode, StereoMode::off)
      << "no halves beside halves";
  for (const char* over : {"colour_bar", "light_ball", "overview_inset"}) {
    for (QWidget* part : detail.findChildren<QWidget*>(QString::fromLatin1(over))) {
      EXPECT_FALSE(part->isVisible()) << over << ": one eye alone would see it";
    }
  }
  // Where the pointer carries the hand.
  std::vector<ViewMm> hands;
  QObject::connect(&detail, &DetailView::handMoved,
                   [&](const ViewMm& at, bool) { hands.push_back(at); });
  for (const double part : {0.25, 0.75}) {
    move(detail, {part * detail.width(), 0.5 * detail.height()});
  }
  ASSERT_TRUE(waitFor([&] { return hands.size() >= 2; }));
  // A pixel of a half is two of the whole, and the view has a frame of two pixels about it.
  EXPECT_NEAR(hands.front().x, hands.back().x, 5 * detail.mmPerPixel());
  EXPECT_NEAR(hands.back().x, 110, 3) << "the middle of what is shown";
  child<QComboBox>("stereo_kind")->setCurrentIndex(0);
  child<QCheckBox>("stereo_on")->setChecked(false);
  EXPECT_EQ(detail.shot(), mono);
}

TEST_F(ViewTest, OverAndUnderShowsTheLeftEyeAboveTheRightOne) {
  auto& detail = window().detailView();
  document().region().setRect({60, 60, 100, 100});
  const QImage mono = detail.shot();
  child<QComboBox>("stereo_kind")->setCurrentIndex(4);
  child<QCheckBox>("stereo_on")->setChecked(true);
  ASSERT_EQ(detail.sceneState().stereo.mode, StereoMode::over_under);
  const auto halfOfHeight = [](const QImage& picture, int which) {
    const int half = picture.height() / 2;
    return picture.copy(0, which * (picture.height() - half), picture.width(), half);
  };
  const QImage pair = detail.shot();
  ASSERT_EQ(pair.size(), mono.size());
  const QImage above = halfOfHeight(pair, 0), below = halfOfHeight(pair, 1);
  EXPECT_LT(share(above, below), 0.4) << "the same place";
  EXPECT_GT(share(above, below), 0.002) << "seen by two eyes";
  child<QCheckBox>("stereo_swap")->setChecked(true);
  const QImage swapped = detail.shot();
  const double of_eyes = share(above, below);
  EXPECT_LT(share(halfOfHeight(swapped, 0), below), 0.1 * of_eyes);
  EXPECT_LT(share(halfOfHeight(swapped, 1), above), 0.1 * of_eyes);
}

TEST_F(ViewTest, OnAFullScreenAPairHasTheScreenToItself) {
  child<QComboBox>("stereo_kind")->setCurrentIndex(3);
  window().runCommand("stereo");
  window().runCommand("full_screen");
  EXPECT_FALSE(window().statusBar()->isVisible());
  EXPECT_FALSE(child<QWidget>("overview_inset")->isVisible());
  child<QComboBox>("stereo_kind")->setCurrentIndex(5);
  EXPECT_TRUE(window().statusBar()->isVisible()) << "rows leave the words readable";
  EXPECT_TRUE(child<QWidget>("overview_inset")->isVisible());
  child<QComboBox>("stereo_kind")->setCurrentIndex(4);
  EXPECT_FALSE(window().statusBar()->isVisible());
  window().runCommand("full_screen");
  EXPECT_TRUE(window().statusBar()->isVisible());
}

TEST_F(ViewTest, InterlacedGivesEachEyeItsRows) {
  auto& detail = window().detailView();
  document().region().setRect({60, 60, 100, 100});
  const QImage mono = detail.shot();
  child<QComboBox>("stereo_kind")->setCurrentIndex(5);
  child<QCheckBox>("stereo_on")->setChecked(true);
  const QImage rows = detail.shot();
  child<QCheckBox>("stereo_swap")->setChecked(true);
  const QImage swapped = detail.shot();
  EXPECT_NE(rows, mono);
  EXPECT_NE(rows, swapped);
  // Every second row of one is a row of one eye, and so is the other second row of the other.
  const auto unlike = [](const QImage& a, const QImage& b, int first) {
    int other = 0;
    for (int y = first; y < a.height(); y += 2) {
      for (int x = 0; x < a.width(); ++x) other += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
    return other;
  };
  EXPECT_GT(unlike(rows, swapped, 0), 0);
  EXPECT_GT(unlike(rows, swapped, 1), 0);
}

TEST_F(ViewTest, EyeSeparationAndZeroPlaneReachTheViews) {
  child<QCheckBox>("stereo_on")->setChecked(true);
  child<QDoubleSpinBox>("eye_angle")->setValue(7);
  EXPECT_EQ(window().detailView().sceneState().stereo.eye_angle_deg, 7);
  EXPECT_FALSE(window().detailView().sceneState().stereo.zero_plane_mm.has_value());
  child<QCheckBox>("zero_plane_auto")->setChecked(false);
  child<QDoubleSpinBox>("zero_plane")->setValue(5);
  EXPECT_EQ(window().detailView().sceneState().stereo.zero_plane_mm, 5);
}

/// Mean difference of two pictures of one size, 0 ... 255.
double difference(const QImage& a, const QImage& b) {
  const QImage one = a.convertToFormat(QImage::Format_RGB888);
  const QImage two = b.convertToFormat(QImage::Format_RGB888);
  EXPECT_EQ(one.size(), two.size());
  double sum = 0;
  for (int y = 0; y < one.height(); ++y) {
    for (int x = 0; x < 3 * one.width(); ++x) {
      sum += std::abs(one.constScanLine(y)[x] - two.constScanLine(y)[x]);
    }
  }
  return sum / (3.0 * one.width() * one.height());
}

/// What warms up draws a speck; with a small scan the view had its size by then, and showed the
/// speck enlarged until something changed that size.
TEST_F(ViewTest, AViewThatHasItsSizeBeforeItIsWarmDrawsThatManyPixels) {
  RenderScheduler turns;
  DetailView view(document(), turns);
  view.resize(400, 400);
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view, 60'000));
  QImage seen;
  ASSERT_TRUE(waitFor([&] {
    seen = view.grab().toImage();
    return qGray(seen.pixel(seen.rect().center())) > 90;
  }));
  view.resize(402, 402);  // Draws anew at a size that Qt has told.
  view.resize(400, 400);
  view.shot();
  EXPECT_LT(difference(seen, view.grab().toImage()), 1);
}

TEST_F(ViewTest, AutomaticDepthGivesEachViewTheParallaxThatFillsTheComfortableRange) {
  document().region().setRect({60, 60, 100, 100});
  action("stereo")->trigger();
  ASSERT_TRUE(child<QCheckBox>("stereo_automatic")->isChecked());
  const auto range = [&](SurfaceView& view, double low, double high) {
    const double screen_mm = 25.4 / window().screen()->physicalDotsPerInch() / view.mmPerPixel();
    return parallax(0.5 * (high - low), view.sceneState().stereo.eye_angle_deg, screen_mm, 600)
        .visual_deg;
  };
  const auto shown = document().window();
  EXPECT_NEAR(range(window().detailView(), shown->min_mm, shown->max_mm), kComfortDeg, 1e-6);
  // The small overview could fill it only by hiding flanks.
  EXPECT_EQ(window().referenceView().sceneState().stereo.eye_angle_deg, kMostEyeAngleDeg);
  EXPECT_LT(range(window().referenceView(), 0, 20), kComfortDeg);
  window().resize(1000, 700);  // Larger pictures need less.
  QApplication::processEvents();
  EXPECT_NEAR(range(window().detailView(), shown->min_mm, shown->max_mm), kComfortDeg, 1e-6);
  // Nobody chose an angle: what is shown is not a step, and nothing to be saved.
  const int steps = document().history().count();
  document().region().setRect({20, 20, 60, 60});
  EXPECT_EQ(document().history().count(), steps + 1);
}

/// The share of pixels of the colour of interpolated cells.
double orangeShare(const QImage& image) {
  int orange = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      if (qRed(p) > qGreen(p) + 60 && qGreen(p) > qBlue(p) + 20) ++orange;
    }
  }
  return static_cast<double>(orange) / (image.width() * image.height());
}

/// Every seventh point of every seventh row is missing: single cells are interpolated.
TEST_F(ViewTest, InterpolatedCellsLookLikeMeasuredOnesUntilTheyAreAskedFor) {
  const auto open = [&](const QString& file) {
    OpenRequest request;
    request.file = file;
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    window().open(request);
    ASSERT_TRUE(waitFor([&] { return document().file() == file && !document().loader().busy(); }));
  };
  QFile points(path("gaps.xyz")), whole(path("whole.xyz"));
  ASSERT_TRUE(points.open(QIODevice::WriteOnly) && whole.open(QIODevice::WriteOnly));
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 60; ++col) {
      const QByteArray line = QByteArray::number(col) + ' ' + QByteArray::number(row) + " 0\n";
      whole.write(line);
      if (row % 7 != 3 || col % 7 != 3) points.write(line);
    }
  }
  points.close();
  whole.close();
  open(whole.fileName());
  const QImage measured = window().detailView().shot();
  // A hole is no interpolated cell: it is hatched whether these are marked or not.
  QFile hole(path("hole.xyz"));
  ASSERT_TRUE(hole.open(QIODevice::WriteOnly));
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 60; ++col) {
      if (std::abs(row - 30) < 10 && std::abs(col - 30) < 10) continue;
      hole.write(QByteArray::number(col) + ' ' + QByteArray::number(row) + " 0\n");
    }
  }
  hole.close();
  open(hole.fileName());
  ASSERT_FALSE(action("show_unmeasured")->isChecked());
  ASSERT_EQ(document().surface()->holes.size(), 1U);
  EXPECT_GT(share(window().detailView().shot(), measured), 0.03) << "the hatch";
  open(points.fileName());
  const auto& origins = document().window()->origins;
  ASSERT_GT(std::count(origins.begin(), origins.end(), CellStatus::interpolated), 20);
  EXPECT_LT(difference(window().detailView().shot(), measured), 0.2) << "no chisel marks";
  auto* legend = window().detailView().findChild<QWidget*>("cell_legend");
  EXPECT_FALSE(legend->isVisible());
  EXPECT_LT(orangeShare(window().detailView().shot()), 0.001);
  action("show_unmeasured")->trigger();
  EXPECT_TRUE(legend->isVisible());
  EXPECT_TRUE(legend->accessibleDescription().startsWith("interpolated: 2"))
      << legend->accessibleDescription().toStdString();
  EXPECT_GT(orangeShare(window().detailView().shot()), 0.01);
  EXPECT_GT(orangeShare(window().referenceView().shot()), 0.002);
  // What is saved shows what is seen.
  window().saveImage(ImageSource::detail, {400, 400}, path("saved.png"));
  ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
  EXPECT_GT(orangeShare(QImage(path("saved.png"))), 0.01);
  document().history().undo();
  EXPECT_FALSE(action("show_unmeasured")->isChecked());
  EXPECT_FALSE(legend->isVisible());
}

TEST_F(ViewTest, TheScaleBarOfAGermanWindowHasADecimalComma) {
  document().region().setRect({100, 90, 3, 3});
  const QImage point = window().detailView().shot();
  QLocale::setDefault(QLocale(QLocale::German));
  restart();
  openRelief();
  document().region().setRect({100, 90, 3, 3});
  const QImage comma = window().detailView().shot();
  QLocale::setDefault(QLocale(QLocale::English));
  ASSERT_EQ(point.size(), comma.size());
  QRect other;
  for (int y = 0; y < point.height(); ++y) {
    for (int x = 0; x < point.width(); ++x) {
      if (point.pixel(x, y) != comma.pixel(x, y)) other |= QRect(x, y, 1, 1);
    }
  }
  EXPECT_FALSE(other.isEmpty()) << "0.5 mm and 0,5 mm";
  EXPECT_LT(other.width(), 12) << "one character, and what stands behind it";
  EXPECT_LT(other.height(), 12);
  EXPECT_GT(other.top(), point.height() - 100) << "in the bar, at the bottom left";
  EXPECT_LT(other.right(), 200);
}

TEST_F(ViewTest, OneValueHasOneColourInBothViewsAndTheBarsEndsAreRound) {
  document().region().setRect({60, 60, 60, 60});
  action("relief_height")->trigger();
  const auto whole = window().referenceView().shownRange();
  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(*whole, (std::array<double, 2>{0, 19})) << "of 98 % of the values";
  EXPECT_EQ(window().detailView().shownRange(), whole);
  const auto* bar = window().referenceView().findChild<ColourBar*>("colour_bar");
  EXPECT_EQ(bar->accessibleDescription(), "height (mm) from 0 to 19");
  document().region().setGain(2);  // Twice the heights are other values.
  EXPECT_NE(window().detailView().shownRange(), whole);
  document().history().undo();
  EXPECT_EQ(window().detailView().shownRange(), whole);
  action("relief_slope")->trigger();
  EXPECT_EQ(window().detailView().shownRange(), window().referenceView().shownRange());
  EXPECT_NE(window().detailView().shownRange(), whole);
}

TEST_F(ViewTest, TheBarOfAGreyAnaglyphIsGrey) {
  action("relief_height")->trigger();
  const auto* bar = window().detailView().findChild<ColourBar*>("colour_bar");
  ASSERT_TRUE(bar->isVisible());
  EXPECT_NE(bar->colourAt(0.9)[0], bar->colourAt(0.9)[2]) << "viridis ends in yellow";
  action("stereo")->trigger();
  EXPECT_EQ(bar->colourAt(0.9)[0], bar->colourAt(0.9)[1]);
  EXPECT_EQ(bar->colourAt(0.9)[1], bar->colourAt(0.9)[2]);
  action("stereo")->trigger();
  EXPECT_NE(bar->colourAt(0.9)[0], bar->colourAt(0.9)[2]);
}

TEST_F(ViewTest, TheDepthBufferGivesTheSameReliefAsTheProcessor) {
  const auto cpu = document().surface();
  action("engine_depthbuffer")->trigger();
  ASSERT_TRUE(waitFor([this] {
    return !document().loader().busy() &&
           (document().surface()->engine == "depthbuffer" || !window().message().isEmpty());
  })) << "depth buffer";
  ASSERT_EQ(document().surface()->engine, "depthbuffer") << window().message().toStdString();
  const auto gl = document().surface();
  ASSERT_EQ(gl->map.frame, cpu->map.frame);
  const Cell top{gl->map.frame.size.cols * 2 / 5, gl->map.frame.size.rows * 9 / 20};
  EXPECT_NEAR(gl->map.heightMm(top), cpu->map.heightMm(top), 0.2);
}

TEST_F(ViewTest, TheLightMovesInBothViews) {
  child<QSlider>("light_azimuth")->setValue(90);
  child<QSlider>("light_elevation")->setValue(20);
  EXPECT_EQ(window().detailView().sceneState().light.azimuth_deg, 90);
  EXPECT_EQ(window().referenceView().sceneState().light.elevation_deg, 20);
}

}  // namespace
}  // namespace relievo
