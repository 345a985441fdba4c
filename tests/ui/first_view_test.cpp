// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/first_view.h"

#include <QApplication>
#include <QFile>
#include <QSignalSpy>
#include <QThread>

#include "tests/core/io/las_sample.h"
#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

/// Opens a cloud that is large enough to be looked at before it is read whole.
class FirstViewTest : public GuiTest {
 protected:
  static constexpr int kSide = 1500;

  FirstViewTest() { document().loader().setFirstViewFrom(1'000'000); }

  /// kSide * kSide points, a wavy plate with stated metres.
  QString writeCloud() const {
    test::Las las = test::withRecord(test::geoKeys({{3076, 0, 1, 9001}, {4099, 0, 1, 9001}}));
    las.scale = {0.001, 0.001, 0.001};
    las.raw.reserve(kSide * kSide);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        las.raw.push_back({x, y, (x / 50 % 2 + y / 50 % 2) * 20});
      }
    }
    las.promised = las.legacy_promised = static_cast<std::uint32_t>(las.raw.size());
    QFile file(path(QStringLiteral("cloud.las")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    const std::string bytes = test::lasFile(las);
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    return file.fileName();
  }
  FirstViewCard& card() const { return *child<FirstViewCard>("first_view"); }
};

TEST_F(FirstViewTest, IsThereBeforeTheFileIsReadAndGoesWhenItIsOpen) {
  window().open(writeCloud());
  ASSERT_TRUE(waitFor([this] { return card().isVisible(); }));
  EXPECT_FALSE(document().isOpen());
  EXPECT_EQ(card().geometry(), card().parentWidget()->rect());
  EXPECT_TRUE(card().text().contains("first view from")) << card().text().toStdString();
  const QStringList shares =
      card().text().section("first view from ", 1).section(" points", 0, 0).split(" of ");
  ASSERT_EQ(shares.size(), 2) << card().text().toStdString();
  const auto number = [](QString words) { return words.remove(QRegExp("\\D")).toInt(); };
  EXPECT_EQ(number(shares[1]), kSide * kSide);
  EXPECT_GT(number(shares[0]), 0);
  EXPECT_LT(number(shares[0]), kSide * kSide);
  // Something is drawn: the plate's steps are lit and in shade.
  EXPECT_GT(card().grab().toImage().convertToFormat(QImage::Format_Indexed8).colorCount(), 8);
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_FALSE(card().isVisible());
  EXPECT_EQ(document().surface()->info.finite_points, std::uint64_t{kSide} * kSide);
}

TEST_F(FirstViewTest, LeavesTheOpenObjectItsViewsAndGoesWhenStopped) {
  openRelief();
  const DocumentState before = document().state();
  window().open(writeCloud());
  ASSERT_TRUE(waitFor([this] { return card().isVisible(); }));
  EXPECT_LT(card().width(), window().width() / 2);
  EXPECT_EQ(document().state(), before);
  EXPECT_TRUE(card().text().contains("object before"));
  document().loader().cancel();
  EXPECT_FALSE(card().isVisible());
  EXPECT_EQ(document().state(), before);
}

TEST_F(FirstViewTest, OfWorkThatWasStoppedIsNotTold) {
  openRelief();
  QSignalSpy told(&document().loader(), &SurfaceLoader::firstView);
  const QString cloud = writeCloud();
  window().open(cloud);
  document().loader().cancel();
  openRelief();
  EXPECT_EQ(told.count(), 0);
  // Nor if it was made already, and nobody had heard of it yet.
  for (const unsigned long ms : {100UL, 300UL, 600UL, 1000UL}) {
    window().open(cloud);
    QThread::msleep(ms);
    document().loader().cancel();
    QApplication::processEvents();
    EXPECT_EQ(told.count(), 0) << ms;
  }
  EXPECT_FALSE(card().isVisible());
}

TEST_F(FirstViewTest, IsNotMadeOfFilesThatAreReadSooner) {
  QSignalSpy told(&document().loader(), &SurfaceLoader::firstView);
  document().loader().setFirstViewFrom(kSide * kSide + 1);
  window().open(writeCloud());
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(told.count(), 0);
}

}  // namespace
}  // namespace relievo
