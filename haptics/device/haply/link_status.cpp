// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/link_status.h"

#include "core/message/catalogue.h"

namespace relievo::haply {

namespace {
Message describeAbsent(const LinkStatus& status) {
  const std::string wanted = status.wanted.data(), others = status.others.data();
  if (status.was_open) return said<MessageId::haply_unplugged>();
  if (wanted.empty() || others.empty()) return said<MessageId::haply_no_device>();
  return said<MessageId::haply_chosen_absent>(wanted, others);
}

NumberArgument newtons(double value) {
  return {value, 2, NumberArgument::Form::fixed, MessageUnit::newton};
}
}  // namespace

Message describe(const LinkStatus& status) {
  switch (status.state) {
    case LinkState::closed:
      break;
    case LinkState::no_service:
      return status.was_open ? said<MessageId::haply_lost_service>(status.address.data())
                             : said<MessageId::haply_no_service>(status.address.data());
    case LinkState::other_service:
      return said<MessageId::haply_other_service>(status.address.data(), status.detail.data());
    case LinkState::old_service:
      return said<MessageId::haply_old_service>(status.version.text());
    case LinkState::no_device:
      return describeAbsent(status);
    case LinkState::several:
      return said<MessageId::haply_several>(status.others.data());
    case LinkState::checking:
      return said<MessageId::haply_checking>();
    case LinkState::no_power:
      return said<MessageId::haply_no_power>();
    case LinkState::not_started:
      return said<MessageId::haply_not_started>();
    case LinkState::not_calibrated:
      return said<MessageId::haply_not_calibrated>();
    case LinkState::foreign:
      return said<MessageId::haply_foreign>();
    case LinkState::disobeyed:
      return said<MessageId::haply_disobeyed>(newtons(status.ordered_n), newtons(status.told_n),
                                              status.version.text());
    case LinkState::pushed:
      return said<MessageId::haply_pushed>();
    case LinkState::ready:
      return said<MessageId::haply_ready>();
    case LinkState::silent:
      return said<MessageId::haply_silent>();
  }
  return said<MessageId::haply_not_in_use>();
}

std::string_view nameOf(LinkState state) noexcept {
  constexpr std::array<std::string_view, 15> kNames{
      "closed",  "no_service", "other_service", "old_service", "no_device",
      "several", "checking",   "no_power",      "not_started", "not_calibrated",
      "foreign", "disobeyed",  "pushed",        "ready",       "silent"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string nameOf(std::string_view type, std::string_view id) {
  std::string name = "Haply";
  if (type == "inverse3") {
    name += " Inverse3";
  } else if (type == "inverse3x") {
    name += " Inverse3x";
  } else if (type == "minverse") {
    name += " Minverse";
  } else if (!type.empty()) {
    name.append(" ").append(type);
  }
  return id.empty() ? name : name.append(" ").append(id);
}

}  // namespace relievo::haply
