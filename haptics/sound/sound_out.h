// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "haptics/sound/synth.h"

namespace relievo::sound {

/// Gives the next frames. It must neither allocate nor wait. [audio thread]
using RenderFrames = std::function<void(std::span<Frame>)>;

/// Where sound goes as it is made: asks for frames in a thread of its own. [one thread]
class SoundOut {
 public:
  enum class State : std::uint8_t {
    opening,  ///< Nothing is known yet.
    playing,
    gone  ///< There is none, or there is none any more; it does not come back by itself.
  };
  SoundOut() = default;
  virtual ~SoundOut() = default;  ///< On return nothing is asked for any more.
  SoundOut(const SoundOut&) = delete;
  SoundOut& operator=(const SoundOut&) = delete;

  virtual State state() const = 0;
  /// Why it is gone, in the system's words.
  virtual std::string problem() const = 0;
};

/// The sound server of the desktop: PulseAudio, or PipeWire in its place. Its library is loaded at
/// the first call. It never fails: what cannot be opened is gone.
std::unique_ptr<SoundOut> openSoundServer(RenderFrames render);

}  // namespace relievo::sound
