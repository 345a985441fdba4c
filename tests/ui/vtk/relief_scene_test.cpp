// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/relief_scene.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include "tests/ui/vtk/picture.h"
#include "tests/ui/vtk/synthetic_relief.h"
#include "ui/vtk/display_connection.h"

namespace relievo {
namespace {

constexpr RectMm kWhole{0, 0, 100, 100};

SyntheticRelief flat(double height_mm) {
  return makeRelief(200, 100, [=](double, double) { return height_mm; });
}

/// A relief that exists only inside [x0, x1] x [y0, y1]; its edges lie at samples.
SyntheticRelief plate(double x0, double y0, double x1, double y1) {
  SyntheticRelief relief = flat(3);
  const GridFrame& f = relief.frame;
  for (int row = 0; row < f.size.rows; ++row) {
    for (int col = 0; col < f.size.cols; ++col) {
      const double x = f.xMm(col), y = f.yMm(row);
      if (x < x0 || x > x1 || y < y0 || y > y1) {
        relief.origins[f.size.index({col, row})] = CellStatus::outside;
      }
    }
  }
  return relief;
}

Probe probeAt(ViewMm proxy, ViewMm hip, DeviceN force) {
  Probe probe;
  probe.proxy = proxy;
  probe.hip = hip;
  probe.force = force;
  probe.touching = true;
  return probe;
}

bool isBlue(const Rgb& c) {
  return c[2] > 120 && c[2] > c[0] + 60 && c[2] > c[1] + 40;
}
bool isRed(const Rgb& c) {
  return c[0] > 180 && c[1] < 90 && c[2] < 90;
}
bool isAmber(const Rgb& c) {
  return c[0] > 120 && c[1] > 80 && c[2] < c[1] - 50;
}

// A plate's edges fall where the rectangle says, to a hundredth of a pixel's brightness.
TEST(ReliefScene, APictureOfTheRectangleShowsExactlyTheRectangle) {
  // Half a cell around each sample inside is drawn: from 37 to 71 and from 28 to 80.
  const SyntheticRelief relief = plate(37.2, 28.2, 70.8, 79.8);
  ReliefScene scene;
  scene.setSurface(relief.grid());
  scene.setBackground(0, 0, 1);
  scene.setCamera({.rect = {20, 10, 75, 75}});
  const RgbImage image = renderOffscreen(scene, 600, 600);  // 8 pixels a millimetre.
  const double surface = at(image, 300, 300)[0];
  ASSERT_GT(surface, 100);
  double across = 0, first = 0;
  for (int x = 0; x < 600; ++x) across += at(image, x, 300)[0] / surface;
  for (int x = 0; x < 300; ++x) first += 1 - at(image, x, 300)[0] / surface;
  EXPECT_NEAR(first, 8 * (37 - 20), 0.2);
  EXPECT_NEAR(across, 8 * (71 - 37), 0.4);
  double top = 0, down = 0;
  for (int y = 0; y < 600; ++y) down += at(image, 300, y)[0] / surface;
  for (int y = 0; y < 300; ++y) top += 1 - at(image, 300, y)[0] / surface;
  EXPECT_NEAR(top, 8 * (85 - 80), 0.2);  // The rectangle's upper edge is 10 + 75.
  EXPECT_NEAR(down, 8 * (80 - 28), 0.4);
}

TEST(ReliefScene, ASurfaceFillsThePictureToTheLastPixel) {
  ReliefScene scene;
  const SyntheticRelief relief = flat(3);
  scene.setSurface(relief.grid());
  scene.setBackground(0, 0, 1);
  scene.setCamera({.rect = kWhole});
  const RgbImage image = renderOffscreen(scene, 400, 400);
  for (const int far : {0, 399}) {
    EXPECT_EQ(at(image, far, 200), at(image, 200, 200));
    EXPECT_EQ(at(image, 200, far), at(image, 200, 200));
  }
}

TEST(ReliefScene, TheLongerSideOfAPictureShowsMore) {
  ReliefScene scene;
  scene.setCamera({.rect = {20, 10, 60, 60}});
  const ViewMm left = scene.viewFromPixel(0, 300, 900, 600, 0);
  const ViewMm right = scene.viewFromPixel(900, 300, 900, 600, 0);
  const ViewMm top = scene.viewFromPixel(450, 0, 900, 600, 0);
  EXPECT_NEAR(left.x, 5, 1e-9);
  EXPECT_NEAR(right.x, 95, 1e-9);
  EXPECT_NEAR(top.y, 70, 1e-9);
}

TEST(ReliefScene, APixelOfATiltedPictureLeadsBackToWhatIsDrawnThere) {
  ReliefScene scene;
  scene.setSurface(flat(2).grid());
  scene.setCamera({.rect = kWhole, .azimuth_deg = 30, .elevation_deg = -40});
  const ViewMm ball{64, 41, 9};
  scene.setProbe(probeAt(ball, ball, {}), 2);
  const RgbImage image = renderOffscreen(scene, 500, 400);
  double x = 0, y = 0, count = 0;
  for (int row = 0; row < 400; ++row) {
    for (int col = 0; col < 500; ++col) {
      const Rgb c = at(image, col, row);
      if (!isBlue(c) && !isRed(c)) continue;
      x += col + 0.5, y += row + 0.5, count += 1;
    }
  }
  ASSERT_GT(count, 50);
  const ViewMm found = scene.viewFromPixel(x / count, y / count, 500, 400, ball.z);
  EXPECT_NEAR(found.x, ball.x, 0.2);
  EXPECT_NEAR(found.y, ball.y, 0.2);
  EXPECT_DOUBLE_EQ(found.z, ball.z);
}

TEST(ReliefScene, ThePinkWindowLiesOnItsRectangleOverEverything) {
  ReliefScene scene;
  const SyntheticRelief relief = makeRelief(200, 100, domeWithRidges);
  scene.setSurface(relief.grid());
  scene.setCamera({.rect = kWhole});
  scene.setPinkWindow(RectMm{20, 30, 40, 50}, false);
  // The hand on the frame does not hide it either.
  scene.setProbe(probeAt({20, 50, 30}, {20, 50, 30}, {}), 3);
  const RgbImage image = renderOffscreen(scene, 500, 500);  // 5 pixels a millimetre.
  const auto expect_frame = [&](int x, int y, bool vertical) {
    for (const int step : {-3, -2, -1, 0, 1, 2}) {
      const Rgb c = vertical ? at(image, x + step, y) : at(image, x, y + step);
      const bool pink = step == -1 || step == 0, dark = step == -2 || step == 1;
      EXPECT_EQ(c == kPinkRgb, pink) << x << ' ' << y << ' ' << step;
      if (dark) {
        EXPECT_LT(grey(c), 50);
      }
    }
  };
  for (const int y : {110, 180, 250, 340}) {
    expect_frame(100, y, true);
    expect_frame(300, y, true);
  }
  for (const int x : {110, 180, 250, 290}) {
    expect_frame(x, 100, false);
    expect_frame(x, 350, false);
  }
}

TEST(ReliefScene, ThePinkWindowHasEightHandlesIfAsked) {
  ReliefScene scene;
  scene.setSurface(flat(0).grid());
  scene.setCamera({.rect = kWhole});
  for (const bool handles : {false, true}) {
    scene.setPinkWindow(RectMm{20, 30, 40, 50}, handles);
    const RgbImage image = renderOffscreen(scene, 500, 500);
    int found = 0;
    for (const int x : {100, 200, 300}) {
      for (const int y : {100, 225, 350}) {
        found += at(image, x - 3, y - 3) == kPinkRgb && at(image, x + 2, y + 2) == kPinkRgb ? 1 : 0;
      }
    }
    EXPECT_EQ(found, handles ? 8 : 0);
  }
}

TEST(ReliefScene, TheProbeIsSeenThroughTheSurface) {
  ReliefScene scene;
  scene.setSurface(flat(20).grid());
  scene.setCamera({.rect = kWhole});
  scene.setProbe(probeAt({40, 60, 5}, {40, 48, -3}, {2, 0, 0}), 2);
  const RgbImage image = renderOffscreen(scene, 500, 500);
  EXPECT_TRUE(isBlue(at(image, 200, 200)));
  EXPECT_TRUE(isRed(at(image, 200, 260)));  // Middle of the HIP,
  for (const int dx : {-14, 14}) EXPECT_TRUE(isRed(at(image, 200 + dx, 260)));  // its ring,
  EXPECT_FALSE(isRed(at(image, 208, 260)));                                     // open between.
  EXPECT_GT(grey(at(image, 200, 230)), grey(at(image, 230, 230)) + 20);  // The line is lighter.
  EXPECT_TRUE(isAmber(at(image, 225, 200)));
}

TEST(ReliefScene, InAGreyAnaglyphTheHandIsARingWithACrossAndTheProxyABall) {
  ReliefScene scene;
  scene.setSurface(flat(0).grid());
  scene.setCamera({.rect = kWhole});
  scene.setProbe(probeAt({40, 60, 0}, {40, 40, 0}, {}), 2);  // 5 pixels a millimetre.
  EXPECT_TRUE(isRed(at(renderOffscreen(scene, 500, 500), 200, 300)));
  // On the plane of zero parallax both eyes see the same.
  scene.setStereo({.mode = StereoMode::anaglyph, .eye_angle_deg = 4, .zero_plane_mm = 0});
  const RgbImage image = renderOffscreen(scene, 500, 500);
  const Rgb ball = at(image, 200, 200), stone = at(image, 400, 400);
  EXPECT_LT(grey(ball), grey(stone) - 40) << "a full, dark ball";
  for (const int d : {-6, -4, 4, 6}) {
    for (const int side : {-1, 1}) {
      EXPECT_GT(grey(at(image, 200 + d, 300 + side * d)), 230) << "the cross, " << d;
      EXPECT_LT(grey(at(image, 200 + d, 200 + side * d)), grey(stone) - 20) << "no cross, " << d;
    }
  }
  for (const int d : {-14, 14}) {
    EXPECT_GT(grey(at(image, 200 + d, 300)), 230) << "the ring";
    EXPECT_GT(grey(at(image, 200, 300 + d)), 230) << "the ring";
  }
  for (const int d : {-8, 8}) {
    EXPECT_LT(std::abs(grey(at(image, 200 + d, 300)) - grey(stone)), 12) << "open between";
  }
  scene.setStereo({});
  EXPECT_TRUE(isRed(at(renderOffscreen(scene, 500, 500), 200, 300))) << "with colours as before";
}

TEST(ReliefScene, TheForceArrowIsAsLongAsTheForceIsLarge) {
  ReliefScene scene;
  scene.setSurface(flat(0).grid());
  scene.setCamera({.rect = kWhole});
  const auto length_px = [&](double newtons) {
    scene.setProbe(probeAt({30, 50, 0}, {30, 50, 0}, {newtons, 0, 0}), 2);
    const RgbImage image = renderOffscreen(scene, 500, 500);
    int last = 160;  // Where the ball ends: 5 pixels a millimetre.
    for (int x = 160; x < 500; ++x) {
      if (isAmber(at(image, x, 250)) || isAmber(at(image, x, 249))) last = x;
    }
    return last - 159;
  };
  EXPECT_NEAR(length_px(4), 100, 4);
  EXPECT_NEAR(length_px(8), 200, 4);
  EXPECT_EQ(length_px(0), 1);
}

TEST(ReliefScene, TheLightComesFromTheUpperLeftUntilItIsMoved) {
  ReliefScene scene;
  const SyntheticRelief dome = makeRelief(200, 100, [](double x, double y) {
    return 12 * std::exp(-(std::pow(x - 50, 2) + std::pow(y - 50, 2)) / 400);
  });
  scene.setSurface(dome.grid());
  scene.setCamera({.rect = kWhole});
  RgbImage image = renderOffscreen(scene, 400, 400);
  EXPECT_GT(meanGrey(image, 120, 120, 160, 160), meanGrey(image, 240, 240, 280, 280) + 40);
  const double sides = meanGrey(image, 120, 240, 160, 280) - meanGrey(image, 240, 120, 280, 160);
  EXPECT_NEAR(sides, 0, 8);
  scene.setLight({.azimuth_deg = 135, .elevation_deg = 45});
  image = renderOffscreen(scene, 400, 400);
  EXPECT_LT(meanGrey(image, 120, 120, 160, 160), meanGrey(image, 240, 240, 280, 280) - 40);
}

TEST(ReliefScene, FilledCellsAreMarkedAndTheBasePlaneMoreSo) {
  SyntheticRelief relief = flat(0);
  const GridFrame& f = relief.frame;
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 200; ++col) {
      CellStatus& origin = relief.origins[f.size.index({col, row})];
      if (col < 60) origin = CellStatus::interpolated;
      if (col > 140) origin = CellStatus::base_plane;
    }
  }
  ReliefScene scene;
  scene.setSurface(relief.grid());
  scene.setCamera({.rect = kWhole});
  const RgbImage image = renderOffscreen(scene, 400, 400);
  const double interpolated = meanGrey(image, 20, 50, 100, 350);
  const double measured = meanGrey(image, 150, 50, 250, 350);
  const double base = meanGrey(image, 300, 50, 380, 350);
  EXPECT_LT(interpolated, measured - 4);
  EXPECT_LT(base, interpolated - 8);
}

