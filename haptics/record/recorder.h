// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "haptics/loop/core_snapshot.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/record/sample_log.h"
#include "haptics/rt/spsc_ring.h"
#include "haptics/rt/triple_buffer.h"

namespace relievo {

/// How a recording ended.
struct RecordingEnd {
  std::filesystem::path file;
  std::uint64_t samples = 0;  ///< Saved.
  std::string error;          ///< Empty: all is saved. Else a sentence for people (E401).
  std::shared_ptr<const Message> message = nullptr;  ///< The same for a window's language.
};

/// Records every sample to a CSV or HDF5 file (conventions.md 5.5) from the drain thread. Samples
/// that the loop had to drop, faults and changes of window are named in the event column.
class Recorder {
 public:
  Recorder() = default;
  ~Recorder();  ///< After the drain has gone; closes what is open.
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// [GUI thread] Makes the file at once; recording starts with the drain's next batch.
  /// @throw WriteError  the file cannot be made
  /// @throw Error       a recording is running
  void start(const std::filesystem::path& file, std::string_view header,
             const HapticSpace* surface = nullptr);
  /// Before the drain starts: recordings begin at a snapshot from there, which whoever calls
  /// start() has to ask for, and end with lines that let them be replayed. @param build  names it
  void beginAt(SnapshotRing& snapshots, std::string build);
  /// [GUI thread] Ends with the drain's next batch; see ended(). Footer lines end the file.
  void stop(const std::string& footer = {});
  /// [GUI thread] An event for the next row without another (noteEvent). One that comes with the
  /// end stands in the footer. @return false: no recording is running, or too many wait
  bool note(const std::string& event);
  bool running() const noexcept { return running_; }  ///< [GUI thread] start() until ended().
  std::uint64_t samples() noexcept;                   ///< [GUI thread] Recorded so far.
  /// [GUI thread] Once per recording that came to its end.
  std::optional<RecordingEnd> ended();

  void take(std::span<const HapticSample> batch);  ///< [drain thread] the sink

 private:
  void switchOver();                       // [drain thread]
  void write(const HapticSample& sample);  // [drain thread]
  void finish(const WriteError* stopped);  // [drain thread]
  std::string takeNote();                  // [drain thread] Empty: none.

  // GUI to drain: a file to write to, or null: stop. Drain to GUI: how it ended. The pointers own.
  SpscRing<SampleLog*, 16> commands_;
  SpscRing<std::string*, 16> footers_;
  SpscRing<std::string*, 16> notes_;
  SpscRing<RecordingEnd*, 16> ends_;
  TripleBuffer<std::uint64_t> counts_;
  bool running_ = false;  // [GUI thread]
  // [drain thread]
  std::unique_ptr<SampleLog> writer_;
  HapticSample last_;
  SnapshotRing* snapshots_ = nullptr;
  std::string build_;
  std::optional<CoreSnapshot> begins_;  // Of the running recording.
  std::string replay_lines_;
  std::int64_t start_ns_ = 0;
  bool first_ = true;
};

}  // namespace relievo
