// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>

#include "core/cloud/scan.h"

namespace relievo::test {

using HeightFunction = std::function<double(double, double)>;

inline void finishScan(Scan& scan) {
  scan.info.file = "made.ply";
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.faces = scan.triangles.size();
  FileBounds box{scan.point(0), scan.point(0)};
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const FilePoint p = scan.point(i);
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  scan.info.bounds = box;
}

/// Points on a lattice: x = i step, y = j step, z = f(x, y).
inline Scan latticeScan(int cols, int rows, double step, const HeightFunction& f) {
  Scan scan;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < cols; ++i) {
      const double x = i * step;
      const double y = j * step;
      scan.points.push_back(
          {static_cast<float>(x), static_cast<float>(y), static_cast<float>(f(x, y))});
    }
  }
  finishScan(scan);
  return scan;
}

/// The same lattice as a mesh, two triangles a cell, facing +z.
inline Scan latticeMesh(int cols, int rows, double step, const HeightFunction& f) {
  Scan scan = latticeScan(cols, rows, step, f);
  const auto node = [cols](int i, int j) { return static_cast<std::uint32_t>(j * cols + i); };
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < cols; ++i) {
      scan.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      scan.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  }
  scan.info.faces = scan.triangles.size();
  return scan;
}

}  // namespace relievo::test