TEST(ReliefScene, TheHatchIsSeenOnEveryGround) {
  struct Ground {
    const char* name;
    int painted;           ///< 0 to 255; -1: stone.
    double elevation_deg;  ///< Of the light.
  };
  for (const Ground& ground : {Ground{"bright stone", -1, 80}, Ground{"grazed stone", -1, 2},
                               Ground{"white", 255, 45}, Ground{"black", 0, 45}}) {
    SyntheticRelief relief = flat(0);
    const GridFrame& f = relief.frame;
    for (int row = 0; row < 200; ++row) {
      for (int col = 0; col < 200; ++col) {
        relief.origins[f.size.index({col, row})] =
            col < 100 ? CellStatus::interpolated : CellStatus::base_plane;
      }
    }
    const std::vector<std::uint8_t> colours(3 * f.size.count(),
                                            static_cast<std::uint8_t>(ground.painted));
    ReliefScene scene;
    SurfaceGrid grid = relief.grid();
    if (ground.painted >= 0) {
      grid.colours = &colours;
      grid.lit = false;
    }
    scene.setSurface(grid);
    scene.setCamera({.rect = kWhole});
    scene.setLight({.azimuth_deg = 315, .elevation_deg = ground.elevation_deg});
    const RgbImage image = renderOffscreen(scene, 400, 400);
    for (const int left : {40, 240}) {
      double darkest = 255, lightest = 0;
      for (int y = 150; y < 250; ++y) {
        for (int x = left; x < left + 100; ++x) {
          darkest = std::min(darkest, grey(at(image, x, y)));
          lightest = std::max(lightest, grey(at(image, x, y)));
        }
      }
      EXPECT_GT(lightest - darkest, 70) << ground.name << (left < 200 ? ", filled" : ", hole");
    }
  }
}

