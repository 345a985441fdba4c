// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/in_process.h"
#include "core/message/catalogue.h"

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include "haptics/rt/realtime_thread.h"

namespace relievo::emulator {

namespace {
constexpr std::int64_t kMs = 1'000'000;

class InProcessPort : public falcon::Port {
 public:
  InProcessPort(std::shared_ptr<SharedFalcon> falcon, std::shared_ptr<TestClock> clock)
      : falcon_(std::move(falcon)), clock_(std::move(clock)) {}

  falcon::PortResult request(const falcon::BridgeRequest& request) override {
    const std::array<std::uint8_t, 8> setup{0x40,
                                            request.request,
                                            static_cast<std::uint8_t>(request.value & 0xffU),
                                            static_cast<std::uint8_t>(request.value >> 8U),
                                            static_cast<std::uint8_t>(request.index & 0xffU),
                                            static_cast<std::uint8_t>(request.index >> 8U),
                                            0,
                                            0};
    return falcon_->with([&](FalconEmulator& f) {
      if (!f.plugged()) return falcon::PortResult::gone;
      return f.control(setup, {}, clock_->now()) ? falcon::PortResult::ok
                                                 : falcon::PortResult::timeout;
    });
  }

  falcon::PortResult write(std::span<const std::uint8_t> bytes) override {
    const std::int64_t give_up = clock_->now() + 100 * kMs;
    while (true) {
      const auto [plugged, taken] = falcon_->with([&](FalconEmulator& f) {
        return std::pair{f.plugged(), f.plugged() && f.bulkOut(bytes, clock_->now())};
      });
      if (!plugged) return falcon::PortResult::gone;
      if (taken) return falcon::PortResult::ok;
      if (clock_->now() >= give_up) return falcon::PortResult::timeout;
      clock_->waitUntil(clock_->now() + kMs);
    }
  }

  Incoming read(std::span<std::uint8_t> into, std::int64_t until_ns) override {
    const std::int64_t again_ns = std::exchange(read_again_ns_, 0);
    while (clock_->now() < std::min(again_ns, until_ns)) {
      clock_->waitUntil(std::min(again_ns, until_ns));
    }
    while (true) {
      bool plugged = true, fails = false;
      std::int64_t next = 0;
      const auto packet = falcon_->with([&](FalconEmulator& f) {
        plugged = f.plugged();
        fails = plugged && f.failsToRead();
        auto due = plugged && !fails ? f.bulkIn(clock_->now()) : std::nullopt;
        next = f.nextIn(clock_->now());
        return due;
      });
      if (!plugged) return {0, falcon::PortResult::gone};
      if (fails) {
        read_again_ns_ = clock_->now() + 5 * kMs;
        return {0, falcon::PortResult::failed};
      }
      if (packet) {
        falcon::LineStatus line;
        const std::size_t bytes = falcon::stripStatus(*packet, into, line);
        cts_ = line.clear_to_send;
        errors_.add(line);
        if (bytes > 0 || line.damaged()) return {bytes, falcon::PortResult::ok, line.damaged()};
        continue;
      }
      if (clock_->now() >= until_ns) return {0, falcon::PortResult::timeout};
      // Now and then to the plug, even if the chip has nothing for a while.
      clock_->waitUntil(std::min({until_ns, next, clock_->now() + 20 * kMs}));
    }
  }

  void discardInput() override {
    falcon_->with([this](FalconEmulator& f) {
      if (!f.plugged()) return;
      while (f.bulkIn(clock_->now())) {
      }
    });
  }
  bool clearToSend() const override { return cts_; }
  falcon::LineErrors lineErrors() const override { return errors_; }

 private:
  std::shared_ptr<SharedFalcon> falcon_;
  std::shared_ptr<TestClock> clock_;
  falcon::LineErrors errors_;
  std::int64_t read_again_ns_ = 0;
  bool cts_ = false;
};
}  // namespace

std::int64_t TestClock::now() const {
  return kind_ == Kind::real ? monotonicNs() : now_ns_;
}

void TestClock::waitUntil(std::int64_t until_ns) {
  if (kind_ == Kind::real) {
    const std::int64_t left = until_ns - monotonicNs();
    if (left > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(left));
    return;
  }
  const std::int64_t next_ms = (now_ns_ / kMs + 1) * kMs;
  if (until_ns < next_ms) {
    now_ns_ = std::max(now_ns_, until_ns);
    return;
  }
  now_ns_ = next_ms;
  if (every_ms) every_ms(now_ns_);
}

falcon::Opening InProcessBus::open() {
  ++opens;
  std::vector<PlacedFalcon> plugged;
  std::vector<falcon::SeenFalcon> seen;
  for (const PlacedFalcon& one : falcons_) {
    if (!one.falcon->with([](FalconEmulator& f) { return f.plugged(); })) continue;
    plugged.push_back(one);
    seen.push_back(one.place);
  }
  const falcon::FalconSearch::Found found = search_.among(seen);
  falcon::Opening opening;
  if (found.falcon == nullptr) {
    opening.presence = found.several ? falcon::Presence::several : falcon::Presence::absent;
    if (!search_.choice().any()) opening.wanted = nameOf(search_.choice());
    opening.others = found.others;
    return opening;
  }
  opening.presence = pretend;
  if (opening.presence == falcon::Presence::broken)
    opening.detail = said<MessageId::quoted>("Input/output error");
  if (opening.presence == falcon::Presence::present) {
    opening.which = *found.falcon;
    const auto index = static_cast<std::size_t>(found.falcon - seen.data());
    opening.port = std::make_unique<InProcessPort>(plugged[index].falcon, clock_);
    search_.keep(opening.which);
  }
  return opening;
}

void InProcessBus::waitForChange(std::int64_t until_ns) {
  const auto seen = [this] {
    std::vector<bool> plugged;
    for (const PlacedFalcon& one : falcons_) {
      plugged.push_back(one.falcon->with([](FalconEmulator& f) { return f.plugged(); }));
    }
    return std::pair{plugged, pretend};
  };
  const auto before = seen();
  while (clock_->now() < until_ns && seen() == before) {
    clock_->waitUntil(std::min(until_ns, clock_->now() + 10 * kMs));
  }
}

}  // namespace relievo::emulator
