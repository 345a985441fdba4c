// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "tests/emulator/falcon_emulator.h"

namespace relievo::test {

/// What reached the emulated Falcon, by its own account: commands, the time between them, and where
/// the force went out in the middle of a touch.
class FalconWire {
 public:
  /// Upper edges of the times between two commands, ns.
  static constexpr std::array<std::int64_t, 8> kEdgesNs{1'500'000,   2'500'000,    5'000'000,
                                                        10'000'000,  20'000'000,   50'000'000,
                                                        100'000'000, 1'000'000'000};
  /// Commands for which the motors were at zero, between two that pushed, no more than a second.
  struct ForceGap {
    double at_s = 0, ms = 0;
    std::uint64_t commands = 0;
  };

  explicit FalconWire(std::shared_ptr<emulator::SharedFalcon> falcon);
  /// Takes what has come since the last call; often enough that nothing piles up.
  void take();

  std::uint64_t commands() const { return commands_; }
  std::uint64_t pushing() const { return pushing_; }
  std::uint64_t badCommands() const;
  double longestMs() const { return 1e-6 * static_cast<double>(longest_ns_); }
  double largestN() const { return largest_n_; }  ///< At the grip, whenever take() looked.
  const std::array<std::uint64_t, kEdgesNs.size() + 1>& gaps() const { return gaps_; }
  const std::vector<ForceGap>& forceGaps() const { return force_gaps_; }

 private:
  std::shared_ptr<emulator::SharedFalcon> falcon_;
  std::uint64_t commands_ = 0, pushing_ = 0;
  std::int64_t first_ns_ = 0, last_ns_ = 0, longest_ns_ = 0;
  std::int64_t pushed_ns_ = 0;       // The last command that pushed.
  std::uint64_t zero_commands_ = 0;  // Since then.
  double largest_n_ = 0;
  std::array<std::uint64_t, kEdgesNs.size() + 1> gaps_{};
  std::vector<ForceGap> force_gaps_;
};

}  // namespace relievo::test