TEST(ReliefScene, ReplacingTheSurfaceReplacesThePicture) {
  ReliefScene scene;
  scene.setCamera({.rect = kWhole});
  const SyntheticRelief dome = makeRelief(200, 100, domeWithRidges), level = flat(1);
  scene.setSurface(dome.grid());
  const RgbImage first = renderOffscreen(scene, 200, 200);
  scene.setSurface(level.grid());
  const RgbImage second = renderOffscreen(scene, 200, 200);
  scene.setSurface(dome.grid());
  EXPECT_EQ(renderOffscreen(scene, 200, 200).rgb, first.rgb);
  EXPECT_NE(second.rgb, first.rgb);
  scene.clearSurface();
  const RgbImage empty = renderOffscreen(scene, 200, 200);
  EXPECT_EQ(at(empty, 0, 0), at(empty, 100, 100));
}

TEST(ReliefScene, KeepsItsSharpnessFarFromTheOrigin) {
  SyntheticRelief near = makeRelief(200, 100, domeWithRidges), far = near;
  far.frame.first_x_mm += 4e6;
  far.frame.first_y_mm += 5e6;
  ReliefScene near_scene, far_scene;
  near_scene.setSurface(near.grid());
  near_scene.setCamera({.rect = kWhole});
  far_scene.setSurface(far.grid());
  far_scene.setCamera({.rect = {4e6, 5e6, 100, 100}});
  const RgbImage a = renderOffscreen(near_scene, 300, 300),
                 b = renderOffscreen(far_scene, 300, 300);
  int largest = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    largest = std::max(largest, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
  }
  EXPECT_LE(largest, 6);
}

