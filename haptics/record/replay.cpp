// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/replay.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/base/failure.h"
#include "haptics/record/recorded_loop.h"
#include "haptics/record/sample_log.h"

namespace relievo {

namespace {
std::int64_t nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool lacks(const LogTable& log, std::string_view column) {
  return std::find(log.lacking.begin(), log.lacking.end(), column) != log.lacking.end();
}
}  // namespace

std::int64_t nanosecondsOf(const TouchRow& row) {
  return nanoseconds(row.t_s);
}

DeviceReading readingOf(const TouchRow& row, std::int64_t first_ns) {
  DeviceReading reading;
  reading.position = row.hand_hip;
  reading.buttons = row.buttons;
  reading.time_ns = first_ns + nanosecondsOf(row) - nanoseconds(row.age_s);
  return reading;
}

void compare(HapticSample& sample, const TouchRow& row, const LogTable& log, ReplayResult& result,
             const std::function<void(const HapticSample&, double t_s)>& each) {
  sample.rate_hz = row.rate_hz;  // Measured, not computed.
  each(sample, row.t_s);
  const TouchRow replayed = touchRow(sample, row.t_s);
  for (const LogColumn& column : kNumberColumns) {
    const double now = column.value(replayed), logged = column.value(row);
    if (sameBits(now, logged) || lacks(log, column.name)) continue;
    ++result.different;
    if (!result.first) {
      result.first = ReplayDifference{sample.tick, std::string(column.name), logged, now};
    }
    return;
  }
}

ReplayResult replay(const HapticSpace& space, const HapticOptions& core_options, ForceChain chain,
                    const LogTable& log,
                    const std::function<void(const HapticSample&, double t_s)>& each,
                    const Task& task) {
  ReplayResult result;
  HapticCore core(chain);
  const std::map<std::uint64_t, LoopChange> told = loopChanges(log.footer);
  ChangeCursor changes(told);
  const std::map<std::uint64_t, GuidePath> guides = recordedGuides(log.footer);
  for (const TouchRow& row : log.rows) {
    constexpr std::uint64_t kTicksPerCheck = 1024;
    if (row.tick != result.ticks) {
      throw failure<MessageId::recording_lost_samples>(result.ticks);
    }
    if (result.ticks++ % kTicksPerCheck == 0) task.check();
    changes.at(row.tick);
    const HapticOptions options = asTheLoopHad(core_options, changes.now().options_id);
    DeviceReading reading = readingOf(row, 0);
    changes.tell(core, options, reading);
    HapticSample sample =
        core.tick(space, options, reading, nanosecondsOf(row), guideNamed(guides, options));
    compare(sample, row, log, result, each);
  }
  return result;
}

}  // namespace relievo
