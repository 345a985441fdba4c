// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/boot_image.h"

#include <optional>
#include <utility>

#include "core/message/catalogue.h"

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
  const auto refuse = [&image](Message why) {
    image.problem = std::move(why);
    return image;
  };
  if (bytes.size() < kLeastImageBytes || bytes.size() > kMostImageBytes) {
    return refuse(said<MessageId::image_length>(bytes.size()));
  }
  if (bytes.size() % 2 != 0) return refuse(said<MessageId::image_odd>());
  Words words(bytes);
  if (words.word() != kKey) return refuse(said<MessageId::image_key>());
  const bool reserved = words.skip(kReservedWords);
  const auto entry = words.twoWords();
  if (!reserved || !entry) return refuse(said<MessageId::image_without_entry>());
  image.entry = *entry;
  while (true) {
    const auto count = words.word();
    if (count && *count == 0) break;
    if (!count || !words.twoWords() || !words.skip(*count)) {
      return refuse(said<MessageId::image_ends_in_block>(image.blocks + 1));
    }
    ++image.blocks;
    image.words += *count;
  }
  if (words.left() != 0) return refuse(said<MessageId::image_too_long>(words.left()));
  if (image.blocks == 0) return refuse(said<MessageId::image_without_blocks>());
  return image;
}

}  // namespace relievo::falcon
