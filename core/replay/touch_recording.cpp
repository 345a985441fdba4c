// SPDX-License-Identifier: BSD-3-Clause
#include "core/replay/touch_recording.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {

constexpr double kGraceS = 1e-9;

/// The rectangle around the proxies of one window.
RectMm touchedRect(const TouchRecording& recording, std::uint64_t window_id) {
  double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
  for (const TouchRow& row : recording.rows) {
    if (row.window_id != window_id) continue;
    left = std::min(left, row.proxy.x);
    right = std::max(right, row.proxy.x);
    bottom = std::min(bottom, row.proxy.y);
    top = std::max(top, row.proxy.y);
  }
  return {left, bottom, right - left, top - bottom};
}

/// The square of a detail about a point, on the map.
Region squareAt(const DetailLadder& ladder, int detail, const RectMm& touched) {
  if (detail <= 1) return wholeRegion(ladder);
  const int known = std::min(detail, ladder.levels());
  const double side = ladder.sideMm(known);
  const Region about{touched.x_mm + 0.5 * (touched.width_mm - side),
                     touched.y_mm + 0.5 * (touched.height_mm - side), side,
                     Level{ladder.levels() - known}};
  return moved(ladder, about, 0, 0).value_or(about);
}

}  // namespace

const TouchRow& rowAt(const TouchRecording& recording, double t_s) {
  const auto later = std::upper_bound(recording.rows.begin(), recording.rows.end(), t_s + kGraceS,
                                      [](double t, const TouchRow& row) { return t < row.t_s; });
  return later == recording.rows.begin() ? *later : *std::prev(later);
}

const TouchEvent* eventAfter(const TouchRecording& recording, double t_s) {
  const auto& all = recording.events;
  const auto next = std::upper_bound(all.begin(), all.end(), t_s + kGraceS,
                                     [](double t, const TouchEvent& e) { return t < e.t_s; });
  return next == all.end() ? nullptr : &*next;
}

const TouchEvent* eventBefore(const TouchRecording& recording, double t_s) {
  const auto& all = recording.events;
  const auto here = std::lower_bound(all.begin(), all.end(), t_s - kGraceS,
                                     [](const TouchEvent& e, double t) { return e.t_s < t; });
  return here == all.begin() ? nullptr : &*std::prev(here);
}

const TouchEvent* eventAt(const TouchRecording& recording, double t_s) {
  return eventBefore(recording, t_s + 2 * kGraceS);
}

const TouchedWindow* windowOf(const TouchRecording& recording, const TouchRow& row) {
  const auto found =
      std::find_if(recording.windows.begin(), recording.windows.end(),
                   [&](const TouchedWindow& window) { return window.id == row.window_id; });
  return found == recording.windows.end() ? nullptr : &*found;
}

int placeUnknownWindows(TouchRecording& recording, const DetailLadder& ladder) {
  int added = 0;
  const TouchRow* before = nullptr;
  for (const TouchRow& row : recording.rows) {
    const bool same = before != nullptr && before->window_id == row.window_id;
    before = &row;
    if (same || row.window_id == 0 || windowOf(recording, row) != nullptr) continue;
    recording.windows.push_back(
        {.id = row.window_id,
         .region = squareAt(ladder, row.detail, touchedRect(recording, row.window_id)),
         .gain = 1,
         .known = false});
    ++added;
  }
  return added;
}

Probe probeOf(const TouchRow& row, std::uint64_t window_id) {
  Probe probe;
  probe.proxy = row.proxy;
  probe.hip = row.hip;
  probe.force = row.force;
  probe.touching = row.contact;
  probe.forces_on = norm(row.force) > 0;
  probe.origin = row.origin;
  probe.window_id = window_id;
  return probe;
}

RecordingFit fitOf(const TouchRecording& recording, const std::string& sha256,
                   const std::array<double, 16>& view_from_file) {
  if (recording.input_sha256.empty() || sha256.empty()) return RecordingFit::not_said;
  if (recording.input_sha256 != sha256) return RecordingFit::other_input;
  if (!recording.view_from_file) return RecordingFit::fits;
  for (std::size_t i = 0; i < view_from_file.size(); ++i) {
    const double said = (*recording.view_from_file)[i];
    // Written with all digits; another view differs in the first ones.
    if (std::abs(said - view_from_file[i]) > 1e-9 * (1 + std::abs(said))) {
      return RecordingFit::other_view;
    }
  }
  return RecordingFit::fits;
}

}  // namespace relievo
