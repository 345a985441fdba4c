// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <unordered_map>

#include "core/base/failure.h"

namespace relievo {
namespace {

constexpr int kRowsAtOnce = 32;  // Some 30 ms on the largest maps: often enough to cancel.

/// A line between two neighbouring samples: the lower or left one, and whether it runs upward.
using EdgeId = std::uint64_t;
/// Two edges of one cell, joined by a piece of a curve.
using AreaResult = std::array<EdgeId, 2>;

/// Where the plane cuts an edge, found while its cells are at hand.
struct EdgePoint {
  ViewMm at;
  bool unmeasured = false;                 ///< One of its two samples is not measured.
  double off_mm = 0;                       ///< How far their errors may move it.
  std::array<std::size_t, 2> pieces = {};  ///< That end here, + 1; 0: none.
};

class Cutter {
 public:
  Cutter(const GridFrame& frame, const PlaneMm& plane, std::size_t most_points)
      : frame_(frame), plane_(plane), most_points_(most_points) {}

  /// The cells between two rows. Rows come lowest first.
  void cutRow(const MapPart& map, int row) {
    for (int col = 0; col + 1 < frame_.size.cols; ++col) cutCell(map, {.col = col, .row = row});
  }

  std::vector<SectionCurve> curves() const {
    std::vector<SectionCurve> found;
    std::vector<bool> used(pieces_.size(), false);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!used[i]) found.push_back(trace(i, used));
    }
    std::stable_sort(found.begin(), found.end(), [](const SectionCurve& a, const SectionCurve& b) {
      return a.length_mm > b.length_mm;
    });
    return found;
  }

 private:
  /// Height of a sample over the plane, along the plane's normal. Exactly 0 counts as above, so
  /// that a curve through a sample is found once.
  double over(const MapPart& map, Cell c) const {
    return plane_.normal.x * frame_.xMm(c.col) + plane_.normal.y * frame_.yMm(c.row) +
           plane_.normal.z * static_cast<double>(map.heightMm(c)) - plane_.offset_mm;
  }

  EdgeId edge(Cell c, bool upward) const { return 2 * frame_.size.index(c) + (upward ? 1 : 0); }

  void cutCell(const MapPart& map, Cell c) {
    const std::array<Cell, 4> corners{c,
                                      {.col = c.col + 1, .row = c.row},
                                      {.col = c.col + 1, .row = c.row + 1},
                                      {.col = c.col, .row = c.row + 1}};
    std::array<double, 4> h{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (map.origin(corners[i]) == CellStatus::outside) return;
      h[i] = over(map, corners[i]);
    }
    // Bottom, right, top, left: edge i joins corners i and i + 1.
    const std::array<EdgeId, 4> edges{edge(corners[0], false), edge(corners[1], true),
                                      edge(corners[3], false), edge(corners[0], true)};
    std::array<std::size_t, 4> cut{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if ((h[i] >= 0) != (h[(i + 1) % 4] >= 0)) cut[count++] = i;
    }
    if (count == 2) add(map, edges[cut[0]], edges[cut[1]]);
    if (count != 4) return;
    // A saddle: the bilinear height in the middle says which corners belong together.
    const bool middle_above = h[0] + h[1] + h[2] + h[3] >= 0;
    const bool first_above = h[0] >= 0;
    if (middle_above == first_above) {
      add(map, edges[0], edges[1]);
      add(map, edges[2], edges[3]);
    } else {
      add(map, edges[3], edges[0]);
      add(map, edges[1], edges[2]);
    }
  }

  void add(const MapPart& map, EdgeId a, EdgeId b) {
    for (const EdgeId e : {a, b}) {
      const auto [found, is_new] = at_edge_.try_emplace(e);
      if (is_new) found->second = pointOn(map, e);
      std::array<std::size_t, 2>& at = found->second.pieces;
      (at[0] != 0 ? at[1] : at[0]) = pieces_.size() + 1;
    }
    pieces_.push_back({a, b});
    if (at_edge_.size() > most_points_) {
      throw failure<MessageId::section_too_long>(most_points_);
    }
  }

  std::optional<std::size_t> nextAt(EdgeId e, const std::vector<bool>& used) const {
    for (const std::size_t piece : at_edge_.at(e).pieces) {
      if (piece > 0 && !used[piece - 1]) return piece - 1;
    }
    return std::nullopt;
  }

  /// Follows pieces from one end; returns the edges passed, `from` not among them.
  std::vector<EdgeId> follow(EdgeId from, std::vector<bool>& used) const {
    std::vector<EdgeId> passed;
    for (auto next = nextAt(from, used); next; next = nextAt(from, used)) {
      used[*next] = true;
      const AreaResult& piece = pieces_[*next];
      from = piece[0] == from ? piece[1] : piece[0];
      passed.push_back(from);
    }
    return passed;
  }

  SectionCurve trace(std::size_t start, std::vector<bool>& used) const {
    used[start] = true;
    const AreaResult& piece = pieces_[start];
    std::vector<EdgeId> edges = follow(piece[0], used);
    std::reverse(edges.begin(), edges.end());
    edges.push_back(piece[0]);
    const std::vector<EdgeId> onward = follow(piece[1], used);
    edges.push_back(piece[1]);
    edges.insert(edges.end(), onward.begin(), onward.end());
    SectionCurve curve;
    curve.closed = edges.size() > 2 && edges.front() == edges.back();
    if (curve.closed) edges.pop_back();
    double unmeasured = 0;
    std::vector<double> off_mm;
    for (const EdgeId e : edges) {
      const EdgePoint& point = at_edge_.at(e);
      curve.points.push_back(point.at);
      off_mm.push_back(point.off_mm);
      if (point.unmeasured) unmeasured += 1;
    }
    for (std::size_t i = curve.closed ? 0 : 1; i < curve.points.size(); ++i) {
      const std::size_t before = i > 0 ? i - 1 : curve.points.size() - 1;
      const double length = norm(curve.points[i] - curve.points[before]);
      curve.length_mm += length;
      curve.length_off_mm += std::hypot(length, off_mm[i] + off_mm[before]) - length;
    }
    curve.length_off_mm += endsOff(curve) + wallsOff(curve.points, off_mm, curve.closed);
    curve.not_measured = unmeasured / static_cast<double>(edges.size());
    return curve;
  }

