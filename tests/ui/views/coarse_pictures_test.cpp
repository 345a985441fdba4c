// SPDX-License-Identifier: BSD-3-Clause
// Half as many pixels each way while somebody drags faster than whole pictures come.
#include "ui/views/coarse_pictures.h"

#include <gtest/gtest.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderWindow.h>
#include <cmath>
#include <QSignalSpy>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

constexpr qint64 kSlowMs = 60;  // Longer than the 40 ms of 25 pictures a second.

TEST(CoarsePictures, ComeWithThePointerAheadOfSlowPictures) {
  for (const qint64 took_ms : {kSlowMs, 10 * kSlowMs}) {
    CoarsePictures coarse;
    coarse.stepDrawn(20, true);
    EXPECT_FALSE(coarse.on());
    coarse.stepDrawn(took_ms, true);
    EXPECT_TRUE(coarse.on());
    coarse.stepDrawn(20, true);
    EXPECT_TRUE(coarse.on()) << "they are fast because they are coarse";
    QSignalSpy over(&coarse, &CoarsePictures::over);
    ASSERT_TRUE(waitFor([&] { return over.count() == 1; })) << "nobody drags any more";
    EXPECT_FALSE(coarse.on());
  }
}

TEST(CoarsePictures, DoNotComeWhereTheHandIsSlow) {
  CoarsePictures coarse;
  for (int i = 0; i < 4; ++i) {
    coarse.stepDrawn(kSlowMs, false);
    EXPECT_FALSE(coarse.on());
  }
}

class CoarseViewTest : public GuiTest {
 protected:
  vtkRenderWindow* drawnIn() {
    return window().detailView().findChild<QVTKOpenGLNativeWidget*>()->renderWindow();
  }
};

TEST_F(CoarseViewTest, AViewDrawsItsWholePixelsAgainAndInPictures) {
  openRelief();
  CoarsePictures& coarse = window().detailView().coarsePictures();
  const QSize whole = window().detailView().shot().size();
  const auto isDrawnIn = [&](QSize size) {
    return std::abs(drawnIn()->GetSize()[0] - size.width()) <= 1 &&
           std::abs(drawnIn()->GetSize()[1] - size.height()) <= 1;
  };
  ASSERT_TRUE(isDrawnIn(whole));
  // Somebody drags: the window moves while the pointer is ahead of slow pictures.
  double way_mm = 0;
  ASSERT_TRUE(waitFor([&] {
    coarse.stepDrawn(kSlowMs, true);
    const Region region = window().document().project().region;
    way_mm = way_mm > 0 ? -1 : 1;
    window().document().setRect({region.x_mm - 0.5 * region.side_mm + way_mm,
                                 region.y_mm - 0.5 * region.side_mm, region.side_mm,
                                 region.side_mm});
    QCoreApplication::processEvents();
    return isDrawnIn(CoarsePictures::kPart * whole);
  }));
  EXPECT_EQ(window().detailView().shot().size(), whole);
  EXPECT_TRUE(isDrawnIn(whole)) << "a picture of the view is whole";
  EXPECT_TRUE(waitFor([&] { return !coarse.on() && isDrawnIn(whole); }));
}

}  // namespace
}  // namespace relievo
