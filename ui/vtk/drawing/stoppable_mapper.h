// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stop_token>
#include <utility>

#include <vtkOpenGLPolyDataMapper.h>

namespace relievo {

/// Draws a mesh of polygons a part at a time and looks between two parts whether it is to stop;
/// then the picture lacks the rest. The parts are those of one draw call in its order: the pixels
/// do not tell. Without a token that can stop it is the mapper it derives from.
class StoppableMapper : public vtkOpenGLPolyDataMapper {
 public:
  static StoppableMapper* New();
  vtkTypeMacro(StoppableMapper, vtkOpenGLPolyDataMapper)

      void stopBy(std::stop_token stop) {
    stop_ = std::move(stop);
  }

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;

 protected:
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

 private:
  std::stop_token stop_;
};

}  // namespace relievo
