// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/touch_row.h"
#include "core/region/probe.h"
#include "core/region/region.h"

namespace relievo {

/// A window that was under the hand.
struct TouchedWindow {
  std::uint64_t id = 0;
  Region region;
  double gain = 1;
  /// False: the recording does not say where it lay; it was placed around the touched points.
  bool known = true;
};

/// What happened, as the recording says it, or what a person noted.
struct TouchEvent {
  double t_s = 0;  ///< As TouchRow's; of a note: when it was begun.
  std::string text;
  bool is_note = false;
};

/// A recording of a touch as a plain value: no device, no file, no thread. What a replay shows
/// depends on the time alone, so that the same time gives the same picture.
struct TouchRecording {
  std::string name;  ///< Of the file, for people.
  /// At least one; times are finite and do not decrease.
  std::vector<TouchRow> rows;
  std::vector<TouchedWindow> windows;  ///< One for every window_id of the rows, once placed.
  std::vector<TouchEvent> events;      ///< In order of time.
  std::string input;                   ///< Name of the file that was touched; empty: not said.
  std::string input_sha256;            ///< Of its bytes; empty: not said.
  /// File coordinates to view mm, row-major, as the map was made; nothing: not said.
  std::optional<std::array<double, 16>> view_from_file;
  /// What brings the map back: JSON of a provenance or project; empty: not said.
  std::string state;

  double startS() const noexcept { return rows.front().t_s; }
  double endS() const noexcept { return rows.back().t_s; }
};

/// The last row that is not later than `t_s`; the first one before the start. Times are compared
/// with a nanosecond's grace: frame times are sums of floating-point steps.
const TouchRow& rowAt(const TouchRecording& recording, double t_s);

/// The first event after a time, and the last one before it; null: there is none.
const TouchEvent* eventAfter(const TouchRecording& recording, double t_s);
const TouchEvent* eventBefore(const TouchRecording& recording, double t_s);
/// The last event that is not later than `t_s`; null: there is none.
const TouchEvent* eventAt(const TouchRecording& recording, double t_s);

/// Null if no such window is known.
const TouchedWindow* windowOf(const TouchRecording& recording, const TouchRow& row);

/// Adds a window for every id of the rows that has none: the square of the row's detail about the
/// middle of what was touched there, kept on the map.
/// @return how many were added
int placeUnknownWindows(TouchRecording& recording, const DetailLadder& ladder);

/// What is drawn of a row. Forces count as on where a force was felt.
/// @param window_id  of the window that is shown
Probe probeOf(const TouchRow& row, std::uint64_t window_id);

/// Is this recording of this map, and if not, what is different?
enum class RecordingFit {
  fits,
  not_said,     ///< The recording does not say what it was made on.
  other_input,  ///< Another file.
  other_view,   ///< The same file, made into another map.
};
/// @param view_from_file  of the open map
RecordingFit fitOf(const TouchRecording& recording, const std::string& sha256,
                   const std::array<double, 16>& view_from_file);

}  // namespace relievo
