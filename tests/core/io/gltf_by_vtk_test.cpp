// SPDX-License-Identifier: BSD-3-Clause
// Our glTF opened by VTK's reader, which shares nothing with the code that writes it.
#include <gtest/gtest.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>

#include "core/io/export/export_grid.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

constexpr int kCols = 40;
constexpr int kRows = 30;
constexpr int kGap = 17 * kCols + 23;  ///< A cell outside the object.

/// A bowl in view millimetres, coloured by place.
ExportGrid bowl() {
  DepthMap map;
  map.frame = {
      .size = {.cols = kCols, .rows = kRows}, .spacing_mm = 0.5, .first_x_mm = 1, .first_y_mm = 2};
  ExportGrid grid;
  for (int i = 0; i < kCols * kRows; ++i) {
    const double x = i % kCols - 20;
    const double y = i / kCols - 15;
    map.heights_mm.push_back(static_cast<float>(0.01 * (x * x + y * y)));
    map.origins.push_back(i == kGap ? CellStatus::outside : CellStatus::measured);
  }
  grid = viewGrid(map);
  for (int i = 0; i < kCols * kRows; ++i) {
    grid.colours.push_back({static_cast<std::uint8_t>(6 * (i % kCols)),
                            static_cast<std::uint8_t>(8 * (i / kCols)), 90, 255});
  }
  return grid;
}

vtkSmartPointer<vtkPolyData> readByVtk(const std::filesystem::path& file) {
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const auto blocks =
      vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
  vtkSmartPointer<vtkPolyData> mesh;
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem()) {
    EXPECT_EQ(mesh, nullptr) << "more than one mesh";
    mesh = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject());
  }
  return mesh;
}

TEST(GltfByVtk, HasOurPlacesColoursAndTriangles) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "bowl.glb";
  const ExportGrid grid = bowl();
  exportGrid(file, grid, ExportFormat::gltf);
  const vtkSmartPointer<vtkPolyData> mesh = readByVtk(file);
  ASSERT_NE(mesh, nullptr);
  ASSERT_EQ(mesh->GetNumberOfPoints(), kCols * kRows - 1);
  EXPECT_EQ(mesh->GetNumberOfCells(), 2 * ((kCols - 1) * (kRows - 1) - 4));
  vtkDataArray* const colours = mesh->GetPointData()->GetArray("COLOR_0");
  ASSERT_NE(colours, nullptr);
  ASSERT_NE(mesh->GetPointData()->GetNormals(), nullptr);
  std::array<double, 3> first{};
  mesh->GetPoint(0, first.data());
  const auto linear = [](int byte) {
    const double stored = byte / 255.0;
    return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
  };
  // Whole numbers of 16 bits, or what they stand for.
  const double most = colours->GetRange(2)[1] > 1 ? 65535 : 1;
  vtkIdType point = 0;
  for (int i = 0; i < kCols * kRows; ++i) {
    if (i == kGap) continue;
    std::array<double, 3> place{};
    mesh->GetPoint(point, place.data());
    ASSERT_NEAR(place[0] - first[0], 0.0005 * (i % kCols), 1e-7) << i;
    ASSERT_NEAR(place[1] - first[1], 0.0005 * (i / kCols), 1e-7) << i;
    const auto at = static_cast<std::size_t>(i);
    const auto rise = static_cast<double>(grid.heights[at] - grid.heights[0]);
    ASSERT_NEAR(place[2] - first[2], 0.001 * rise, 1e-7) << i;
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(colours->GetComponent(point, k) / most,
                  linear(grid.colours[at][static_cast<std::size_t>(k)]), 2e-4)
          << i;
    }
    ++point;
  }
}

}  // namespace
}  // namespace relievo
