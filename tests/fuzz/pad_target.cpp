// SPDX-License-Identifier: BSD-3-Clause
// Gamepads under libFuzzer: whatever sysfs says of an input device, its buttons are those of pads,
// and each is at most one of the four.
#include <algorithm>
#include <string_view>

#include "haptics/device/pad/pad_bits.h"
#include "tests/fuzz/invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;  // NOLINT(google-build-using-namespace): a program of one file.
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  const std::size_t split = std::min<std::size_t>(data[0], text.size());
  const std::vector<int> bits = pad::bitsOf(text);
  fuzz::require(std::is_sorted(bits.begin(), bits.end()), "bits ascend");
  fuzz::require(std::adjacent_find(bits.begin(), bits.end()) == bits.end(), "each is there once");
  fuzz::require(bits.empty() || (bits.front() >= 0 && bits.back() < 1024), "there are 1024");
  const pad::PadFacts facts = pad::factsOf(text.substr(0, split), text.substr(split));
  int pressed = 0;
  for (const int key : facts.keys) {
    const bool is_pads = (key >= 0x120 && key <= 0x13f) || (key >= 0x2c0 && key <= 0x2e7);
    fuzz::require(is_pads, "a key is a pad's");
    const int button = pad::falconButton(facts, key);
    fuzz::require(button >= -1 && button < 4, "there are four buttons");
    if (button >= 0) ++pressed;
    fuzz::require(button < 0 || button == pressed - 1 || facts.keys.size() == 1,
                  "the first four keys are they, in turn");
  }
  fuzz::require(pressed == std::min<int>(4, static_cast<int>(facts.keys.size())),
                "as many keys press as there are buttons");
  return 0;
}
