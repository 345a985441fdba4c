// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/surface_mesh.h"
#include "core/base/failure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

namespace relievo {

SurfaceMesh::SurfaceMesh() {
  vertices_->SetNumberOfComponents(3);
  normals_->SetNumberOfComponents(3);
  normals_->SetName("Normals");
  origins_->SetNumberOfComponents(3);
  origins_->SetName(kOriginArray);
  vtkNew<vtkPoints> points;
  points->SetData(vertices_);
  poly_->SetPoints(points);
  poly_->GetPointData()->SetNormals(normals_);
  poly_->GetPointData()->AddArray(origins_);
}

void SurfaceMesh::update(const SurfaceGrid& grid) {
  const GridSize size = grid.frame.size;
  if (!grid.heights_mm || grid.heights_mm->size() != size.count() ||
      (grid.origins && grid.origins->size() != size.count()) ||
      (grid.colours && grid.colours->size() != 3 * size.count())) {
    throw failure<MessageId::surface_lists_differ>();
  }
  if (size.cols < 2 || size.rows < 2 || !(grid.frame.spacing_mm > 0)) {
    throw failure<MessageId::surface_too_small>();
  }
  frame_ = grid.frame;
  classify(grid);
  middle_ = {frame_.xMm(0) + 0.5 * (size.cols - 1) * frame_.spacing_mm,
             frame_.yMm(0) + 0.5 * (size.rows - 1) * frame_.spacing_mm, 0.5 * (min_mm_ + max_mm_)};
  rebuildVertices(*grid.heights_mm);
  rebuildNormals(*grid.heights_mm);
  rebuildOrigins(grid);
  rebuildColours(grid);
  if (!(size_of_cells_ == size) || inside_of_cells_ != inside_) rebuildCells();
  poly_->GetPoints()->Modified();
  poly_->Modified();
}

void SurfaceMesh::classify(const SurfaceGrid& grid) {
  const std::size_t count = frame_.size.count();
  const float* const h = grid.heights_mm->data();
  inside_.resize(count);
  float lowest = std::numeric_limits<float>::max(), highest = std::numeric_limits<float>::lowest();
  std::size_t inside_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool inside =
        std::isfinite(h[i]) && !(grid.origins && (*grid.origins)[i] == CellStatus::outside);
    inside_[i] = inside ? 1 : 0;
    if (!inside) continue;
    ++inside_count;
    lowest = std::min(lowest, h[i]);
    highest = std::max(highest, h[i]);
  }
  all_inside_ = inside_count == count;
  min_mm_ = inside_count ? static_cast<double>(lowest) : 0.0;
  max_mm_ = inside_count ? static_cast<double>(highest) : 0.0;
}

namespace {

/// The mesh has one more ring of vertices than the grid, half a spacing beyond the outermost
/// samples and as high as they are: a map covers half a cell more all round.
GridSize withRing(GridSize size) {
  return {size.cols + 2, size.rows + 2};
}

/// Place of mesh column or row `i` in samples from the first one, of `count`.
double placeOf(int i, int count) {
  if (i == 0) return -0.5;
  return i == count + 1 ? count - 0.5 : i - 1.0;
}

int sampleOf(int i, int count) {
  return std::clamp(i - 1, 0, count - 1);
}

}  // namespace

void SurfaceMesh::rebuildVertices(const std::vector<float>& heights) {
  const GridSize size = frame_.size, mesh = withRing(size);
  vertices_->SetNumberOfTuples(static_cast<vtkIdType>(mesh.count()));
  float* out = vertices_->GetPointer(0);
  const auto z0 = static_cast<float>(middle_.z);
  const float outside_z = static_cast<float>(std::clamp(0.0, min_mm_, max_mm_)) - z0;
  std::vector<float> x(static_cast<std::size_t>(mesh.cols));
  for (int i = 0; i < mesh.cols; ++i) {
    x[static_cast<std::size_t>(i)] =
        static_cast<float>((placeOf(i, size.cols) - 0.5 * (size.cols - 1)) * frame_.spacing_mm);
  }
  for (int j = 0; j < mesh.rows; ++j) {
    const int row = sampleOf(j, size.rows);
    const auto y =
        static_cast<float>((placeOf(j, size.rows) - 0.5 * (size.rows - 1)) * frame_.spacing_mm);
    for (int i = 0; i < mesh.cols; ++i) {
      const std::size_t sample = size.index({sampleOf(i, size.cols), row});
      *out++ = x[static_cast<std::size_t>(i)];
      *out++ = y;
      *out++ = inside_[sample] ? heights[sample] - z0 : outside_z;
    }
  }
  vertices_->Modified();
}

