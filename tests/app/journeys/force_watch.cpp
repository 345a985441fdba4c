// SPDX-License-Identifier: BSD-3-Clause
#include "tests/app/journeys/force_watch.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace relievo {

using emulator::FalconBody;
using emulator::FalconEmulator;
using emulator::SeenCommand;
using emulator::Triple;

namespace {

double forceN(const SeenCommand& command, const Triple& grip) {
  FalconBody body;
  body.hold(grip);
  body.drive(command.motors);
  const Triple force = body.force();
  return std::hypot(force[0], force[1], force[2]);
}

}  // namespace

ForceWatch::ForceWatch(std::shared_ptr<emulator::SharedFalcon> falcon)
    : falcon_(std::move(falcon)), thread_([this](const std::stop_token& stop) {
        constexpr std::chrono::milliseconds kNap{2};
        while (!stop.stop_requested()) {
          look();
          std::this_thread::sleep_for(kNap);
        }
      }) {}

void ForceWatch::look() {
  std::vector<SeenCommand> commands;
  const Triple grip = falcon_->with([&](FalconEmulator& f) {
    commands = f.commands();
    f.forgetCommands();
    return f.body.grip();
  });
  judge(commands, grip);
}

void ForceWatch::judge(const std::vector<SeenCommand>& commands, const Triple& grip) {
  const std::lock_guard lock(mutex_);
  for (const SeenCommand& command : commands) {
    if (!command.neutral()) {
      if (!last_ || last_->neutral()) ++pushes_;
      largest_n_ = std::max(largest_n_, std::min(forceN(command, grip), forceN(command, grip_)));
    }
    last_ = command;
  }
  grip_ = grip;
}

double ForceWatch::takeLargestN() {
  const std::lock_guard lock(mutex_);
  return std::exchange(largest_n_, 0.0);
}

int ForceWatch::takePushes() {
  const std::lock_guard lock(mutex_);
  return std::exchange(pushes_, 0);
}

std::optional<SeenCommand> ForceWatch::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

bool ForceWatch::isNeutral() const {
  const std::optional<SeenCommand> command = last();
  return command && command->neutral();
}

}  // namespace relievo
