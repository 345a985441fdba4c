// SPDX-License-Identifier: BSD-3-Clause
// The scan behind the relief in 3-D, and the relief made from where it is looked at.
#include "ui/views/scan_view.h"

#include <cmath>
#include <QAction>
#include <QFile>
#include <QImage>
#include <QPushButton>
#include <QTextStream>
#include <QToolButton>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/views/cloud_view.h"
#include "ui/work/pictures/scan_points.h"

namespace relievo {
namespace {

class ScanViewTest : public GuiTest {
 protected:
  ScanView& scan() { return *child<ScanView>("scan_view"); }
  CloudView& cloud() { return *scan().cloud(); }

  void show() {
    QTest::keyClick(&window().detailView(), Qt::Key_F8);
    ASSERT_TRUE(waitFor([this] { return scan().isVisible() && scan().isReady(); }));
  }
  bool open(const QString& file) {
    OpenRequest request;
    request.file = file;
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    window().open(request);
    return waitFor([&] { return document().isOpen() && !document().loader().busy(); });
  }
  QString write(const QString& name, const QString& text) {
    QFile file(path(name));
    if (file.open(QIODevice::WriteOnly)) file.write(text.toUtf8());
    return file.fileName();
  }
  /// Rows of the relief's rotation.
  Rotation reliefRotation() {
    const auto& m = document().surface()->view_from_file.m;
    const double scale = std::hypot(m[0], m[4], m[8]);
    Rotation r{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) r[3 * i + j] = m[4 * i + j] / scale;
    }
    return r;
  }
  QImage picture() {
    QTest::qWait(300);  // Past the moment in which a turned view draws less.
    return cloud().grab().toImage();
  }
};

double distance(const Rotation& a, const Rotation& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

int pinkPixels(const QImage& image) {
  int pink = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      if (qRed(p) > qGreen(p) + 60 && qBlue(p) > qGreen(p) + 20) ++pink;
    }
  }
  return pink;
}

/// Pixels that are as light as lit stone.
int stonePixels(const QImage& image) {
  int light = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      if (qGray(p) > 70 && std::abs(qRed(p) - qBlue(p)) < 30) ++light;
    }
  }
  return light;
}

TEST_F(ScanViewTest, AKeyShowsTheScanInThePlaceOfTheOverviewAndBringsThatBack) {
  openRelief();
  EXPECT_TRUE(window().referenceView().isVisible());
  show();
  EXPECT_FALSE(window().referenceView().isVisible());
  EXPECT_TRUE(action("show_scan")->isChecked());
  EXPECT_TRUE(cloud().hasFocus());
  EXPECT_EQ(cloud().cloud()->points.size(), 500U * 400U);
  EXPECT_GT(stonePixels(picture()), 2000) << "its points are drawn";
  QTest::keyClick(&cloud(), Qt::Key_F8);
  EXPECT_TRUE(waitFor([this] { return window().referenceView().isVisible(); }));
  EXPECT_TRUE(window().referenceView().hasFocus()) << "the focus stays beside the detail view";
}

TEST_F(ScanViewTest, TheSwitchAboveTheOverviewDoesTheSame) {
  openRelief();
  auto* button = child<QToolButton>("scan_switch");
  ASSERT_TRUE(button->isVisible());
  EXPECT_FALSE(button->accessibleName().isEmpty());
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(waitFor([this] { return scan().isVisible() && scan().isReady(); }));
}

TEST_F(ScanViewTest, ItIsTurnedFreelyByMouseAndKeysAndSaysHowFar) {
  openRelief();
  show();
  const Rotation first = scan().rotation();
  drag(cloud(), {100, 100}, {160, 70});
  EXPECT_GT(distance(scan().rotation(), first), 0.1);
  QTest::mouseClick(child<QPushButton>("scan_as_relief"), Qt::LeftButton);
  EXPECT_LT(distance(scan().rotation(), reliefRotation()), 1e-9);
  EXPECT_EQ(scan().turnedDeg(), 0);
  EXPECT_FALSE(child<QPushButton>("scan_make_relief")->isEnabled()) << "it is that already";
  for (int i = 0; i < 4; ++i) QTest::keyClick(&cloud(), Qt::Key_Right);
  EXPECT_NEAR(scan().turnedDeg(), 20, 1e-6);
  EXPECT_TRUE(cloud().accessibleDescription().contains(QString::fromUtf8("20\u00b0")))
      << cloud().accessibleDescription().toStdString();
  EXPECT_TRUE(child<QPushButton>("scan_make_relief")->isEnabled());
}

TEST_F(ScanViewTest, EnterMakesTheReliefFromHereAndUndoBringsTheOneBeforeBack) {
  openRelief();
  show();
  const Rotation top = reliefRotation();
  QTest::keyClick(&cloud(), Qt::Key_Left);
  QTest::keyClick(&cloud(), Qt::Key_Up);
  const Rotation seen = scan().rotation();
  ASSERT_GT(distance(seen, top), 0.05);
  QTest::keyClick(&cloud(), Qt::Key_Return);
  ASSERT_TRUE(waitFor(
      [this] { return !document().loader().busy() && document().surface()->view_name == "free"; }));
  EXPECT_LT(distance(reliefRotation(), seen), 1e-9);
  EXPECT_EQ(scan().turnedDeg(), 0);
  EXPECT_LT(distance(scan().rotation(), seen), 1e-12) << "the scan is looked at as before";
  document().history().undo();
  EXPECT_LT(distance(reliefRotation(), top), 1e-9);
  EXPECT_GT(scan().turnedDeg(), 1);
}

