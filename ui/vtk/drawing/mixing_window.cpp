// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/drawing/mixing_window.h"

#include <vtk_glew.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/relief/stereo.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {

vtkStandardNewMacro(MixingWindow);

void MixingWindow::StereoRenderComplete() {
  const int* const size = GetSize();
  vtkNew<vtkUnsignedCharArray> right;
  GetPixelData(0, 0, size[0] - 1, size[1] - 1, DoubleBuffer == 0 ? 1 : 0, right.GetPointer(), 0);
  const auto bytes = static_cast<std::size_t>(right->GetNumberOfValues());
  if (scene_ == nullptr || StereoType != VTK_STEREO_ANAGLYPH || !StereoBuffer ||
      static_cast<std::size_t>(StereoBuffer->GetNumberOfValues()) != bytes) {
    vtkGenericOpenGLRenderWindow::StereoRenderComplete();
    return;
  }
  std::span<std::uint8_t> first(StereoBuffer->GetPointer(0), bytes);
  std::span<std::uint8_t> second(right->GetPointer(0), bytes);
  const StereoOptions& stereo = scene_->stereo();
  if (stereo.swap_eyes) std::swap(first, second);
  joinEyes(printed(stereo.mode), first, second,
           {.width = size[0],
            .height = size[1],
            .channels = 3,
            .from_bottom = true,
            .first_row = first_row_});
  ResultFrame = stereo.swap_eyes ? right.GetPointer() : StereoBuffer.GetPointer();
  StereoBuffer = vtkSmartPointer<vtkUnsignedCharArray>::New();
}

void MixingWindow::copyRows(std::span<std::uint8_t> bytes) {
  MakeCurrent();
  vtkOpenGLState* const state = GetState();
  state->ResetFramebufferBindings();
  state->PushReadFramebufferBinding();
  DisplayFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  DisplayFramebuffer->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, Size[0], Size[1], GL_BGRA, GL_UNSIGNED_BYTE, bytes.data());
  state->PopReadFramebufferBinding();
  const auto row_bytes = static_cast<std::ptrdiff_t>(4 * Size[0]);
  auto bottom = bytes.begin() + row_bytes * (Size[1] - 1);
  for (auto top = bytes.begin(); top < bottom; top += row_bytes, bottom -= row_bytes) {
    std::swap_ranges(top, top + row_bytes, bottom);
  }
}

}  // namespace relievo
