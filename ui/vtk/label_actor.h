// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkTextActor.h>

namespace relievo {

/// Text over a picture. VTK draws all text of a process through one cache of glyphs that knows no
/// threads (vtkFreeTypeTools); labels of views, pictures and videos, each on a thread of its own,
/// take turns at it. Every text of a scene must be one of these. [one thread each]
class LabelActor : public vtkTextActor {
 public:
  static LabelActor* New();
  vtkTypeMacro(LabelActor, vtkTextActor)

      protected : int UpdateRectangle(vtkViewport* viewport) override;
};

}  // namespace relievo
