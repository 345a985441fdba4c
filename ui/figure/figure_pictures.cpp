// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_pictures.h"

#include <algorithm>
#include <cmath>

#include "core/base/failure.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/crop_level.h"
#include "ui/vtk/offscreen.h"

namespace relievo {
namespace {

constexpr int kMostSamples = 4096;     // Across a panel.
constexpr double kHatchPoints = 5;     // Between two lines of a hatch.
constexpr double kHatchPixels = 14;    // The same at mark scale 1.
constexpr double kMarginSamples = 12;  // Around the cut, for slopes and horizons at its rim.

QImage imageOf(const RgbaImage& picture) {
  return QImage(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
                QImage::Format_RGBA8888_Premultiplied)
      .convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

/// What must not be drawn is outside; what must not be hatched is measured.
void applyOrigins(DepthMap& map, const FigurePanel& panel, const FigureRequest& f) {
  for (CellStatus& origin : map.origins) {
    const bool known = origin == CellStatus::measured || origin == CellStatus::steep;
    if (panel.as_measured && !known) origin = CellStatus::outside;
    if (!f.hatch && origin != CellStatus::outside) origin = CellStatus::measured;
  }
}

struct Eyes {
  double angle_deg = 0, parallax_deg = 0, zero_plane_mm = 0;
};

Eyes eyesFor(const DepthMap& map, const FigureRequest& f, double paper_per_mm) {
  const HeightRange z = heightRange(map);
  Eyes eyes;
  if (f.zero_plane_mm) {
    checkZeroPlane(*f.zero_plane_mm, z.min_mm, z.max_mm,
                   map.frame.spacing_mm * std::max(map.frame.size.cols, map.frame.size.rows));
  }
  eyes.zero_plane_mm = f.zero_plane_mm.value_or(0.5 * (z.min_mm + z.max_mm));
  if (f.stereo == StereoPrint::off) return eyes;
  const double farthest =
      std::max(std::abs(z.max_mm - eyes.zero_plane_mm), std::abs(eyes.zero_plane_mm - z.min_mm));
  eyes.angle_deg = f.limit_parallax ? comfortableEyeAngle(farthest, paper_per_mm, f.eye_angle_deg)
                                    : f.eye_angle_deg;
  eyes.parallax_deg = parallax(farthest, eyes.angle_deg, paper_per_mm).visual_deg;
  return eyes;
}

/// @throw ArgumentError  too many for a picture, or none
LevelSamples samplesIn(const Surface& surface, Level level, const RectMm& rect, int margin) {
  const GridFrame& f = levelFrame(surface, level);
  const auto range = [&](double low, double high, double first, int count) {
    const int a = static_cast<int>(std::floor((low - first) / f.spacing_mm)) - margin;
    const int b = static_cast<int>(std::ceil((high - first) / f.spacing_mm)) + margin;
    return std::pair{std::clamp(a, 0, count - 1), std::clamp(b, 0, count - 1)};
  };
  const auto [left, right] = range(rect.x_mm, rect.x_mm + rect.width_mm, f.first_x_mm, f.size.cols);
  const auto [bottom, top] =
      range(rect.y_mm, rect.y_mm + rect.height_mm, f.first_y_mm, f.size.rows);
  const int cols = right - left + 1;
  const int rows = top - bottom + 1;
  if (cols < 2 || rows < 2) {
    throw failure<MessageId::nothing_in_region>();
  }
  if (std::max(cols, rows) > kMostSamples) {
    throw failure<MessageId::level_too_fine>(level.value, kMostSamples);
  }
  return {.left = left, .right = right, .bottom = bottom, .top = top};
}

}  // namespace

DepthMap cutOut(const Surface& surface, Level level, const RectMm& rect, int margin, double gain) {
  return cropLevel(surface, level, samplesIn(surface, level, rect, margin), gain);
}

PanelPicture drawPanel(const Surface& surface, const Project& project, const FigurePanel& panel,
                       const FigureSheet& sheet, const QSize& pixels, double dpi,
                       const Task& task) {
  const FigureRequest& f = project.figure;
  const double spacing = surface.ladder.spacings_mm[static_cast<std::size_t>(panel.level.value)];
  const int margin =
      static_cast<int>(std::clamp(f.look.radius_mm / spacing, kMarginSamples, 200.0));
  requireColours(surface, f.look.kind);
  const LevelSamples samples = samplesIn(surface, panel.level, panel.shown, margin);
  DepthMap map = cropLevel(surface, panel.level, samples, project.gain);
  task.check();
  applyOrigins(map, panel, f);
  PanelPicture made;
  std::vector<std::uint8_t> colours;
  if (f.look.kind != ReliefKind::lit) {
    made.values = reliefValues(map, f.look, task);
    colours = reliefColours(made.values, f.look, levelColours(surface, panel.level, samples));
    made.values.values.clear();
  }
  ReliefScene scene;
  scene.setSurface({map.frame, &map.heights_mm, &map.origins, colours.empty() ? nullptr : &colours,
                    isLit(f.look.kind)});
  task.check();
  scene.setCamera({.rect = panel.shown});
  scene.setLight(f.look.light);
  scene.setBackground(1, 1, 1);
  scene.setMarkScale(kHatchPoints * dpi / 72 / kHatchPixels);
  const Eyes eyes = eyesFor(map, f, sheet.paper_per_mm);
  scene.setStereo({.mode = StereoMode::off, .zero_plane_mm = eyes.zero_plane_mm});
  made.eye_angle_deg = eyes.angle_deg;
  made.parallax_deg = eyes.parallax_deg;
  made.zero_plane_mm = eyes.zero_plane_mm;
  const PictureOptions options{
      .width = pixels.width(), .height = pixels.height(), .transparent = f.transparent};
  const auto seen_by = [&](int eye) {
    scene.setEyeTurn(eye * 0.5 * eyes.angle_deg);
    return renderPicture(scene, options, task);
  };
  if (isAnaglyph(f.stereo) && panel.eye == 0) {
    const int red = f.swap_eyes ? 1 : -1;
    RgbaImage left = seen_by(red);
    mixAnaglyph(f.stereo, left.rgba, seen_by(-red).rgba);
    made.image = imageOf(left);
  } else {
    made.image = imageOf(seen_by(panel.eye));
  }
  return made;
}

}  // namespace relievo