/// Two half planes 5 mm above and below the plane z = 0, rough enough to correlate.
SyntheticRelief twoTerraces() {
  return makeRelief(400, 100, [](double x, double y) {
    const double rough = 0.5 * std::sin(1.7 * x + 0.9 * y) * std::cos(1.3 * y - 0.4 * x);
    return (x < 50 ? 5 : -5) + rough;
  });
}

TEST(ReliefScene, AnaglyphHasParallaxOfBothSignsAndNoneUpright) {
  ReliefScene scene;
  const SyntheticRelief relief = twoTerraces();
  scene.setSurface(relief.grid());
  scene.setCamera({.rect = {25, 25, 50, 50}});  // 10 pixels a millimetre.
  scene.setStereo({.mode = StereoMode::anaglyph, .eye_angle_deg = 4, .zero_plane_mm = 0.0});
  const RgbImage image = renderOffscreen(scene, 500, 500);
  const double expected = 10 * 2 * 5 * std::tan(2 * std::numbers::pi / 180);  // 3.49 pixels.
  // Red is the left eye's picture: what is nearer than the screen lies further right in it.
  const ChannelShift near = channelShift(image, 0, 1, {40, 150, 200, 350}, 8);
  const ChannelShift far = channelShift(image, 0, 1, {300, 150, 460, 350}, 8);
  EXPECT_NEAR(near.x, -expected, 0.3);
  EXPECT_NEAR(far.x, expected, 0.3);
  EXPECT_GE(std::abs(near.x), 3);
  EXPECT_NEAR(near.y, 0, 0.1);
  EXPECT_NEAR(far.y, 0, 0.1);
}

