// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/pad/pad_bits.h"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace relievo::pad {

namespace {
constexpr int kBitsPerWord = 8 * sizeof(long);
constexpr std::size_t kMostWords = 1024 / kBitsPerWord;
// Codes of the kernel's interface (linux/input-event-codes.h).
constexpr int kEnter = 28, kLeftOfMouse = 0x110, kFirstButton = 0x120, kLastButton = 0x13f,
              kFirstExtra = 0x2c0, kLastExtra = 0x2e7, kRumble = 0x50;

std::uint64_t wordOf(std::string_view text) {
  constexpr int kHex = 16;
  std::uint64_t word = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), word, kHex);
  return error == std::errc() && end == text.data() + text.size() ? word : 0;
}

bool has(const std::vector<int>& bits, int bit) {
  return std::binary_search(bits.begin(), bits.end(), bit);
}

bool isPadsButton(int key) {
  return (key >= kFirstButton && key <= kLastButton) || (key >= kFirstExtra && key <= kLastExtra);
}
}  // namespace

std::vector<int> bitsOf(std::string_view text) {
  std::vector<int> bits;
  // From its end: the lowest word is the last one, and what is too high is left out.
  for (std::size_t words = 0; !text.empty() && words < kMostWords;) {
    const std::size_t gap = text.find_last_of(" \n");
    const std::string_view last = gap == std::string_view::npos ? text : text.substr(gap + 1);
    text = gap == std::string_view::npos ? std::string_view() : text.substr(0, gap);
    if (last.empty()) continue;
    const std::uint64_t word = wordOf(last);
    for (int i = 0; i < kBitsPerWord; ++i) {
      if ((word >> i & 1U) != 0) bits.push_back(static_cast<int>(words) * kBitsPerWord + i);
    }
    ++words;
  }
  return bits;
}

PadFacts factsOf(std::string_view keys, std::string_view effects) {
  PadFacts facts;
  const std::vector<int> all = bitsOf(keys);
  if (has(all, kEnter) || has(all, kLeftOfMouse)) return facts;
  std::copy_if(all.begin(), all.end(), std::back_inserter(facts.keys), isPadsButton);
  facts.can_rumble = has(bitsOf(effects), kRumble);
  return facts;
}

int falconButton(const PadFacts& facts, int key) noexcept {
  constexpr std::ptrdiff_t kButtons = 4;
  constexpr int kCentre = 2;
  const auto found = std::find(facts.keys.begin(), facts.keys.end(), key);
  if (found == facts.keys.end()) return -1;
  if (facts.keys.size() == 1) return kCentre;
  const std::ptrdiff_t place = found - facts.keys.begin();
  return place < kButtons ? static_cast<int>(place) : -1;
}

}  // namespace relievo::pad
