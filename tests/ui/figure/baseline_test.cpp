// SPDX-License-Identifier: BSD-3-Clause
// Pictures as they were looked at and found right, in tests/ui/figure/baselines. Anew, to be looked
// at and committed like code:
//   RELIEVO_WRITE_BASELINES=1 tests/own_screen build/release/tests/ui_figure_baseline_test
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/depth/rules/rasterize.h"
#include "core/io/raster/picture_pixels.h"
#include "tests/ui/vtk/synthetic_relief.h"
#include "ui/figure/figure.h"
#include "ui/vtk/files/picture_file.h"
#include "ui/vtk/files/read_picture.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

const fs::path kBaselines = RELIEVO_SOURCE_DIR "/tests/ui/figure/baselines";
constexpr int kSide = 160;    // Pixels.
constexpr int kBlock = 4;     // What an eye at arm's length takes together.
constexpr double kMost = 20;  // Of 255: another driver's rounding and edges stay below.

/// Mean of one channel over a block; without alpha all is opaque.
double meanOf(const StoredPixels& p, int left, int top, int channel) {
  double sum = 0;
  int count = 0;
  for (int y = top; y < std::min(top + kBlock, p.height); ++y) {
    for (int x = left; x < std::min(left + kBlock, p.width); ++x, ++count) {
      if (channel >= p.channels) {
        sum += 255;
        continue;
      }
      const auto at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) +
                       static_cast<std::size_t>(x)) *
                          static_cast<std::size_t>(p.channels) +
                      static_cast<std::size_t>(channel);
      sum += p.bytes[at];
    }
  }
  return sum / count;
}

/// How far the most different block is, in its most different channel; 255 for another size.
double seenDifference(const StoredPixels& a, const StoredPixels& b) {
  if (a.width != b.width || a.height != b.height) return 255;
  double most = 0;
  for (int top = 0; top < a.height; top += kBlock) {
    for (int left = 0; left < a.width; left += kBlock) {
      for (int channel = 0; channel < 4; ++channel) {
        most =
            std::max(most, std::abs(meanOf(a, left, top, channel) - meanOf(b, left, top, channel)));
      }
    }
  }
  return most;
}

RgbaImage opaque(const RgbImage& image) {
  RgbaImage made{image.width, image.height, {}};
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    made.rgba.insert(made.rgba.end(), {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2], 255});
  }
  return made;
}

/// The picture that was found right; written first, if that is what is wanted.
StoredPixels baseline(const std::string& name, const RgbaImage& now) {
  const fs::path file = kBaselines / (name + ".png");
  if (std::getenv("RELIEVO_WRITE_BASELINES") != nullptr) {
    fs::create_directories(kBaselines);
    writePng(file, now, 100, {});
  }
  const auto pixels = readPixelsHere(file);
  EXPECT_TRUE(pixels) << file << " cannot be read";
  return pixels.value_or(StoredPixels{});
}

/// @param other  drawn with a fault that has to be seen
void expectAsBefore(const std::string& name, const RgbaImage& now, const RgbaImage& other) {
  const StoredPixels before = baseline(name, now);
  const double difference = seenDifference(before, storedPixels(now));
  if (difference > kMost) {
    const fs::path folder = RELIEVO_BINARY_DIR "/screenshots";
    fs::create_directories(folder);
    writePng(folder / ("baseline_" + name + ".png"), now, 100, {});
    ADD_FAILURE() << name << " differs by " << difference << "; look at " << folder;
  }
  EXPECT_GT(seenDifference(before, storedPixels(other)), kMost)
      << name << ": the fault is not seen";
}

class Baseline : public ::testing::Test {
 protected:
  Baseline() {
    scene_.setSurface(relief_.grid());
    scene_.setCamera({.rect = {0, 0, 100, 100}});
  }
  RgbaImage drawn() { return opaque(renderOffscreen(scene_, kSide, kSide)); }

  SyntheticRelief relief_ = makeRelief(200, 100, domeWithRidges);
  ReliefScene scene_;
};

TEST_F(Baseline, TheSurfaceUnderItsLamps) {
  const RgbaImage now = drawn();
  scene_.setLight({.azimuth_deg = 270, .elevation_deg = 45});
  expectAsBefore("surface", now, drawn());
}

TEST_F(Baseline, TheAnaglyph) {
  StereoOptions stereo{.mode = StereoMode::anaglyph, .eye_angle_deg = 6, .zero_plane_mm = 0};
  scene_.setStereo(stereo);
  const RgbaImage now = drawn();
  stereo.swap_eyes = true;
  scene_.setStereo(stereo);
  expectAsBefore("anaglyph", now, drawn());
}

TEST_F(Baseline, HandAndProxyInAGreyAnaglyph) {
  Probe probe;
  probe.proxy = {35, 60, 12};
  probe.hip = {65, 35, 2};
  scene_.setProbe(probe, 5);
  StereoOptions stereo{.mode = StereoMode::anaglyph, .eye_angle_deg = 6, .zero_plane_mm = 5};
  scene_.setStereo(stereo);
  const RgbaImage now = drawn();
  stereo.mode = StereoMode::half_colour;  // There they have their colours.
  scene_.setStereo(stereo);
  expectAsBefore("anaglyph_hand", now, drawn());
}

TEST_F(Baseline, ThePinkWindow) {
  scene_.setPinkWindow(RectMm{30, 40, 40, 40}, true);
  const RgbaImage now = drawn();
  scene_.setPinkWindow(RectMm{31, 40, 40, 40}, true);
  expectAsBefore("pink_window", now, drawn());
}

TEST_F(Baseline, TheScaleBar) {
  scene_.setScaleBar(true);
  const RgbaImage now = drawn();
  scene_.setScaleBar(false);
  expectAsBefore("scale_bar", now, drawn());
}

TEST(BaselineOfFigures, AFigureWithItsOverview) {
  Scan scan;
  for (int row = 0; row <= 200; ++row) {
    for (int col = 0; col <= 200; ++col) {
      const double x = 0.5 * col, y = 0.5 * row;
      scan.points.push_back(
          {static_cast<float>(x), static_cast<float>(y), static_cast<float>(domeWithRidges(x, y))});
    }
  }
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.format = "PLY";
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{"top", {}};
  options.spacing_mm = 0.5;
  const Surface surface = makeSurface(scan, options, rasterize);
  Project project;
  project.file = "dome.ply";
  project.sha256 = std::string(64, 'a');
  project.region = {.x_mm = 20, .y_mm = 20, .side_mm = 40, .level = {0}};
  project.figure.width_mm = 85;
  project.figure.dpi = 80;
  const RgbaImage now = drawFigure(surface, project).image;
  project.figure.window_outline = false;
  expectAsBefore("figure", now, drawFigure(surface, project).image);
}

}  // namespace
}  // namespace relievo
