// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "haptics/device/device.h"
#include "haptics/device/haply/link_status.h"
#include "haptics/device/haply/port.h"

namespace relievo::haply {

/// Which device is meant by an id: "haply" (empty: the only one), "haply:049D". Nothing: it names
/// none.
std::optional<std::string> chosenBy(std::string_view id);
std::string idOf(std::string_view chosen);

/// A session with the service, and everything that it sees.
struct Inventory {
  LinkState state = LinkState::no_service;  ///< `ready`: there is a session, and `seen` is told.
  std::unique_ptr<Port> port;
  ServiceVersion version;
  std::string detail;  ///< If another service answers.
  ServiceState seen;
};
/// Waits for three times its patience at most. @throw DeviceError  this build cannot
Inventory lookAround(Service& service, const std::stop_token& stop);

/// The one that is meant, in that inventory; null: there is none.
struct Choice {
  const ServiceDevice* device = nullptr;
  LinkStatus status;  ///< Why none is, or `checking`.
};
Choice choose(const Inventory& inventory, const Service& service, std::string_view chosen);

/// What keeps a device from being felt as its status has it; `ready`: nothing.
LinkState stateOf(const ServiceDevice& device) noexcept;

/// Its limits. No data sheet is public: those of the maker's tutorials and of SOFA's driver, or
/// below them (docs/adr/0165). What is not known has the least of them.
DeviceInfo limitsOf(std::string_view type);

}  // namespace relievo::haply
