// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/output_watch.h"

#include <pulse/pulseaudio.h>

#include <array>
#include <chrono>
#include <string_view>

#include "core/base/late_library.h"

namespace relievo {
namespace {

using Clock = std::chrono::steady_clock;

// What is needed of libpulse; everything else works where it is not installed.
#define RELIEVO_PULSE_FUNCTIONS(FUNCTION)  \
  FUNCTION(context_connect)                \
  FUNCTION(context_disconnect)             \
  FUNCTION(context_get_server_info)        \
  FUNCTION(context_get_sink_info_by_name)  \
  FUNCTION(context_get_state)              \
  FUNCTION(context_new)                    \
  FUNCTION(context_set_state_callback)     \
  FUNCTION(context_set_subscribe_callback) \
  FUNCTION(context_subscribe)              \
  FUNCTION(context_unref)                  \
  FUNCTION(operation_unref)                \
  FUNCTION(proplist_gets)                  \
  FUNCTION(threaded_mainloop_free)         \
  FUNCTION(threaded_mainloop_get_api)      \
  FUNCTION(threaded_mainloop_new)          \
  FUNCTION(threaded_mainloop_start)        \
  FUNCTION(threaded_mainloop_stop)

/// pa_context_new is pulse().context_new, and so on.
struct PulseFunctions {
// NOLINTNEXTLINE(bugprone-macro-parentheses): the name that a member gets.
#define RELIEVO_MEMBER(name) decltype(&::pa_##name) name = nullptr;
  RELIEVO_PULSE_FUNCTIONS(RELIEVO_MEMBER)
#undef RELIEVO_MEMBER
  bool is_there = false;
};

PulseFunctions loadedPulse() {
  LateLibrary library("libpulse.so.0");
  PulseFunctions functions;
#define RELIEVO_FIND(name) library.find("pa_" #name, functions.name);
  RELIEVO_PULSE_FUNCTIONS(RELIEVO_FIND)
#undef RELIEVO_FIND
  functions.is_there = library.isThere();
  return functions;
}

const PulseFunctions& pulse() {
  static const PulseFunctions functions = loadedPulse();
  return functions;
}

/// By the type of the port that sounds, else by what the output's device is.
SoundOutput outputOf(const pa_sink_info& sink) {
  if (sink.active_port != nullptr) {
    switch (sink.active_port->type) {
      case PA_DEVICE_PORT_TYPE_HEADPHONES:
      case PA_DEVICE_PORT_TYPE_HEADSET:
      case PA_DEVICE_PORT_TYPE_HANDSET:
      case PA_DEVICE_PORT_TYPE_EARPIECE:
        return SoundOutput::headphones;
      case PA_DEVICE_PORT_TYPE_UNKNOWN:
        break;
      default:
        return SoundOutput::room;
    }
  }
  const char* const form = pulse().proplist_gets(sink.proplist, PA_PROP_DEVICE_FORM_FACTOR);
  constexpr std::array<std::string_view, 4> kInTheEars{"headphone", "headset", "handset",
                                                       "hands-free"};
  for (const std::string_view word : kInTheEars) {
    if (form != nullptr && form == word) return SoundOutput::headphones;
  }
  return SoundOutput::room;
}

}  // namespace

/// One connection, until it fails.
class OutputWatch::Server {
 public:
  Server() { open(); }
  ~Server() {
    if (loop_ == nullptr) return;
    if (is_running_) pulse().threaded_mainloop_stop(loop_);  // Joins: nobody calls from here on.
    if (context_ != nullptr) {
      pulse().context_set_state_callback(context_, nullptr, nullptr);
      pulse().context_set_subscribe_callback(context_, nullptr, nullptr);
      pulse().context_disconnect(context_);
      pulse().context_unref(context_);
    }
    pulse().threaded_mainloop_free(loop_);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  SoundOutput output() const { return output_.load(std::memory_order_acquire); }
  bool isGone() const { return is_gone_.load(std::memory_order_acquire); }
  bool isOld() const {
    return std::chrono::duration<double>(Clock::now() - made_).count() > kAgainS;
  }

 private:
  void open() {
    if (!pulse().is_there) return fail();
    loop_ = pulse().threaded_mainloop_new();
    if (loop_ == nullptr) return fail();
    context_ = pulse().context_new(pulse().threaded_mainloop_get_api(loop_), "relievo");
    if (context_ == nullptr) return fail();
    pulse().context_set_state_callback(context_, &Server::contextChanged, this);
    if (pulse().context_connect(context_, nullptr, PA_CONTEXT_NOAUTOSPAWN, nullptr) < 0) {
      return fail();
    }
    if (pulse().threaded_mainloop_start(loop_) < 0) return fail();
    is_running_ = true;
  }
  void fail() {
    output_.store(SoundOutput::unknown, std::memory_order_release);
    is_gone_.store(true, std::memory_order_release);
  }
  static void forget(pa_operation* asked) {
    if (asked != nullptr) pulse().operation_unref(asked);
  }
  void ask() { forget(pulse().context_get_server_info(context_, &Server::serverTold, this)); }
  static void contextChanged(pa_context* context, void* self) {
    auto& server = *static_cast<Server*>(self);
    const pa_context_state_t state = pulse().context_get_state(context);
    if (!PA_CONTEXT_IS_GOOD(state)) return server.fail();
    if (state != PA_CONTEXT_READY) return;
    pulse().context_set_subscribe_callback(
        context,
        [](pa_context*, pa_subscription_event_type_t, std::uint32_t, void* who) {
          static_cast<Server*>(who)->ask();
        },
        self);
    // A port is of a sink; which sink is the default one is of the server.
    const auto of = static_cast<pa_subscription_mask_t>(PA_SUBSCRIPTION_MASK_SINK |
                                                        PA_SUBSCRIPTION_MASK_SERVER);
    forget(pulse().context_subscribe(context, of, nullptr, nullptr));
    server.ask();
  }
  static void serverTold(pa_context* context, const pa_server_info* info, void* self) {
    auto& server = *static_cast<Server*>(self);
    if (info == nullptr || info->default_sink_name == nullptr) {
      return server.output_.store(SoundOutput::unknown, std::memory_order_release);
    }
    forget(pulse().context_get_sink_info_by_name(context, info->default_sink_name,
                                                 &Server::sinkTold, self));
  }
  static void sinkTold(pa_context* /*context*/, const pa_sink_info* sink, int end, void* self) {
    if (end != 0 || sink == nullptr) return;
    static_cast<Server*>(self)->output_.store(outputOf(*sink), std::memory_order_release);
  }

  const Clock::time_point made_ = Clock::now();
  std::atomic<SoundOutput> output_{SoundOutput::unknown};
  std::atomic<bool> is_gone_{false};
  pa_threaded_mainloop* loop_ = nullptr;
  pa_context* context_ = nullptr;
  bool is_running_ = false;
};

OutputWatch::OutputWatch() : server_(std::make_unique<Server>()) {}
OutputWatch::~OutputWatch() = default;

SoundOutput OutputWatch::output() {
  if (server_->isGone() && server_->isOld()) server_ = std::make_unique<Server>();
  return server_->output();
}

}  // namespace relievo
