// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/view_picture.h"

#include <algorithm>
#include <array>
#include <QRect>
#include <vector>

#include "core/base/failure.h"
#include "core/project/caption.h"
#include "core/provenance/embedded.h"
#include "core/provenance/name_text.h"
#include "core/provenance/program.h"
#include "core/provenance/set_mark.h"
#include "core/relief/relief_image.h"
#include "core/session/colours/surface_colours.h"
#include "ui/figure/hand_signs.h"
#include "ui/figure/picture_libraries.h"
#include "ui/vtk/files/picture_file.h"
#include "ui/vtk/offscreen.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {
namespace {

/// @param colour  "#rrggbb"
std::array<double, 3> channels(const std::string& colour) {
  const auto channel = [&](std::size_t at) {
    return static_cast<double>(std::stoi(colour.substr(at, 2), nullptr, 16)) / 255;
  };
  return {channel(1), channel(3), channel(5)};
}

Probe probeOf(const DrawnHand& hand) {
  Probe probe;
  probe.proxy = hand.proxy;
  probe.hip = hand.hip;
  probe.force = hand.force;
  probe.force_limit_n = hand.force_limit_n;
  probe.touching = hand.touching;
  probe.forces_on = hand.forces_on;
  return probe;
}

RgbaImage opaque(const RgbImage& image) {
  RgbaImage page{image.width, image.height, {}};
  page.rgba.reserve(image.rgb.size() / 3 * 4);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    page.rgba.insert(page.rgba.end(), {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2], 255});
  }
  return page;
}

/// The legend of hand and proxy, which a grey anaglyph tells apart by their shapes alone.
void addHandLegend(RgbImage& image) {
  RgbaImage page = opaque(image);
  paintHandLegend(page, QRect(0, 0, page.width, page.height));
  for (std::size_t i = 0, k = 0; i < image.rgb.size(); i += 3, k += 4) {
    std::copy_n(&page.rgba[k], 3, &image.rgb[i]);
  }
}

RgbImage draw(const Surface& surface, const RegionWindow& window, const Project& p,
              const Task& task) {
  constexpr int kRing = 1;
  requireColours(surface, p.look.kind);
  ReliefScene scene;
  const DepthMap drawn = windowMap(window, kRing);
  std::vector<std::uint8_t> colours;
  if (p.look.kind != ReliefKind::lit) {
    colours = reliefColours(reliefValues(drawn, p.look, task), p.look,
                            windowColours(surface, window, kRing));
  }
  scene.setSurface({.frame = drawn.frame,
                    .heights_mm = &drawn.heights_mm,
                    .origins = &drawn.origins,
                    .colours = colours.empty() ? nullptr : &colours,
                    .lit = isLit(p.look.kind)});
  const Region& region = p.region;
  scene.setCamera({.rect = {.x_mm = region.x_mm,
                            .y_mm = region.y_mm,
                            .width_mm = region.side_mm,
                            .height_mm = region.side_mm},
                   .azimuth_deg = p.azimuth_deg,
                   .elevation_deg = p.elevation_deg});
  scene.setInterpolated(interpolatedMark(p.look));
  StereoOptions stereo = p.stereo;
  if (p.picture->eye != FigureEye::both) {
    stereo.mode = StereoMode::off;
    const bool left = (p.picture->eye == FigureEye::left) != stereo.swap_eyes;
    scene.setEyeTurn((left ? -0.5 : 0.5) * stereo.eye_angle_deg);
  }
  scene.setStereo(stereo);
  scene.setColourless(p.stereo.mode == StereoMode::anaglyph);  // Each eye's picture, too.
  scene.setLight(p.look.light);
  scene.setScaleBar(p.picture->scale_bar);
  if (!p.picture->background.empty()) {
    const auto [red, green, blue] = channels(p.picture->background);
    scene.setBackground(red, green, blue);
  }
  scene.setLines(p.picture->lines);
  if (p.picture->hand) scene.setProbe(probeOf(*p.picture->hand), p.picture->hand->ball_radius_mm);
  RgbImage image = renderOffscreen(scene, p.picture->width_px, p.picture->height_px, task);
  if (p.picture->hand && p.stereo.mode == StereoMode::anaglyph) addHandLegend(image);
  return image;
}

void writePicture(const OutputFile& file, const RgbImage& image, const PictureText& text) {
  if (pictureFormatOf(file.path) == PictureFormat::png) {
    writePng(file, image, text);
    return;
  }
  writeTiff(file, opaque(image), kScreenDpi, text);
}

}  // namespace

RgbImage drawViewPicture(const Surface& surface, const RegionWindow& window, const Project& p,
                         const Task& task) {
  if (p.picture->source != PictureChoice{}.source) {
    throw failure<MessageId::picture_of_the_window>(p.picture->source);
  }
  return draw(surface, window, p, task);
}

ViewPictureFacts writeViewPicture(const Surface& surface, const RegionWindow& window,
                                  const Project& project, const OutputFile& file,
                                  const Task& task) {
  Project p = project;
  p.made = withLibraries(madeText(surface), pictureLibraries());
  const RgbImage image = drawViewPicture(surface, window, p, task);
  ViewPictureFacts facts{.width_px = image.width,
                         .height_px = image.height,
                         .mm_per_pixel = p.region.side_mm / std::min(image.width, image.height),
                         .caption = {}};
  facts.caption = captionOf(p, surface, window, pictureFacts(p, facts.mm_per_pixel));
  Project shown = relativeTo(p, file.path);
  shown.made = markedMade(shown.made, setMark(projectJson(shown), facts.caption));
  writePicture(file, image,
               {{"Title", escapedName(std::filesystem::path(p.file).filename().string())},
                {"Description", facts.caption},
                {"Software", "relievo " + std::string(programVersion())},
                {std::string(kStateKey), projectJson(shown)}});
  return facts;
}

void writeViewEyes(const Surface& surface, const RegionWindow& window, const Project& project,
                   const OutputFile& file, const Task& task) {
  for (const FigureEye eye : {FigureEye::left, FigureEye::right}) {
    Project one = project;
    one.picture->eye = eye;
    writeViewPicture(surface, window, one, {eyeFile(file.path, eye, ".png"), file.set}, task);
  }
}

std::vector<std::filesystem::path> viewEyeFiles(const std::filesystem::path& file) {
  return {eyeFile(file, FigureEye::left, ".png"), eyeFile(file, FigureEye::right, ".png")};
}

}  // namespace relievo
