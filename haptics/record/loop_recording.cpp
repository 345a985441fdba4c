// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/loop_recording.h"

#include "core/base/error.h"
#include "haptics/record/events.h"
#include "haptics/record/recorded_loop.h"

namespace relievo {

void LoopRecording::take(std::span<const HapticSample> batch) {
  for (const HapticSample& sample : batch) {
    if (left_ == 0 || !error_.empty()) break;
    if (!before_) start_ns_ = sample.time_ns;
    try {
      if (const std::string line = changeLine(before_ ? &*before_ : nullptr, sample);
          !line.empty()) {
        log_.keep(line);
      }
      log_.write(sample, 1e-9 * static_cast<double>(sample.time_ns - start_ns_),
                 before_ ? eventBetween(*before_, sample) : eventAtStart(sample));
    } catch (const WriteError& error) {
      error_ = error.what();
      break;
    }
    gaps_ += before_ && sample.tick != before_->tick + 1 ? 1 : 0;
    before_ = sample;
    --left_;
  }
  if (left_ == 0 || !error_.empty()) done_.store(true, std::memory_order_release);
}

}  // namespace relievo
