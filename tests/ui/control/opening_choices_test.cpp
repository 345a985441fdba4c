// SPDX-License-Identifier: BSD-3-Clause
// What a file leaves open when it is opened: how large a picture of heights is, clouds that the
// memory does not hold, and whether the view of the file before stays.
#include <cmath>
#include <QAction>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QtTest/QTest>
#include <QUndoStack>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/raster_scale_dialog.h"
#include "ui/frame/message_strip.h"

namespace relievo {
namespace {

class OpeningChoicesTest : public GuiTest {
 protected:
  /// 60 x 50 pixels of 16 bits, 0 ... 59 000.
  QString picture() const {
    QImage image(60, 50, QImage::Format_Grayscale16);
    for (int y = 0; y < 50; ++y) {
      auto* row = reinterpret_cast<quint16*>(image.scanLine(y));
      for (int x = 0; x < 60; ++x) row[x] = static_cast<quint16>(1000 * x);
    }
    QString file = path("heights.png");
    EXPECT_TRUE(image.save(file));
    return file;
  }
  void open(const QString& file) {
    OpenRequest request;
    request.file = file;
    window().open(request);
  }
  bool isOpen(const QString& file) {
    return waitFor([&] {
      return document().isOpen() && !document().loader().busy() && document().file() == file &&
             !window().message().isEmpty();
    });
  }
  QPushButton* button(const QString& name) const {
    for (QPushButton* b : child<MessageStrip>("message_strip")->findChildren<QPushButton*>()) {
      if (!b->isHidden() && b->accessibleName() == name) return b;
    }
    return nullptr;
  }
};

TEST_F(OpeningChoicesTest, APictureOfHeightsIsGuessedAndAskedAbout) {
  open(picture());
  ASSERT_TRUE(isOpen(path("heights.png")));
  EXPECT_TRUE(window().message().contains("does not say how large it is"))
      << window().message().toStdString();
  EXPECT_TRUE(window().message().contains("guess"));
  // 59 mm long, 59 000 steps: a tenth is 0.0001.
  EXPECT_NEAR(heightRange(document().surface()->map).max_mm, 5.9, 0.01);
  ASSERT_NE(button("Say how large…"), nullptr);
  button("Say how large…")->click();
  auto* dialog = window().findChild<RasterScaleDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->findChild<QDoubleSpinBox*>("raster_pixel")->setValue(0.5);
  dialog->findChild<QDoubleSpinBox*>("raster_step")->setValue(0.0005);
  EXPECT_TRUE(dialog->findChild<QLabel*>("raster_size")->text().contains("29.5"))
      << dialog->findChild<QLabel*>("raster_size")->text().toStdString();
  dialog->findChild<QCheckBox*>("raster_deeper")->setChecked(true);
  dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  ASSERT_TRUE(waitFor([this] {
    return !document().loader().busy() && document().project().options.raster.pixel_mm.has_value();
  }));
  const DepthMap& map = document().surface()->map;
  EXPECT_EQ(map.frame.spacing_mm, 0.5);
  EXPECT_NEAR(heightRange(map).max_mm, 29.5, 0.01);
  EXPECT_EQ(map.heights_mm[map.frame.size.index({.col = 59, .row = 0})], 0) << "deepest";
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  document().history().undo();
  EXPECT_NEAR(heightRange(document().surface()->map).max_mm, 5.9, 0.01);
}

TEST_F(OpeningChoicesTest, WhatWasGuessedCanBeKeptAndIsAskedAgainUnderUnits) {
  open(picture());
  ASSERT_TRUE(isOpen(path("heights.png")));
  ASSERT_NE(button("Keep it so"), nullptr);
  button("Keep it so")->click();
  ASSERT_TRUE(waitFor([this] {
    return !document().loader().busy() && document().project().options.raster.height_mm.has_value();
  }));
  EXPECT_NEAR(*document().project().options.raster.height_mm, 1e-4, 1e-12);
  action("units")->trigger();
  EXPECT_NE(window().findChild<RasterScaleDialog*>(), nullptr);
}

TEST_F(OpeningChoicesTest, ACloudThatTheMemoryDoesNotHoldIsOfferedThinned) {
  const QString file = writeRelief();
  document().loader().setFreeBytes(9'000'000);
  open(file);
  ASSERT_TRUE(waitFor([this] { return window().message().contains("E102"); }))
      << window().message().toStdString();
  EXPECT_FALSE(document().isOpen()) << "nothing was loaded";
  // 200 000 points of 100 bytes are 20 MB; two thirds of what is free hold a quarter of them.
  ASSERT_NE(button("Load one point in 4"), nullptr) << window().message().toStdString();
  QTest::keyClick(&window(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(document().source().scan->points.size(), 50'000U);
  EXPECT_EQ(document().project().scan.every, 4U) << "a project brings the same points back";
}

TEST_F(OpeningChoicesTest, TheNextFileIsSeenLikeThisOneIfAsked) {
  openRelief();
  document().region().setRect({40, 50, 60, 60});
  document().region().setGain(2);
  window().detailView().turnBy(20, 10);
  const Project before = document().project();
  const QString other = writeRelief(QStringLiteral("other.ply"));
  const auto opened = [&](const QString& file) {
    window().open(file);
    return waitFor([&] { return !document().loader().busy() && document().file() == file; });
  };
  ASSERT_TRUE(opened(other));
  EXPECT_EQ(document().project().azimuth_deg, 0) << "its own view, at first";
  EXPECT_EQ(document().project().gain, 1);
  EXPECT_EQ(document().detail(), 1);
  document().region().setRect({40, 50, 60, 60});
  document().region().setGain(2);
  window().detailView().turnBy(20, 10);
  window().runCommand("relief_slope");
  window().runCommand("light_rake_left");
  const ReliefLook look = document().project().look;
  ASSERT_NE(look.light, LightOptions{});
  action("keep_view")->trigger();
  const QString third = writeRelief(QStringLiteral("third.ply"));
  ASSERT_TRUE(opened(third));
  const Project& after = document().project();
  EXPECT_EQ(after.azimuth_deg, before.azimuth_deg);
  EXPECT_EQ(after.elevation_deg, before.elevation_deg);
  EXPECT_EQ(after.gain, 2);
  EXPECT_EQ(after.region, before.region);
  EXPECT_EQ(after.look, look) << "light and relief image";
  ASSERT_TRUE(after.options.view.has_value());
  EXPECT_EQ(after.options.view->name, document().surface()->view_name) << "the same side";
  restart();
  EXPECT_TRUE(action("keep_view")->isChecked()) << "remembered";
}

TEST_F(OpeningChoicesTest, AFileThatIsDroppedWithControlIsSeenLikeTheOneBefore) {
  openRelief();
  document().region().setRect({40, 50, 60, 60});
  window().detailView().turnBy(20, 10);
  const Project before = document().project();
  ASSERT_FALSE(action("keep_view")->isChecked());
  const auto dropped = [&](const QString& file, Qt::KeyboardModifiers with) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, with);
    QApplication::sendEvent(&window(), &enter);
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, with);
    QApplication::sendEvent(&window(), &event);
    return waitFor([&] { return !document().loader().busy() && document().file() == file; });
  };
  ASSERT_TRUE(dropped(writeRelief(QStringLiteral("other.ply")), Qt::ControlModifier));
  EXPECT_EQ(document().project().azimuth_deg, before.azimuth_deg);
  EXPECT_EQ(document().project().region, before.region);
  ASSERT_TRUE(dropped(writeRelief(QStringLiteral("third.ply")), Qt::NoModifier));
  EXPECT_EQ(document().project().azimuth_deg, 0) << "by itself: its own view";
  EXPECT_EQ(document().detail(), 1);
}

}  // namespace
}  // namespace relievo
