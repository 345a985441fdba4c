// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/shader_warmup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include <vtk_glew.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include "tests/ui/vtk/synthetic_relief.h"
#include "ui/vtk/display_connection.h"

namespace relievo {
namespace {

constexpr int kSide = 200;

/// Counts the programs that the driver is asked to link, through GLEW's table.
class LinkCount {
 public:
  LinkCount() : before_(glLinkProgram) {
    count_ = 0;
    real_ = before_;
    __glewLinkProgram = [](GLuint program) {
      ++count_;
      real_(program);
    };
  }
  ~LinkCount() { __glewLinkProgram = before_; }
  LinkCount(const LinkCount&) = delete;
  LinkCount& operator=(const LinkCount&) = delete;
  int count() const { return count_; }

 private:
  PFNGLLINKPROGRAMPROC before_;
  static inline int count_ = 0;
  static inline PFNGLLINKPROGRAMPROC real_ = nullptr;
};

class FirstDrawsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(connection_.isOpen());
    window_->SetOffScreenRendering(1);
    window_->SetSize(kSide, kSide);
    window_->Start();  // Makes the context, and GLEW's table.
  }
  /// Everything a scene shows, one after the other.
  vtkNew<vtkUnsignedCharArray> drawAll() {
    SyntheticRelief relief = makeRelief(40, 40, [](double x, double y) { return 0.01 * x * y; });
    const std::vector<std::uint8_t> colours(3 * relief.frame.size.count(), 90);
    ReliefScene scene;
    scene.setSurface(relief.grid());
    scene.setCamera({.rect = {0, 0, 20, 20}});
    scene.setPinkWindow(RectMm{5, 5, 8, 8}, true);
    scene.setScaleBar(true);
    Probe probe;
    probe.proxy = {10, 10, 4};
    probe.hip = {10, 10, 2};
    probe.force = {0, 0, 2};
    scene.setProbe(probe, 1);
    window_->SetSize(kSide, kSide);
    scene.attachTo(window_);
    scene.prepare(kSide, kSide);
    window_->Render();
    SurfaceGrid painted = relief.grid();
    painted.colours = &colours;
    scene.setSurface(painted);
    StereoOptions stereo;
    stereo.mode = StereoMode::anaglyph;
    scene.setStereo(stereo);
    scene.prepare(kSide, kSide);
    window_->Render();
    scene.setStereo({});
    scene.setSurface(relief.grid());
    scene.prepare(kSide, kSide);
    window_->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window_->GetPixelData(0, 0, kSide - 1, kSide - 1, 0, pixels);
    return pixels;
  }
  vtkRenderWindow* window() { return window_; }

 private:
  DisplayConnection connection_;
  vtkNew<vtkRenderWindow> window_;
};

TEST_F(FirstDrawsTest, NothingIsLeftToCompileForAScene) {
  {
    ShaderWarmup first(window());
    while (first.step()) {
    }
  }
  const LinkCount links;
  drawAll();
  EXPECT_EQ(links.count(), 0);
}

TEST_F(FirstDrawsTest, NoStepCompilesMuch) {
  ShaderWarmup first(window());
  const LinkCount links;
  int most = 0, before = 0;
  while (first.step()) {
    most = std::max(most, links.count() - before);
    before = links.count();
  }
  EXPECT_GT(before, 4) << "the count counts";
  EXPECT_LE(most, 1);
}

TEST_F(FirstDrawsTest, PicturesAreThoseOfAWindowWithoutThem) {
  const auto plain = drawAll();
  {
    ShaderWarmup first(window());
    first.step();
    first.step();  // Left halfway, as by somebody who wants a picture at once.
  }
  const auto after = drawAll();
  ASSERT_EQ(plain->GetNumberOfValues(), 3 * kSide * kSide);
  ASSERT_EQ(plain->GetNumberOfValues(), after->GetNumberOfValues());
  EXPECT_EQ(std::vector<unsigned char>(plain->Begin(), plain->End()),
            std::vector<unsigned char>(after->Begin(), after->End()));
}

}  // namespace
}  // namespace relievo
