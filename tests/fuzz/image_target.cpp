// SPDX-License-Identifier: BSD-3-Clause
// Firmware files under libFuzzer: an image is good only if a second walk over its stream says so.
#include <optional>

#include "haptics/device/falcon/boot_image.h"
#include "tests/fuzz/invariants.h"

namespace {

/// Where a stream for TI's serial boot loader ends; nothing: not within these bytes.
std::optional<std::size_t> streamEnd(std::span<const std::uint8_t> bytes) {
  const auto word = [&](std::size_t at) { return bytes[at] + 256U * bytes[at + 1]; };
  if (bytes.size() < 24 || word(0) != 0x08aa) return std::nullopt;
  std::size_t at = 22;  // Key, eight reserved words, entry point.
  while (at + 2 <= bytes.size()) {
    const unsigned words = word(at);
    if (words == 0) return at + 2;
    at += 6 + std::size_t{2} * words;
  }
  return std::nullopt;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;  // NOLINT(google-build-using-namespace): a program of one file.
  const std::span<const std::uint8_t> bytes(data, size);
  const falcon::BootImage image = falcon::inspectBootImage(bytes);
  const bool fits = size >= falcon::kLeastImageBytes && size <= falcon::kMostImageBytes;
  fuzz::require(image.good() == (fits && streamEnd(bytes) == size),
                "good is what a boot loader would load to its end");
  fuzz::require(2 * image.words + 6 * image.blocks <= size, "blocks lie within the file");
  return 0;
}
