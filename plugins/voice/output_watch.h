// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

namespace relievo {

/// Where sound comes out, as far as anybody can tell.
enum class SoundOutput : std::uint8_t {
  unknown,     ///< No sound server answers, or it does not say.
  headphones,  ///< On or in the ears: headphones, a headset, a handset.
  room         ///< Anything else, which everybody hears.
};

/// Asks the desktop's sound server (PulseAudio, or PipeWire in its place) through which port its
/// default output sounds, and is told of each change, in a thread of its own. Its library is loaded
/// by the first watch. It never fails: where there is no server the output stays unknown, and the
/// server is looked for again each kAgainS. [one thread]
class OutputWatch {
 public:
  static constexpr double kAgainS = 5;

  OutputWatch();
  ~OutputWatch();
  OutputWatch(const OutputWatch&) = delete;
  OutputWatch& operator=(const OutputWatch&) = delete;

  /// Call it now and then: it looks for a server that was not there. It never waits for one.
  SoundOutput output();

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace relievo
