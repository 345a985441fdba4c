// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/haply/haply_in_process.h"

#include <algorithm>
#include <utility>

namespace relievo::emulator {

namespace {
constexpr std::int64_t kMs = 1'000'000, kAnswerNs = 20'000;
}

class HaplySession : public haply::Port {
 public:
  explicit HaplySession(HaplyInProcess& service) : service_(service) {
    coming_.push_back({service_.now(), service_.world.inventory(service_.now())});
  }
  ~HaplySession() override { service_.world.endSession(service_.now()); }

  haply::PortResult send(std::string_view text, std::int64_t /*until_ns*/) override {
    HaplyWorld& world = service_.world;
    if (!service_.runs || world.hasFault(HaplyFault::closes)) return haply::PortResult::gone;
    std::int64_t late_ns = kAnswerNs;
    if (world.hasFault(HaplyFault::late_3_ms)) late_ns = 3 * kMs;
    if (world.hasFault(HaplyFault::late_10_ms)) late_ns = 10 * kMs;
    if (world.hasFault(HaplyFault::late_30_ms)) late_ns = 30 * kMs;
    // An answer tells of the time at which the question came.
    std::string answer = world.answer(text, service_.now());
    if (world.hasFault(HaplyFault::silent)) return haply::PortResult::ok;
    coming_.push_back({service_.now() + late_ns, answer});
    if (world.hasFault(HaplyFault::two_answers))
      coming_.push_back({coming_.back().time_ns, answer});
    return haply::PortResult::ok;
  }

  Incoming receive(std::int64_t until_ns) override {
    const bool there = !coming_.empty() && coming_.front().time_ns <= until_ns;
    if (there || until_ns > service_.now()) {
      service_.sleepUntil(there ? std::max(coming_.front().time_ns, service_.now()) : until_ns);
    }
    if (!service_.runs) return {haply::PortResult::gone, {}};
    if (!there || coming_.front().time_ns > service_.now()) return {};
    given_ = std::move(coming_.front().text);
    coming_.pop_front();
    return {haply::PortResult::ok, given_};
  }

 private:
  struct Message {
    std::int64_t time_ns;
    std::string text;
  };
  HaplyInProcess& service_;
  std::deque<Message> coming_;
  std::string given_;
};

haply::Connection HaplyInProcess::connect(const std::stop_token& /*stop*/) {
  ++connections;
  haply::Connection connection;
  if (!runs) return connection;
  connection.reached = haply::Reached::other;
  connection.detail = "no version";
  if (foreign) return connection;
  connection.version = *haply::readVersion(world.versionText());
  connection.reached = haply::Reached::too_old;
  if (!haply::isSpokenBy(connection.version)) return connection;
  connection.reached = haply::Reached::connected;
  connection.port = std::make_unique<HaplySession>(*this);
  return connection;
}

void HaplyInProcess::sleepUntil(std::int64_t time_ns) {
  while (now_ns_ < time_ns) {
    const std::int64_t next_ms = (now_ns_ / kMs + 1) * kMs;
    now_ns_ = std::min(next_ms, time_ns);
    world.advance(now_ns_);
    if (now_ns_ == next_ms && each_ms) each_ms(now_ns_);
  }
}

}  // namespace relievo::emulator
