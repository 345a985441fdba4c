// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/vec3.h"
#include "haptics/device/haply/scanner.h"

namespace relievo::haply {

/// As Haply's Inverse Service speaks: right-handed, x right, y away from the person, z up.
using ServiceM = Vec3<struct ServiceMTag>;  ///< Place, metres.
using ServiceN = Vec3<struct ServiceNTag>;  ///< Force, newtons.

DeviceMm deviceFromService(ServiceM place) noexcept;
ServiceN serviceFromDevice(DeviceN force) noexcept;

/// Of GET /version.
struct ServiceVersion {
  int major = 0, minor = 0;
  ShortText text;
};
/// Nothing: the text is no answer to that question.
std::optional<ServiceVersion> readVersion(std::string_view text) noexcept;
/// 3.1 or a later 3: earlier ones speak otherwise, and of later ones nothing is known.
bool isSpokenBy(const ServiceVersion& version) noexcept;

/// The member that holds the force in an order. The other one is ignored without a word.
enum class ForceKey : std::uint8_t { values, vector };
ForceKey forceKeyOf(const ServiceVersion& version) noexcept;  ///< `vector` from 3.5 on.

/// Turns, shifts and scales: {x, y, z, w of the turn, x, y, z, scales in x, y, z}.
struct Pose {
  std::array<double, 10> values{0, 0, 0, 1, 0, 0, 0, 1, 1, 1};
  bool isLike(const Pose& other) const noexcept;
};

/// One device with motors, as far as one message tells of it.
struct ServiceDevice {
  ShortText list;  ///< The member of the message that it stands in: "inverse3".
  ShortText id;    ///< Letters, digits, '_', '-' and '.' alone.
  ShortText type;  ///< "inverse3", "inverse3x", "minverse"; of its configuration, else its list.
  std::optional<ServiceM> place;
  std::optional<ServiceN> force;  ///< That the service says it shows.
  Pose transform;                 ///< Of this session.
  bool has_configuration = false;
  ShortText basis, preset;  ///< Of the configuration; an empty basis is the usual one.
  Pose mount;
  bool has_status = false;
  bool calibrated = false, ready = false, started = false, power_supply = false;
};

/// What the service says: one message.
struct ServiceState {
  static constexpr std::size_t kMostDevices = 8;
  std::array<ServiceDevice, kMostDevices> devices;
  std::size_t device_count = 0;
  /// Of all grips: bit 0 plus, 2 centre, 3 minus, as DeviceReading has them.
  std::uint32_t buttons = 0;
  /// Those that were told. More than kMostDevices are not.
  std::span<const ServiceDevice> told() const noexcept { return {devices.data(), device_count}; }
  const ServiceDevice* find(std::string_view id) const noexcept;
};
/// Without allocation. @return false: the text is damaged, or what matters here makes no sense
bool readState(std::string_view text, ServiceState& into) noexcept;

/// Writes the driver's messages into its own memory; each is valid until the next one.
class MessageWriter {
 public:
  /// Once after connecting: our name, the middle of the workspace as origin, the axes as they are
  /// usual. Shows no force.
  std::string_view configuration(const ServiceDevice& device) noexcept;
  /// Shows no force.
  std::string_view question(const ServiceDevice& device, bool everything) noexcept;
  /// Shows this force, once.
  std::string_view order(const ServiceDevice& device, ForceKey key, ServiceN force,
                         bool everything) noexcept;

 private:
  void begin(std::string_view session, const ServiceDevice& device) noexcept;
  std::string_view end(std::string_view tail) noexcept;
  void put(std::string_view text) noexcept;
  void put(double value) noexcept;

  std::array<char, 512> text_{};
  std::size_t size_ = 0;
};

inline constexpr std::string_view kPreset = "arm_front_centered", kBasis = "XYZ";

}  // namespace relievo::haply
