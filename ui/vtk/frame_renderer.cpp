// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/frame_renderer.h"

#include <algorithm>

#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "core/base/failure.h"
#include "ui/vtk/gl_session.h"

namespace relievo {
namespace {
constexpr int kSamples = 4;  // Smooth edges; eight cost software graphics twice the time.
}

struct FrameRenderer::Impl {
  OffscreenWindow window;
  ReliefScene scene;
  RgbaImage image;
  vtkNew<vtkUnsignedCharArray> pixels;
};

FrameRenderer::FrameRenderer(int width_px, int height_px) : impl_(std::make_unique<Impl>()) {
  if (std::max(width_px, height_px) > impl_->window.sizeLimitPx()) {
    throw failure<MessageId::driver_size_limit>(width_px, height_px);
  }
  impl_->image = {width_px, height_px,
                  std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width_px) *
                                            static_cast<std::size_t>(height_px))};
  impl_->window.get()->SetSize(width_px, height_px);
  impl_->scene.attachTo(impl_->window.get(), kSamples);
  impl_->scene.renderer()->SetBackgroundAlpha(1);  // Tells black from a failure (offscreen.h).
}

FrameRenderer::~FrameRenderer() = default;

ReliefScene& FrameRenderer::scene() {
  return impl_->scene;
}

const RgbaImage& FrameRenderer::draw(const Task& task) {
  RgbaImage& image = impl_->image;
  impl_->scene.prepare(image.width, image.height);
  impl_->scene.stopBy(task.stop);
  impl_->window.get()->Render();
  task.check();  // Else it may be cut.
  impl_->window.get()->GetRGBACharPixelData(0, 0, image.width - 1, image.height - 1, 0,
                                            impl_->pixels);
  const auto row_bytes = 4 * static_cast<std::size_t>(image.width);
  const unsigned char* const drawn = impl_->pixels->GetPointer(0);
  if (!anythingDrawn({drawn, row_bytes * static_cast<std::size_t>(image.height)})) {
    throw failure<MessageId::black_picture>();
  }
  for (int row = 0; row < image.height; ++row) {
    const unsigned char* const from =
        drawn + static_cast<std::size_t>(image.height - 1 - row) * row_bytes;
    std::uint8_t* const to = image.rgba.data() + static_cast<std::size_t>(row) * row_bytes;
    std::copy(from, from + row_bytes, to);
    for (std::size_t i = 3; i < row_bytes; i += 4) to[i] = 255;
  }
  return image;
}

}  // namespace relievo
