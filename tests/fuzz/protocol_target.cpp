// SPDX-License-Identifier: BSD-3-Clause
// What a Falcon may send, under libFuzzer: any bytes in any packets give whole answers or none.
#include <algorithm>
#include <array>
#include <vector>

#include "haptics/device/falcon/protocol.h"
#include "tests/fuzz/invariants.h"

namespace {

using namespace relievo;  // NOLINT(google-build-using-namespace): a program of one file.

/// Read again by the protocol's description: four nibbles a number, the lowest first.
falcon::Report readAgain(const std::array<std::uint8_t, falcon::kFrameBytes>& frame) {
  falcon::Report report;
  for (std::size_t arm = 0; arm < falcon::kArms; ++arm) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const unsigned nibble = frame[1 + 4 * arm + i] - 0x41U;
      fuzz::require(nibble < 16, "a digit of an encoder is one");
      value += nibble << (4 * i);
    }
    report.encoders[arm] = static_cast<std::int16_t>(value);
  }
  const unsigned flags = frame[13] - 0x41U;
  fuzz::require(flags < 128, "there are four buttons and three arms");
  report.buttons = static_cast<std::uint8_t>(flags & 15U);
  report.homed = static_cast<std::uint8_t>(flags >> 4U);
  return report;
}

void read(std::span<const std::uint8_t> payload) {
  falcon::ReportReader reader;
  std::array<std::uint8_t, falcon::kFrameBytes> last{};
  std::uint64_t reports = 0;
  for (const std::uint8_t byte : payload) {
    std::rotate(last.begin(), last.begin() + 1, last.end());
    last.back() = byte;
    const auto report = reader.take(byte);
    if (!report) continue;
    ++reports;
    fuzz::require(last.front() == '<' && last.back() == '>', "an answer has its marks");
    fuzz::require(*report == readAgain(last), "an answer is its own sixteen bytes and no others");
  }
  fuzz::require(reports * falcon::kFrameBytes + reader.malformed() <= payload.size(),
                "no byte is counted twice");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> transfer(data, size);
  std::vector<std::uint8_t> payload(size);
  falcon::LineStatus status;
  const std::size_t bytes = falcon::stripStatus(transfer, payload, status);
  const std::size_t packets = (size + falcon::kPacketBytes - 1) / falcon::kPacketBytes;
  fuzz::require(bytes + 2 * packets >= size && bytes <= size, "only status is taken out");
  read({payload.data(), bytes});
  read(transfer);
  return 0;
}
