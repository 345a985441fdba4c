// SPDX-License-Identifier: BSD-3-Clause
// closed_clouds MESH...: clouds sampled on closed meshes, gridded, and held against the mesh itself
// on the very same samples, and ("fine") against its map of 600 samples across, within two of them.
// One line a cloud; exit 1 if a bar is missed: pits 0.1 %, lost cells 0.5 %, rms 0.6 of the spacing
// away from silhouettes.
// CLOSED_CLOUDS_VIEW, _LEAST, _MOST: one view, clouds of so many points; _PITS: says where.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "core/depth/rules/rasterize.h"
#include "core/io/import.h"
#include "core/session/surface.h"
#include "tests/benchmark/closed_cloud_judge.h"

namespace {

using namespace relievo;
using namespace relievo::benchmark;

using Point = std::array<double, 3>;

Point corner(const Scan& mesh, std::uint32_t i) {
  return {static_cast<double>(mesh.points[i][0]), static_cast<double>(mesh.points[i][1]),
          static_cast<double>(mesh.points[i][2])};
}

double areaOf(const Point& a, const Point& b, const Point& c) {
  const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Point v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                          u[0] * v[1] - u[1] * v[0]);
}

Scan sampled(const Scan& mesh, const Sampling& how, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> areas;
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};
  for (const auto& t : mesh.triangles) {
    areas.push_back(areaOf(corner(mesh, t[0]), corner(mesh, t[1]), corner(mesh, t[2])));
    for (const std::uint32_t i : t) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], corner(mesh, i)[k]);
        high[k] = std::max(high[k], corner(mesh, i)[k]);
      }
    }
  }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  std::discrete_distribution<std::size_t> triangle(areas.begin(), areas.end());
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> noise(0, how.noise * size);
  Scan cloud;
  cloud.info = mesh.info;
  cloud.info.faces = 0;
  cloud.origin = mesh.origin;
  while (cloud.points.size() < how.points) {
    Point p;
    if (unit(random) < how.strays) {
      for (std::size_t k = 0; k < 3; ++k) p[k] = low[k] + unit(random) * (high[k] - low[k]);
    } else {
      const auto& t = mesh.triangles[triangle(random)];
      double u = unit(random);
      double v = unit(random);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const Point a = corner(mesh, t[0]);
      const Point b = corner(mesh, t[1]);
      const Point c = corner(mesh, t[2]);
      for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]);
      const double along = (p[0] - low[0]) / std::max(high[0] - low[0], 1e-300);
      if (unit(random) > 1 / how.unevenness + (1 - 1 / how.unevenness) * along) continue;
      for (double& value : p) value += how.noise > 0 ? noise(random) : 0.0;
    }
    cloud.points.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  cloud.info.points = cloud.info.finite_points = cloud.points.size();
  return cloud;
}

constexpr int kFineCells = 600;

bool isMeasured(CellStatus origin) {
  return origin == CellStatus::measured;
}

/// Pits and lost cells against the map of the mesh itself on a fine grid, where the mesh is not too
/// steep to be measured: the cloud's grid is no excuse.
void compareFinely(const Surface& surface, const Surface& mesh, Found& found) {
  const GridFrame& frame = surface.map.frame;
  const GridFrame& fine = mesh.map.frame;
  const double size = fine.spacing_mm * std::max(fine.size.cols, fine.size.rows);
  // The same rotation and unit: the two views differ by a shift.
  const std::array<double, 3> shift{mesh.view_from_file.m[3] - surface.view_from_file.m[3],
                                    mesh.view_from_file.m[7] - surface.view_from_file.m[7],
                                    mesh.view_from_file.m[11] - surface.view_from_file.m[11]};
  double cells = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const double x = frame.xMm(col) + shift[0];
      const double y = frame.yMm(row) + shift[1];
      const int fine_col = static_cast<int>(std::lround((x - fine.first_x_mm) / fine.spacing_mm));
      const int fine_row = static_cast<int>(std::lround((y - fine.first_y_mm) / fine.spacing_mm));
      float low = 1e30F;
      bool inside = true;
      for (int r = fine_row - 2; r <= fine_row + 2 && inside; ++r) {
        for (int c = fine_col - 2; c <= fine_col + 2 && inside; ++c) {
          const Cell near{.col = c, .row = r};
          inside = fine.size.contains(near) && isMeasured(mesh.map.origins[fine.size.index(near)]);
          if (inside) low = std::min(low, mesh.map.heights_mm[fine.size.index(near)]);
        }
      }
      if (!inside) continue;
      ++cells;
      const std::size_t i = frame.size.index({.col = col, .row = row});
      const CellStatus origin = surface.map.origins[i];
      const bool is_there = origin == CellStatus::measured || origin == CellStatus::interpolated;
      found.fine_lost += is_there ? 0 : 1;
      if (!is_there && std::getenv("CLOSED_CLOUDS_PITS") != nullptr) {
        std::printf("  fine lost at %d %d origin %d\n", col, row, static_cast<int>(origin));
      }
      const double height = static_cast<double>(surface.map.heights_mm[i]) + shift[2];
      if (!is_there || height >= static_cast<double>(low) - 0.03 * size) continue;
      found.fine_pits += 1;
      if (std::getenv("CLOSED_CLOUDS_PITS") != nullptr) {
        std::printf("  fine pit at %d %d: %.2f, mesh from %.2f, size %.2f, origin %d\n", col, row,
                    height, static_cast<double>(low), size, static_cast<int>(origin));
      }
    }
  }
  found.fine_pits *= 100 / std::max(cells, 1.0);
  found.fine_lost *= 100 / std::max(cells, 1.0);
}

Found judged(const Surface& surface, const Scan& mesh, const Surface& fine) {
  const GridFrame& frame = surface.map.frame;
  Found found = compared(
      surface,
      rasterize({.scan = mesh, .view_from_file = surface.view_from_file, .frame = frame}, {})
          .front);
  compareFinely(surface, fine, found);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  Judgement judgement;
  for (int k = 1; k < argc; ++k) {
    const Scan mesh = importScan(argv[k]);
    std::map<std::string, Surface> fine;  // By the view.
    judgement.judge(
        std::filesystem::path(argv[k]).filename().string(),
        [&mesh](const Sampling& how) { return sampled(mesh, how, 7); },
        [&](const Surface& surface, SurfaceOptions finely) {
          const std::string view = finely.view->name;
          finely.cells = kFineCells;
          if (!fine.contains(view)) fine.emplace(view, makeSurface(mesh, finely, rasterize));
          return judged(surface, mesh, fine.at(view));
        });
  }
  return judgement.end();
}