// Central differences; at the rim of the object and of the grid one-sided, so that the jump to
// "outside" does not darken the outline.
void SurfaceMesh::rebuildNormals(const std::vector<float>& heights) {
  const GridSize size = frame_.size, mesh = withRing(size);
  normals_->SetNumberOfTuples(static_cast<vtkIdType>(mesh.count()));
  float* out = normals_->GetPointer(0);
  const auto stride = static_cast<std::size_t>(size.cols);
  const auto per_step = static_cast<float>(1 / frame_.spacing_mm);
  const float* const h = heights.data();
  const auto slope = [&](std::size_t here, std::size_t before, std::size_t after) {
    if (!all_inside_) {
      if (!inside_[here]) return 0.0F;
      if (!inside_[before]) before = here;
      if (!inside_[after]) after = here;
    }
    const std::size_t steps = (before != here ? 1U : 0U) + (after != here ? 1U : 0U);
    if (steps == 0) return 0.0F;
    return (h[after] - h[before]) * (steps == 2 ? 0.5F * per_step : per_step);
  };
  for (int j = 0; j < mesh.rows; ++j) {
    const int row = sampleOf(j, size.rows);
    const std::size_t down = row > 0 ? stride : 0, up = row + 1 < size.rows ? stride : 0;
    for (int i = 0; i < mesh.cols; ++i) {
      const int col = sampleOf(i, size.cols);
      const std::size_t here = size.index({col, row});
      const float dzdx =
          slope(here, col > 0 ? here - 1 : here, col + 1 < size.cols ? here + 1 : here);
      const float dzdy = slope(here, here - down, here + up);
      const float scale = 1.0F / std::sqrt(dzdx * dzdx + dzdy * dzdy + 1.0F);
      *out++ = -dzdx * scale;
      *out++ = -dzdy * scale;
      *out++ = scale;
    }
  }
  if (!all_inside_) shadeRimCells();
  normals_->Modified();
}

// A rim cell has corners outside. With the normals of their neighbours inside it is lit like the
// object's edge; with ones of their own it would be a bright line around every outline.
void SurfaceMesh::shadeRimCells() {
  const GridSize size = frame_.size, mesh = withRing(size);
  float* const normals = normals_->GetPointer(0);
  const auto is_inside = [&](int i, int j) {
    return inside_[size.index({sampleOf(i, size.cols), sampleOf(j, size.rows)})] != 0;
  };
  for (int j = 0; j < mesh.rows; ++j) {
    for (int i = 0; i < mesh.cols; ++i) {
      if (is_inside(i, j)) continue;
      std::array<float, 3> sum{};
      for (int nj = std::max(j - 1, 0); nj <= std::min(j + 1, mesh.rows - 1); ++nj) {
        for (int ni = std::max(i - 1, 0); ni <= std::min(i + 1, mesh.cols - 1); ++ni) {
          if (!is_inside(ni, nj)) continue;
          const float* const n = normals + 3 * mesh.index({ni, nj});
          for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
        }
      }
      const float length = std::hypot(sum[0], sum[1], sum[2]);
      if (!(length > 0)) continue;
      float* const out = normals + 3 * mesh.index({i, j});
      for (std::size_t k = 0; k < 3; ++k) out[k] = sum[k] / length;
    }
  }
}

