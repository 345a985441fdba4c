// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/document.h"

#include <QSignalSpy>

#include "core/depth/rules/rasterize.h"
#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class DocumentTest : public GuiTest {
 protected:
  bool open(Document& document, const OpenRequest& request) {
    QSignalSpy failed(&document, &Document::failed);
    document.open(request);
    return waitFor([&] { return !document.loader().busy(); }) && failed.isEmpty() &&
           document.isOpen();
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
  EXPECT_EQ(document.project().region.side_mm, 50);
  EXPECT_EQ(document.project().region.x_mm, 15);
}

TEST_F(DocumentTest, UnitsScaleEveryLengthAndCanBeUndone) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const double width = document.surface()->map.widthMm();
  document.choices().setUnit(LengthUnit::cm);
  ASSERT_TRUE(waitFor([&] { return !document.loader().busy(); }));
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
      document.region().setRect({ladder.left_mm, ladder.bottom_mm, side, side});
      const StepAbout centre{ladder.left_mm + side / 2, ladder.bottom_mm + side / 2, false};
      document.region().finer(centre);
      document.region().setRect({ladder.left_mm, ladder.bottom_mm, side, side});
      document.region().coarser(centre);
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
  const Region first = document.project().region;
  document.region().preview({10, 10, 50, {0}});
  document.region().preview(first);
  document.region().commit("Move window");
  EXPECT_EQ(document.history().count(), 0);
}

TEST_F(DocumentTest, CancelKeepsTheSurfaceAndIsSaidAtOnce) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const DocumentState before = document.state();
  QSignalSpy cancelled(&document.loader(), &SurfaceLoader::cancelled);
  document.choices().setView({"front", {}});
  document.loader().cancel();
  EXPECT_EQ(cancelled.size(), 1);
  EXPECT_FALSE(document.loader().busy());
  // A later request still works, and the cancelled one never shows.
  document.choices().setView({"bottom", {}});
  ASSERT_TRUE(waitFor([&] { return !document.loader().busy(); }));
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
  document.choices().setEngine("depthbuffer");
  ASSERT_TRUE(waitFor([&] { return !document.loader().busy(); }));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("depth buffer"));
  EXPECT_EQ(document.state(), before);
  EXPECT_EQ(document.project().options.engine, "cpu");
}

TEST_F(DocumentTest, MeaninglessRegionsAreRefused) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const DocumentState before = document.state();
  EXPECT_FALSE(document.region().setRect({0, 0, 0, 10}));
  EXPECT_FALSE(document.region().setRect({0, 0, std::nan(""), 10}));
  EXPECT_FALSE(document.region().setGain(0));
  EXPECT_EQ(document.state(), before);
}

TEST_F(DocumentTest, AnEditIsAStepAndItsUndoTakesBackThatAlone) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  const int steps = document.history().index();
  EXPECT_TRUE(document.edit("Relief image", [](Project& p) { p.look.kind = ReliefKind::slope; }));
  EXPECT_FALSE(document.edit("Relief image", [](Project& p) { p.look.kind = ReliefKind::slope; }))
      << "nothing is other than before";
  EXPECT_EQ(document.history().index(), steps + 1);
  document.amend([](Project& p) { p.figures = {"a.png"}; });
  document.setTurn(20, 10);
  document.history().undo();
  EXPECT_EQ(document.project().look.kind, ReliefKind::lit);
  EXPECT_EQ(document.project().figures, std::vector<std::string>{"a.png"});
  EXPECT_EQ(document.project().azimuth_deg, 20);
  document.history().redo();
  EXPECT_EQ(document.project().look.kind, ReliefKind::slope);
  EXPECT_EQ(document.project().history.back(), "Relief image");
}

TEST_F(DocumentTest, ATurnOfTheViewIsAStepAndOneWithOthersInARow) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  document.turnView(20, 10);
  document.turnView(40, -100);
  EXPECT_EQ(document.history().count(), 1);
  EXPECT_EQ(document.project().elevation_deg, -kMostTiltDeg);
  document.setTurn(5, 5);  // A film, say.
  document.edit("Relief image", [](Project& p) { p.look.kind = ReliefKind::slope; });
  document.setTurn(7, 5);
  document.history().undo();
  EXPECT_EQ(document.project().azimuth_deg, 7) << "what no step turned stays turned";
  document.history().undo();
  EXPECT_EQ(document.project().azimuth_deg, 0);
  EXPECT_EQ(document.project().elevation_deg, 0);
  document.history().redo();
  EXPECT_EQ(document.project().azimuth_deg, 40);
  document.straighten();
  EXPECT_EQ(document.history().undoText(), "Straighten the view");
  document.history().undo();
  EXPECT_EQ(document.project().azimuth_deg, 40);
}

