// SPDX-License-Identifier: BSD-3-Clause
// Pictures on OBJ meshes: what is read, and what an OBJ must not make the program open.
#include <cpl_string.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>
#include <vector>

#include "core/io/import.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Rows from the top: red green / blue white.
void writePicture(const std::filesystem::path& file, const char* driver, int cols = 2,
                  int rows = 2) {
  GDALRegister_GTiff();
  GDALRegister_PNG();
  GDALRegister_JPEG();
  GDALRegister_MEM();
  GDALDriverManager* const drivers = GetGDALDriverManager();
  GDALDataset* const memory =
      drivers->GetDriverByName("MEM")->Create("", cols, rows, 3, GDT_Byte, nullptr);
  std::vector<std::uint8_t> texels{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  if (cols == 2 && rows == 2) {
    EXPECT_EQ(memory->RasterIO(GF_Write, 0, 0, 2, 2, texels.data(), 2, 2, GDT_Byte, 3, nullptr, 3,
                               6, 1, nullptr),
              CE_None);
  }
  GDALClose(drivers->GetDriverByName(driver)->CreateCopy(file.c_str(), memory, 0, nullptr, nullptr,
                                                         nullptr));
  GDALClose(memory);
}

const std::string kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string kFace = "f 1/1 2/2 3/3 4/-1\n";

class ObjTexture : public ::testing::Test {
 protected:
  Scan load(const std::string& material, const std::string& content) {
    folder_.write("a.mtl", material);
    return importScan(folder_.write("a.obj", content));
  }
  std::string file(const std::string& picture) const { return "newmtl stone\nmap_Kd " + picture; }
  TemporaryFolder folder_;
};

TEST_F(ObjTexture, PngJpegAndTiffAreReadWithTheirPlaces) {
  for (const auto& [name, driver] :
       std::vector<std::pair<std::string, const char*>>{{"a.png", "PNG"}, {"a.tif", "GTiff"}}) {
    SCOPED_TRACE(name);
    writePicture(folder_.path() / name, driver);
    const Scan scan = load(file(name), "mtllib a.mtl\n" + kQuad + "usemtl stone\n" + kFace);
    EXPECT_THAT(scan.info.warnings, IsEmpty());
    ASSERT_EQ(scan.textures.size(), 1U);
    EXPECT_EQ(scan.textures[0].cols, 2U);
    EXPECT_THAT(scan.textures[0].texels,
                ElementsAre(Rgba{255, 0, 0, 255}, Rgba{0, 255, 0, 255}, Rgba{0, 0, 255, 255},
                            Rgba{255, 255, 255, 255}));
    EXPECT_THAT(scan.texture_of, ElementsAre(0, 0));
    ASSERT_EQ(scan.texture_corners.size(), 2U);
    EXPECT_EQ(scan.texture_corners[0], (TextureCorners{{{0, 0}, {1, 0}, {1, 1}}}));
    EXPECT_EQ(scan.texture_corners[1], (TextureCorners{{{0, 0}, {1, 1}, {0, 1}}}));
    ASSERT_TRUE(scan.info.colour.has_value());
    EXPECT_EQ(scan.info.colour->source, "texture");
    EXPECT_EQ(scan.info.colour->points, 4U);
  }
  writePicture(folder_.path() / "a.jpg", "JPEG", 16, 8);
  EXPECT_EQ(load(file("a.jpg"), "mtllib a.mtl\n" + kQuad + "usemtl stone\n" + kFace)
                .textures.at(0)
                .texels.size(),
            128U);
}

TEST_F(ObjTexture, NamesMayHoldBlanksFoldersAndOptions) {
  std::filesystem::create_directories(folder_.path() / "my pictures");
  writePicture(folder_.path() / "my pictures" / "old stone.png", "PNG");
  for (const std::string name : {"my pictures/old stone.png", "my pictures\\old stone.png",
                                 "-s 1 1 1 -o 0.5 -clamp on my pictures/old stone.png"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(load(file(name), "mtllib a.mtl\n" + kQuad + "usemtl stone\n" + kFace).textures.size(),
              1U);
  }
}

TEST_F(ObjTexture, FacesOfOtherMaterialsAndWithoutPlacesHaveNone) {
  writePicture(folder_.path() / "a.png", "PNG");
  const Scan scan = load(file("a.png"), "mtllib a.mtl\n" + kQuad + "f 1/1 2/2 3/3\nusemtl stone\n" +
                                            "f 1/1 2/2 3/3\nf 1 2 3\nusemtl wood\nf 1/1 2/2 3/3\n");
  EXPECT_THAT(scan.texture_of, ElementsAre(kNoTexture, 0, kNoTexture, kNoTexture));
}

TEST_F(ObjTexture, WhatLiesOutsideOrIsNoPictureBecomesAWarning) {
  const TemporaryFolder outside;
  writePicture(outside.path() / "secret.png", "PNG");
  std::filesystem::create_symlink(outside.path() / "secret.png", folder_.path() / "link.png");
  ASSERT_EQ(::mkfifo((folder_.path() / "pipe.png").c_str(), 0600), 0);
  folder_.write("text.png", "no picture at all");
  folder_.write("list.vrt", "<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"/>");
  writePicture(folder_.path() / "long.tif", "GTiff", 20'000, 1);
  const std::string up = "../" + outside.path().filename().string() + "/secret.png";
  const std::vector<std::pair<std::string, std::string>> cases{
      {up, "outside its folder"},
      {(outside.path() / "secret.png").string(), "outside its folder"},
      {"link.png", "outside its folder"},
      {"pipe.png", "is no file"},
      {"missing.png", "is not there"},
      {"text.png", "is no PNG, JPEG or TIFF"},
      {"list.vrt", "is no PNG, JPEG or TIFF"},
      {"long.tif", "20000 x 1 pixels"}};
  for (const auto& [name, reason] : cases) {
    SCOPED_TRACE(name);
    const Scan scan = load(file(name), "mtllib a.mtl\n" + kQuad + "usemtl stone\n" + kFace);
    EXPECT_EQ(scan.triangles.size(), 2U);
    EXPECT_THAT(scan.textures, IsEmpty());
    EXPECT_FALSE(scan.info.colour.has_value());
    EXPECT_THAT(englishTexts(scan.info.warnings),
                ElementsAre(::testing::AllOf(HasSubstr(reason), HasSubstr("loaded without it"))));
  }
  outside.write("secret.mtl", "newmtl stone\nmap_Kd secret.png\n");
  std::filesystem::create_symlink(outside.path() / "secret.mtl", folder_.path() / "link.mtl");
  std::filesystem::create_directory_symlink(outside.path(), folder_.path() / "there");
  const std::string absolute = (outside.path() / "secret.mtl").string();
  for (const std::string& library : {std::string("../a.mtl"), std::string("link.mtl"),
                                     std::string("there/secret.mtl"), absolute}) {
    const Scan scan = load("", "mtllib " + library + "\n" + kQuad + "usemtl stone\n" + kFace);
    EXPECT_THAT(scan.textures, IsEmpty()) << library;
    EXPECT_THAT(englishTexts(scan.info.warnings), ElementsAre(HasSubstr("outside its folder")))
        << library;
  }
}

}  // namespace
}  // namespace relievo
