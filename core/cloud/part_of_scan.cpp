// SPDX-License-Identifier: BSD-3-Clause
#include "core/cloud/part_of_scan.h"

#include <algorithm>
#include <cstddef>

namespace relievo {
namespace {

template <class T, class Keep>
std::vector<T> partOfList(const std::vector<T>& list, std::size_t kept, const Keep& keep) {
  std::vector<T> part;
  if (list.empty()) return part;
  part.reserve(kept);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (keep(i)) part.push_back(list[i]);
  }
  return part;
}

}  // namespace

Scan partOf(const Scan& scan, const std::vector<std::uint8_t>& keep) {
  const auto keeps_point = [&keep](std::size_t i) { return keep[i] != 0; };
  const auto keeps_triangle = [&](std::size_t t) {
    return std::all_of(scan.triangles[t].begin(), scan.triangles[t].end(), keeps_point);
  };
  const auto kept = static_cast<std::size_t>(
      std::count_if(keep.begin(), keep.end(), [](std::uint8_t k) { return k != 0; }));
  Scan part;
  part.info = scan.info;
  part.origin = scan.origin;
  part.points = partOfList(scan.points, kept, keeps_point);
  part.colours = partOfList(scan.colours, kept, keeps_point);
  part.intensities = partOfList(scan.intensities, kept, keeps_point);
  part.classes = partOfList(scan.classes, kept, keeps_point);
  part.returns = partOfList(scan.returns, kept, keeps_point);
  part.parts = partOfList(scan.parts, kept, keeps_point);
  part.triangles = partOfList(scan.triangles, 0, keeps_triangle);
  part.texture_corners = partOfList(scan.texture_corners, 0, keeps_triangle);
  part.texture_of = partOfList(scan.texture_of, 0, keeps_triangle);
  part.textures = scan.textures;
  if (!part.triangles.empty()) {
    std::vector<std::uint32_t> number(keep.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < keep.size(); ++i) {
      number[i] = next;
      next += keep[i] != 0 ? 1 : 0;
    }
    for (auto& triangle : part.triangles) {
      for (std::uint32_t& corner : triangle) corner = number[corner];
    }
  }
  FileBounds box{part.point(0), part.point(0)};
  for (std::size_t i = 0; i < part.points.size(); ++i) {
    const FilePoint p = part.point(i);
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  part.info.bounds = box;
  return part;
}

}  // namespace relievo
