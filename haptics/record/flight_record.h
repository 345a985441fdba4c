// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/loop/haptic_core.h"
#include "haptics/record/recorder.h"
#include "haptics/rt/spsc_ring.h"

namespace relievo {

/// The last 30 s are always kept; when a fault appears they are written to a file of their own, so
/// that what led to it can be looked at.
class FlightRecord {
 public:
  static constexpr std::size_t kTicks = 30'000;
  static constexpr int kMostFiles = 20;  ///< Then no more are written in this run.
  /// So many stay in the folder, of all runs; the oldest go when a new one is written.
  static constexpr std::size_t kMostKept = 40;

  /// @param folder  is made when it is first needed
  FlightRecord(std::filesystem::path folder, std::string header);
  ~FlightRecord();
  FlightRecord(const FlightRecord&) = delete;
  FlightRecord& operator=(const FlightRecord&) = delete;

  void take(std::span<const HapticSample> batch);  ///< [drain thread] the sink
  /// [GUI thread] Once per fault: the file, or why there is none.
  std::optional<RecordingEnd> written();

 private:
  void save();   // [drain thread]
  void prune();  // [drain thread]

  std::filesystem::path folder_;
  std::string header_;
  SpscRing<RecordingEnd*, 32> ends_;  // The pointers own.
  // [drain thread]
  std::vector<HapticSample> kept_;  // A ring once it is full; the oldest is at next_.
  std::size_t next_ = 0;
  DeviceFault fault_ = DeviceFault::none;
  int files_ = 0;
};

}  // namespace relievo
