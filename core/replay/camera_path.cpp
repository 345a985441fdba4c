// SPDX-License-Identifier: BSD-3-Clause
#include "core/replay/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/failure.h"

namespace relievo {
namespace {

// Middle x and y, log of side, log of gain, azimuth, elevation.
constexpr std::size_t kValues = 6;
using Values = std::array<double, kValues>;
constexpr std::size_t kAzimuth = 4;

Values valuesOf(const ViewState& view) {
  return {view.region.centreX(), view.region.centreY(), std::log(view.region.side_mm),
          std::log(view.gain),   view.azimuth_deg,      view.elevation_deg};
}

/// Slope at a key between the steepness of its two sides: 0 where they differ in sign, else their
/// weighted harmonic mean, which keeps the cubic monotone.
double slopeBetween(double left, double left_s, double right, double right_s) {
  if (!(left * right > 0)) return 0;
  const double w1 = 2 * right_s + left_s;
  const double w2 = right_s + 2 * left_s;
  return (w1 + w2) / (w1 / left + w2 / right);
}

double cubic(double from, double to, double slope_from, double slope_to, double step_s,
             double part) {
  const double p2 = part * part;
  const double p3 = p2 * part;
  return (2 * p3 - 3 * p2 + 1) * from + (p3 - 2 * p2 + part) * step_s * slope_from +
         (3 * p2 - 2 * p3) * to + (p3 - p2) * step_s * slope_to;
}

}  // namespace

void check(const CameraPath& path) {
  if (path.keys.size() < 2) {
    throw failure<MessageId::path_of_one_view>(path.name);
  }
  for (std::size_t i = 0; i < path.keys.size(); ++i) {
    const KeyView& key = path.keys[i];
    if (!std::isfinite(key.t_s) || (i > 0 && !(key.t_s > path.keys[i - 1].t_s))) {
      throw failure<MessageId::path_goes_back>(path.name, i + 1);
    }
    for (const double value : valuesOf(key.view)) {
      if (!std::isfinite(value)) {
        throw failure<MessageId::path_without_place>(path.name, i + 1);
      }
    }
  }
}

ViewState viewAt(const CameraPath& path, const DetailLadder& ladder, double t_s) {
  check(path);
  const auto& keys = path.keys;
  const double t = std::clamp(t_s, keys.front().t_s, keys.back().t_s);
  std::size_t i = 0;  // The key before.
  while (i + 2 < keys.size() && keys[i + 1].t_s <= t) ++i;
  // The keys around: at most two before and two after; turns are counted on from the first of them.
  const std::size_t first = i == 0 ? 0 : i - 1;
  const std::size_t last = std::min(i + 2, keys.size() - 1);
  std::array<Values, 4> values{};
  for (std::size_t k = first; k <= last; ++k) {
    values[k - first] = valuesOf(keys[k].view);
    if (k == first) continue;
    double& azimuth = values[k - first][kAzimuth];
    const double before = values[k - first - 1][kAzimuth];
    azimuth = before + std::remainder(azimuth - before, 360.0);
  }
  const auto gap_after = [&](std::size_t k) { return keys[k + 1].t_s - keys[k].t_s; };
  const auto steepness = [&](std::size_t k, std::size_t v) {
    return (values[k + 1 - first][v] - values[k - first][v]) / gap_after(k);
  };
  const auto slope = [&](std::size_t k, std::size_t v) {
    if (k == 0 || k + 1 == keys.size()) return 0.0;
    return slopeBetween(steepness(k - 1, v), gap_after(k - 1), steepness(k, v), gap_after(k));
  };
  const double part = (t - keys[i].t_s) / gap_after(i);
  Values now{};
  for (std::size_t v = 0; v < kValues; ++v) {
    now[v] = cubic(values[i - first][v], values[i + 1 - first][v], slope(i, v), slope(i + 1, v),
                   gap_after(i), part);
  }
  ViewState view = part < 1 ? keys[i].view : keys[i + 1].view;
  const double side = std::exp(now[2]);
  view.region = {now[0] - 0.5 * side, now[1] - 0.5 * side, side, defaultLevel(ladder, side)};
  view.gain = std::exp(now[3]);
  view.azimuth_deg = std::remainder(now[kAzimuth], 360.0);
  view.elevation_deg = now[5];
  return view;
}

}  // namespace relievo
