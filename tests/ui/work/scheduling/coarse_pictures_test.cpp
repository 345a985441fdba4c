// SPDX-License-Identifier: BSD-3-Clause
// Half as many pixels each way while somebody drags faster than whole pictures come.
#include "ui/work/scheduling/coarse_pictures.h"

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
  QVTKOpenGLNativeWidget* canvas() {
    return window().detailView().findChild<QVTKOpenGLNativeWidget*>();
  }
  /// With so many of the pixels that the view has now, each way.
  bool isDrawnIn(double part) {
    const QSize wanted = part * canvas()->devicePixelRatioF() * canvas()->size();
    const int* const size = canvas()->renderWindow()->GetSize();
    return std::abs(size[0] - wanted.width()) <= 1 && std::abs(size[1] - wanted.height()) <= 1;
  }
};

TEST_F(CoarseViewTest, AViewDrawsItsWholePixelsAgainAndInPictures) {
  openRelief();
  CoarsePictures& coarse = window().detailView().coarsePictures();
  ASSERT_TRUE(waitFor([&] { return isDrawnIn(1); }));
  // Somebody drags: the window moves while the pointer is ahead of slow pictures.
  double left_mm = 40;
  ASSERT_TRUE(waitFor([&] {
    coarse.stepDrawn(kSlowMs, true);
    left_mm = 81 - left_mm;
    window().document().region().setRect({left_mm, 40, 60, 60});
    QCoreApplication::processEvents();
    return isDrawnIn(CoarsePictures::kPart);
  }));
  EXPECT_EQ(window().detailView().shot().size(), canvas()->devicePixelRatioF() * canvas()->size());
  EXPECT_TRUE(isDrawnIn(1)) << "a picture of the view is whole";
  EXPECT_TRUE(waitFor([&] { return !coarse.on() && isDrawnIn(1); }));
}

}  // namespace
}  // namespace relievo
