// SPDX-License-Identifier: BSD-3-Clause
// What a figure's files say and come back as, and what is refused before one is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/provenance/embedded.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/scan_fixtures.h"
#include "ui/figure/figure.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// A dome on a plate of 100 x 80 mm.
class FigureFilesTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    SurfaceOptions options;
    options.unit = LengthUnit::mm;
    options.view = ViewChoice{"top", {}};
    const Scan scan = test::latticeScan(101, 81, 1, [](double x, double y) {
      const double r = std::hypot(x - 50, y - 40) / 30;
      return r < 1 ? 8 * (1 - r * r) : 0;
    });
    surface_ = std::make_unique<Surface>(makeSurface(scan, options, rasterize));
  }
  static void TearDownTestSuite() { surface_.reset(); }
  void SetUp() override {
    project_.file = (folder_ / "relief.ply").string();
    project_.sha256 = std::string(64, 'a');
    project_.region = {.x_mm = 20, .y_mm = 10, .side_mm = 60, .level = {0}};
    project_.figure.width_mm = 85;
  }
  Figure draw() { return drawFigure(*surface_, project_); }

  static std::unique_ptr<Surface> surface_;
  test::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
  Project project_;
};
std::unique_ptr<Surface> FigureFilesTest::surface_;

TEST_F(FigureFilesTest, EachEyesFileComesBackAsThatEyesPicture) {
  project_.figure.dpi = 100;
  project_.figure.scale_1_to = 1.5;
  project_.figure.look.kind = ReliefKind::height;
  for (const StereoPrint stereo : {StereoPrint::off, StereoPrint::dubois}) {
    for (const bool swap : {false, true}) {
      project_.figure.stereo = stereo;
      project_.figure.swap_eyes = swap;
      const auto files = writeEyes(*surface_, project_, folder_ / "e.tif").files;
      ASSERT_EQ(files.size(), 2U);
      const std::array eyes{FigureEye::left, FigureEye::right};
      for (std::size_t i = 0; i < 2; ++i) {
        const auto state = embeddedState(files[i]);
        ASSERT_TRUE(state);
        const Project back = projectFromJson(*state, files[i].string());
        EXPECT_EQ(back.figure.eye, eyes.at(i));
        writeFigure(*surface_, back, folder_ / "again.png");
        EXPECT_EQ(cv::norm(cv::imread((folder_ / "again.png").string(), cv::IMREAD_UNCHANGED),
                           cv::imread(files[i].string(), cv::IMREAD_UNCHANGED), cv::NORM_INF),
                  0);
        const std::string caption = drawFigure(*surface_, back).facts.caption;
        EXPECT_NE(caption.find(std::string(name(eyes.at(i))) + " eye's picture of two"),
                  std::string::npos)
            << caption;
      }
      EXPECT_GT(
          cv::norm(cv::imread(files[0].string()), cv::imread(files[1].string()), cv::NORM_INF), 0);
    }
  }
}

TEST_F(FigureFilesTest, AStateWithoutAnEyeIsOfBoth) {
  std::string state = projectJson(project_);
  const std::string eye = "\"eye\":";
  const std::size_t at = state.find(eye);
  ASSERT_NE(at, std::string::npos);
  state.erase(at, state.find(',', at) + 1 - at);
  EXPECT_EQ(projectFromJson(state, "old").figure.eye, FigureEye::both);
}

TEST_F(FigureFilesTest, ASquareRegionIsASquareFigure) {
  project_.figure.layout = FigureLayout::detail;
  project_.figure.legend = false;
  for (const double width_mm : {85.0, 115.5, 173.0}) {
    for (const double dpi : {300.0, 450.0, 613.0}) {
      project_.figure.width_mm = width_mm;
      project_.figure.dpi = dpi;
      const FigureFacts facts = previewFigure(*surface_, project_, 100).facts;
      EXPECT_EQ(facts.width_px, facts.height_px) << width_mm << " mm, " << dpi << " dpi";
    }
  }
}

TEST_F(FigureFilesTest, AScaleThatLeavesNoPaperIsRefused) {
  project_.figure.scale_1_to = 1e8;
  for (const FigureLayout layout : {FigureLayout::reference_detail, FigureLayout::detail}) {
    project_.figure.layout = layout;
    try {
      draw();
      ADD_FAILURE() << name(layout);
    } catch (const ArgumentError& error) {
      EXPECT_NE(std::string(error.what()).find("at least 20 mm"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_THROW(writeEyes(*surface_, project_, folder_ / "e.png"), ArgumentError);
}

TEST_F(FigureFilesTest, ARecordingOfAnotherScanIsRefused) {
  project_.figure.dpi = 60;
  project_.figure.layout = FigureLayout::plot;
  const auto record = [&](const std::string& sha256) {
    Project touched = project_;
    touched.figure = {};
    touched.sha256 = sha256;
    std::string line = projectJson(touched);
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::ofstream(folder_ / "run.csv")
        << "# " << stateLine(line) << "\n"
        << "t_s,hip_z_mm,proxy_z_mm,f_x_N,f_y_N,f_z_N\n0,1,2,0,0,1\n1,0,2,0,0,2\n";
    ASSERT_TRUE(embeddedState(folder_ / "run.csv"));
  };
  project_.figure.recording = (folder_ / "run.csv").string();
  record(project_.sha256);
  EXPECT_EQ(draw().image.width, 201);
  record(std::string(64, 'b'));
  try {
    writeFigure(*surface_, project_, folder_ / "a.png");
    ADD_FAILURE() << "drawn";
  } catch (const FileError& error) {
    EXPECT_EQ(error.code, "E501");
    EXPECT_NE(std::string(error.what()).find("'run.csv' is no recording of 'relief.ply'"),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

TEST_F(FigureFilesTest, AFileThatCannotBeWrittenSaysWhyAndNoneIsWritten) {
  project_.figure.dpi = 60;
  const auto message = [&](const FigureFiles& files) {
    try {
      writeFigureFiles(*surface_, project_, files);
    } catch (const WriteError& error) {
      return std::string(error.what());
    }
    return std::string("written");
  };
  const fs::path none = folder_ / "none";
  for (const char* name : {"a.png", "a.tif", "a.pdf", "a.svg"}) {
    const std::string told = message({.figure = none / name});
    EXPECT_NE(told.find("(No such file or directory)"), std::string::npos) << told;
    EXPECT_EQ(told.find(" written"), std::string::npos) << told;
  }
  const fs::path figure = folder_ / "f.png";
  const std::string caption = message({.figure = figure, .caption = none / "c.txt"});
  EXPECT_NE(caption.find("(No such file or directory)"), std::string::npos) << caption;
  const std::string heights =
      message({.figure = figure, .both_eyes = true, .heights = none / "h.tif"});
  EXPECT_NE(heights.find("(No such file or directory)"), std::string::npos) << heights;
  EXPECT_TRUE(fs::is_empty(folder_)) << "nothing is half done";
  try {
    check(FigureFiles{.figure = "dd/"});
    ADD_FAILURE();
  } catch (const ArgumentError& error) {
    EXPECT_NE(std::string(error.what()).find("'dd/' does not"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace relievo
