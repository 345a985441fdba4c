// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "haptics/device/falcon/port.h"
#include "tests/emulator/falcon_emulator.h"

namespace relievo::emulator {

/// The clock of a test. Made up: it runs as fast as it is waited for, and something can happen at
/// each of its milliseconds. Or the computer's.
class TestClock {
 public:
  enum class Kind { made_up, real };
  explicit TestClock(Kind kind = Kind::made_up) : kind_(kind) {}
  std::int64_t now() const;
  /// Returns at `until_ns`, or earlier.
  void waitUntil(std::int64_t until_ns);
  /// [made up, from every_ms or while it waits there] As if the waiting thread had not run for so
  /// long.
  void jump(std::int64_t ns) { now_ns_ += ns; }
  /// [made up] Called once for every millisecond that passes.
  std::function<void(std::int64_t now_ns)> every_ms;

 private:
  Kind kind_;
  std::int64_t now_ns_ = 1'000'000'000;
};

/// An emulated Falcon and where it is plugged in, whenever it is.
struct PlacedFalcon {
  falcon::SeenFalcon place;
  std::shared_ptr<SharedFalcon> falcon;
};

/// Emulated Falcons without USB, for tests of the driver above the transport.
class InProcessBus : public falcon::Bus {
 public:
  InProcessBus(std::shared_ptr<SharedFalcon> falcon, std::shared_ptr<TestClock> clock)
      : InProcessBus({{{}, std::move(falcon)}}, std::move(clock), {}) {}
  InProcessBus(std::vector<PlacedFalcon> falcons, std::shared_ptr<TestClock> clock,
               falcon::FalconChoice choice)
      : falcons_(std::move(falcons)), clock_(std::move(clock)), search_(std::move(choice)) {}
  falcon::Opening open() override;
  falcon::FalconChoice choice() const override { return search_.choice(); }
  void waitForChange(std::int64_t until_ns) override;
  std::int64_t now() override { return clock_->now(); }
  std::int64_t slept() override { return slept_ns; }

  falcon::Presence pretend = falcon::Presence::present;  ///< What open() finds, if not absent.
  std::int64_t slept_ns = 0;
  int opens = 0;  ///< How often somebody has tried.

 private:
  std::vector<PlacedFalcon> falcons_;
  std::shared_ptr<TestClock> clock_;
  falcon::FalconSearch search_;
};

}  // namespace relievo::emulator
