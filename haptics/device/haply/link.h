// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "haptics/device/haply/device_search.h"
#include "haptics/device/haply/link_status.h"
#include "haptics/device/haply/messages.h"
#include "haptics/device/haply/port.h"
#include "haptics/device/link/force_gate.h"
#include "haptics/device/link/mailbox.h"

namespace relievo::haply {

/// What the owner tells the link. [owner writes, link thread reads]
struct LinkWish {
  std::uint32_t retries = 0;  ///< Raise it to try again after a fault that does not heal by itself.
};

using LinkMailbox = relievo::LinkMailbox<LinkWish, LinkStatus>;

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
  enum class SetUp : std::uint8_t { asked, ours, foreign };

  bool begin(const Inventory& inventory);
  Leave operate(const std::stop_token& stop);
  bool ask(std::int64_t now_ns);
  bool send(std::string_view text);
  std::optional<Leave> answer(const std::stop_token& stop);
  std::optional<Leave> drain();
  std::optional<Leave> takeAnswer(std::string_view text, std::int64_t now_ns);
  std::optional<Leave> watch(std::int64_t now_ns);
  void sayGoodbye();

  // link_checks.cpp
  void follow(const ServiceDevice& device, std::int64_t now_ns);
  void checkSetUp(const ServiceDevice& device, std::int64_t now_ns);
  void setUpAnew(std::int64_t now_ns);
  void checkEcho(const ServiceDevice& device, std::int64_t now_ns);
  void checkHeard(double told_n);
  void checkExcess(ServiceN told, std::int64_t now_ns);
  void noteSent(ServiceN force, std::int64_t now_ns);
  void forgiveGap(std::int64_t now_ns);
  LinkState judge(std::int64_t now_ns) const;
  void takeButtons(std::uint32_t buttons);

  DeviceN force(std::int64_t now_ns);
  bool isWanted(std::int64_t now_ns);
  std::int64_t silentAt() const;
  void interrupt(DeviceFault fault, std::int64_t now_ns);
  void setState(LinkState state, std::int64_t now_ns);
  void publishStatus();
  void countAnswer(std::int64_t now_ns);

  Service& service_;
  LinkMailbox& mailbox_;
  std::string chosen_;
  ForceGate force_gate_;
  std::unique_ptr<Port> port_;
  ServiceDevice device_;  // As it was found: list, id and type name it.
  ForceKey key_ = ForceKey::values;
  MessageWriter writer_;
  ServiceState heard_;
  LinkStatus status_;
  LinkReading reading_;
  std::uint32_t retries_seen_ = 0;

  // Of operate().
  std::int64_t asked_ns_ = 0, answered_ns_ = 0, published_ns_ = 0, rate_mark_ns_ = 0;
  std::uint64_t rate_answers_ = 0;
  int under_way_ = 0;     // Questions without an answer.
  int silence_step_ = 0;  // How far the measures against silence have gone.
  int nonsense_ = 0;      // Messages in a row that were not believed.
  int zeros_left_ = 0;    // Orders of zero that follow the last force.
  bool resting_ = false;
  bool drives_ = false;          // The last message was an order, not a question.
  std::uint32_t held_over_ = 0;  // Buttons whose presses before are unknown: none until let go.

  LinkState told_state_ = LinkState::not_started;  // By the device's status.

  // The set-up.
  SetUp set_up_ = SetUp::asked;
  bool configure_next_ = false;
  std::int64_t everything_ns_ = 0;  // When it was asked for last.
  std::int64_t told_ns_ = 0;        // When a configuration was told last.
  std::int64_t set_up_ns_ = 0;      // Since when it is asked for, or foreign.
  std::int64_t foreign_ns_ = 0;     // When somebody else's was found last; 0: never.
  std::optional<Pose> mount_;       // That came with ours.

  // Forces that were sent, the newest first; and what was told of them.
  struct Sent {
    ServiceN force;
    std::int64_t time_ns = 0;
  };
  std::array<Sent, 64> sent_{};
  int unheard_ = 0;               // Answers without what was sent.
  std::int64_t unsteady_ns_ = 0;  // When the own force was interrupted, fell or turned last.
  std::int64_t excess_ns_ = 0;    // Since when more is told than was sent; 0: it is not.
  int excesses_ = 0;              // Answers since then.
  std::int64_t pushed_ns_ = 0;    // When that was last so for long; 0: never.
  bool disobeyed_ = false;
};

}  // namespace relievo::haply