TEST_F(ScanViewTest, ASideThatHasANameIsChosenByIt) {
  openRelief();
  show();
  cloud().look(*standardRotation("bottom"));
  EXPECT_NEAR(scan().turnedDeg(), 180, 1e-6);
  ASSERT_TRUE(window().runCommand("relief_from_scan"));
  EXPECT_TRUE(waitFor([this] { return document().surface()->view_name == "bottom"; }));
}

TEST_F(ScanViewTest, TheArrowPointsAlongTheProjectionAndTheBoxIsTheWindow) {
  openRelief();
  show();
  const Rotation relief = reliefRotation();
  ASSERT_TRUE(cloud().arrow().has_value());
  const FilePoint along = cloud().arrow()->to - cloud().arrow()->from;
  const FilePoint toward{relief[6], relief[7], relief[8]};
  EXPECT_NEAR(dot(along, toward), -norm(along), 1e-9 * norm(along));
  EXPECT_GT(dot(cloud().arrow()->to, toward), 20) << "it ends above the dome";
  // From the top, the file's axes are the view's: the box has the window's sides.
  const Region& region = document().project().region;
  ASSERT_TRUE(cloud().box().has_value());
  EXPECT_NEAR(cloud().box()->max.x - cloud().box()->min.x, region.side_mm, 1e-6);
  ASSERT_TRUE(document().region().finer(document().region().aboutCentre()));
  EXPECT_NEAR(cloud().box()->max.x - cloud().box()->min.x, document().project().region.side_mm,
              1e-6);
  EXPECT_LT(document().project().region.side_mm, region.side_mm + 1e-9);
  // Both are seen; a view that was zoomed stays as it is.
  QTest::keyClick(&cloud(), Qt::Key_Minus);
  const int with = pinkPixels(picture());
  cloud().setArrow(std::nullopt);
  const int without = pinkPixels(picture());
  EXPECT_GT(with, without + 50);
  EXPECT_GT(without, 50);
}

TEST_F(ScanViewTest, AMeshOfFewTrianglesIsASurface) {
  // A roof: points alone would be six specks.
  const QString mesh = write("roof.ply",
                             "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
                             "property float y\nproperty float z\nelement face 4\n"
                             "property list uchar int vertex_indices\nend_header\n"
                             "0 0 0\n40 0 0\n40 30 0\n0 30 0\n0 15 12\n40 15 12\n"
                             "3 0 1 5\n3 0 5 4\n3 3 4 5\n3 3 5 2\n");
  ASSERT_TRUE(open(mesh));
  show();
  EXPECT_EQ(cloud().cloud()->triangles.size(), 4U);
  const QImage seen = picture();
  EXPECT_GT(stonePixels(seen), seen.width() * seen.height() / 20);
}

TEST(DrawnScan, AMeshThatIsTooLargeIsShownBySomeOfItsPoints) {
  Scan scan;
  for (int i = 0; i < 40; ++i) {
    scan.points.push_back({static_cast<float>(i % 8), static_cast<float>(i / 8), 0});
  }
  scan.triangles = {{0, 1, 8}, {1, 9, 8}, {2, 3, 10}};
  EXPECT_EQ(drawnScan(scan, 20, {}).triangles.size(), 3U);
  for (const std::size_t most : {2U, 10U}) {  // Too many triangles; too many points for so few.
    const CloudPoints drawn = drawnScan(scan, most, {});
    EXPECT_TRUE(drawn.triangles.empty()) << most;
    EXPECT_EQ(drawn.points.size(), most);
    EXPECT_EQ(drawn.normals.size(), most);
  }
}

TEST_F(ScanViewTest, PointsFarFromAllOthersAreLeftOutAsInTheRelief) {
  QString text;
  QTextStream out(&text);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) out << x << ' ' << y << ' ' << (x * y) % 5 << '\n';
  }
  out << "90000 90000 90000\n";
  out.flush();
  ASSERT_TRUE(open(write("stray.xyz", text)));
  show();
  EXPECT_EQ(cloud().cloud()->points.size(), 3600U);
  EXPECT_LT(cloud().camera().height, 300) << "the view is not fitted around the stray";
}

TEST_F(ScanViewTest, WhereThereIsNoScanTheOverviewComesBack) {
  openRelief();
  show();
  ASSERT_TRUE(open(write("map.asc",
                         "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                         "1 2 3\n2 3 4\n3 4 5\n")));
  EXPECT_FALSE(action("show_scan")->isEnabled());
  EXPECT_FALSE(action("show_scan")->isChecked());
  EXPECT_TRUE(waitFor([this] { return window().referenceView().isVisible(); }));
  EXPECT_FALSE(window().runCommand("relief_from_scan"));
}

TEST_F(ScanViewTest, AnotherFileIsDrawnInPlaceOfTheOneBefore) {
  openRelief();
  show();
  QString text;
  QTextStream out(&text);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) out << x << ' ' << y << " 1\n";
  }
  out.flush();
  ASSERT_TRUE(open(write("plate.xyz", text)));
  ASSERT_TRUE(waitFor([this] { return scan().isReady(); }));
  EXPECT_EQ(cloud().cloud()->points.size(), 1600U);
}

}  // namespace
}  // namespace relievo
