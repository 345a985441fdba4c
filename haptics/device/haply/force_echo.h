// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/device/haply/messages.h"

namespace relievo::haply {

/// Compares the force that the service tells with what was sent: a service may damp, and may
/// neither leave out nor add. No clock of its own. [device thread]
class ForceEcho {
 public:
  void restart(std::int64_t now_ns);
  /// The own force was interrupted: what is told meanwhile says little.
  void disturb(std::int64_t now_ns) { unsteady_ns_ = now_ns; }
  void noteSent(ServiceN force, std::int64_t now_ns);
  void check(ServiceN told, std::int64_t now_ns);

  /// What was sent is not shown. Stays until it is forgiven.
  bool isDisobeyed() const { return disobeyed_; }
  void forgive() { disobeyed_ = false; }
  /// Then: the force that was sent at least, and the one that was told.
  double orderedN() const { return ordered_n_; }
  double toldN() const { return told_n_; }
  /// More was shown than was sent, within the last two seconds.
  bool wasPushed(std::int64_t now_ns) const;

 private:
  struct Sent {
    ServiceN force;
    std::int64_t time_ns = 0;
  };
  void checkHeard(double told_n);
  void checkExcess(ServiceN told, std::int64_t now_ns);

  std::array<Sent, 64> sent_{};   // The newest first.
  int unheard_ = 0;               // Answers without what was sent.
  std::int64_t unsteady_ns_ = 0;  // When the own force was interrupted, fell or turned last.
  std::int64_t excess_ns_ = 0;    // Since when more is told than was sent; 0: it is not.
  int excesses_ = 0;              // Answers since then.
  std::int64_t pushed_ns_ = 0;    // When that was last so for long; 0: never.
  bool disobeyed_ = false;
  double ordered_n_ = 0, told_n_ = 0;
};

}  // namespace relievo::haply
