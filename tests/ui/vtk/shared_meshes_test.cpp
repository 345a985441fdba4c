// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "core/io/import.h"
#include "core/session/surface.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/ui/vtk/depth_comparison.h"

namespace relievo {
namespace {

/// The engines on a scan as the program would ask them, 800 samples across, automatic view.
void expectEnginesAgreeOn(const std::string& name) {
  const std::filesystem::path folder = test::sharedData();
  if (folder.empty()) GTEST_SKIP() << "The shared scans are not here.";
  const Scan scan = importScan(folder / name);
  ASSERT_FALSE(scan.triangles.empty());
  FrontDepths cpu, gl;
  GridFrame frame;
  const DepthEngine both = [&](const DepthRequest& request, const Task& task) {
    frame = request.frame;
    cpu = rasterize(request, task).front;
    gl = captureDepths(request, task).front;
    return cpu;
  };
  SurfaceOptions options;
  options.cells = 800;
  makeSurface(scan, options, both);
  expectEnginesAgree(cpu, gl, frame.size, 3 * frame.spacing_mm, 0.05);
}

TEST(SharedMeshes, BothEnginesSeeTheSameArmadillo) {
  expectEnginesAgreeOn("obj/armadillo.obj");
}
TEST(SharedMeshes, BothEnginesSeeTheSameBunny) {
  expectEnginesAgreeOn("ply/bun_zipper.ply");
}
TEST(SharedMeshes, BothEnginesSeeTheSameStlBunny) {
  expectEnginesAgreeOn("stl/bunny.stl");
}
TEST(SharedMeshes, BothEnginesSeeTheSameMountain) {
  expectEnginesAgreeOn("obj/mountain.obj");
}
TEST(SharedMeshes, BothEnginesSeeTheSameDemosthenes) {
  expectEnginesAgreeOn("obj/demosthenes-low-res.obj");
}

}  // namespace
}  // namespace relievo
