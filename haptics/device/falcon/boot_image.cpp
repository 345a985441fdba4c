// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/boot_image.h"

#include <optional>

namespace relievo::falcon {

namespace {
constexpr unsigned kKey = 0x08aa;
constexpr int kReservedWords = 8;

class Words {
 public:
  explicit Words(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::optional<std::uint32_t> word() {
    if (bytes_.size() < 2) return std::nullopt;
    const std::uint32_t value = bytes_[0] | static_cast<std::uint32_t>(bytes_[1]) << 8U;
    bytes_ = bytes_.subspan(2);
    return value;
  }
  std::optional<std::uint32_t> twoWords() {
    const auto high = word(), low = word();
    if (!high || !low) return std::nullopt;
    return *high << 16U | *low;
  }
  bool skip(std::size_t words) {
    if (bytes_.size() < 2 * words) return false;
    bytes_ = bytes_.subspan(2 * words);
    return true;
  }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
};
}  // namespace

BootImage inspectBootImage(std::span<const std::uint8_t> bytes) {
  BootImage image;
  const auto refuse = [&image](std::string why) {
    image.problem = std::move(why);
    return image;
  };
  if (bytes.size() < kLeastImageBytes || bytes.size() > kMostImageBytes) {
    return refuse("it has " + std::to_string(bytes.size()) + " bytes; 2048 to 65536 are possible");
  }
  if (bytes.size() % 2 != 0) return refuse("its length is odd");
  Words words(bytes);
  if (words.word() != kKey) return refuse("it does not begin with AA 08");
  const bool reserved = words.skip(kReservedWords);
  const auto entry = words.twoWords();
  if (!reserved || !entry) return refuse("it ends before its entry point");
  image.entry = *entry;
  while (true) {
    const std::string in_block = "it ends in block " + std::to_string(image.blocks + 1);
    const auto count = words.word();
    if (!count) return refuse(in_block);
    if (*count == 0) break;
    if (!words.twoWords() || !words.skip(*count)) return refuse(in_block);
    ++image.blocks;
    image.words += *count;
  }
  if (words.left() != 0) {
    return refuse(std::to_string(words.left()) + " bytes follow its last block");
  }
  if (image.blocks == 0) return refuse("it has no blocks");
  return image;
}

}  // namespace relievo::falcon
