// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>

#include "haptics/device/device.h"
#include "haptics/device/falcon/link/link_status.h"
#include "tests/emulator/falcon_emulator.h"

namespace relievo::falcon::test {

using emulator::FalconEmulator;

/// One line of the list of faults that strike while touching.
struct Fault {
  const char* name;
  void (*strike)(FalconEmulator&);
  void (*mend)(FalconEmulator&);
  DeviceFault told;  ///< What the loop is told; none: too short for that.
  std::uint64_t (*counted)(const LinkStatus&);  ///< Where it stays to be seen.
  bool homing_lost;
};
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
inline void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}
constexpr int kForEver = 1 << 30;
inline void mendsItself(FalconEmulator& /*falcon*/) {}
inline const std::array<Fault, 14> kFaults{{
    {"LostByteOfAnAnswer", [](FalconEmulator& f) { f.troubles.lose_answer_bytes = 1; }, mendsItself,
     DeviceFault::none, [](const LinkStatus& s) { return s.counts.hiccups + s.counts.malformed; },
     false},
    {"LostByteOfACommand", [](FalconEmulator& f) { f.troubles.lose_command_bytes = 1; },
     mendsItself, DeviceFault::none, [](const LinkStatus& s) { return s.counts.hiccups; }, false},
    {"ShortAnswer", [](FalconEmulator& f) { f.troubles.short_answers = 1; }, mendsItself,
     DeviceFault::none, [](const LinkStatus& s) { return s.counts.malformed; }, false},
    {"Noise", [](FalconEmulator& f) { f.troubles.noisy_answers = 1; }, mendsItself,
     DeviceFault::none, [](const LinkStatus& s) { return s.counts.malformed; }, false},
    {"ImpossiblePose", [](FalconEmulator& f) { f.troubles.impossible_encoders = true; },
     [](FalconEmulator& f) { f.troubles.impossible_encoders = false; }, DeviceFault::none,
     [](const LinkStatus& s) { return s.counts.impossible_poses; }, false},
    {"Overrun", [](FalconEmulator& f) { f.troubles.overruns = 1; }, mendsItself, DeviceFault::none,
     [](const LinkStatus& s) { return s.counts.overruns; }, false},
    {"FramingError", [](FalconEmulator& f) { f.troubles.framing_errors = 1; }, mendsItself,
     DeviceFault::none, [](const LinkStatus& s) { return s.counts.framing; }, false},
    {"ParityError", [](FalconEmulator& f) { f.troubles.parity_errors = 1; }, mendsItself,
     DeviceFault::none, [](const LinkStatus& s) { return s.counts.parity; }, false},
    {"LateAnswers", [](FalconEmulator& f) { f.hold_answers_ns = 8'000'000; },
     [](FalconEmulator& f) { f.hold_answers_ns = 0; }, DeviceFault::none,
     [](const LinkStatus& s) { return s.counts.hiccups; }, false},
    {"FailedRead", [](FalconEmulator& f) { f.troubles.failed_reads = 1; }, mendsItself,
     DeviceFault::none, [](const LinkStatus& s) { return s.counts.failed_reads; }, false},
    {"ReadsThatGoOnFailing", [](FalconEmulator& f) { f.troubles.failed_reads = kForEver; },
     [](FalconEmulator& f) { f.troubles.failed_reads = 0; }, DeviceFault::timeout,
     [](const LinkStatus& s) { return s.counts.failed_reads; }, false},
    {"Stall", [](FalconEmulator& f) { f.troubles.silent = true; },
     [](FalconEmulator& f) { f.troubles.silent = false; }, DeviceFault::timeout,
     [](const LinkStatus& s) { return s.counts.stalls; }, false},
    {"Unplugged", [](FalconEmulator& f) { f.unplug(); },
     [](FalconEmulator& f) {
       f.powerCycle();
       f.plugIn();
     },
     DeviceFault::disconnected, [](const LinkStatus& s) { return s.unplugged; }, true},
    {"LostHoming", [](FalconEmulator& f) { f.body.forgetHoming(); }, mendsItself,
     DeviceFault::not_ready,
     [](const LinkStatus& s) { return std::uint64_t{s.homed != kAllHomed}; }, true},
}};

/// Of the commands since the fault struck one may still carry force, if it was under way: the
/// fault is in its answer. The next one carries zero.
inline bool nextCommandIsNeutral(const FalconEmulator& falcon) {
  const auto& commands = falcon.commands();
  const auto end = commands.begin() + std::min<std::ptrdiff_t>(2, std::ssize(commands));
  return std::any_of(commands.begin(), end, [](const auto& c) { return c.neutral(); });
}

/// The same for a fault that stays: every command after that one carries zero.
inline bool everyNextCommandIsNeutral(const FalconEmulator& falcon) {
  const auto& commands = falcon.commands();
  if (commands.size() < 2) return false;
  return std::all_of(commands.begin() + 1, commands.end(),
                     [](const auto& c) { return c.neutral(); });
}

}  // namespace relievo::falcon::test
