// SPDX-License-Identifier: BSD-3-Clause
// What a view shows is what VTK drew for it, every pixel of it.
#include "ui/views/surface_view.h"

#include <gtest/gtest.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <QCoreApplication>
#include <QMouseEvent>

#include "tests/ui/gui_fixture.h"
#include "ui/views/copied_picture.h"

namespace relievo {
namespace {

/// Whether copies of the pictures are shown; else Qt composes them.
class SurfaceViewTest : public GuiTest, public ::testing::WithParamInterface<bool> {
 protected:
  SurfaceViewTest() {
    SurfaceView::setCopied(GetParam());
    restart();
  }
  ~SurfaceViewTest() override { SurfaceView::setCopied({}); }
  QWidget* shownPart() {
    return GetParam() ? static_cast<QWidget*>(view().findChild<CopiedPicture*>()) : canvas();
  }
  QWidget* hiddenPart() {
    return GetParam() ? static_cast<QWidget*>(canvas()) : view().findChild<CopiedPicture*>();
  }
  DetailView& view() { return window().detailView(); }
  QVTKOpenGLNativeWidget* canvas() { return view().findChild<QVTKOpenGLNativeWidget*>(); }
  /// As VTK has them.
  QImage drawn() {
    vtkRenderWindow* const window = canvas()->renderWindow();
    const int* const size = window->GetSize();
    canvas()->makeCurrent();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
    QImage image(size[0], size[1], QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const unsigned char* const p =
            pixels->GetPointer(3 * (vtkIdType{image.height() - 1 - y} * image.width() + x));
        image.setPixel(x, y, qRgb(p[0], p[1], p[2]));
      }
    }
    return image;
  }
  void expectAsDrawn(const char* when) {
    const QImage shown = view().shot();
    EXPECT_EQ(shown.convertToFormat(QImage::Format_RGB32), drawn()) << when;
    const QImage with_alpha = shown.convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < with_alpha.height(); ++y) {
      for (int x = 0; x < with_alpha.width(); ++x) {
        ASSERT_EQ(qAlpha(with_alpha.pixel(x, y)), 255) << when << " at " << x << ", " << y;
      }
    }
  }
  void hoverAt(const QPointF& at) {
    QMouseEvent event(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view(), &event);
  }
};

TEST_P(SurfaceViewTest, ShowsWhatIsDrawnAndOpaquely) {
  openRelief();
  EXPECT_TRUE(waitFor([this] { return shownPart()->isVisible(); }));
  EXPECT_FALSE(hiddenPart()->isVisible());
  expectAsDrawn("at first");
  expectAsDrawn("once more");
  window().document().region().setRect({40, 40, 60, 60});
  expectAsDrawn("another window");
  hoverAt({100, 100});
  expectAsDrawn("a hand over the surface");
  hoverAt({140, 120});
  expectAsDrawn("that moved");
  StereoOptions stereo;
  stereo.mode = StereoMode::anaglyph;
  view().setStereo(stereo);
  expectAsDrawn("both eyes");
  view().setStereo({});
  window().resize(window().width() - 60, window().height() - 40);
  QCoreApplication::processEvents();
  expectAsDrawn("another size");
}

/// Without another round of the event loop: a window of another size shows no picture of the old
/// one.
TEST_P(SurfaceViewTest, PaintsAPictureOfItsSize) {
  openRelief();
  ASSERT_TRUE(waitFor([this] { return shownPart()->isVisible(); }));
  for (const int less : {0, 40}) {
    view().shot();  // Whatever was still to be drawn.
    window().resize(window().width() - less, window().height() - less);
    QCoreApplication::processEvents();
    const QImage on_screen = shownPart()->grab().toImage();
    EXPECT_EQ(on_screen.convertToFormat(QImage::Format_RGB32),
              view().shot().convertToFormat(QImage::Format_RGB32))
        << less;
  }
}

INSTANTIATE_TEST_SUITE_P(BothWays, SurfaceViewTest, ::testing::Bool());

}  // namespace
}  // namespace relievo
