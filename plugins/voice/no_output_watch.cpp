// SPDX-License-Identifier: BSD-3-Clause
// Instead of output_watch.cpp, in a build without libpulse's headers.
#include "plugins/voice/output_watch.h"

namespace relievo {

class OutputWatch::Server {};

OutputWatch::OutputWatch() = default;
OutputWatch::~OutputWatch() = default;

SoundOutput OutputWatch::output() {
  return SoundOutput::unknown;
}

}  // namespace relievo
