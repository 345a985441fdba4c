// SPDX-License-Identifier: BSD-3-Clause
#include "tests/realtime/falcon_wire.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo::test {

FalconWire::FalconWire(std::shared_ptr<emulator::SharedFalcon> falcon)
    : falcon_(std::move(falcon)) {
  falcon_->with([](emulator::FalconEmulator& f) { f.forgetCommands(); });
}

void FalconWire::take() {
  constexpr std::int64_t kTouchNs = 1'000'000'000;  // A longer pause is a hand that lifted off.
  std::vector<emulator::SeenCommand> seen;
  falcon_->with([&](emulator::FalconEmulator& f) {
    seen = f.commands();
    f.forgetCommands();
    const emulator::Triple n = f.body.force();
    largest_n_ = std::max(largest_n_, std::hypot(n[0], n[1], n[2]));
  });
  for (const emulator::SeenCommand& command : seen) {
    if (commands_++ == 0) {
      first_ns_ = command.time_ns;
    } else {
      const std::int64_t gap_ns = command.time_ns - last_ns_;
      longest_ns_ = std::max(longest_ns_, gap_ns);
      std::size_t bin = 0;
      while (bin < kEdgesNs.size() && gap_ns > kEdgesNs[bin]) ++bin;
      ++gaps_[bin];
    }
    last_ns_ = command.time_ns;
    if (command.neutral()) {
      ++zero_commands_;
      continue;
    }
    ++pushing_;
    if (pushed_ns_ != 0 && zero_commands_ > 0 && command.time_ns - pushed_ns_ <= kTouchNs) {
      force_gaps_.push_back({1e-9 * static_cast<double>(pushed_ns_ - first_ns_),
                             1e-6 * static_cast<double>(command.time_ns - pushed_ns_),
                             zero_commands_});
    }
    pushed_ns_ = command.time_ns;
    zero_commands_ = 0;
  }
}

std::uint64_t FalconWire::badCommands() const {
  return falcon_->with(
      [](emulator::FalconEmulator& f) { return static_cast<std::uint64_t>(f.badCommands()); });
}

}  // namespace relievo::test
