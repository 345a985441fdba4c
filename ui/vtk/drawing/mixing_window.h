// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <cstdint>
#include <span>

namespace relievo {

class ReliefScene;

/// A view's window. Mixes two eyes' pictures as `renderOffscreen` does; VTK alone knows only
/// channel masks. [GUI thread]
class MixingWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static MixingWindow* New();
  vtkTypeMacro(MixingWindow, vtkGenericOpenGLRenderWindow)

      void follow(const ReliefScene* scene) {
    scene_ = scene;
  }
  void setFirstRow(int row) { first_row_ = row; }  ///< Of the screen: PixelRows.

  /// The picture that was drawn last, top row first; of each pixel blue, green, red and a byte that
  /// tells nothing. @param bytes  4 for each pixel of GetSize()
  void copyRows(std::span<std::uint8_t> bytes);

 protected:
  void StereoRenderComplete() override;

 private:
  const ReliefScene* scene_ = nullptr;
  int first_row_ = 0;
};

}  // namespace relievo
