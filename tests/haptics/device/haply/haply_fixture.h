// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "haptics/device/haply/link.h"
#include "haptics/device/haply/link_status.h"
#include "tests/emulator/haply/haply_in_process.h"

namespace relievo::haply {

using emulator::HaplyFault;
using emulator::HaplyInProcess;
using emulator::HaplyWorld;

/// The link with a made-up service on a made-up clock, and a loop that wants one force.
class HaplyLink : public testing::Test {
 protected:
  HaplyInProcess service_;
  LinkMailbox mailbox_;
  DeviceN wanted_;  ///< Ordered every millisecond while the hand may be pushed.
  bool loop_runs_ = true;
  DeviceReading reading_;          ///< The newest.
  std::vector<DeviceFault> told_;  ///< Each time another one began.
  std::string chosen_;

  HaplyWorld& world() { return service_.world; }
  const LinkStatus& status() {
    mailbox_.status.update();
    return mailbox_.status.front();
  }
  double shownN() { return std::hypot(world().force()[0], world().force()[1], world().force()[2]); }
  /// In that millisecond of the run, before the loop's tick.
  void at(int ms, std::function<void()> action) { actions_.emplace(ms, std::move(action)); }
  void plantAt(int ms, HaplyFault fault) {
    at(ms, [this, fault] { world().fault = fault; });
  }
  std::int64_t timeOf(int ms) const { return begin_ns_ + ms * std::int64_t{1'000'000}; }

  void run(int ms) {
    std::stop_source stop;
    int now_ms = 0;
    const std::stop_token token = stop.get_token();
    Inventory inventory = lookAround(service_, token);
    begin_ns_ = service_.now() / 1'000'000 * 1'000'000;
    service_.each_ms = [&](std::int64_t now_ns) {
      ++now_ms;
      const auto [first, last] = actions_.equal_range(now_ms);
      for (auto one = first; one != last; ++one) one->second();
      if (loop_runs_) tick(now_ns);
      if (now_ms >= ms) stop.request_stop();
    };
    Link(service_, mailbox_, chosen_).run(token, std::move(inventory));
    service_.each_ms = {};
  }

  /// The largest change of force from one to the next that was shown after a time, and how much
  /// was: { N per ms, N }.
  std::pair<double, double> riseAfter(std::int64_t time_ns) {
    double steepest = 0, most = 0, before = 0;
    std::int64_t before_ns = time_ns;
    for (const HaplyWorld::Shown& shown : world().log) {
      const double n = std::hypot(shown.force[0], shown.force[1], shown.force[2]);
      if (shown.time_ns > time_ns) {
        const double ms = std::max(1.0, 1e-6 * static_cast<double>(shown.time_ns - before_ns));
        steepest = std::max(steepest, (n - before) / ms);
        most = std::max(most, n);
      }
      before = n;
      before_ns = shown.time_ns;
    }
    return {steepest, most};
  }
  /// When the motors were at zero first after a time, ms later; below 0: never.
  double zeroAfterMs(std::int64_t time_ns) {
    for (const HaplyWorld::Shown& shown : world().log) {
      const bool zero = shown.force == HaplyWorld::Triple{};
      if (shown.time_ns >= time_ns && zero) {
        return 1e-6 * static_cast<double>(shown.time_ns - time_ns);
      }
    }
    return -1;
  }

 private:
  void tick(std::int64_t now_ns) {
    const std::uint32_t cuts = mailbox_.cuts.load();
    mailbox_.readings.update();
    const DeviceFault before = reading_.fault;
    reading_ = loop_end_.take(cuts, mailbox_.readings.front());
    if (reading_.fault != DeviceFault::none && reading_.fault != before) {
      told_.push_back(reading_.fault);
    }
    const DeviceN force = reading_.fault == DeviceFault::none ? wanted_ : DeviceN{};
    mailbox_.orders.write(loop_end_.order(force, now_ns));
  }

  std::multimap<int, std::function<void()>> actions_;
  LoopEnd loop_end_;
  std::int64_t begin_ns_ = 0;
};

}  // namespace relievo::haply
