// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/event_channel.h"

#include <chrono>
#include <optional>
#include <system_error>
#include <utility>

namespace relievo::haply {

namespace {
constexpr std::int64_t kPauseNs = 2'000'000'000;
constexpr int kMostAtOnce = 32;  // Whoever sends more waits for the next look.
}  // namespace

EventChannel::EventChannel(ServiceAddress address) : address_(std::move(address)) {}

EventChannel::~EventChannel() {
  stop_.request_stop();
  if (connecting_.valid()) connecting_.wait();
}

void EventChannel::connect(std::int64_t now_ns) {
  if (connecting_.valid()) {
    if (connecting_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      port_ = connecting_.get();
    }
    return;
  }
  if (address_.events_port == 0 || now_ns < next_try_ns_) return;
  next_try_ns_ = now_ns + kPauseNs;
  try {
    connecting_ = std::async(std::launch::async, [address = address_, stop = stop_.get_token()] {
      return eventPort(address, stop);
    });
  } catch (const std::system_error&) {
    // No thread is left: the next try may have one, and no force depends on it.
  }
}

std::vector<ServiceEvent> EventChannel::poll(std::int64_t now_ns) {
  std::vector<ServiceEvent> events;
  if (port_ == nullptr) connect(now_ns);
  if (port_ == nullptr) return events;
  for (int i = 0; i < kMostAtOnce; ++i) {
    const Port::Incoming in = port_->receive(now_ns);
    if (in.result == PortResult::timeout) break;
    if (in.result == PortResult::gone) {
      port_.reset();
      next_try_ns_ = now_ns + kPauseNs;
      break;
    }
    if (const auto event = readEvent(in.text)) events.push_back(*event);
  }
  return events;
}

}  // namespace relievo::haply
