// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/cloud/scan.h"
#include "ui/vtk/cloud/cloud_camera.h"

class vtkRenderWindow;

namespace relievo {

/// Points as they are drawn. Plain value.
struct CloudPoints {
  FilePoint origin;                                  ///< Added to every point.
  std::vector<std::array<float, 3>> points;          ///< File units from `origin`.
  std::vector<std::array<float, 3>> normals;         ///< As long, or empty; 0 0 0: not known.
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< sRGB; as long.
  double spacing = 0;                                ///< Of neighbours, file units; 0: not known.
};

/// A box of any direction, as lines.
struct CloudBox {
  FilePoint min, max;
  Rotation axes{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< Rows, as CropBox::axes.
  friend bool operator==(const CloudBox&, const CloudBox&) = default;
};

/// Points, lit from the viewer, and a box around some of them. [the thread of its window]
class CloudScene {
 public:
  CloudScene();
  ~CloudScene();
  CloudScene(const CloudScene&) = delete;
  CloudScene& operator=(const CloudScene&) = delete;

  void setPoints(std::shared_ptr<const CloudPoints> points);
  void setBox(const std::optional<CloudBox>& box);
  void setBackground(double red, double green, double blue);
  void setCamera(const CloudCamera& camera);
  /// To be called once. The window outlives this.
  void attachTo(vtkRenderWindow* window);
  /// Before each picture: its size in pixels.
  void prepare(const PictureSize& size, double mark_scale);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
