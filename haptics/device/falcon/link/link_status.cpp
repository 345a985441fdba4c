// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/link/link_status.h"

#include <utility>
#include <vector>

#include "core/message/catalogue.h"

namespace relievo::falcon {

namespace {
WordsArgument missingArms(std::uint8_t homed) {
  constexpr std::array<MessageId, kArms> kNames{
      MessageId::falcon_arm_top, MessageId::falcon_arm_right, MessageId::falcon_arm_left};
  std::vector<Message> missing;
  for (std::size_t i = 0; i < kArms; ++i) {
    if ((homed >> i & 1U) == 0) missing.push_back({kNames[i], {}});
  }
  return missing;
}

template <std::size_t Size>
void put(const std::string& text, std::array<char, Size>& into) {
  into.fill('\0');
  text.copy(into.data(), Size - 1);
}

Message describeAbsent(const LinkStatus& status) {
  const std::string wanted = status.wanted.data(), others = status.others.data();
  if (status.unplugged > 0) {
    return others.empty() ? said<MessageId::falcon_unplugged>()
                          : said<MessageId::falcon_unplugged_others>(others);
  }
  if (wanted.empty()) return said<MessageId::falcon_absent>();
  return others.empty() ? said<MessageId::falcon_chosen_absent>(wanted)
                        : said<MessageId::falcon_chosen_absent_others>(wanted, others);
}

Message describeNotStarted(const LinkStatus& status) {
  if (status.failed_openings > 0) {
    return said<MessageId::falcon_openings_failed>(status.failed_openings);
  }
  if (auto detail = detailOf(status)) {
    return said<MessageId::falcon_not_started_for>(status.attempts, *std::move(detail));
  }
  return said<MessageId::falcon_not_started>(status.attempts);
}

Message describeHoming(const LinkStatus& status) {
  if (!status.homing_is_long) return said<MessageId::falcon_homing>(missingArms(status.homed));
  return said<MessageId::falcon_homing_long>(missingArms(status.homed));
}
}  // namespace

LinkStatus statusOf(const Opening& opening) {
  constexpr std::array<LinkState, 6> kStates{LinkState::closed,    LinkState::absent,
                                             LinkState::forbidden, LinkState::busy,
                                             LinkState::broken,    LinkState::several};
  LinkStatus status;
  status.state = kStates[static_cast<std::size_t>(opening.presence)];
  take(opening, status);
  return status;
}

void take(const Opening& opening, LinkStatus& status) {
  status.detail_size = 0;
  if (opening.detail) putDetail(*opening.detail, status);
  put(opening.wanted, status.wanted);
  put(opening.others, status.others);
  if (opening.presence != Presence::present) return;
  put(opening.which.serial, status.serial);
  put(opening.which.port, status.port);
}

void putDetail(const Message& detail, LinkStatus& status) {
  std::string bytes = messageBytes(detail);
  if (bytes.size() > status.detail.size()) {
    const std::size_t around = messageBytes(said<MessageId::quoted>("")).size();
    const std::string text = englishText(detail).substr(0, status.detail.size() - around);
    bytes = messageBytes(said<MessageId::quoted>(text));
  }
  status.detail_size = static_cast<std::uint16_t>(bytes.copy(status.detail.data(), bytes.size()));
}

std::optional<Message> detailOf(const LinkStatus& status) {
  return messageFromBytes({status.detail.data(), status.detail_size});
}

Message describe(const LinkStatus& status) {
  switch (status.state) {
    case LinkState::closed:
      return said<MessageId::falcon_not_in_use>();
    case LinkState::absent:
      return describeAbsent(status);
    case LinkState::several:
      return said<MessageId::falcon_several>(status.others.data());
    case LinkState::forbidden:
      return said<MessageId::falcon_forbidden>();
    case LinkState::busy:
      return said<MessageId::falcon_busy>();
    case LinkState::broken:
      return said<MessageId::falcon_broken>(detailOf(status).value_or(said<MessageId::quoted>("")));
    case LinkState::checking:
      return said<MessageId::falcon_checking>();
    case LinkState::no_firmware:
      return detailOf(status).value_or(said<MessageId::falcon_needs_firmware>());
    case LinkState::starting:
      return status.attempt > 3
                 ? said<MessageId::falcon_still_starting>(status.attempt, status.attempts)
                 : said<MessageId::falcon_starting>(status.attempt, status.attempts);
    case LinkState::not_started:
      return describeNotStarted(status);
    case LinkState::homing:
      return describeHoming(status);
    case LinkState::pull_out:
      return said<MessageId::falcon_pull_out>();
    case LinkState::ready:
      return said<MessageId::falcon_ready>();
    case LinkState::silent:
      if (status.failed_openings == 0) break;
      return said<MessageId::falcon_opened_anew>(status.failed_openings, status.attempts);
  }
  return said<MessageId::falcon_silent>();
}

std::string udevRule() {
  const std::string give = R"(MODE="0660", GROUP="plugdev", TAG+="uaccess")"
                           "\n";
  return R"(SUBSYSTEM=="usb", ENV{DEVTYPE}=="usb_device", ATTR{idVendor}=="0403", )"
         R"(ATTR{idProduct}=="cb48", )" +
         give +
         R"(SUBSYSTEM=="hidraw", KERNELS=="*:256F:*|*:046D:C60[356].*|*:046D:C62[135678B].*", )" +
         give +
         R"(SUBSYSTEM=="hidraw", ACTION!="remove", )"
         R"(PROGRAM="/usr/bin/od -An -tx1 -w8 -N8 /sys%p/device/report_descriptor", )"
         R"(RESULT=="*05 01 09 0[458] *|*05 01 15 00 09 0[458] *", )" +
         give + R"(SUBSYSTEM=="usb", ENV{DEVTYPE}=="usb_device", ATTR{idVendor}=="1451", )" + give;
}

}  // namespace relievo::falcon