  /// What half a cell does to the length: a closed curve d farther out all round is 2 pi d longer
  /// (Steiner's formula); an open one has two ends, each as steep as its last piece.
  double endsOff(const SectionCurve& curve) const {
    const double s = frame_.spacing_mm;
    if (curve.closed) return std::numbers::pi * s;
    const std::vector<ViewMm>& p = curve.points;
    return 0.5 * std::max(s, norm(p[1] - p[0])) +
           0.5 * std::max(s, norm(p.back() - p[p.size() - 2]));
  }

  EdgePoint pointOn(const MapPart& map, EdgeId e) const {
    const auto index = static_cast<std::int64_t>(e / 2);
    const Cell a{.col = static_cast<int>(index % frame_.size.cols),
                 .row = static_cast<int>(index / frame_.size.cols)};
    const Cell b =
        e % 2 == 1 ? Cell{.col = a.col, .row = a.row + 1} : Cell{.col = a.col + 1, .row = a.row};
    const double ha = over(map, a);
    const double hb = over(map, b);
    const double t = ha / (ha - hb);
    const auto at = [&](Cell c) {
      return ViewMm{frame_.xMm(c.col), frame_.yMm(c.row), static_cast<double>(map.heightMm(c))};
    };
    // Along the edge, where the plane leans; up and down with the surface, where it stands.
    const double error = std::max(map.heightErrorMm(a), map.heightErrorMm(b));
    const double upright = std::sqrt(std::max(0.0, 1 - plane_.normal.z * plane_.normal.z));
    const double along = std::min(error * std::abs(plane_.normal.z) / std::abs(ha - hb), 1.0);
    return {.at = at(a) + t * (at(b) - at(a)),
            .unmeasured =
                map.origin(a) != CellStatus::measured || map.origin(b) != CellStatus::measured,
            .off_mm = along * norm(at(b) - at(a)) + upright * error};
  }

  GridFrame frame_;
  PlaneMm plane_;
  std::size_t most_points_;
  std::vector<AreaResult> pieces_;
  std::unordered_map<EdgeId, EdgePoint> at_edge_;
};

}  // namespace

double wallsOff(const std::vector<ViewMm>& points, const std::vector<double>& off_mm, bool closed) {
  struct Step {
    double across = 0, up = 0, error = 0;
  };
  std::vector<Step> steps;
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : points.size() - 1;
    const ViewMm d = points[i] - points[before];
    steps.push_back({std::hypot(d.x, d.y), d.z, off_mm[i] + off_mm[before]});
  }
  double off = 0;
  const auto wall = [&](const Step& at, const Step& beside) {
    if (!(beside.across > 0)) return 0.0;
    const double shared = beside.up / beside.across * at.across;
    const double part = std::abs(at.up - shared);
    return part > 2 * at.error ? std::min(part, std::abs(at.up)) : 0;
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    double most = 0;
    if (i > 0 || closed) most = wall(steps[i], steps[i > 0 ? i - 1 : steps.size() - 1]);
    if (i + 1 < steps.size() || closed) {
      most = std::max(most, wall(steps[i], steps[(i + 1) % steps.size()]));
    }
    off += std::hypot(steps[i].across, std::abs(steps[i].up) - most) + most -
           std::hypot(steps[i].across, steps[i].up);
  }
  return off;
}

PlaneMm planeThrough(const std::vector<ViewMm>& p) {
  if (p.size() == 1) return {.normal = {0, 0, 1}, .offset_mm = p[0].z};
  if (p.size() != 2 && p.size() != 3) {
    throw failure<MessageId::section_places>();
  }
  const ViewMm a = p[1] - p[0];
  const ViewMm b = p.size() == 2 ? ViewMm{0, 0, 1} : p[2] - p[0];
  const ViewMm normal{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const double length = norm(normal);
  // On one line but for rounding.
  if (!(length > 1e-9 * norm(a) * norm(b))) {
    if (p.size() == 2) throw failure<MessageId::two_places_no_plane>();
    throw failure<MessageId::three_places_no_plane>();
  }
  const ViewMm unit = (1 / length) * normal;
  return {.normal = unit, .offset_mm = dot(unit, p[0])};
}

std::vector<SectionCurve> section(const MapCells& map, const PlaneMm& plane,
                                  std::size_t most_points) {
  const double length = norm(plane.normal);
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(plane.offset_mm)) {
    throw failure<MessageId::plane_without_direction>();
  }
  const GridSize size = map.frame().size;
  Cutter cutter(map.frame(), {.normal = (1 / length) * plane.normal, .offset_mm = plane.offset_mm},
                most_points);
  for (int row = 0; row + 1 < size.rows; row += kRowsAtOnce) {
    const int end = std::min(row + kRowsAtOnce, size.rows - 1);
    const MapPart part =
        map.part({.col = 0, .row = row}, {.cols = size.cols, .rows = end + 1 - row});
    for (int r = row; r < end; ++r) cutter.cutRow(part, r);
  }
  return cutter.curves();
}

}  // namespace relievo
