// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/depth_capture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <vtk_glew.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>

#include "core/base/failure.h"
#include "ui/vtk/gl_session.h"

namespace relievo {
namespace {

constexpr std::size_t kChunk = 250'000;  // Primitives drawn between two looks at the stop token.
constexpr int kTilePx = 2048;  // Small tiles keep float interpolation across them exact enough.
constexpr double kNudgePx = 1.0 / 64;      // Seen by every driver: at least 6 bits below a pixel.
constexpr double kOnSamplePx = 1.0 / 256;  // What drivers round to the sample itself.

/// Stored points to view millimetres; the large part (UTM easting, northing) is added once, in
/// double, as the CPU engine does it.
class ViewFromPoint {
 public:
  explicit ViewFromPoint(const DepthRequest& request)
      : m_(request.view_from_file.m), shift_(request.view_from_file(request.scan.origin)) {}
  ViewMm operator()(const std::array<float, 3>& p) const noexcept {
    const auto x = static_cast<double>(p[0]), y = static_cast<double>(p[1]),
               z = static_cast<double>(p[2]);
    return {m_[0] * x + m_[1] * y + m_[2] * z + shift_.x,
            m_[4] * x + m_[5] * y + m_[6] * z + shift_.y,
            m_[8] * x + m_[9] * y + m_[10] * z + shift_.z};
  }

 private:
  std::array<double, 16> m_;
  ViewMm shift_;
};

/// From view millimetres to the drawing: one unit is one sample distance, (0, 0) the middle of the
/// grid; heights fill -0.5 .. 0.5 but for a sliver, so that nothing touches a clipping plane.
struct Drawing {
  GridFrame frame;
  double middle_z_mm = 0, range_mm = 1;

  double u(double x_mm) const {
    return (x_mm - frame.first_x_mm) / frame.spacing_mm - 0.5 * (frame.size.cols - 1);
  }
  double v(double y_mm) const {
    return (y_mm - frame.first_y_mm) / frame.spacing_mm - 0.5 * (frame.size.rows - 1);
  }
  double w(double z_mm) const { return (z_mm - middle_z_mm) / range_mm; }
  double zOf(double depth) const { return middle_z_mm + (0.5 - depth) * range_mm; }

