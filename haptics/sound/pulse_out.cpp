// SPDX-License-Identifier: BSD-3-Clause
#include <pulse/pulseaudio.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/base/late_library.h"
#include "haptics/sound/sound_out.h"

namespace relievo::sound {

namespace {

// What is needed of libpulse, which is loaded when sound is first switched on: everything else
// works where it is not installed.
#define RELIEVO_PULSE_FUNCTIONS(FUNCTION) \
  FUNCTION(context_connect)               \
  FUNCTION(context_disconnect)            \
  FUNCTION(context_errno)                 \
  FUNCTION(context_get_state)             \
  FUNCTION(context_new)                   \
  FUNCTION(context_set_state_callback)    \
  FUNCTION(context_unref)                 \
  FUNCTION(stream_begin_write)            \
  FUNCTION(stream_connect_playback)       \
  FUNCTION(stream_disconnect)             \
  FUNCTION(stream_get_state)              \
  FUNCTION(stream_new)                    \
  FUNCTION(stream_set_state_callback)     \
  FUNCTION(stream_set_write_callback)     \
  FUNCTION(stream_unref)                  \
  FUNCTION(stream_write)                  \
  FUNCTION(strerror)                      \
  FUNCTION(threaded_mainloop_free)        \
  FUNCTION(threaded_mainloop_get_api)     \
  FUNCTION(threaded_mainloop_new)         \
  FUNCTION(threaded_mainloop_start)       \
  FUNCTION(threaded_mainloop_stop)

/// pa_context_new is pulse().context_new, and so on.
struct PulseFunctions {
// NOLINTNEXTLINE(bugprone-macro-parentheses): the name that a member gets.
#define RELIEVO_MEMBER(name) decltype(&::pa_##name) name = nullptr;
  RELIEVO_PULSE_FUNCTIONS(RELIEVO_MEMBER)
#undef RELIEVO_MEMBER
  std::string problem;  ///< Why there are none, in the system's words; empty: they are there.
};

PulseFunctions loadedPulse() {
  LateLibrary library("libpulse.so.0");
  PulseFunctions functions;
#define RELIEVO_FIND(name) library.find("pa_" #name, functions.name);
  RELIEVO_PULSE_FUNCTIONS(RELIEVO_FIND)
#undef RELIEVO_FIND
  functions.problem = library.problem();
  return functions;
}

const PulseFunctions& pulse() {
  static const PulseFunctions functions = loadedPulse();
  return functions;
}

// As measured (docs/adr/0211): two blocks wait at most, and nothing is lost.
constexpr std::uint32_t kBlockFrames = 256;
constexpr std::uint32_t kBlockBytes = kBlockFrames * sizeof(Frame);
constexpr std::uint32_t kWaitingBytes = kBlockBytes * 21 / 10 / sizeof(Frame) * sizeof(Frame);

class PulseOut : public SoundOut {
 public:
  explicit PulseOut(RenderFrames render) : render_(std::move(render)) { open(); }

  ~PulseOut() override {
    if (loop_ == nullptr) return;
    if (is_running_) pulse().threaded_mainloop_stop(loop_);  // Joins: nobody calls from here on.
    if (stream_ != nullptr) {
      pulse().stream_set_write_callback(stream_, nullptr, nullptr);
      pulse().stream_set_state_callback(stream_, nullptr, nullptr);
      pulse().stream_disconnect(stream_);
      pulse().stream_unref(stream_);
    }
    if (context_ != nullptr) {
      pulse().context_set_state_callback(context_, nullptr, nullptr);
      pulse().context_disconnect(context_);
      pulse().context_unref(context_);
    }
    pulse().threaded_mainloop_free(loop_);
  }

  State state() const override { return state_.load(std::memory_order_acquire); }
  std::string problem() const override { return state() == State::gone ? problem_ : std::string(); }

