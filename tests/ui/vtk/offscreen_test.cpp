// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/offscreen.h"

#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <numbers>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <vtkRenderer.h>

#include "core/base/error.h"
#include "tests/ui/vtk/picture.h"
#include "tests/ui/vtk/synthetic_relief.h"
#include "ui/vtk/frame_renderer.h"
#include "ui/vtk/scale_length.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// The environment's DISPLAY is another one, or none, while this lives.
class OtherDisplay {
 public:
  explicit OtherDisplay(const char* name) {
    if (const char* now = std::getenv("DISPLAY")) before_ = now;
    if (name) {
      setenv("DISPLAY", name, 1);
    } else {
      unsetenv("DISPLAY");
    }
  }
  ~OtherDisplay() { setenv("DISPLAY", before_.c_str(), 1); }

 private:
  std::string before_;
};

bool canOpen(const std::string& display) {
  const OtherDisplay other(display.c_str());
  return haveDisplay();
}

class PictureFile : public ::testing::Test {
 protected:
  PictureFile() {
    folder_ = fs::temp_directory_path() / ("relievo_png_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  ~PictureFile() override { fs::remove_all(folder_); }

  RgbImage gradient(int width, int height) const {
    RgbImage image{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i) {
      image.rgb.push_back(static_cast<std::uint8_t>((i * 7 + i / 11) % 256));
    }
    return image;
  }
  fs::path folder_;
};

struct ReadBack {
  RgbImage image;
  std::map<std::string, std::string> text;
};

ReadBack readPng(const fs::path& file) {
  std::FILE* in = std::fopen(file.c_str(), "rb");
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, in);
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  ReadBack back;
  back.image.width = static_cast<int>(png_get_image_width(png, info));
  back.image.height = static_cast<int>(png_get_image_height(png, info));
  for (int row = 0; row < back.image.height; ++row) {
    const png_byte* bytes = png_get_rows(png, info)[row];
    back.image.rgb.insert(back.image.rgb.end(), bytes,
                          bytes + std::ptrdiff_t{3} * back.image.width);
  }
  png_textp entries = nullptr;
  int count = 0;
  png_get_text(png, info, &entries, &count);
  for (int i = 0; i < count; ++i) back.text[entries[i].key] = entries[i].text;
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(in);
  return back;
}

TEST_F(PictureFile, PixelsAndTextComeBack) {
  const RgbImage image = gradient(37, 21);
  const fs::path file = folder_ / "figure.png";
  writePng(file, image,
           {{"Title", "Ganesh, detail 2 of 4"},
            {"Author", "J\u00f6rg \u00c5ngstr\u00f6m"},
            {"relievo:state", R"({"level": 2, "region_mm": [1, 2, 3, 4]})"}});
  ReadBack back = readPng(file);
  EXPECT_EQ(back.image.width, 37);
  EXPECT_EQ(back.image.height, 21);
  EXPECT_EQ(back.image.rgb, image.rgb);
  EXPECT_EQ(back.text["Title"], "Ganesh, detail 2 of 4");
  EXPECT_EQ(back.text["Author"], "J\u00f6rg \u00c5ngstr\u00f6m");
  EXPECT_EQ(back.text["relievo:state"], R"({"level": 2, "region_mm": [1, 2, 3, 4]})");
}

TEST_F(PictureFile, AFailureLeavesNothingBehindAndTheOldFileAsItWas) {
  EXPECT_THROW(writePng(folder_ / "missing" / "figure.png", gradient(4, 4)), WriteError);
  const fs::path taken = folder_ / "taken.png";
  fs::create_directories(taken / "inside");  // A folder cannot be replaced by a file.
  EXPECT_THROW(writePng(taken, gradient(4, 4)), WriteError);
  EXPECT_THROW(writePng(folder_ / "none.png", RgbImage{}), WriteError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(PictureFile, AFullDiskIsAnError) {
  // A limit on the size of files, which the system reports as it does a full disk.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 500;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(writePng(folder_ / "full.png", gradient(300, 300)), WriteError);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST(Offscreen, APictureThatCannotBeHeldIsAnErrorAndNotBlack) {
  ReliefScene scene;
  EXPECT_THROW(renderOffscreen(scene, 200'000, 20'000), ArgumentError);
  EXPECT_THROW(renderOffscreen(scene, 0, 16), ArgumentError);
}

ReliefScene& shownFromAbove(ReliefScene& scene, const SyntheticRelief& relief) {
  scene.setSurface(relief.grid());
  scene.setCamera({.rect = {0, 0, 100, 100}});
  return scene;
}

TEST(Offscreen, APictureInTilesIsThePictureInOnePiece) {
  const SyntheticRelief relief = makeRelief(200, 100, domeWithRidges);
  ReliefScene scene;
  shownFromAbove(scene, relief).setPinkWindow(RectMm{20, 30, 40, 40}, true);
  scene.setScaleBar(true);
  const RgbaImage whole = renderPicture(scene, {.width = 500, .height = 430});
  const RgbaImage tiled = renderPicture(scene, {.width = 500, .height = 430, .tile_px = 128});
  ASSERT_EQ(whole.rgba.size(), tiled.rgba.size());
  int most = 0;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
    const int difference = std::abs(whole.rgba[i] - tiled.rgba[i]);
    most = std::max(most, difference);
    if (difference > 2) ++differing;
  }
  // Where the edge of the relief or of a facet passes a pixel's samples within rounding.
  EXPECT_LT(differing, whole.rgba.size() / 1000) << "at most " << most;
}

TEST(Offscreen, DrawingInPartsThatCanBeStoppedDoesNotShow) {
  const SyntheticRelief relief = makeRelief(200, 100, domeWithRidges);
  ReliefScene scene;
  shownFromAbove(scene, relief);
  const PictureOptions options{.width = 300, .height = 240};
  const std::stop_source stop;
  const RgbaImage in_parts = renderPicture(scene, options, Task{stop.get_token(), {}});
  EXPECT_EQ(in_parts.rgba, renderPicture(scene, options).rgba);
}

TEST(Offscreen, CancelNeedsNotWaitForTheTile) {
  const SyntheticRelief relief = makeRelief(200, 100, domeWithRidges);
  ReliefScene scene;
  shownFromAbove(scene, relief);
  std::stop_source stop;
  const Task task{stop.get_token(), [&](std::string_view, double) { stop.request_stop(); }};
  EXPECT_THROW(renderPicture(scene, {.width = 300, .height = 240}, task), Cancelled);
}

/// Mean step between neighbouring columns (or rows) `at` - 1 and `at`, of 8 bits.
double stepAcross(const RgbaImage& image, int at, bool columns) {
  double sum = 0;
  const int length = columns ? image.height : image.width;
  for (int i = 0; i < length; ++i) {
    const auto pixel = [&](int k) {
      const auto x = static_cast<std::size_t>(columns ? k : i);
      const auto y = static_cast<std::size_t>(columns ? i : k);
      return 4 * (y * static_cast<std::size_t>(image.width) + x);
    };
    for (std::size_t c = 0; c < 3; ++c) {
      sum += std::abs(image.rgba[pixel(at) + c] - image.rgba[pixel(at - 1) + c]);
    }
  }
  return sum / (3.0 * length);
}

// 180 mm at 600 dots per inch are 4252 pixels.
TEST(Offscreen, APrintOf180MmAt600DpiHasNoSeams) {
  constexpr int kPixels = 4252;
  const SyntheticRelief relief = makeRelief(400, 100, domeWithRidges);
  ReliefScene scene;
  shownFromAbove(scene, relief);
  const RgbaImage image = renderPicture(scene, {.width = kPixels, .height = kPixels});
  const RgbaImage other =
      renderPicture(scene, {.width = kPixels, .height = kPixels, .tile_px = 1500});
  std::size_t differing = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (std::abs(image.rgba[i] - other.rgba[i]) > 2) ++differing;
  }
  EXPECT_LT(differing, image.rgba.size() / 1000);
  for (const bool columns : {true, false}) {
    for (const int border : {2048, 4096}) {
      // In the rows tiles count from below.
      const int at = columns ? border : kPixels - border;
      double around = 0;
      for (const int k : {-3, -2, -1, 1, 2, 3}) {
        around = std::max(around, stepAcross(image, at + k, columns));
      }
      const double here = stepAcross(image, at, columns);
      std::printf("step across the border at %d: %.3f, beside it at most %.3f\n", at, here, around);
      EXPECT_LE(here, 1.5 * around + 0.1);
    }
  }
}

TEST(Offscreen, APictureBeyondTheDriversLimitHasNoBlackPart) {
  const SyntheticRelief relief = makeRelief(50, 100, domeWithRidges);
  ReliefScene scene;
  shownFromAbove(scene, relief);
  const RgbImage image = renderOffscreen(scene, 20'000, 40);
  for (const int x : {5, 2047, 2048, 9'999, 16'500, 19'990}) {
    EXPECT_GT(grey(at(image, x, 20)), 20) << x;
  }
}

TEST(Offscreen, ATransparentPictureHasAlphaOnTheReliefAlone) {
  const SyntheticRelief relief = makeRelief(50, 100, [](double, double) { return 1.0; });
  ReliefScene scene;
  scene.setSurface(relief.grid());
  scene.setCamera({.rect = {-50, 0, 200, 100}});
  const RgbaImage image = renderPicture(scene, {.width = 200, .height = 100, .transparent = true});
  const auto alpha = [&](int x, int y) {
    return image.rgba[4 * static_cast<std::size_t>(y * 200 + x) + 3];
  };
  EXPECT_EQ(alpha(10, 50), 0);
  EXPECT_EQ(alpha(190, 50), 0);
  EXPECT_EQ(alpha(100, 50), 255);
  EXPECT_EQ(image.rgba[4 * (50 * 200 + 10)], 0) << "nothing shines through";
}

TEST(Offscreen, APaintedReliefKeepsItsColoursWithoutLampsAndIsShadedWithThem) {
  const SyntheticRelief relief = makeRelief(50, 100, domeWithRidges);
  std::vector<std::uint8_t> colours;
  for (std::size_t i = 0; i < relief.heights_mm.size(); ++i) {
    colours.insert(colours.end(), {20, 160, 220});
  }
  SurfaceGrid grid = relief.grid();
  grid.colours = &colours;
  grid.lit = false;
  ReliefScene scene;
  scene.setSurface(grid);
  scene.setCamera({.rect = {0, 0, 100, 100}});
  const RgbImage flat = renderOffscreen(scene, 100, 100);
  for (const int x : {5, 50, 80}) EXPECT_EQ(at(flat, x, 50), (Rgb{20, 160, 220})) << x;
  grid.lit = true;
  scene.setSurface(grid);
  const RgbImage lit = renderOffscreen(scene, 100, 100);
  EXPECT_NE(at(lit, 20, 30), at(lit, 80, 70));
  EXPECT_GT(at(lit, 30, 30)[2], 3 * at(lit, 30, 30)[0]) << "still blue";
  const SurfaceGrid stone = relief.grid();
  scene.setSurface(stone);
  const Rgb c = at(renderOffscreen(scene, 100, 100), 30, 30);
  EXPECT_NEAR(c[0], c[2], 20);
}

TEST(Offscreen, TheEyesMoveWhatIsHighApartAndNothingUpOrDown) {
  const SyntheticRelief relief = makeRelief(200, 100, domeWithRidges);
  ReliefScene scene;
  shownFromAbove(scene, relief).setStereo({.zero_plane_mm = 0});
  scene.setEyeTurn(-3);
  const RgbImage left = renderOffscreen(scene, 300, 300);
  scene.setEyeTurn(3);
  const RgbImage right = renderOffscreen(scene, 300, 300);
  // The left eye's red and the right eye's green, as in an anaglyph.
  RgbImage both = left;
  for (std::size_t i = 0; i < both.rgb.size(); i += 3) both.rgb[i + 1] = right.rgb[i + 1];
  const ChannelShift top = channelShift(both, 0, 1, {120, 120, 180, 180}, 20);
  // 10 mm high, 3 pixels a millimetre: 2 sin(3 degrees) 30 pixels toward the left for the right
  // eye.
  EXPECT_NEAR(top.x, -2 * std::sin(3 * std::numbers::pi / 180) * 30, 0.6);
  EXPECT_NEAR(top.y, 0, 0.2);
}

TEST(Offscreen, WhatIsDrawnInBlackIsAPicture) {
  ReliefScene scene;
  scene.setBackground(0, 0, 0);
  EXPECT_TRUE(isBlack(renderOffscreen(scene, 20, 10)));
  const SyntheticRelief relief = makeRelief(10, 10, [](double, double) { return 1.0; });
  // As the lowest value in shades of grey.
  const std::vector<std::uint8_t> black(3 * relief.heights_mm.size(), 0);
  SurfaceGrid grid = relief.grid();
  grid.colours = &black;
  grid.lit = false;
  scene.setSurface(grid);
  scene.setBackground(1, 1, 1);
  scene.setCamera({.rect = {2, 2, 4, 4}});
  EXPECT_TRUE(isBlack(renderOffscreen(scene, 600, 600))) << "in four tiles";
  const RgbaImage through = renderPicture(scene, {.width = 20, .height = 20, .transparent = true});
  EXPECT_EQ(through.rgba[3], 255);
  FrameRenderer frames(20, 20);
  frames.scene().setSurface(grid);
  frames.scene().setCamera({.rect = {2, 2, 4, 4}});
  EXPECT_EQ(frames.draw().rgba[0], 0);
}

TEST(Offscreen, WhatTheDriverDidNotDrawIsAFailure) {
  EXPECT_FALSE(anythingDrawn(std::vector<std::uint8_t>(16, 0)));
  EXPECT_TRUE(anythingDrawn(std::vector<std::uint8_t>{0, 0, 0, 255}));
  const SyntheticRelief relief = makeRelief(10, 10, [](double, double) { return 1.0; });
  FrameRenderer frames(20, 20);
  frames.scene().setSurface(relief.grid());
  frames.scene().setCamera({.rect = {0, 0, 10, 10}});
  frames.scene().renderer()->DrawOff();  // As a driver that leaves the memory as it was.
  EXPECT_THROW(frames.draw(), GraphicsError);
}

TEST(Offscreen, TheSamePictureComesOutTwice) {
  const SyntheticRelief relief = makeRelief(100, 100, domeWithRidges);
  ReliefScene scene;
  scene.setSurface(relief.grid());
  scene.setCamera({.rect = {0, 0, 100, 100}});
  scene.setScaleBar(true);
  EXPECT_EQ(renderOffscreen(scene, 320, 200).rgb, renderOffscreen(scene, 320, 200).rgb);
}

/// In large text a window that is not large leaves little room for its views.
TEST(Offscreen, TheScaleBarOfASmallViewFitsIntoIt) {
  const auto picture = [](bool bar, int width, int height) {
    ReliefScene scene;
    scene.setCamera({.rect = {0, 0, 1.5, 1.0}});
    scene.setScaleBar(bar);
    scene.setMarkScale(fittingMarkScale(3, width, height));
    return renderPicture(scene, {.width = width, .height = height});
  };
  for (const auto& [width, height] : {std::pair{215, 165}, std::pair{430, 120}}) {
    const RgbaImage with = picture(true, width, height), without = picture(false, width, height);
    int marked = 0;
    for (int i = 0; i < width * height; ++i) {
      const auto at = static_cast<std::size_t>(4 * i);
      if (std::equal(&with.rgba[at], &with.rgba[at] + 4, &without.rgba[at])) continue;
      ++marked;
      const int col = i % width, row = i / width;
      EXPECT_TRUE(col > 0 && col < width - 1 && row > 0 && row < height - 1) << col << ", " << row;
    }
    EXPECT_GT(marked, 200);
    EXPECT_LT(marked, width * height / 5) << "most of the view is free";
  }
  EXPECT_EQ(fittingMarkScale(3, 1200, 900), 3) << "as wanted where there is room";
}

/// Pictures whose scale bars differ in number and size.
std::vector<std::vector<std::uint8_t>> picturesWithLabels() {
  constexpr int kPictures = 120;
  FrameRenderer frames(160, 120);
  frames.scene().setScaleBar(true);
  std::vector<std::vector<std::uint8_t>> pictures;
  for (int i = 0; i < kPictures; ++i) {
    const double side_mm = std::pow(1.2, i);
    frames.scene().setMarkScale(1 + 0.05 * (i % 30));
    frames.scene().setCamera({.rect = {0, 0, side_mm, side_mm}});
    pictures.push_back(frames.draw().rgba);
  }
  return pictures;
}

TEST(Offscreen, LabelsOfSeveralThreadsAreThoseOfOne) {
  const auto expected = picturesWithLabels();
  std::array<std::vector<std::vector<std::uint8_t>>, 4> drawn;
  {
    std::vector<std::jthread> threads;
    for (auto& pictures : drawn) {
      threads.emplace_back([&pictures] { pictures = picturesWithLabels(); });
    }
  }
  for (const auto& pictures : drawn) EXPECT_TRUE(pictures == expected);
}

TEST(Offscreen, WithoutADisplayItSaysSo) {
  const OtherDisplay none(nullptr);
  EXPECT_FALSE(haveDisplay());
  ReliefScene scene;
  EXPECT_THROW(renderOffscreen(scene, 20, 20), GraphicsError);
}

TEST(DisplayGuard, StartsAServerWhereThereIsNoneAndStopsItAgain) {
  const OtherDisplay none(nullptr);
  std::string name;
  {
    const DisplayGuard guard;
    name = std::getenv("DISPLAY");
    EXPECT_TRUE(haveDisplay());
    ReliefScene scene;
    EXPECT_EQ(renderOffscreen(scene, 30, 20).rgb.size(), 30U * 20U * 3U);
  }
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
  EXPECT_FALSE(canOpen(name));
}

TEST(DisplayGuard, LeavesAWorkingDisplayAlone) {
  ASSERT_TRUE(haveDisplay());
  const std::string before = std::getenv("DISPLAY");
  const DisplayGuard guard;
  EXPECT_EQ(before, std::getenv("DISPLAY"));
}

TEST(DisplayGuard, ReplacesADeadDisplay) {
  const OtherDisplay dead(":987");
  const DisplayGuard guard;
  EXPECT_STRNE(std::getenv("DISPLAY"), ":987");
  EXPECT_TRUE(haveDisplay());
}

TEST(DisplayGuard, SaysSoWhereXvfbIsMissing) {
  const OtherDisplay none(nullptr);
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  EXPECT_THROW(DisplayGuard(), GraphicsError);
  setenv("PATH", path.c_str(), 1);
}

TEST(DisplayGuard, ItsServerHearsNoCtrlC) {
  const OtherDisplay none(nullptr);
  const DisplayGuard guard;
  // A terminal sends Ctrl+C to every process of its group.
  const std::string self = std::to_string(getpid());
  std::ifstream children("/proc/self/task/" + self + "/children");
  if (!children) GTEST_SKIP() << "the system lists no child processes";
  int servers = 0;
  for (pid_t child = 0; children >> child;) {
    EXPECT_NE(getpgid(child), getpgrp());
    ++servers;
  }
  EXPECT_EQ(servers, 1);
}

TEST(DisplayGuard, ItsServerEndsWithTheProcess) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("DISPLAY");
    const DisplayGuard guard;
    const std::string name = std::getenv("DISPLAY");
    if (write(ends[1], name.data(), name.size()) < 0) _exit(1);
    kill(getpid(), SIGKILL);
  }
  close(ends[1]);
  char buffer[32] = {};
  ASSERT_GT(read(ends[0], buffer, sizeof buffer - 1), 0);
  waitpid(child, nullptr, 0);
  bool gone = false;
  for (int tries = 0; tries < 100 && !gone; ++tries) gone = !canOpen(buffer);
  EXPECT_TRUE(gone);
}

}  // namespace
}  // namespace relievo
