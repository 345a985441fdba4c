// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "haptics/rt/realtime.h"

namespace relievo::falcon {

// What goes over the wire, as bytes; no input or output happens here.

inline constexpr std::uint16_t kVendorId = 0x0403, kProductId = 0xcb48;
inline constexpr std::uint8_t kEndpointIn = 0x81, kEndpointOut = 0x02;
inline constexpr std::size_t kPacketBytes = 64;  ///< Full speed; the first two are line status.
inline constexpr std::size_t kFrameBytes = 16;
inline constexpr int kMaxCounts = 4095;  ///< Largest motor value that Novint's own driver sends.

/// Motors and encoders: 0 top, 1 right, 2 left as the user sees the device.
inline constexpr std::size_t kArms = 3;
inline constexpr std::uint8_t kAllHomed = 0b111;

/// Colours of the logo; they can be added.
enum Lights : std::uint8_t { lights_off = 0, green = 2, blue = 4, red = 8 };

/// Host to device: one frame.
struct Command {
  std::array<std::int16_t, kArms> motors{};  ///< -4095 to 4095.
  bool homing = true;  ///< Keep it on: without it the device does not tell which arms are homed.
  std::uint8_t lights = lights_off;
};
using Frame = std::array<std::uint8_t, kFrameBytes>;
Frame encode(const Command& command) RELIEVO_REALTIME;

/// Device to host: the answer to one frame.
struct Report {
  std::array<std::int16_t, kArms> encoders{};
  std::uint8_t buttons = 0;  ///< Bits 0 to 3: plus, forward, centre, minus.
  std::uint8_t homed = 0;    ///< Bit i: arm i has found its zero.
  friend bool operator==(const Report&, const Report&) = default;
};

/// Finds answers in a stream of bytes. Whatever lies between '<' and '>' and is no answer is
/// dropped and counted; nothing of it is used.
class ReportReader {
 public:
  /// @return a report, if this byte completed one
  std::optional<Report> take(std::uint8_t byte) RELIEVO_REALTIME;
  void reset() RELIEVO_REALTIME { filled_ = 0; }  ///< Forgets a half-read answer.
  std::uint64_t malformed() const RELIEVO_REALTIME { return malformed_; }

 private:
  std::array<std::uint8_t, kFrameBytes> bytes_{};
  std::size_t filled_ = 0;
  bool in_noise_ = false;
  std::uint64_t malformed_ = 0;
};

// The FT232R between USB and the Falcon's processor: vendor requests to the device, no data.

struct BridgeRequest {
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  friend bool operator==(const BridgeRequest&, const BridgeRequest&) = default;
};
inline constexpr BridgeRequest kPurge1{0, 1},
    kPurge2{0, 2};  ///< Names differ by author: send both.
inline constexpr BridgeRequest kDtrLow{1, 0x0100}, kDtrHigh{1, 0x0101}, kRtsLow{1, 0x0200};
inline constexpr BridgeRequest kFlowOff{2, 0}, kData8N1{4, 0x0008};
inline constexpr BridgeRequest kHelloBaud{3, 0x4138};   ///< 9600 baud.
inline constexpr BridgeRequest kUploadBaud{3, 0x0015};  ///< 142 857 baud.
inline constexpr BridgeRequest kRunBaud{3, 0x0002};     ///< 1.5 Mbaud.
constexpr BridgeRequest latencyTimer(std::uint8_t ms) {
  return {9, ms};
}

/// The two bytes in front of every packet, added up.
struct LineStatus {
  bool clear_to_send = false;
  bool overrun = false, parity = false, framing = false, broken = false;
  /// Bytes are missing, or not what was sent.
  bool damaged() const RELIEVO_REALTIME { return overrun || parity || framing || broken; }
};

/// Takes the status bytes out of what one read brought: one or more packets of 64 bytes, the last
/// one possibly shorter. What stands in a damaged packet and before it is thrown away: nobody knows
/// which of its bytes are right. @return number of bytes written to `payload`, which must hold as
/// many as `transfer`.
std::size_t stripStatus(std::span<const std::uint8_t> transfer, std::span<std::uint8_t> payload,
                        LineStatus& status) RELIEVO_REALTIME;

// The boot loader in the Falcon's processor (TI C28x, serial).
inline constexpr std::array<std::uint8_t, 3> kHello{0x0a, 0x43, 0x0d};
inline constexpr std::array<std::uint8_t, 4> kHelloAnswer{0x0a, 0x44, 0x2c, 0x0d};
inline constexpr std::uint8_t kAutoBaud = 'A';
/// With two status bytes one full packet: the bridge chip sends it without waiting.
inline constexpr std::size_t kUploadChunk = 62;

}  // namespace relievo::falcon