 private:
  void open() {
    if (!pulse().problem.empty()) return fail(pulse().problem);
    loop_ = pulse().threaded_mainloop_new();
    if (loop_ == nullptr) return fail("no thread for it");
    context_ = pulse().context_new(pulse().threaded_mainloop_get_api(loop_), "relievo");
    if (context_ == nullptr) return fail("no memory for it");
    pulse().context_set_state_callback(context_, &PulseOut::contextChanged, this);
    if (pulse().context_connect(context_, nullptr, PA_CONTEXT_NOAUTOSPAWN, nullptr) < 0) {
      return failAsSaid();
    }
    if (pulse().threaded_mainloop_start(loop_) < 0) return fail("no thread for it");
    is_running_ = true;
  }

  /// Once; the words are written before the state says that they are there.
  void fail(std::string problem) {
    if (state() == State::gone) return;
    problem_ = std::move(problem);
    state_.store(State::gone, std::memory_order_release);
  }
  void failAsSaid() {
    const char* const words = pulse().strerror(pulse().context_errno(context_));
    fail(words == nullptr ? "the system does not say why" : words);
  }

  static void contextChanged(pa_context* context, void* self) {
    auto& out = *static_cast<PulseOut*>(self);
    const pa_context_state_t state = pulse().context_get_state(context);
    if (state == PA_CONTEXT_READY) out.openStream();
    if (!PA_CONTEXT_IS_GOOD(state)) out.failAsSaid();
  }

  void openStream() {
    const pa_sample_spec spec{PA_SAMPLE_FLOAT32NE, kSampleRateHz, 2};
    stream_ = pulse().stream_new(context_, "Touch", &spec, nullptr);
    if (stream_ == nullptr) return failAsSaid();
    pulse().stream_set_state_callback(stream_, &PulseOut::streamChanged, this);
    pulse().stream_set_write_callback(stream_, &PulseOut::write, this);
    const pa_buffer_attr buffer{.maxlength = 4 * kBlockBytes,
                                .tlength = kWaitingBytes,
                                .prebuf = kBlockBytes,
                                .minreq = kBlockBytes,
                                .fragsize = 0};
    if (pulse().stream_connect_playback(stream_, nullptr, &buffer, PA_STREAM_ADJUST_LATENCY,
                                        nullptr, nullptr) < 0) {
      failAsSaid();
    }
  }

  static void streamChanged(pa_stream* stream, void* self) {
    auto& out = *static_cast<PulseOut*>(self);
    const pa_stream_state_t state = pulse().stream_get_state(stream);
    if (state == PA_STREAM_READY && out.state() == State::opening) {
      out.state_.store(State::playing, std::memory_order_release);
    }
    if (state == PA_STREAM_FAILED || state == PA_STREAM_TERMINATED) out.failAsSaid();
  }

  /// Called when the server has room for so many bytes.
  static void write(pa_stream* stream, std::size_t bytes, void* self) {
    auto& out = *static_cast<PulseOut*>(self);
    while (bytes >= sizeof(Frame)) {
      void* room = nullptr;
      std::size_t size = bytes;
      if (pulse().stream_begin_write(stream, &room, &size) < 0 || room == nullptr) return;
      const std::size_t frames = std::min(size, bytes) / sizeof(Frame);
      if (frames == 0) return;
      out.render_(std::span<Frame>(static_cast<Frame*>(room), frames));
      const std::size_t written = frames * sizeof(Frame);
      if (pulse().stream_write(stream, room, written, nullptr, 0, PA_SEEK_RELATIVE) < 0) return;
      bytes -= written;
    }
  }

  RenderFrames render_;
  std::atomic<State> state_{State::opening};
  std::string problem_;
  pa_threaded_mainloop* loop_ = nullptr;
  pa_context* context_ = nullptr;
  pa_stream* stream_ = nullptr;  // [audio thread] while that runs.
  bool is_running_ = false;
};

}  // namespace

std::unique_ptr<SoundOut> openSoundServer(RenderFrames render) {
  return std::make_unique<PulseOut>(std::move(render));
}

}  // namespace relievo::sound