  void setHeights(double lowest_mm, double highest_mm) {
    middle_z_mm = 0.5 * (lowest_mm + highest_mm);
    const double span = highest_mm - lowest_mm;
    range_mm = span * (1 + 1e-4) + 1e-6 * frame.spacing_mm;
  }
};

struct Tile {
  int col = 0, row = 0, cols = 0, rows = 0;
};

std::vector<Tile> tilesOf(GridSize size, int limit_px) {
  std::vector<Tile> tiles;
  const int side = std::min(limit_px, kTilePx);
  for (int row = 0; row < size.rows; row += side) {
    for (int col = 0; col < size.cols; col += side) {
      tiles.push_back({col, row, std::min(side, size.cols - col), std::min(side, size.rows - row)});
    }
  }
  return tiles;
}

struct Shift {
  double right_px = 0, up_px = 0;
};
constexpr std::array<Shift, 4> kAllWays{
    {{kNudgePx, kNudgePx}, {-kNudgePx, kNudgePx}, {kNudgePx, -kNudgePx}, {-kNudgePx, -kNudgePx}}};

/// What is drawn: vertices, and how many of them make one primitive (1: points, 3: triangles).
struct Shape {
  vtkNew<vtkPoints> vertices;
  std::vector<std::uint32_t> indices;
  int corners = 3;
  std::size_t primitives() const { return indices.size() / static_cast<std::size_t>(corners); }
};

Drawing drawingOf(const DepthRequest& request, const Task& task) {
  const ViewFromPoint view_from_point(request);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < request.scan.points.size(); ++i) {
    if (i % 65536 == 0) task.check();
    const double z = view_from_point(request.scan.points[i]).z;
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
  Drawing drawing{request.frame};
  drawing.setHeights(lowest, highest);
  return drawing;
}

void setVertices(Shape& shape, std::vector<float>& coordinates) {
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(coordinates.size() / 3));
  std::copy(coordinates.begin(), coordinates.end(), array->GetPointer(0));
  shape.vertices->SetData(array);
}

/// Index of the sample nearest to u (in samples), -1 beyond the half cell around the grid; the rim
/// itself belongs to the grid.
double nearestSample(double u, int count) {
  const double index = std::floor(u + 0.5);
  if (index == count && u <= count - 0.5 + 1e-7) return count - 1;
  return index >= 0 && index < count ? index : -1;
}

// A point counts for its nearest sample, so its vertex is put on that sample's pixel centre here,
// in double; which point is in front is the depth buffer's work.
void fillPoints(Shape& shape, const DepthRequest& request, const Drawing& drawing,
                const Task& task) {
  const GridFrame& frame = request.frame;
  const GridSize size = frame.size;
  const ViewFromPoint view_from_point(request);
  std::vector<float> coordinates;
  for (std::size_t i = 0; i < request.scan.points.size(); ++i) {
    if (i % 65536 == 0) task.check();
    const ViewMm p = view_from_point(request.scan.points[i]);
    const double col = nearestSample((p.x - frame.first_x_mm) / frame.spacing_mm, size.cols);
    const double row = nearestSample((p.y - frame.first_y_mm) / frame.spacing_mm, size.rows);
    if (col < 0 || row < 0) continue;
    coordinates.push_back(static_cast<float>(col - 0.5 * (size.cols - 1)));
    coordinates.push_back(static_cast<float>(row - 0.5 * (size.rows - 1)));
    coordinates.push_back(static_cast<float>(drawing.w(p.z)));
  }
  setVertices(shape, coordinates);
  shape.corners = 1;
  shape.indices.resize(coordinates.size() / 3);
  for (std::size_t i = 0; i < shape.indices.size(); ++i) {
    shape.indices[i] = static_cast<std::uint32_t>(i);
  }
}

void fillTriangles(Shape& shape, const DepthRequest& request, const Drawing& drawing,
                   const Task& task) {
  const ViewFromPoint view_from_point(request);
  std::vector<float> coordinates;
  coordinates.reserve(3 * request.scan.points.size());
  for (std::size_t i = 0; i < request.scan.points.size(); ++i) {
    if (i % 65536 == 0) task.check();
    const ViewMm p = view_from_point(request.scan.points[i]);
    coordinates.push_back(static_cast<float>(drawing.u(p.x)));
    coordinates.push_back(static_cast<float>(drawing.v(p.y)));
    coordinates.push_back(static_cast<float>(drawing.w(p.z)));
  }
  setVertices(shape, coordinates);
  shape.corners = 3;
  shape.indices.reserve(3 * request.scan.triangles.size());
  for (const auto& t : request.scan.triangles) {
    shape.indices.insert(shape.indices.end(), t.begin(), t.end());
  }
}

/// Triangles with an edge along a line of samples, which OpenGL's fill rule may leave out.
std::vector<std::uint32_t> trianglesAlongSamples(const Shape& shape, GridSize size) {
  const float* const xyz = vtkFloatArray::SafeDownCast(shape.vertices->GetData())->GetPointer(0);
  const std::array<double, 2> first{-0.5 * (size.cols - 1), -0.5 * (size.rows - 1)};
  const auto along_samples = [&](std::uint32_t a, std::uint32_t b) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double p = static_cast<double>(xyz[3 * std::size_t{a} + axis]) - first[axis];
      const double q = static_cast<double>(xyz[3 * std::size_t{b} + axis]) - first[axis];
      if (std::abs(p - q) < kOnSamplePx && std::abs(p - std::round(p)) < kOnSamplePx) return true;
    }
    return false;
  };
  std::vector<std::uint32_t> chosen;
  for (std::size_t t = 0; t + 2 < shape.indices.size(); t += 3) {
    const std::uint32_t a = shape.indices[t], b = shape.indices[t + 1], c = shape.indices[t + 2];
    if (along_samples(a, b) || along_samples(b, c) || along_samples(c, a)) {
      chosen.insert(chosen.end(), {a, b, c});
    }
  }
  return chosen;
}

/// The off-screen window with one shape in it.
class Capture {
 public:
  explicit Capture(const Shape& shape) : corners_(static_cast<std::size_t>(shape.corners)) {
    limit_px_ = window_.sizeLimitPx();
    poly_->SetPoints(shape.vertices);
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    mapper->SetInputData(poly_);
    mapper->ScalarVisibilityOff();
    actor_->SetMapper(mapper);
    actor_->GetProperty()->LightingOff();
    actor_->GetProperty()->SetPointSize(1);
    renderer_->AddActor(actor_);
    window_.get()->AddRenderer(renderer_);
  }

  int limitPx() const { return limit_px_; }

