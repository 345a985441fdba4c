// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "haptics/device/haply/answer_rate.h"
#include "haptics/device/haply/device_search.h"
#include "haptics/device/haply/force_echo.h"
#include "haptics/device/haply/link_status.h"
#include "haptics/device/haply/messages.h"
#include "haptics/device/haply/port.h"
#include "haptics/device/haply/questions.h"
#include "haptics/device/haply/set_up_check.h"
#include "haptics/device/link/force_ramp.h"
#include "haptics/device/link/mailbox.h"

namespace relievo::haply {

/// What the owner tells the link. [owner writes, link thread reads]
struct LinkCommand {
  std::uint32_t retries = 0;  ///< Raise it to try again after a fault that does not heal by itself.
};

using LinkMailbox = relievo::LinkMailbox<LinkCommand, LinkStatus>;

/// Keeps one device of the Inverse Service going: a thousand times a second one question, one
/// answer. Every interruption makes the next message carry zero force, and force comes back only
/// with orders that were made from readings after it. Waits nowhere but in `Service` and `Port`;
/// runs on their clock. All of it: [device thread].
class Link {
 public:
  /// @param chosen  its id; empty: the only one, which it then keeps to
  Link(Service& service, LinkMailbox& mailbox, std::string chosen);

  /// Until stopped; leaves with zero force.
  /// @param inventory  an open session in which the device was found
  void run(const std::stop_token& stop, Inventory inventory);

 private:
  enum class Leave : std::uint8_t { stopped, gone, absent, silent };

  bool begin(const Inventory& inventory);
  Leave operate(const std::stop_token& stop);
  bool ask(std::int64_t now_ns);
  bool send(std::string_view text);
  std::optional<Leave> answer(const std::stop_token& stop);
  std::optional<Leave> drain();
  std::optional<Leave> takeAnswer(std::string_view text, std::int64_t now_ns);
  std::optional<Leave> watch(std::int64_t now_ns);
  void sendNeutralFrame();

  // link_checks.cpp
  void follow(const ServiceDevice& device, std::int64_t now_ns);
  void checkEcho(const ServiceDevice& device, std::int64_t now_ns);
  void forgiveGap(std::int64_t now_ns);
  LinkState judge(std::int64_t now_ns) const;
  void takeButtons(std::uint32_t buttons);

  DeviceN force(std::int64_t now_ns);
  bool isWanted(std::int64_t now_ns);
  void interrupt(DeviceFault fault, std::int64_t now_ns);
  void setState(LinkState state, std::int64_t now_ns);
  void publishStatus();
  void countAnswer(std::int64_t now_ns);

  Service& service_;
  LinkMailbox& mailbox_;
  std::string chosen_;
  ForceRamp force_ramp_;
  std::unique_ptr<Port> port_;
  ServiceDevice device_;  // As it was found: list, id and type name it.
  ForceKey key_ = ForceKey::values;
  MessageWriter writer_;
  ServiceState heard_;
  LinkStatus status_;
  LinkReading reading_;
  std::uint32_t retries_seen_ = 0;

  // Of operate().
  Questions questions_;
  AnswerRate rate_;
  std::int64_t answered_ns_ = 0, published_ns_ = 0;
  int nonsense_ = 0;    // Messages in a row that were not believed.
  int zeros_left_ = 0;  // Orders of zero that follow the last force.
  bool resting_ = false;
  bool drives_ = false;          // The last message was an order, not a question.
  std::uint32_t held_over_ = 0;  // Buttons whose presses before are unknown: none until let go.
  LinkState told_state_ = LinkState::not_started;  // By the device's status.
  SetUpCheck set_up_;
  ForceEcho echo_;
};

}  // namespace relievo::haply
