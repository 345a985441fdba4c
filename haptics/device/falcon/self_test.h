// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/message/message.h"
#include "haptics/device/falcon/falcon_device.h"

namespace relievo::falcon {

/// One thing that was tried. What a person must judge or do is not failed, only not seen; motors
/// that move nothing at all are failed.
struct SelfTestLine {
  enum class Result : std::uint8_t { passed, failed, not_seen };
  Result result = Result::passed;
  Message text;
};

struct SelfTestOptions {
  double rate_s = 2;             ///< How long the evenness of answers is measured.
  bool nudges = true;            ///< 0.5 N for 150 ms or 5 mm along each axis, both ways.
  double wait_for_person_s = 0;  ///< Longest wait for buttons and movement; 0: they are not tried.
};

/// Tries an open, ready Falcon: evenness of answers, lights, nudges, buttons, encoders, and whether
/// the hand gets to the edges of what the workspace uses. Plays the
/// loop's part: calls exchange() itself, once a step. [any one thread, about 1000 steps a second]
class SelfTest {
 public:
  enum class Phase : std::uint8_t { rate, lights, nudges, person, done };

  SelfTest(FalconDevice& device, SelfTestOptions options);
  /// @return false: done
  bool step(std::int64_t now_ns);
  Phase phase() const { return phase_; }
  /// What is going on and what to do: "Press each of the four buttons: minus is still missing."
  Message prompt() const;
  const std::vector<SelfTestLine>& lines() const { return lines_; }
  bool passed() const;

 private:
  void next(Phase phase, std::int64_t now_ns);
  Phase afterNudges() const { return options_.wait_for_person_s > 0 ? Phase::person : Phase::done; }
  bool endByFault(std::int64_t now_ns);  ///< As step().
  bool showLight(double since_s);        ///< False: all were shown.
  /// True: every arm, button and side was seen.
  bool watchPerson(const DeviceReading& reading);
  void judgeRate(double measured_s);
  void judgeNudges();
  void judgePerson();
  void judgeEdges();
  std::vector<Message> missingSides() const;
  DeviceN nudge(const DeviceReading& reading, double since_s);

  FalconDevice& device_;
  SelfTestOptions options_;
  Phase phase_ = Phase::rate;
  std::int64_t began_ns_ = 0;
  DeviceFault fault_ = DeviceFault::none;  ///< That ends the test.
  std::int64_t fault_ns_ = 0;
  DeviceN force_;
  LinkStatus before_;
  std::vector<SelfTestLine> lines_;
  int nudge_ = -1;
  DeviceMm nudge_from_;
  bool nudged_far_ = false;
  std::array<double, 6> moved_mm_{};
  std::uint32_t pressed_ = 0;
  std::array<int, kArms> least_{}, most_{};
  std::array<double, 6> reached_mm_{};  ///< Right, left, up, down, out, in.
};

}  // namespace relievo::falcon
