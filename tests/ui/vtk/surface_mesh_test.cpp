// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/surface_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "tests/ui/vtk/synthetic_relief.h"
#include "ui/vtk/screen_marks.h"

namespace relievo {
namespace {

/// Vertex of a sample: the mesh has a ring of vertices around the samples.
vtkIdType vertexOf(const GridFrame& frame, Cell cell) {
  return (cell.row + 1) * (frame.size.cols + 2) + cell.col + 1;
}

TEST(SurfaceMesh, NormalsOfAParaboloidAreItsOwn) {
  // Central differences are exact on a quadratic.
  const SyntheticRelief relief = makeRelief(
      50, 10, [](double x, double y) { return 0.2 * x * x - 0.1 * y * y + 0.3 * x * y; });
  SurfaceMesh mesh;
  mesh.update(relief.grid());
  for (int row = 1; row < 49; ++row) {
    for (int col = 1; col < 49; ++col) {
      const double x = relief.frame.xMm(col), y = relief.frame.yMm(row);
      const double dx = 0.4 * x + 0.3 * y, dy = -0.2 * y + 0.3 * x;
      const double length = std::sqrt(dx * dx + dy * dy + 1);
      double n[3];
      mesh.poly()->GetPointData()->GetNormals()->GetTuple(vertexOf(relief.frame, {col, row}), n);
      ASSERT_NEAR(n[0], -dx / length, 2e-4);
      ASSERT_NEAR(n[1], -dy / length, 2e-4);
      ASSERT_NEAR(n[2], 1 / length, 2e-4);
    }
  }
}

TEST(SurfaceMesh, CellsWithNoCornerInsideAreLeftOut) {
  SyntheticRelief relief = makeRelief(5, 5, [](double, double) { return 1.0; });
  SurfaceMesh mesh;
  mesh.update(relief.grid());
  EXPECT_EQ(mesh.poly()->GetNumberOfPolys(), 36);
  for (std::size_t i = 0; i < 25; ++i) {
    if (i != 12) relief.origins[i] = CellStatus::outside;
  }
  mesh.update(relief.grid());
  EXPECT_EQ(mesh.poly()->GetNumberOfPolys(), 4);  // Around the one sample that is left.
  relief.origins.assign(25, CellStatus::measured);
  relief.heights_mm[0] = std::numeric_limits<float>::quiet_NaN();  // Not a height: outside.
  relief.heights_mm[1] = relief.heights_mm[5] = relief.heights_mm[6] = relief.heights_mm[0];
  mesh.update(relief.grid());
  EXPECT_EQ(mesh.poly()->GetNumberOfPolys(), 32);
}

TEST(SurfaceMesh, TheRimIsLitLikeTheEdgeBesideIt) {
  SyntheticRelief relief = makeRelief(20, 20, [](double x, double) { return 2 * x; });
  for (int row = 0; row < 20; ++row) {
    for (int col = 12; col < 20; ++col) {
      relief.origins[relief.frame.size.index({col, row})] = CellStatus::outside;
    }
  }
  SurfaceMesh mesh;
  mesh.update(relief.grid());
  double inside[3], rim[3];
  vtkDataArray* const normals = mesh.poly()->GetPointData()->GetNormals();
  normals->GetTuple(vertexOf(relief.frame, {11, 10}), inside);
  normals->GetTuple(vertexOf(relief.frame, {12, 10}), rim);
  EXPECT_NEAR(inside[2], 1 / std::sqrt(5), 1e-6);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(rim[k], inside[k], 1e-6);
}

/// Of the points that cells have corners at: xmin, xmax, ymin, ymax, zmin, zmax.
std::array<double, 6> boundsOfCells(SurfaceMesh& mesh) {
  std::array<double, 6> bounds{};
  mesh.poly()->GetCellsBounds(bounds.data());
  return bounds;
}

TEST(SurfaceMesh, HasAQuarterOfTheCellsOverTheSameRectangleWhileCoarse) {
  for (const int samples : {20, 21}) {
    const SyntheticRelief relief = makeRelief(samples, 10, [](double x, double) { return 2 * x; });
    SurfaceMesh mesh;
    EXPECT_FALSE(mesh.setCoarse(false)) << "it is not";
    mesh.update(relief.grid());
    const auto whole = boundsOfCells(mesh);
    const vtkIdType all = mesh.poly()->GetNumberOfPolys();
    EXPECT_EQ(all, (samples + 1) * (samples + 1));
    EXPECT_TRUE(mesh.setCoarse(true));
    EXPECT_FALSE(mesh.setCoarse(true));
    const vtkIdType across = samples / 2 + 1;
    EXPECT_EQ(mesh.poly()->GetNumberOfPolys(), across * across);
    EXPECT_EQ(boundsOfCells(mesh), whole);
    mesh.update(relief.grid());
    EXPECT_EQ(mesh.poly()->GetNumberOfPolys(), across * across) << "of another window, too";
    EXPECT_TRUE(mesh.setCoarse(false));
    EXPECT_EQ(mesh.poly()->GetNumberOfPolys(), all);
    EXPECT_EQ(boundsOfCells(mesh), whole);
  }
}

TEST(SurfaceMesh, KeepsItsCellsWhileOnlyHeightsAndPlaceChange) {
  SyntheticRelief relief = makeRelief(20, 10, domeWithRidges);
  SurfaceMesh mesh;
  mesh.update(relief.grid());
  vtkCellArray* const cells = mesh.poly()->GetPolys();
  const auto cells_time = cells->GetMTime();
  relief.frame.first_x_mm += 3;
  for (float& h : relief.heights_mm) h += 1;
  mesh.update(relief.grid());
  EXPECT_EQ(mesh.poly()->GetPolys(), cells);
  EXPECT_EQ(cells->GetMTime(), cells_time);
  relief.origins[0] = relief.origins[1] = relief.origins[20] = relief.origins[21] =
      CellStatus::outside;
  mesh.update(relief.grid());
  EXPECT_NE(mesh.poly()->GetPolys(), cells);
}

TEST(SurfaceMesh, VerticesLieOnTheSamples) {
  SyntheticRelief relief = makeRelief(20, 10, domeWithRidges);
  SurfaceMesh mesh;
  mesh.update(relief.grid());
  double p[3];
  mesh.poly()->GetPoint(vertexOf(relief.frame, {3, 17}), p);
  EXPECT_NEAR(p[0] + mesh.middle().x, relief.frame.xMm(3), 1e-6);
  EXPECT_NEAR(p[1] + mesh.middle().y, relief.frame.yMm(17), 1e-6);
  EXPECT_NEAR(p[2] + mesh.middle().z,
              static_cast<double>(relief.heights_mm[relief.frame.size.index({3, 17})]), 1e-6);
}

TEST(SurfaceMesh, FillsTheRectangleThatTheGridCovers) {
  SyntheticRelief relief = makeRelief(20, 10, domeWithRidges);
  SurfaceMesh mesh;
  mesh.update(relief.grid());
  double bounds[6];
  mesh.poly()->GetPoints()->ComputeBounds();
  mesh.poly()->GetPoints()->GetBounds(bounds);
  EXPECT_NEAR(bounds[0] + mesh.middle().x, 0, 1e-6);
  EXPECT_NEAR(bounds[1] + mesh.middle().x, 10, 1e-6);
  EXPECT_NEAR(bounds[2] + mesh.middle().y, 0, 1e-6);
  EXPECT_NEAR(bounds[3] + mesh.middle().y, 10, 1e-6);
}

TEST(ScaleBar, LengthsAreRoundAndInTheUnitOneWouldSay) {
  const auto label = [](double at_most_mm) { return scaleLength(at_most_mm).label; };
  EXPECT_EQ(label(0.7), "0.5 mm");
  EXPECT_EQ(label(9.99), "5 mm");
  EXPECT_EQ(label(10), "10 mm");
  EXPECT_EQ(label(49), "20 mm");
  EXPECT_EQ(label(99), "50 mm");
  EXPECT_EQ(label(100), "10 cm");
  EXPECT_EQ(label(260), "20 cm");
  EXPECT_EQ(label(1000), "1 m");
  EXPECT_EQ(label(86000), "50 m");
  EXPECT_EQ(label(2.3e6), "2 km");
  EXPECT_EQ(label(0.004), "2 \u00b5m");
  for (double mm = 0.01; mm < 1e5; mm *= 1.37) {
    EXPECT_LE(scaleLength(mm).mm, mm * (1 + 1e-6));
    EXPECT_GE(scaleLength(mm).mm, mm / 2.5001);
  }
}

}  // namespace
}  // namespace relievo
