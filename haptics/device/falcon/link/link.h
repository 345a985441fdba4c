// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "haptics/device/device.h"
#include "haptics/device/falcon/kinematics.h"
#include "haptics/device/falcon/link/answer_times.h"
#include "haptics/device/falcon/link/button_debounce.h"
#include "haptics/device/falcon/link/homing.h"
#include "haptics/device/falcon/link/link_status.h"
#include "haptics/device/falcon/link/pose_gate.h"
#include "haptics/device/falcon/link/silence.h"
#include "haptics/device/falcon/port.h"
#include "haptics/device/link/force_ramp.h"
#include "haptics/device/link/mailbox.h"

namespace relievo::falcon {

/// What the owner tells the link. [owner writes, link thread reads]
struct LinkCommand {
  std::uint32_t retries = 0;       ///< Raise it to try again after a failure.
  std::uint32_t measurements = 0;  ///< Raise it to measure times anew.
  double counts_per_n_mm = kNominalCountsPerNmm / 2;
  bool show_lights = false;  ///< `lights` instead of those that tell the state.
  std::uint8_t lights = lights_off;
};

using LinkMailbox = relievo::LinkMailbox<LinkCommand, LinkStatus>;

/// The firmware's bytes. @throw FileError  says where was looked, or what is wrong with the file
using FirmwareSource = std::function<std::vector<std::uint8_t>()>;

struct LinkLimits : ForceRules {
  int attempts = 10;  ///< To start the firmware.
};

/// Keeps one Falcon going: finds it, starts its firmware, homes it, then one frame after the other,
/// exactly one question under way. Every interruption sends zero force first, and force comes back
/// only with orders made from readings after it. Waits nowhere but in `Bus` and `Port`; runs on
/// their clock. All of it: [device thread].
class Link {
 public:
  Link(Bus& bus, LinkMailbox& mailbox, FirmwareSource firmware, LinkLimits limits = {});

  /// Until stopped; leaves with motors at zero force and lights off.
  /// @param opening  already open, or without a port: waits for one
  void run(const std::stop_token& stop, Opening opening);

 private:
  enum class Leave : std::uint8_t { stopped, gone, silent };
  enum class Upload : std::uint8_t { done, no_hello, no_lock, wrong_echo, no_start, gone };

  std::unique_ptr<Port> waitForDevice(const std::stop_token& stop, bool also_absent);
  void serve(const std::stop_token& stop, std::unique_ptr<Port>& port);
  void close(std::unique_ptr<Port>& port, bool for_good);
  void waitAfterFailure(const std::stop_token& stop);
  bool pause(const std::stop_token& stop, std::int64_t most_ns);
  PortResult request(const BridgeRequest& request);
  PortResult write(std::span<const std::uint8_t> bytes);
  bool read(std::span<std::uint8_t> into, std::int64_t until_ns, std::size_t& bytes);
  bool requestAll(std::initializer_list<BridgeRequest> requests);
  bool prepareToRun();
  bool answers(int questions);
  bool waitForRetry(const std::stop_token& stop, std::int64_t most_ns);

  // link_start.cpp
  bool start(const std::stop_token& stop, std::unique_ptr<Port>& port);
  Upload uploadOnce(const std::stop_token& stop, const std::vector<std::uint8_t>& firmware);
  Message whyNotStarted(Upload result) const;
  bool hello();
  bool lockBaud();
  bool echoes(std::span<const std::uint8_t> chunk);

  // link_operate.cpp
  Leave operate(const std::stop_token& stop);
  void takeReport(const Report& report, std::int64_t now_ns);
  bool follow(const Report& report, std::int64_t now_ns);
  void takeDamage(std::int64_t now_ns);
  void forgetButtons();
  bool takeFailure(std::int64_t now_ns);
  bool wasPaused(std::int64_t now_ns) const;
  bool takePause(std::int64_t now_ns);
  void measureAnewIfAsked();
  std::int64_t silentAt() const;
  std::optional<Leave> watch(std::int64_t now_ns);
  bool ask(std::int64_t now_ns, bool neutral);
  std::array<std::int16_t, kArms> motorCounts(std::int64_t now_ns);
  std::uint8_t lights(std::int64_t now_ns) const;
  bool isWanted(std::int64_t now_ns);
  void wake();
  bool rest(std::int64_t now_ns);
  void sendNeutralFrame(const Frame& frame);

  void interrupt(DeviceFault fault, std::int64_t now_ns);
  void setState(LinkState state, const std::optional<Message>& detail = {});
  void publishStatus();
  void publishReading(std::int64_t now_ns);

  Bus& bus_;
  LinkMailbox& mailbox_;
  FirmwareSource firmware_;
  LinkLimits limits_;
  ForceRamp force_ramp_;
  Port* port_ = nullptr;
  PortResult lost_ = PortResult::ok;  // How this opening was lost.
  bool known_present_ = false;        // Open, or was until it was lost.
  bool runs_ = false;                 // The bridge is set to the running protocol.

  ReportReader reader_;
  LinkStatus status_;
  LinkReading reading_;
  AnswerTimes times_;
  Silence silence_;
  Homing homing_;
  ButtonDebounce buttons_;
  LinkCommand seen_;  // Of wishes, what was done.
  std::int64_t slept_ = 0;

  // Of operate().
  PoseGate gate_;
  std::optional<AngleJacobian> jacobian_;  // Nothing: no force in this pose.
  std::int64_t force_ns_ = 0, published_ns_ = 0, operates_since_ns_ = 0;
  bool zero_next_ = false;
  bool resting_ = false;
};

}  // namespace relievo::falcon