TEST(ReliefScene, TheZeroPlaneHasNoParallaxAndMonoHasNone) {
  ReliefScene scene;
  const SyntheticRelief relief = twoTerraces();
  scene.setSurface(relief.grid());
  scene.setCamera({.rect = {25, 25, 50, 50}});  // 10 pixels a millimetre.
  scene.setStereo({.mode = StereoMode::anaglyph, .eye_angle_deg = 4, .zero_plane_mm = 5.0});
  const RgbImage image = renderOffscreen(scene, 500, 500);
  EXPECT_NEAR(channelShift(image, 0, 1, {40, 150, 200, 350}, 8).x, 0, 0.2);
  EXPECT_NEAR(channelShift(image, 0, 1, {300, 150, 460, 350}, 8).x, 6.98, 0.4);
  scene.setStereo({});
  const RgbImage mono = renderOffscreen(scene, 500, 500);
  EXPECT_NEAR(channelShift(mono, 0, 1, {40, 150, 200, 350}, 8).x, 0, 0.02);
}

RgbImage pictureOf(vtkRenderWindow* window, int width, int height) {
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels);
  return {width,
          height,
          {pixels->GetPointer(0), pixels->GetPointer(0) + std::ptrdiff_t{3} * width * height}};
}

TEST(ReliefScene, StereoMayBeSwitchedBeforeOrAfterAWindowIsThere) {
  const SyntheticRelief relief = makeRelief(200, 100, domeWithRidges);
  const StereoOptions anaglyph{.mode = StereoMode::anaglyph};
  const DisplayConnection connection;  // Holds the server between this test's windows.
  RgbImage pictures[2];
  for (const bool before : {false, true}) {
    ReliefScene scene;
    scene.setSurface(relief.grid());
    scene.setCamera({.rect = kWhole});
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(300, 300);
    if (before) scene.setStereo(anaglyph);
    scene.attachTo(window);
    scene.prepare(300, 300);
    if (!before) {
      const RgbImage mono = pictureOf(window, 300, 300);
      EXPECT_NEAR(at(mono, 150, 150)[0], at(mono, 150, 150)[1], 12);
      scene.setStereo(anaglyph);
      scene.prepare(300, 300);
    }
    pictures[before ? 1 : 0] = pictureOf(window, 300, 300);
  }
  EXPECT_EQ(pictures[0].rgb, pictures[1].rgb);
}

TEST(ReliefScene, AWindowMayDrawItselfBeforeItIsPrepared) {
  const SyntheticRelief relief = makeRelief(200, 100, domeWithRidges);
  const DisplayConnection connection;
  ReliefScene scene;
  scene.setSurface(relief.grid());
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(200, 200);
  scene.attachTo(window);
  EXPECT_FALSE(isBlack(pictureOf(window, 200, 200)));
}

TEST(ReliefScene, RefusesASurfaceWhoseSizesDoNotFit) {
  ReliefScene scene;
  SyntheticRelief relief = flat(1);
  relief.heights_mm.pop_back();
  EXPECT_THROW(scene.setSurface(relief.grid()), ArgumentError);
  EXPECT_THROW(scene.setCamera({.rect = {0, 0, 0, 10}}), ArgumentError);
}

}  // namespace
}  // namespace relievo
