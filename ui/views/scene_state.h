// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <QColor>
#include <vector>

#include "core/depth/colours/colours.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {

/// Heights kept alive for as long as somebody may draw them.
struct HeldGrid {
  GridFrame frame;
  std::vector<float> heights_mm;
  std::vector<CellStatus> origins;         ///< Same size.
  GridColours own = {};                    ///< What the scan says; empty: nothing.
  std::vector<std::uint8_t> colours = {};  ///< As painted: three a sample, or none: stone.
  bool lit = true;

  SurfaceGrid drawn() const {
    return {frame, &heights_mm, &origins, colours.empty() ? nullptr : &colours, lit};
  }
};

/// What a view shows, apart from its pixels: drawn on screen and, again, into images.
struct SceneState {
  std::shared_ptr<const HeldGrid> grid;
  ReliefCamera camera{.rect = {-50, -50, 100, 100}};
  StereoOptions stereo;
  LightOptions light;
  ReliefLook look;
  std::vector<std::vector<ViewMm>> lines, curves;  ///< Measurements.
  QColor background{0x23, 0x26, 0x2a};
  std::optional<RectMm> pink;
  std::optional<Probe> probe;
  double ball_radius_mm = 1;

  void applyTo(ReliefScene& scene) const;
};

}  // namespace relievo
