// SPDX-License-Identifier: BSD-3-Clause
// Which way up real objects are seen, whatever their file takes for up.
#include <gtest/gtest.h>

#include <string>

#include "core/depth/view.h"
#include "core/io/import.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

Scan stored(Scan scan, const Rotation& axes) {
  for (auto& p : scan.points) {
    const auto q = p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = static_cast<float>(axes[3 * k]) * q[0] + static_cast<float>(axes[3 * k + 1]) * q[1] +
             static_cast<float>(axes[3 * k + 2]) * q[2];
    }
  }
  scan.origin = {0, 0, 0};
  const std::string format = scan.info.format;
  test::finishScan(scan);
  scan.info.format = format;
  return scan;
}

TEST(SharedScans, StandUprightAndFaceTheViewer) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  for (const auto& [file, view] : {std::pair{"obj/armadillo.obj", "top"},
                                   {"obj/demosthenes-low-res.obj", "top"},
                                   {"obj/stanford-bunny.obj", "top"},
                                   {"obj/mountain.obj", "back, upside down"},
                                   {"obj/sword.obj", "right"},
                                   {"ply/DancingGirl_be.ply", "top"},
                                   {"3ds/DancingGirl.3ds", "top"},
                                   {"pcd/DancingGirl_binary.pcd", "top"},
                                   {"text/DancingGirl.asc", "top"},
                                   {"ply/ankylosaurus_mesh.ply", "back"},
                                   {"ply/bun_zipper.ply", "top"},
                                   {"stl/bunny.stl", "front"},
                                   {"pcd/cturtle.pcd", "bottom"},
                                   {"pcd/milk.pcd", "bottom"},
                                   {"pcd/rops_cloud.pcd", "top"},
                                   {"pcd/CSite3_orig-utm.pcd", "top"},
                                   {"las/autzen_trim.las", "top"}}) {
    const NamedRotation found = automaticRotation(importScan(data / file));
    EXPECT_EQ(found.name, view) << file;
    EXPECT_FALSE(found.is_weak && found.name != "right") << file;
  }
}

TEST(SharedScans, WithABaseStandUprightHoweverTheyAreStored) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  for (const char* file : {"obj/stanford-bunny.obj", "ply/DancingGirl_be.ply"}) {
    const Scan scan = importScan(data / file);
    for (const std::string face : {"top", "front", "right", "back", "left", "bottom"}) {
      for (const std::string turn :
           {"", ", turned to the left", ", turned to the right", ", upside down"}) {
        const Rotation axes = *namedRotation(face + turn);
        const NamedRotation view = automaticRotation(stored(scan, axes));
        double up = 0;
        for (std::size_t k = 0; k < 3; ++k) up += view.rotation[3 + k] * axes[3 * k + 1];
        EXPECT_EQ(up, 1) << file << " as " << face << turn << ": " << view.name;
      }
    }
  }
}

}  // namespace
}  // namespace relievo
