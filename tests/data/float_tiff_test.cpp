// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/float_tiff.h"
#include "tests/core/io/temporary_folder.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

namespace relievo::samples {
namespace {

Reference smallReference() {
  Reference r;
  r.cols = 3;
  r.rows = 2;
  r.spacing = 0.5;
  r.first_x = 100.25;
  r.first_y = 7.25;
  r.z = {1, 2, 3, 4, 5, std::numeric_limits<float>::quiet_NaN()};
  return r;
}

class FloatTiff : public testing::Test {
 protected:
  void SetUp() override {
    file_ = test::ownPath("float.tif");
    writeFile(file_, floatTiffBytes(smallReference(), "mm"));
    GDALAllRegister();
    data_.reset(static_cast<GDALDataset*>(GDALOpen(file_.c_str(), GA_ReadOnly)));
    ASSERT_NE(data_, nullptr);
  }
  void TearDown() override {
    data_.reset();
    std::filesystem::remove(file_);
  }

  struct Close {
    void operator()(GDALDataset* d) const { GDALClose(d); }
  };
  std::filesystem::path file_;
  std::unique_ptr<GDALDataset, Close> data_;
};

TEST_F(FloatTiff, IsReadByGdalWithTheNorthernmostRowFirst) {
  ASSERT_EQ(data_->GetRasterXSize(), 3);
  ASSERT_EQ(data_->GetRasterYSize(), 2);
  std::array<float, 6> z{};
  ASSERT_EQ(
      data_->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 3, 2, z.data(), 3, 2, GDT_Float32, 0, 0),
      CE_None);
  EXPECT_EQ(z[0], 4);
  EXPECT_EQ(z[1], 5);
  EXPECT_TRUE(std::isnan(z[2]));
  EXPECT_EQ(z[3], 1);
}

TEST_F(FloatTiff, PutsSamplesIntoTheMiddleOfPixels) {
  std::array<double, 6> t{};
  ASSERT_EQ(data_->GetGeoTransform(t.data()), CE_None);
  EXPECT_EQ(t, (std::array<double, 6>{100, 0.5, 0, 8, 0, -0.5}));
}

TEST_F(FloatTiff, DeclaresNanAsNodata) {
  int declared = 0;
  EXPECT_TRUE(std::isnan(data_->GetRasterBand(1)->GetNoDataValue(&declared)));
  EXPECT_TRUE(declared);
}

}  // namespace
}  // namespace relievo::samples
