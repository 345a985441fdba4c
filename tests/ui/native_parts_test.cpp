// SPDX-License-Identifier: BSD-3-Clause
// A letter that changes somewhere in the window copies no view (docs/adr/0150).
#include <gtest/gtest.h>
#include <QVTKOpenGLNativeWidget.h>
#include <QLabel>
#include <QStatusBar>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/views/copied_picture.h"

namespace relievo {
namespace {

class NativePartsTest : public GuiTest {
 protected:
  void SetUp() override {
    openRelief();
    for (SurfaceView* view : {static_cast<SurfaceView*>(&window().detailView()),
                              static_cast<SurfaceView*>(&window().referenceView())}) {
      auto* canvas = view->findChild<QVTKOpenGLNativeWidget*>();
      QObject::connect(canvas, &QOpenGLWidget::aboutToCompose, &window(), [this] { ++composed_; });
      auto* picture = view->findChild<CopiedPicture*>();
      QObject::connect(picture, &CopiedPicture::painted, &window(), [this] { ++composed_; });
    }
  }
  /// Until nothing was put together for a while.
  bool rests() {
    return waitFor([this] {
      const int before = composed_;
      QTest::qWait(300);
      return composed_ == before;
    });
  }

  /// What five changes of a letter compose. Where a change composes, each of the five does.
  int composedByFiveChanges(QLabel& label) {
    composed_ = 0;
    for (int i = 1; i <= 5; ++i) {
      label.setText(QString::number(i));
      QTest::qWait(100);
    }
    return composed_;
  }

  int composed_ = 0;
};

TEST_F(NativePartsTest, AChangedLabelComposesNoView) {
  ASSERT_TRUE(rests());
  auto* label = new QLabel(QStringLiteral("0"));
  label->setFixedSize(80, 16);  // As the fields of the status bar: no number moves the others.
  window().statusBar()->addWidget(label);
  ASSERT_TRUE(rests());
  // A picture that was still on its way on a busy machine may come in between: the changes are then
  // made again.
  EXPECT_TRUE(waitFor([this, label] { return composedByFiveChanges(*label) == 0; }));
  // What does change a view composes it, so that the count counts.
  window().runCommand("relief_slope");
  EXPECT_TRUE(waitFor([this] { return composed_ > 0; }));
}

}  // namespace
}  // namespace relievo
