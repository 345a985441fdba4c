// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "tests/emulator/falcon_emulator.h"

namespace relievo {

/// Judges every command that reaches an emulated Falcon, as it comes: how hard the motors push the
/// hand by it, by the emulator's own geometry. A thread of its own takes the commands out of the
/// emulator; where it comes late, the hand was somewhere between the two places that it saw, and
/// the smaller force of the two counts.
class ForceWatch {
 public:
  explicit ForceWatch(std::shared_ptr<emulator::SharedFalcon> falcon);
  ForceWatch(const ForceWatch&) = delete;
  ForceWatch& operator=(const ForceWatch&) = delete;

  /// The largest force since the last call, N; 0: none was asked for.
  double takeLargestN();
  /// How often a force began after there was none, since the last call.
  int takePushes();
  /// Lights and motors of the newest command; nothing: none has come.
  std::optional<emulator::SeenCommand> last() const;
  bool isNeutral() const;

 private:
  void look();
  void judge(const std::vector<emulator::SeenCommand>& commands, const emulator::Triple& grip);

  std::shared_ptr<emulator::SharedFalcon> falcon_;
  mutable std::mutex mutex_;  ///< Of what is below; the emulator is never locked with it held.
  double largest_n_ = 0;
  int pushes_ = 0;
  std::optional<emulator::SeenCommand> last_;
  emulator::Triple grip_{0, 0, 110};
  std::jthread thread_;  ///< Last: it uses what is above it.
};

}  // namespace relievo
