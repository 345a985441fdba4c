// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/loop/core_snapshot.h"
#include "haptics/record/replay.h"

namespace relievo {

// What a recording that began in a running loop says beyond its rows, as lines "replay ..." at its
// end: the core's state before the first row and every change of options, surface and fault. States
// and options are JSON with a name for every member, so that another build replays them.

/// How a surface was prepared.
struct RecordedScene {
  std::uint64_t id = 0, window_id = 0;
  Region region;
  double gain = 1;
  SurfaceKind kind = SurfaceKind::crease_aware;
  std::optional<Anchor> anchor;
  bool textured = false;
  std::string firmness = {};   ///< SHA-256 of the raster that said where it is firm; or empty.
  std::uint64_t map = 0;       ///< Of mapLine(); 0: the one in the recording's header.
  std::uint64_t checksum = 0;  ///< sceneChecksum().
};

/// Of heights, firmness and texture: is this the surface that was touched?
std::uint64_t sceneChecksum(const HapticSpace& space);

std::string sceneLine(const RecordedScene& scene);
/// Where a raster of firmness is found that scenes name.
/// @param file  from the recording's folder, or absolute
std::string firmnessLine(std::string_view sha256, std::string_view file);
/// How a map is made that scenes name. @param state  as text; what it says is not looked at here
std::string mapLine(std::uint64_t map, std::string_view state);
std::string optionsLine(const HapticOptions& options);
/// What a hand was led along, under its id.
std::string guideLine(const GuidePath& path);
/// @param build  names the program that wrote it
std::string snapshotLine(const CoreSnapshot& snapshot, std::int64_t first_ns,
                         std::string_view build);
/// Empty: the sample goes on as the one before.
std::string changeLine(const HapticSample* before, const HapticSample& now);

/// The files that such lines name beyond the recording's own input; of any build.
struct RecordedFiles {
  std::map<std::string, std::string> firmness;  ///< Files of firmnessLine(), by SHA-256.
  std::map<std::uint64_t, std::string> maps;    ///< States of mapLine().
};
/// @throw FileError  such a line is damaged
RecordedFiles recordedFiles(std::string_view footer);

/// Of guideLine(), by their ids; of any build. @throw FileError  such a line is damaged
std::map<std::uint64_t, GuidePath> recordedGuides(std::string_view footer);

struct LoopChange {
  std::uint64_t scene_id = 0, options_id = 0;
  DeviceFault fault = DeviceFault::none;
  bool resumed = false;
};

struct RecordedLoop {
  std::string build;  ///< That recorded it.
  CoreSnapshot start;
  std::int64_t first_ns = 0;  ///< Of the first row, on the loop's clock.
  std::map<std::uint64_t, HapticOptions> options;
  std::map<std::uint64_t, RecordedScene> scenes;
  std::map<std::uint64_t, LoopChange> changes;  ///< By tick.
  RecordedFiles files;
  std::map<std::uint64_t, GuidePath> guides;
};
/// What changed at which tick; empty: no line tells of any. @throw FileError  a line is damaged
std::map<std::uint64_t, LoopChange> loopChanges(std::string_view footer);

/// What the loop knew and no row says, while rows are replayed one after the other.
class ChangeCursor {
 public:
  explicit ChangeCursor(const std::map<std::uint64_t, LoopChange>& changes) : changes_(changes) {}
  /// On to this tick. @return something changed
  bool at(std::uint64_t tick);
  const LoopChange& now() const { return now_; }
  /// Gives the core what the device told it: a fault as long as the core did not know of it, and
  /// while forces are off, when it keeps none. Later the row has the hand that was used.
  void tell(HapticCore& core, const HapticOptions& options, DeviceReading& reading) const;

 private:
  const std::map<std::uint64_t, LoopChange>& changes_;
  LoopChange now_;  // Before the first row: none, as every change is told there.
  bool new_fault_ = false;
};

/// Nothing: the log has no such lines. @throw FileError  damaged, or of a build that wrote states
/// as they were in its memory
std::optional<RecordedLoop> recordedLoop(std::string_view footer);
/// Which build wrote them; empty: there are none.
std::string recordedBuild(std::string_view footer);

/// Options as the loop used them under that id: its upper bits say what it overruled.
HapticOptions asTheLoopHad(HapticOptions options, std::uint64_t id);

/// The one that these options name. @return null: they name none
/// @throw FileError  no line tells it
const GuidePath* guideNamed(const std::map<std::uint64_t, GuidePath>& guides,
                            const HapticOptions& options);

/// As replay(), from a running loop.
/// @param space  the surface of a scene; stays valid
/// @throw FileError  rows are missing, or name a scene or options that no line tells  @throw
/// Cancelled
ReplayResult replayLoop(const RecordedLoop& loop, const LogTable& log,
                        const std::function<const HapticSpace&(const RecordedScene&)>& space,
                        const std::function<void(const HapticSample&, double t_s)>& each,
                        const Task& task = {});

}  // namespace relievo
