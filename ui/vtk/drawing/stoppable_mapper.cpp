// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/drawing/stoppable_mapper.h"

#include <algorithm>
#include <cstdint>

#include <vtk_glew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLIndexBufferObject.h>
#include <vtkOpenGLVertexBufferObjectGroup.h>

namespace relievo {
namespace {

// Software OpenGL takes up to some tenths of a second for a mesh of a million cells: a part is
// about 15 ms. A graphics card waits 24 times a picture and does not notice.
constexpr std::size_t kParts = 24;

}  // namespace

vtkStandardNewMacro(StoppableMapper);

void StoppableMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor) {
  if (!stop_.stop_requested()) vtkOpenGLPolyDataMapper::RenderPiece(renderer, actor);
}

// As the base class draws its triangles; lines and points, of which our meshes have none, are left
// to it.
void StoppableMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  vtkOpenGLHelper& triangles = Primitives[PrimitiveTris];
  const bool others = Primitives[PrimitivePoints].IBO->IndexCount != 0 ||
                      Primitives[PrimitiveLines].IBO->IndexCount != 0 ||
                      Primitives[PrimitiveTriStrips].IBO->IndexCount != 0;
  const std::size_t count = triangles.IBO->IndexCount;
  if (!stop_.stop_possible() || others || count == 0) {
    vtkOpenGLPolyDataMapper::RenderPieceDraw(renderer, actor);
    return;
  }
  if (stop_.stop_requested()) return;
  DrawingVertices = false;
  UpdateShaders(triangles, renderer, actor);
  const auto last_vertex = static_cast<GLuint>(VBOs->GetNumberOfTuples("vertexMC") - 1);
  triangles.IBO->Bind();
  const std::size_t part = 3 * std::max<std::size_t>(1, count / 3 / kParts);
  for (std::size_t at = 0; at < count && !stop_.stop_requested(); at += part) {
    const std::size_t taken = std::min(part, count - at);
    glDrawRangeElements(GL_TRIANGLES, 0, last_vertex, static_cast<GLsizei>(taken), GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(at * sizeof(GLuint)));
    glFinish();  // Else every part waits in the driver for the last one.
  }
  triangles.IBO->Release();
}

}  // namespace relievo