TEST_F(DocumentTest, AnotherSurfaceIsLookedStraightAtAndUndoBringsTheTurnBack) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  document.setTurn(20, 10);
  document.choices().setView({"bottom", {}});
  ASSERT_TRUE(waitFor([&] { return !document.loader().busy(); }));
  EXPECT_EQ(document.project().azimuth_deg, 0);
  document.setTurn(-5, 0);
  const Project bottom = document.project();
  document.history().undo();
  EXPECT_EQ(document.project().azimuth_deg, 20);
  EXPECT_EQ(document.project().elevation_deg, 10);
  document.history().redo();
  EXPECT_TRUE(document.project() == bottom);
}

TEST_F(DocumentTest, WorkIsUnsavedWhileItDiffersFromWhatWasSaved) {
  Document document(rasterize);
  EXPECT_FALSE(document.saved().hasUnsaved());
  ASSERT_TRUE(open(document, relief()));
  EXPECT_FALSE(document.saved().hasUnsaved());
  const auto name_one = [](Project& p) { p.places.push_back({"nose", p.region, 1}); };
  document.edit("Places", name_one);
  EXPECT_TRUE(document.saved().hasUnsaved());
  document.history().undo();
  EXPECT_FALSE(document.saved().hasUnsaved());
  document.edit("Places", name_one);
  document.saved().noteSaved("p.relievo.json");
  EXPECT_FALSE(document.saved().hasUnsaved());
  document.history().undo();
  EXPECT_TRUE(document.saved().hasUnsaved()) << "the file has it";
  document.saved().noteSaved("p.relievo.json");
  document.saved().noteUnsaved();
  EXPECT_TRUE(document.saved().hasUnsaved());
}

TEST_F(DocumentTest, AFileThatNamesMoreStepsThanTheHistoryKeepsGivesTheLastOnes) {
  Document document(rasterize);
  OpenRequest request = relief();
  ASSERT_TRUE(open(document, request));
  request.project = document.stored();
  for (int i = 0; i < 1000; ++i) {
    request.project->undo.push_back(undoStep("step", document.project(), document.project()));
    request.project->undo.back().before.gain = 1 + 0.001 * i;
    request.project->history.push_back("step");
  }
  Document other(rasterize);
  ASSERT_TRUE(open(other, request));
  EXPECT_EQ(other.history().count(), 250);
  EXPECT_EQ(other.project().history.size(), 1000U);
  for (int i = 0; i < 250; ++i) other.history().undo();
  EXPECT_DOUBLE_EQ(other.project().gain, 1.75);
}

TEST_F(DocumentTest, AStateComesBackWholeWithItsStepsAndItsPath) {
  Document document(rasterize);
  OpenRequest request = relief();
  ASSERT_TRUE(open(document, request));
  document.region().setRect({40, 40, 60, 60});
  document.edit("Relief image", [](Project& p) {
    p.look = {.kind = ReliefKind::slope, .light = {33.25, 21.5}};
    p.stereo.zero_plane_mm = 1.0 / 3;
    p.places.push_back({"nose", p.region, 1});
  });
  document.region().move(0.1, 0);
  document.amend([](Project& p) { p.paths = {{"path", {{0, viewOf(p)}}}}; });
  document.setTurn(12.5, -7);
  request.project = projectFromJson(projectJson(document.stored()), "test");
  request.project_file = "p.relievo.json";
  Document other(rasterize);
  ASSERT_TRUE(open(other, request));
  const Project& expected = document.project();
  EXPECT_EQ(projectJson(other.project()), projectJson(expected));
  EXPECT_TRUE(other.project() == expected);
  EXPECT_FALSE(other.saved().hasUnsaved());
  EXPECT_EQ(other.saved().projectFile(), "p.relievo.json");
  other.history().undo();
  EXPECT_EQ(other.project().region.x_mm, 40);
}

TEST_F(DocumentTest, WhatIsMadeOfAStateSaysWhereItComesFrom) {
  Document document(rasterize);
  OpenRequest request = relief();
  request.scan.reader = ReaderChoice::own;
  ASSERT_TRUE(open(document, request));
  document.region().setRect({40, 40, 60, 60});
  const Provenance made = document.provenanceIn(path("results/touch.csv"));
  EXPECT_EQ(made.input.file, "../relief.ply");
  EXPECT_EQ(made.input.sha256, document.fileSha256().toStdString());
  EXPECT_EQ(made.scan.reader, ReaderChoice::own);
  ASSERT_TRUE(made.view.has_value());
  EXPECT_EQ(*made.view, viewOf(document.project()));
}

TEST_F(DocumentTest, KnowsTheChecksumOfWhatItRead) {
  Document document(rasterize);
  ASSERT_TRUE(open(document, relief()));
  EXPECT_EQ(document.fileSha256().size(), 64);
}

}  // namespace
}  // namespace relievo
