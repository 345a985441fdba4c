// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/device/haply/messages.h"

namespace relievo::haply {

/// Is the device set up as this program did it? Other programs may set it up, too, and a force that
/// is shown in other axes pushes somewhere else. No clock of its own. [device thread]
class SetUpCheck {
 public:
  enum class State : std::uint8_t { asked, ours, foreign };

  /// @param count  of the times that a set-up was begun; goes on
  explicit SetUpCheck(std::uint64_t& count) : count_(count) {}

  /// A session begins: nobody else's set-up was seen.
  void restart(std::int64_t now_ns);
  /// Sets it up, with the next message.
  void begin(std::int64_t now_ns);
  /// Ours is no longer certain, until it is told again.
  void doubt(std::int64_t now_ns);
  /// This program stood still, or the computer did: nobody failed to tell the set-up meanwhile.
  void forgiveGap(std::int64_t now_ns);
  /// What an answer says of it.
  void check(const ServiceDevice& device, std::int64_t now_ns);

  State state() const { return state_; }
  /// The next message is to set the device up, and shows no force.
  bool isDue() const { return due_; }
  bool takeDue();
  /// Whether the next answer is to tell everything; notes that it was asked for.
  bool askForEverything(std::int64_t now_ns);

 private:
  void takeForeign(std::int64_t now_ns);

  std::uint64_t& count_;
  State state_ = State::asked;
  bool due_ = false;
  std::int64_t everything_ns_ = 0;  // When it was asked for last.
  std::int64_t told_ns_ = 0;        // When a configuration was told last.
  std::int64_t since_ns_ = 0;       // Since when it is asked for, or foreign.
  std::int64_t foreign_ns_ = 0;     // When somebody else's was found last; 0: never.
  std::optional<Pose> mount_;       // That came with ours.
};

}  // namespace relievo::haply
