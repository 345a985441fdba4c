// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/offscreen.h"

#include <algorithm>
#include <array>

#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "core/base/error.h"
#include "ui/vtk/gl_session.h"

namespace relievo {
namespace {

constexpr int kSamples = 8;

RgbImage readPixels(vtkRenderWindow* window, int width, int height) {
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(width);
  RgbImage image{width, height,
                 std::vector<std::uint8_t>(row_bytes * static_cast<std::size_t>(height))};
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height) return image;
  const unsigned char* in = pixels->GetPointer(0);
  for (int row = height - 1; row >= 0; --row) {
    std::uint8_t* out = image.rgb.data() + row_bytes * static_cast<std::size_t>(row);
    for (int col = 0; col < width; ++col, in += 4) {
      *out++ = in[0];
      *out++ = in[1];
      *out++ = in[2];
    }
  }
  return image;
}

}  // namespace

OffscreenWindow::OffscreenWindow() {
  if (!connection_.isOpen()) {
    throw GraphicsError(
        "There is no display to draw with. Set DISPLAY, or start the program on a desktop or under "
        "xvfb-run.");
  }
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(0);
  window_->SetSize(16, 16);
}

int OffscreenWindow::sizeLimitPx() {
  window_->Start();  // Makes the context.
  window_->MakeCurrent();
  std::array<GLint, 2> viewport{};
  GLint texture = 0, buffer = 0;
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
  return std::min({viewport[0], viewport[1], texture, buffer});
}

RgbImage renderOffscreen(const ReliefScene& scene, int width, int height) {
  if (width < 1 || height < 1) throw ArgumentError("A picture needs a width and a height above 0.");
  OffscreenWindow window;
  const int limit = window.sizeLimitPx();
  if (width > limit || height > limit) {
    throw GraphicsError("A picture of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels is too large for this computer's graphics; at most " +
                        std::to_string(limit) + " a side.");
  }
  const std::unique_ptr<ReliefScene> copy = scene.copy();
  window.get()->SetSize(width, height);
  copy->attachTo(window.get(), kSamples);
  copy->prepare(width, height);
  window.get()->Render();
  RgbImage image = readPixels(window.get(), width, height);
  if (isBlack(image) && !copy->mayBeBlack()) {
    throw GraphicsError("The graphics driver returned a black picture of " + std::to_string(width) +
                        " x " + std::to_string(height) + " pixels. Try a smaller one.");
  }
  return image;
}

bool isBlack(const RgbImage& image) {
  return std::all_of(image.rgb.begin(), image.rgb.end(), [](std::uint8_t v) { return v == 0; });
}

}  // namespace relievo
