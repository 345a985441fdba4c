// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/protocol.h"

#include <algorithm>

namespace relievo::falcon {

namespace {
constexpr std::uint8_t kFirst = '<', kLast = '>';
constexpr std::uint8_t kZero = 0x41;  // Payload bytes are values above this: never '<' or '>'.
constexpr std::size_t kStateByte = 13;
constexpr int kHomedShift = 4;

/// Least significant nibble first.
void putWord(std::span<std::uint8_t, 4> bytes, std::int16_t value) RELIEVO_REALTIME {
  auto rest = static_cast<std::uint16_t>(value);
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(kZero + (rest & 0xFU));
    rest = static_cast<std::uint16_t>(rest >> 4U);
  }
}

std::optional<std::int16_t> word(std::span<const std::uint8_t, 4> bytes) RELIEVO_REALTIME {
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (bytes[i] < kZero || bytes[i] > kZero + 15) return std::nullopt;
    value |= static_cast<unsigned>(bytes[i] - kZero) << (4 * i);
  }
  return static_cast<std::int16_t>(value);
}

std::optional<Report> decode(std::span<const std::uint8_t, kFrameBytes> frame) RELIEVO_REALTIME {
  if (frame.front() != kFirst || frame.back() != kLast) return std::nullopt;
  Report report;
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    const auto encoder = word(std::span<const std::uint8_t, 4>(frame.data() + 1 + 4 * arm, 4));
    if (!encoder) return std::nullopt;
    report.encoders[arm] = *encoder;
  }
  // Up to 0x41 + 0x7f: not limited to letters. The bits must not be negative, so unsigned.
  const std::uint8_t byte = frame[kStateByte];
  if (byte < kZero || byte > kZero + 0x7F) return std::nullopt;
  const auto state = static_cast<unsigned>(byte - kZero);
  report.buttons = state & 0xFU;
  report.homed = (state >> kHomedShift) & kAllHomed;
  return report;
}
}  // namespace

Frame encode(const Command& command) RELIEVO_REALTIME {
  Frame frame{};
  frame.front() = kFirst;
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    const auto counts =
        static_cast<std::int16_t>(std::clamp<int>(command.motors[arm], -kMaxCounts, kMaxCounts));
    putWord(std::span<std::uint8_t, 4>(frame.data() + 1 + 4 * arm, 4), counts);
  }
  const unsigned control = (command.lights & (green | blue | red)) | (command.homing ? 1U : 0U);
  frame[kStateByte] = static_cast<std::uint8_t>(kZero + control);
  frame[kStateByte + 1] = kZero;  // Unknown to everybody; always zero.
  frame.back() = kLast;
  return frame;
}

std::optional<Report> ReportReader::take(std::uint8_t byte) RELIEVO_REALTIME {
  if (byte == kFirst) {
    if (filled_ > 0) ++malformed_;
    in_noise_ = false;
    bytes_[0] = byte;
    filled_ = 1;
    return std::nullopt;
  }
  if (filled_ == 0) {
    // Counted once for all the bytes up to the next answer.
    if (!in_noise_) ++malformed_;
    in_noise_ = true;
    return std::nullopt;
  }
  bytes_[filled_++] = byte;
  if (byte != kLast && filled_ < kFrameBytes) return std::nullopt;
  const bool whole = filled_ == kFrameBytes;
  filled_ = 0;
  std::optional<Report> report;
  if (whole) report = decode(bytes_);
  if (!report) {
    ++malformed_;
    in_noise_ = byte != kLast;  // What follows until '<' belongs to the same damage.
  }
  return report;
}

std::size_t stripStatus(std::span<const std::uint8_t> transfer, std::span<std::uint8_t> payload,
                        LineStatus& status) RELIEVO_REALTIME {
  std::size_t written = 0;
  for (std::size_t at = 0; at < transfer.size(); at += kPacketBytes) {
    const auto packet = transfer.subspan(at, std::min(kPacketBytes, transfer.size() - at));
    if (packet.size() < 2) break;
    status.clear_to_send = (packet[0] & 0x10U) != 0;
    const LineStatus now{.overrun = (packet[1] & 0x02U) != 0,
                         .parity = (packet[1] & 0x04U) != 0,
                         .framing = (packet[1] & 0x08U) != 0,
                         .broken = (packet[1] & 0x10U) != 0};
    status.overrun = status.overrun || now.overrun;
    status.parity = status.parity || now.parity;
    status.framing = status.framing || now.framing;
    status.broken = status.broken || now.broken;
    if (now.damaged()) {
      written = 0;
      continue;
    }
    const auto data = packet.subspan(2);
    std::copy(data.begin(), data.end(), payload.begin() + static_cast<std::ptrdiff_t>(written));
    written += data.size();
  }
  return written;
}

}  // namespace relievo::falcon
