// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/buttons/rumble_sink.h"

#include <span>
#include <utility>
#include <vector>

#include "haptics/rt/realtime_thread.h"

namespace relievo {

pad::TouchMoment touchMoment(const HapticSample& sample) {
  const bool beyond = sample.contact && sample.origin == CellStatus::outside;
  return {.time_ns = sample.time_ns,
          .counts = sample.engaged != EngagePhase::off && sample.fault == DeviceFault::none &&
                    sample.stopped == StopReason::none,
          .contact = sample.contact,
          .at_edge = sample.frame != 0 || beyond,
          .force_n = norm(sample.force)};
}

SampleSink rumbleSink(std::shared_ptr<pad::Rumbler> rumbler) {
  return [rumbler = std::move(rumbler),
          moments = std::vector<pad::TouchMoment>()](std::span<const HapticSample> batch) mutable {
    moments.clear();
    for (const HapticSample& sample : batch) moments.push_back(touchMoment(sample));
    rumbler->take(moments, monotonicNs());
  };
}

}  // namespace relievo
