// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "haptics/loop/haptic_loop.h"

namespace relievo {

using SampleSink = std::function<void(std::span<const HapticSample>)>;  ///< [drain thread] no throw

/// The one consumer of a loop's samples: a thread that hands them, in batches and in order, to its
/// sinks. Sinks are called about 100 times a second, or 8 times while nothing is urgent, with an
/// empty batch too if nothing came.
class SampleDrain {
 public:
  SampleDrain(SampleRing& from, std::vector<SampleSink> sinks);
  ~SampleDrain();  ///< Delivers what is left, then joins.
  SampleDrain(const SampleDrain&) = delete;
  SampleDrain& operator=(const SampleDrain&) = delete;

  /// False while nothing happens that a sink would have to tell at once. When it becomes true, the
  /// samples that wait are delivered at once. [any thread but the loop's]
  void setUrgent(bool urgent);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
