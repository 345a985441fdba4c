// SPDX-License-Identifier: BSD-3-Clause
#include "ui/document.h"

#include <QSignalSpy>

#include "core/depth/rasterize.h"
#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class DocumentTest : public GuiTest {
 protected:
  bool open(Document& document, const OpenRequest& request) {
    QSignalSpy failed(&document, &Document::failed);
    document.open(request);
    return waitFor([&] { return !document.busy(); }) && failed.isEmpty() && document.isOpen();
  }
  OpenRequest relief() {
    OpenRequest request;
    request.file = writeRelief();
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    return request;
  }
};

TEST_F(DocumentTest, OpensAtTheDetailOrRegionThatWasAskedFor) {
  Document document(rasterize);
  OpenRequest request = relief();
  request.detail = 3;
  ASSERT_TRUE(open(document, request));
  EXPECT_EQ(document.detail(), 3);
  request.region = RectMm{20, 30, 40, 50};
  ASSERT_TRUE(open(document, request));
  EXPECT_EQ(document.state().region.side_mm, 50);
  EXPECT_EQ(document.state().region.x_mm, 15);
}

TEST_F(DocumentTest, UnitsScaleEveryLengthAndCanBeUndone) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const double width = document.surface()->map.widthMm();
  document.setUnit(LengthUnit::cm);
  ASSERT_TRUE(waitFor([&] { return !document.busy(); }));
  EXPECT_NEAR(document.surface()->map.widthMm(), 10 * width, 1e-6 * width);
  document.history().undo();
  EXPECT_EQ(document.surface()->map.widthMm(), width);
}

TEST_F(DocumentTest, AStepThatKeepsTheDetailIsNamedByWhatItChanges) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  ASSERT_GE(document.details(), 2);
  // A window of another size than its detail has: the next one may be of the same detail.
  for (const double part : {0.4, 0.7, 0.9, 1.3}) {
    for (int detail = 1; detail <= document.details(); ++detail) {
      const DetailLadder& ladder = document.surface()->ladder;
      const double side = part * ladder.sideMm(detail);
      document.setRect({ladder.left_mm, ladder.bottom_mm, side, side});
      const StepAbout centre{ladder.left_mm + side / 2, ladder.bottom_mm + side / 2, false};
      document.finer(centre);
      document.setRect({ladder.left_mm, ladder.bottom_mm, side, side});
      document.coarser(centre);
    }
  }
  int kept = 0;
  for (int i = 0; i < document.history().count(); ++i) {
    const QString name = document.history().text(i);
    const QStringList numbers = name.section(' ', 1).split(QString::fromUtf8(" \u2192 "));
    EXPECT_FALSE(numbers.size() == 2 && numbers[0] == numbers[1]) << name.toStdString();
    if (name == "Smaller window" || name == "Larger window") ++kept;
  }
  EXPECT_GT(kept, 0);
}

TEST_F(DocumentTest, AGestureThatEndsWhereItBeganLeavesNoEntry) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const Region first = document.state().region;
  document.preview({10, 10, 50, {0}});
  document.preview(first);
  document.commit("Move window");
  EXPECT_EQ(document.history().count(), 0);
}

TEST_F(DocumentTest, CancelKeepsTheSurfaceAndIsSaidAtOnce) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const DocumentState before = document.state();
  QSignalSpy cancelled(&document, &Document::cancelled);
  document.setView({"front", {}});
  document.cancel();
  EXPECT_EQ(cancelled.size(), 1);
  EXPECT_FALSE(document.busy());
  // A later request still works, and the cancelled one never shows.
  document.setView({"bottom", {}});
  ASSERT_TRUE(waitFor([&] { return !document.busy(); }));
  EXPECT_EQ(document.surface()->view_name, "bottom");
  document.history().undo();
  EXPECT_EQ(document.state(), before);
}

TEST_F(DocumentTest, AnEngineThatFailsIsReportedAndChangesNothing) {
  Document document([](const DepthRequest&, const Task&) -> FrontDepths {
    throw GraphicsError("There is no depth buffer. Nothing was changed. Use the processor.");
  });
  ASSERT_TRUE(open(document, relief()));
  const DocumentState before = document.state();
  QSignalSpy failed(&document, &Document::failed);
  document.setEngine("depthbuffer");
  ASSERT_TRUE(waitFor([&] { return !document.busy(); }));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("depth buffer"));
  EXPECT_EQ(document.state(), before);
  EXPECT_EQ(document.state().options.engine, "cpu");
}

TEST_F(DocumentTest, MeaninglessRegionsAreRefused) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const DocumentState before = document.state();
  EXPECT_FALSE(document.setRect({0, 0, 0, 10}));
  EXPECT_FALSE(document.setRect({0, 0, std::nan(""), 10}));
  EXPECT_FALSE(document.setGain(0));
  EXPECT_EQ(document.state(), before);
}

TEST_F(DocumentTest, KnowsTheChecksumOfWhatItRead) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  EXPECT_EQ(document.fileSha256().size(), 64);
}

}  // namespace
}  // namespace relievo
