// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/cloud/scan.h"
#include "ui/vtk/cloud/cloud_camera.h"

class vtkRenderWindow;

namespace relievo {

/// Points as they are drawn, or a mesh of them. Plain value.
struct CloudPoints {
  FilePoint origin;                                  ///< Added to every point.
  std::vector<std::array<float, 3>> points;          ///< File units from `origin`.
  std::vector<std::array<float, 3>> normals;         ///< As long, or empty; 0 0 0: not known.
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< sRGB; as long.
  double spacing = 0;                                ///< Of neighbours, file units; 0: not known.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Valid indices; empty: a cloud.
};

/// The colour of boxes, sRGB 0 to 1, unless another one is said.
inline constexpr std::array<double, 3> kBoxColour{1.0, 0.62, 0.20};

/// A box of any direction, as lines.
struct CloudBox {
  FilePoint min, max;
  Rotation axes{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< Rows, as CropBox::axes.
  std::array<double, 3> colour = kBoxColour;
  friend bool operator==(const CloudBox&, const CloudBox&) = default;
};

/// An arrow in space, from its end to its tip; file units.
struct CloudArrow {
  FilePoint from, to;
  friend bool operator==(const CloudArrow&, const CloudArrow&) = default;
};

/// Points or a mesh, lit from the viewer, a box around some of them, and an arrow.
/// [the thread of its window]
class CloudScene {
 public:
  CloudScene();
  ~CloudScene();
  CloudScene(const CloudScene&) = delete;
  CloudScene& operator=(const CloudScene&) = delete;

  void setPoints(std::shared_ptr<const CloudPoints> points);
  void setBox(const std::optional<CloudBox>& box);
  void setArrow(const std::optional<CloudArrow>& arrow);
  /// One point in so many is drawn, so that a view which is being turned keeps up with the hand;
  /// 1: all. A mesh is drawn by its points then.
  void setCoarseness(std::size_t one_in);
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