  /// Of the buffer that was drawn into; ask after drawing.
  DepthBufferFormat format(const Drawing& drawing) {
    GLint bits = 0;
    GLint type = 0;
    vtkOpenGLFramebufferObject* const buffer =
        vtkOpenGLRenderWindow::SafeDownCast(window_.get())->GetRenderFramebuffer();
    buffer->SaveCurrentBindingsAndBuffers();
    buffer->Bind();
    const auto ask = [](GLenum what, GLint* value) {
      glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, what, value);
    };
    ask(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
    ask(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    buffer->RestorePreviousBindingsAndBuffers();
    if (bits <= 0) {
      throw failure<MessageId::depth_buffer_unknown>();
    }
    return {.bits = bits,
            .is_float = type == GL_FLOAT,
            .near_z_mm = drawing.zOf(0),
            .far_z_mm = drawing.zOf(1),
            .triangles = corners_ == 3};
  }

  /// Depths [0, 1] of a tile's samples; 1 is nothing.
  void draw(const std::vector<std::uint32_t>& indices, GridSize grid, const Tile& tile, Shift shift,
            std::vector<float>& depths, const Task& task) {
    window_.get()->SetSize(tile.cols, tile.rows);
    const double cx = tile.col + 0.5 * tile.cols - 0.5 * grid.cols;
    const double cy = tile.row + 0.5 * tile.rows - 0.5 * grid.rows;
    vtkCamera* const camera = renderer_->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(cx, cy, 0);
    camera->SetPosition(cx, cy, 1);
    camera->SetViewUp(0, 1, 0);
    camera->SetParallelScale(0.5 * tile.rows);
    camera->SetClippingRange(0.5, 1.5);
    actor_->SetPosition(shift.right_px, shift.up_px, 0);
    renderer_->PreserveDepthBufferOff();
    const std::size_t step = kChunk * corners_;
    for (std::size_t from = 0; from < indices.size(); from += step) {
      task.check();
      setCells(indices, from, std::min(from + step, indices.size()));
      window_.get()->Render();
      renderer_->PreserveDepthBufferOn();  // The next chunk is tested against this one.
    }
    depths.resize(static_cast<std::size_t>(tile.cols) * static_cast<std::size_t>(tile.rows));
    std::fill(depths.begin(), depths.end(), 1.0F);
    if (indices.empty()) return;
    window_.get()->GetZbufferData(0, 0, tile.cols - 1, tile.rows - 1, depths.data());
  }

 private:
  void setCells(const std::vector<std::uint32_t>& indices, std::size_t from, std::size_t to) {
    vtkNew<vtkTypeInt32Array> offsets, corners;
    corners->SetNumberOfValues(static_cast<vtkIdType>(to) - static_cast<vtkIdType>(from));
    for (std::size_t i = from; i < to; ++i) {
      corners->SetValue(static_cast<vtkIdType>(i - from), static_cast<vtkTypeInt32>(indices[i]));
    }
    const std::size_t per_cell = corners_ == 1 ? to - from : corners_;
    const std::size_t cell_count = (to - from) / per_cell;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(cell_count) + 1);
    for (std::size_t c = 0; c <= cell_count; ++c) {
      offsets->SetValue(static_cast<vtkIdType>(c), static_cast<vtkTypeInt32>(c * per_cell));
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, corners);
    if (corners_ == 1) {
      poly_->SetVerts(cells);
    } else {
      poly_->SetPolys(cells);
    }
  }

  OffscreenWindow window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPolyData> poly_;
  std::size_t corners_;
  int limit_px_ = 0;
};

struct DepthPicture {
  const Drawing& drawing;
  FrontDepths& depths;

  bool take(const Tile& tile, const std::vector<float>& tile_depths, bool only_empty) {
    const GridSize size = drawing.frame.size;
    bool any = false;
    for (int row = 0; row < tile.rows; ++row) {
      for (int col = 0; col < tile.cols; ++col) {
        const Cell cell{tile.col + col, tile.row + row};
        const float d =
            tile_depths[static_cast<std::size_t>(row) * static_cast<std::size_t>(tile.cols) +
                        static_cast<std::size_t>(col)];
        if (!(d < 1)) continue;
        any = true;
        float& out = depths[size.index(cell)];
        if (only_empty && !std::isnan(out)) continue;
        out = static_cast<float>(drawing.zOf(static_cast<double>(d)));
      }
    }
    return any;
  }
};

}  // namespace

CapturedDepths captureDepths(const DepthRequest& request, const Task& task) {
  const GridSize size = request.frame.size;
  if (size.cols < 1 || size.rows < 1 || !(request.frame.spacing_mm > 0)) {
    throw failure<MessageId::depth_map_too_small>();
  }
  CapturedDepths captured(FrontDepths(size.count(), std::numeric_limits<float>::quiet_NaN()));
  FrontDepths& depths = captured.front;
  task.check();
  if (request.scan.points.empty()) return captured;
  const bool is_mesh = !request.scan.triangles.empty();
  const Drawing drawing = drawingOf(request, task);
  Shape shape;
  if (is_mesh) {
    fillTriangles(shape, request, drawing, task);
  } else {
    fillPoints(shape, request, drawing, task);
  }
  Capture capture(shape);
  // The grid's outer samples lie on the object's bounding box, and a sample on an edge belongs to
  // the surface. OpenGL draws only one side's edges; looks shifted by a part of a pixel find the
  // others.
  const std::vector<std::uint32_t> along_samples =
      is_mesh ? trianglesAlongSamples(shape, size) : std::vector<std::uint32_t>{};
  DepthPicture picture{drawing, depths};
  std::vector<float> tile_depths;
  const std::vector<Tile> tiles = tilesOf(size, capture.limitPx());
  bool any = false;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    task.report("Drawing the depth buffer",
                static_cast<double>(t) / static_cast<double>(tiles.size()));
    capture.draw(shape.indices, size, tiles[t], {}, tile_depths, task);
    any |= picture.take(tiles[t], tile_depths, false);
    if (along_samples.empty()) continue;
    for (const Shift shift : kAllWays) {
      capture.draw(along_samples, size, tiles[t], shift, tile_depths, task);
      picture.take(tiles[t], tile_depths, true);
    }
  }
  if (!any && !is_mesh && shape.primitives() > 0) {
    throw failure<MessageId::depth_buffer_empty>();
  }
  task.report("Drawing the depth buffer", 1);
  if (any) captured.depth_buffer = capture.format(drawing);
  return captured;
}

}  // namespace relievo
