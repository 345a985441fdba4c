// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderer.h>

namespace relievo {

/// The lowest layer of a ReliefScene. Its picture may be kept and copied instead of drawn for as
/// long as it shows the same: the layers above it, which clear its depths, change with every
/// movement of a hand, and the surface, which costs most, does not. [thread of the scene]
class KeptSurface : public vtkOpenGLRenderer {
 public:
  static KeptSurface* New();
  vtkTypeMacro(KeptSurface, vtkOpenGLRenderer)

      /// All that the picture depends on, as numbers; two that are equal are of one picture.
      using Sight = std::array<double, 16>;

  void keep(bool keep) { keep_ = keep; }
  /// Of the pictures to come.
  void show(const Sight& sight) { sight_ = sight; }

  void Clear() override;
  int UpdateGeometry(vtkFrameBufferObjectBase* fbo = nullptr) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 private:
  /// Of one eye; the left one's is the only one where there is no stereo.
  struct Picture {
    vtkNew<vtkOpenGLFramebufferObject> pixels;
    Sight sight{};
    bool is_there = false;
  };
  enum class Way { to_kept, from_kept };

  vtkOpenGLRenderWindow* keepingWindow();
  Picture& ofThisEye();
  bool has(const Picture& picture, vtkOpenGLRenderWindow& window) const;
  static bool makeRoom(Picture& picture, vtkOpenGLRenderWindow& window);
  static void copy(Picture& picture, vtkOpenGLRenderWindow& window, Way way);

  bool keep_ = false;
  Sight sight_{};
  std::array<Picture, 2> eyes_;
};

}  // namespace relievo
