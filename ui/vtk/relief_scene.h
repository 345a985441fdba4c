// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/grid.h"
#include "core/base/origin.h"
#include "core/region/probe.h"
#include "core/region/region.h"
#include "core/relief/look.h"

class vtkRenderer;
class vtkRenderWindow;

namespace relievo {

/// Heights to draw: a window, or a whole pyramid level. Copied by setSurface.
struct SurfaceGrid {
  GridFrame frame;
  const std::vector<float>* heights_mm = nullptr;    ///< Row-major, row 0 lowest y.
  const std::vector<CellStatus>* origins = nullptr;  ///< Same size, or null: all measured.
  /// Three bytes per sample, red first; null: stone.
  const std::vector<std::uint8_t>* colours = nullptr;
  bool lit = true;  ///< False: colours as they are, without lamps.
};

/// How cells that were interpolated are told from measured ones. Holes on the base plane are
/// hatched crosswise in any case.
enum class InterpolatedMark { none, hatch, colour };
/// As a look on screen says; figures hatch by a choice of their own.
inline InterpolatedMark interpolatedMark(const ReliefLook& look) {
  return look.unmeasured ? InterpolatedMark::colour : InterpolatedMark::none;
}
/// Red, green, blue: vermilion, which people of all colour vision tell from stone and viridis.
inline constexpr std::array<std::uint8_t, 3> kUnmeasuredColour{213, 94, 0};

/// Part of a picture, pixels from its lower left corner.
struct PictureTile {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Camera of a relief: orthographic. Untilted it looks along -z at exactly `rect`.
struct ReliefCamera {
  RectMm rect;               ///< What is in view, view mm; the longer window side shows more.
  double azimuth_deg = 0;    ///< Turn about the view's y axis; > 0: the viewer goes to the right.
  double elevation_deg = 0;  ///< Turn about the view's x axis; > 0: the viewer goes up (toward +y).
  friend bool operator==(const ReliefCamera&, const ReliefCamera&) = default;
};

/// Everything drawn in one viewport: the relief as a lit quad mesh with per-vertex normals (paper
/// sec. 4), the pink window, proxy and HIP, scale bar. The same scene serves the window's views,
/// screenshots, and `relievo render`. No Qt. [one thread; that of the render window]
class ReliefScene {
 public:
  ReliefScene();
  ~ReliefScene();
  ReliefScene(const ReliefScene&) = delete;
  ReliefScene& operator=(const ReliefScene&) = delete;

  void setSurface(const SurfaceGrid& grid);
  void clearSurface();
  void setCamera(const ReliefCamera& camera);
  void setStereo(const StereoOptions& stereo);
  const StereoOptions& stereo() const;
  void setLight(const LightOptions& light);
  void setBackground(double red, double green, double blue);
  /// Nothing is drawn where there is no relief: pixels keep alpha 0. For pictures off screen.
  void setTransparent(bool transparent);
  /// One eye's picture: sight lines slanted by this angle, about the plane of zero parallax, which
  /// keeps its place and its size; > 0 is the right eye's side. 0: in the middle.
  void setEyeTurn(double turn_deg);
  void setInterpolated(InterpolatedMark mark);  ///< At first: hatch.
  /// Pixels that a line of width 1 takes: 2 on a screen of doubled density.
  void setMarkScale(double pixels);
  /// Pink (#ff4fa3) frame 2 px wide with a dark outline and eight handles; nothing hides it.
  void setPinkWindow(const std::optional<RectMm>& rect, bool with_handles);
  /// Proxy: blue ball; HIP: red ring around a small ball; line between; arrow along the force.
  /// ball_radius_mm in view mm. Nothing hides them.
  void setProbe(const std::optional<Probe>& probe, double ball_radius_mm);
  /// What is drawn will lose its colours: the HIP is told from the proxy by its shape, a white ring
  /// with a cross in it. A stereo mode of grey says so by itself.
  void setColourless(bool colourless);
  /// Measurements: lines through points on the surface, a dot at each, and curves without dots.
  /// Nothing hides them.
  void setLines(const std::vector<std::vector<ViewMm>>& lines,
                const std::vector<std::vector<ViewMm>>& curves = {});
  /// "|-- 10 mm --|" at the lower left.
  void setScaleBar(bool visible);
  void setDecimalMark(char mark);  ///< Of the bar's number; at first a point.

  /// Adds this scene's renderers (three layers) to a window and sets the window's stereo. A scene
  /// belongs to one window; copy() makes one for another.
  /// @param samples  multisampling; 0 and 1 are none, the right choice for software OpenGL
  void attachTo(vtkRenderWindow* window, int samples = 0);
  /// To be called before each render: camera aspect, scale bar length, window frame in pixels.
  /// @param tile  draw only this part of the picture; nothing: all of it
  void prepare(int width_px, int height_px, const std::optional<PictureTile>& tile = {});
  /// The surface's picture is kept and used until something of it changes, as while only the hand
  /// moves; no colour tells, and the background is opaque. At first it is not: for windows that are
  /// drawn often.
  void keepSurface(bool keep);
  /// Of the surface every second sample each way is drawn, while something moves; not copied.
  void setCoarse(bool coarse);
  /// A render that finds this asked to stop leaves the rest of the surface out; not copied.
  void stopBy(const std::stop_token& stop);
  vtkRenderer* renderer();  ///< The one of the surface; for its camera and viewport.

  /// View position under a pixel on the plane z = z_mm; for picking and dragging. Pixels are
  /// continuous from the picture's top left corner: the middle of the first pixel is (0.5, 0.5).
  ViewMm viewFromPixel(double px, double py, int width_px, int height_px, double z_mm) const;

  /// Nothing but the background.
  bool isEmpty() const;

  /// Another scene that shows the same, for another render window. Costs a copy of the surface.
  std::unique_ptr<ReliefScene> copy() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
