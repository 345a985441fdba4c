// SPDX-License-Identifier: BSD-3-Clause
// Instead of pulse_out.cpp, in a build without libpulse's headers.
#include "haptics/sound/sound_out.h"

namespace relievo::sound {

namespace {
class NoOut : public SoundOut {
 public:
  State state() const override { return State::gone; }
  std::string problem() const override { return "this build cannot play sound"; }
};
}  // namespace

std::unique_ptr<SoundOut> openSoundServer(RenderFrames /*render*/) {
  return std::make_unique<NoOut>();
}

}  // namespace relievo::sound