void SurfaceMesh::rebuildOrigins(const SurfaceGrid& grid) {
  const GridSize size = frame_.size, mesh = withRing(size);
  const auto count = static_cast<vtkIdType>(mesh.count());
  if (!grid.origins && all_inside_) {
    if (origins_are_zero_ && origins_->GetNumberOfTuples() == count) return;
    origins_->SetNumberOfTuples(count);
    origins_->Fill(0);
    origins_are_zero_ = true;
  } else {
    origins_->SetNumberOfTuples(count);
    float* out = origins_->GetPointer(0);
    for (int j = 0; j < mesh.rows; ++j) {
      const int row = sampleOf(j, size.rows);
      for (int i = 0; i < mesh.cols; ++i) {
        const std::size_t sample = size.index({sampleOf(i, size.cols), row});
        const CellStatus origin = grid.origins ? (*grid.origins)[sample] : CellStatus::measured;
        *out++ = origin == CellStatus::interpolated ? 1.0F : 0.0F;
        *out++ = origin == CellStatus::base_plane ? 1.0F : 0.0F;
        *out++ = inside_[sample] ? 0.0F : 1.0F;
      }
    }
    origins_are_zero_ = false;
  }
  origins_->Modified();
}

void SurfaceMesh::rebuildColours(const SurfaceGrid& grid) {
  if (!grid.colours) {
    poly_->GetPointData()->SetScalars(nullptr);
    return;
  }
  const GridSize size = frame_.size, mesh = withRing(size);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(mesh.count()));
  unsigned char* out = colours->GetPointer(0);
  for (int j = 0; j < mesh.rows; ++j) {
    const int row = sampleOf(j, size.rows);
    for (int i = 0; i < mesh.cols; ++i) {
      const std::uint8_t* in = grid.colours->data() + 3 * size.index({sampleOf(i, size.cols), row});
      out = std::copy(in, in + 3, out);
    }
  }
  poly_->GetPointData()->SetScalars(colours);
}

namespace {

/// Vertices, of `count` in a row, that cells have corners at: all, or every second one and the
/// last.
std::vector<int> cornersOf(int count, bool coarse) {
  std::vector<int> corners;
  for (int i = 0; i + 1 < count; i += coarse ? 2 : 1) corners.push_back(i);
  corners.push_back(count - 1);
  return corners;
}

}  // namespace

bool SurfaceMesh::setCoarse(bool coarse) {
  if (coarse == is_coarse_) return false;
  is_coarse_ = coarse;
  if (frame_.size.count() != 0) rebuildCells();
  poly_->Modified();
  return true;
}

void SurfaceMesh::rebuildCells() {
  const GridSize size = frame_.size, mesh = withRing(size);
  const std::vector<int> across = cornersOf(mesh.cols, is_coarse_);
  const std::vector<int> up = cornersOf(mesh.rows, is_coarse_);
  const std::size_t quads_at_most = (across.size() - 1) * (up.size() - 1);
  vtkNew<vtkTypeInt32Array> offsets, corners;
  corners->SetNumberOfValues(4 * static_cast<vtkIdType>(quads_at_most));
  vtkTypeInt32* out = corners->GetPointer(0);
  vtkIdType quads = 0;
  for (std::size_t row = 0; row + 1 < up.size(); ++row) {
    const int j = up[row], next_j = up[row + 1];
    const int low = sampleOf(j, size.rows), high = sampleOf(next_j, size.rows);
    for (std::size_t col = 0; col + 1 < across.size(); ++col) {
      const int i = across[col], next_i = across[col + 1];
      const int left = sampleOf(i, size.cols), right = sampleOf(next_i, size.cols);
      if (!(inside_[size.index({left, low})] | inside_[size.index({right, low})] |
            inside_[size.index({left, high})] | inside_[size.index({right, high})])) {
        continue;
      }
      *out++ = static_cast<vtkTypeInt32>(mesh.index({i, j}));
      *out++ = static_cast<vtkTypeInt32>(mesh.index({next_i, j}));
      *out++ = static_cast<vtkTypeInt32>(mesh.index({next_i, next_j}));
      *out++ = static_cast<vtkTypeInt32>(mesh.index({i, next_j}));
      ++quads;
    }
  }
  corners->SetNumberOfValues(4 * quads);
  offsets->SetNumberOfValues(quads + 1);
  for (vtkIdType q = 0; q <= quads; ++q) offsets->SetValue(q, static_cast<vtkTypeInt32>(4 * q));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  poly_->SetPolys(cells);
  size_of_cells_ = size;
  inside_of_cells_ = inside_;
}

}  // namespace relievo
