// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/drawing/kept_surface.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <vector>

#include <vtk_glew.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include "tests/ui/vtk/synthetic_relief.h"
#include "ui/vtk/display_connection.h"

namespace relievo {
namespace {

constexpr int kSamples = 40;

/// Counts the draw calls that are as large as the surface, through GLEW's table.
class SurfaceCount {
 public:
  SurfaceCount() {
    count_ = 0;
    real_ = __glewDrawRangeElements;
    __glewDrawRangeElements = [](GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                                 const void* at) {
      if (count == kDrawn) ++count_;
      real_(mode, start, end, count, type, at);
    };
  }
  ~SurfaceCount() { __glewDrawRangeElements = real_; }
  SurfaceCount(const SurfaceCount&) = delete;
  SurfaceCount& operator=(const SurfaceCount&) = delete;
  int count() const { return count_; }

 private:
  static constexpr GLsizei kDrawn =
      3 * 2 * (kSamples + 1) * (kSamples + 1);  // A ring is around it.
  static inline int count_ = 0;
  static inline PFNGLDRAWRANGEELEMENTSPROC real_ = nullptr;
};

Probe probeAt(double x_mm) {
  Probe probe;
  probe.proxy = {x_mm, 10, 4};
  probe.hip = {x_mm, 10, 2};
  probe.force = {0, 0, 2};
  return probe;
}

/// A scene in a window off the screen, as a view has one.
class DrawnScene {
 public:
  explicit DrawnScene(bool keep) {
    window_->SetOffScreenRendering(1);
    window_->SetSize(width_, height_);
    window_->Start();  // Makes the context, and GLEW's table.
    scene_.setSurface(relief_.grid());
    scene_.setCamera({.rect = {0, 0, 20, 20}});
    scene_.setProbe(probeAt(10), 1);
    scene_.attachTo(window_);
    scene_.keepSurface(keep);
  }
  ReliefScene& scene() { return scene_; }
  SyntheticRelief& relief() { return relief_; }
  void setSize(int width, int height) {
    width_ = width;
    height_ = height;
  }
  std::vector<std::uint8_t> draw() {
    window_->SetSize(width_, height_);
    scene_.prepare(width_, height_);
    window_->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window_->GetPixelData(0, 0, width_ - 1, height_ - 1, 0, pixels);
    return {pixels->Begin(), pixels->End()};
  }

 private:
  int width_ = 160, height_ = 120;
  SyntheticRelief relief_ =
      makeRelief(kSamples, 20, [](double x, double y) { return 0.02 * x * y + 0.2 * x; });
  vtkNew<vtkRenderWindow> window_;
  ReliefScene scene_;  // Leaves the window before it goes.
};

class KeptSurfaceTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(connection_.isOpen()); }

 private:
  DisplayConnection connection_;
};

StereoOptions anaglyph(double angle_deg) {
  StereoOptions stereo;
  stereo.mode = StereoMode::anaglyph;
  stereo.eye_angle_deg = angle_deg;
  return stereo;
}

TEST_F(KeptSurfaceTest, IsDrawnOnceWhileOnlyTheHandMoves) {
  for (const bool in_stereo : {false, true}) {
    const int eyes = in_stereo ? 2 : 1;
    DrawnScene drawn(true);
    if (in_stereo) drawn.scene().setStereo(anaglyph(2));
    const SurfaceCount surfaces;
    drawn.draw();
    EXPECT_EQ(surfaces.count(), eyes) << "the count counts";
    for (int step = 0; step < 5; ++step) {
      drawn.scene().setProbe(probeAt(3 * step), 1);
      drawn.draw();
    }
    EXPECT_EQ(surfaces.count(), eyes);
    drawn.scene().setCamera({.rect = {1, 0, 20, 20}});
    drawn.draw();
    EXPECT_EQ(surfaces.count(), 2 * eyes);
  }
}

/// A change to a scene, by its name.
struct Change {
  const char* name;
  std::function<void(DrawnScene&)> make;
};

std::vector<Change> allChanges() {
  return {
      {"the hand", [](DrawnScene& d) { d.scene().setProbe(probeAt(4), 1); }},
      {"the hand above the surface",
       [](DrawnScene& d) {
         Probe high = probeAt(16);
         high.proxy.z = high.hip.z = 30;
         d.scene().setProbe(high, 1);
       }},
      {"light",
       [](DrawnScene& d) { d.scene().setLight({.azimuth_deg = 80, .elevation_deg = 20}); }},
      {"camera",
       [](DrawnScene& d) {
         d.scene().setCamera({.rect = {3, 2, 12, 12}});
       }},
      {"turned",
       [](DrawnScene& d) {
         d.scene().setCamera({{0, 0, 20, 20}, 25, 30});
       }},
      {"background", [](DrawnScene& d) { d.scene().setBackground(0.6, 0.2, 0.1); }},
      {"transparent", [](DrawnScene& d) { d.scene().setTransparent(true); }},
      {"another surface",
       [](DrawnScene& d) {
         d.relief().heights_mm[820] = 9;
         d.relief().origins[800] = d.relief().origins[801] = CellStatus::interpolated;
         d.relief().origins[840] = d.relief().origins[841] = CellStatus::interpolated;
         d.scene().setSurface(d.relief().grid());
       }},
      {"no mark", [](DrawnScene& d) { d.scene().setInterpolated(InterpolatedMark::none); }},
      {"hatch", [](DrawnScene& d) { d.scene().setInterpolated(InterpolatedMark::hatch); }},
      {"coarser hatch", [](DrawnScene& d) { d.scene().setMarkScale(2); }},
      {"eye", [](DrawnScene& d) { d.scene().setEyeTurn(6); }},
      {"middle", [](DrawnScene& d) { d.scene().setEyeTurn(0); }},
      {"both eyes", [](DrawnScene& d) { d.scene().setStereo(anaglyph(2)); }},
      {"the hand in stereo", [](DrawnScene& d) { d.scene().setProbe(probeAt(12), 1); }},
      {"farther apart", [](DrawnScene& d) { d.scene().setStereo(anaglyph(5)); }},
      {"coarse", [](DrawnScene& d) { d.scene().setCoarse(true); }},
      {"fine", [](DrawnScene& d) { d.scene().setCoarse(false); }},
      {"one eye", [](DrawnScene& d) { d.scene().setStereo({}); }},
      {"size", [](DrawnScene& d) { d.setSize(200, 90); }},
      {"a size as before", [](DrawnScene& d) { d.setSize(160, 120); }},
      {"no surface", [](DrawnScene& d) { d.scene().clearSurface(); }},
      {"the surface", [](DrawnScene& d) { d.scene().setSurface(d.relief().grid()); }},
  };
}

// Both are drawn twice after each change: the second picture is the kept one.
TEST_F(KeptSurfaceTest, NoPixelTellsAKeptPicture) {
  DrawnScene plain(false), kept(true);
  ASSERT_EQ(plain.draw(), kept.draw());
  for (const Change& change : allChanges()) {
    change.make(plain);
    change.make(kept);
    for (int picture = 0; picture < 2; ++picture) {
      EXPECT_TRUE(plain.draw() == kept.draw()) << change.name << ", picture " << picture;
    }
  }
}

}  // namespace
}  // namespace relievo
