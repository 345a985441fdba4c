// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/hid/hid_reports.h"

#include <algorithm>

namespace relievo::hid {

namespace {
constexpr std::uint32_t kButtonPage = 0x09;
constexpr std::size_t kMostFields = 64, kMostBits = std::size_t{8} * 4096;
constexpr double kFullDeflection = 350;

/// One item of a report descriptor (HID 1.11, section 6.2.2).
struct Item {
  std::uint8_t tag_and_type = 0;  // Without the size.
  std::uint32_t value = 0;
};

class Items {
 public:
  explicit Items(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::optional<Item> next() {
    constexpr std::uint8_t kLongItem = 0xfe;
    while (!bytes_.empty()) {
      const std::uint8_t head = bytes_[0];
      if (head == kLongItem) {
        if (bytes_.size() < 3 || bytes_.size() < 3U + bytes_[1]) return std::nullopt;
        bytes_ = bytes_.subspan(3U + bytes_[1]);
        continue;
      }
      constexpr std::array<std::size_t, 4> kSizes{0, 1, 2, 4};
      const std::size_t size = kSizes[head & 3U];
      if (bytes_.size() < 1 + size) return std::nullopt;
      Item item{static_cast<std::uint8_t>(head & 0xfcU), 0};
      for (std::size_t i = 0; i < size; ++i) {
        item.value |= static_cast<std::uint32_t>(bytes_[1 + i]) << (8 * i);
      }
      bytes_ = bytes_.subspan(1 + size);
      return item;
    }
    return std::nullopt;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

struct Globals {
  std::uint32_t page = 0, size = 0, count = 0;
  std::uint8_t id = 0;
};

std::int16_t signedAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] | static_cast<unsigned>(bytes[at + 1]) << 8U);
}
}  // namespace

std::vector<ButtonField> buttonFields(std::span<const std::uint8_t> descriptor) {
  enum : std::uint8_t {
    input = 0x80,
    output = 0x90,
    collection = 0xa0,
    feature = 0xb0,
    end_collection = 0xc0,
    usage_page = 0x04,
    report_size = 0x74,
    report_id = 0x84,
    report_count = 0x94,
    push = 0xa4,
    pop = 0xb4,
    usage = 0x08,
    usage_minimum = 0x18,
  };
  std::vector<ButtonField> fields;
  Items items(descriptor);
  Globals now;
  std::vector<Globals> stack;
  std::array<std::size_t, 256> bits{};   // So far, of the input reports by id.
  constexpr std::uint32_t kNoUsage = 0;  // Undefined on every page.
  std::uint32_t first_usage = kNoUsage;
  while (const std::optional<Item> item = items.next()) {
    switch (item->tag_and_type) {
      case usage_page:
        now.page = item->value;
        break;
      case report_size:
        now.size = item->value;
        break;
      case report_count:
        now.count = item->value;
        break;
      case report_id:
        now.id = static_cast<std::uint8_t>(item->value);
        break;
      case push:
        if (stack.size() < kMostFields) stack.push_back(now);
        break;
      case pop:
        if (!stack.empty()) {
          now = stack.back();
          stack.pop_back();
        }
        break;
      case usage:
      case usage_minimum:
        if (first_usage == kNoUsage) first_usage = item->value & 0xffffU;
        break;
      case input: {
        const std::uint64_t more = std::uint64_t{now.size} * now.count;
        if (more > kMostBits || bits[now.id] + more > kMostBits) return fields;
        constexpr std::uint32_t kConstant = 1, kVariable = 2;
        const bool buttons = now.page == kButtonPage && now.size == 1 && now.count > 0 &&
                             (item->value & kVariable) != 0 && (item->value & kConstant) == 0;
        if (buttons && fields.size() < kMostFields) {
          fields.push_back({now.id, bits[now.id], now.count,
                            static_cast<std::uint16_t>(std::max<std::uint32_t>(first_usage, 1))});
        }
        bits[now.id] += more;
        first_usage = kNoUsage;
        break;
      }
      case output:
      case collection:
      case feature:
      case end_collection:
        first_usage = kNoUsage;  // Local items end at each main item.
        break;
      default:
        break;
    }
  }
  return fields;
}

std::optional<std::uint32_t> buttonsOf(std::span<const std::uint8_t> report,
                                       std::span<const ButtonField> fields) {
  std::optional<std::uint32_t> buttons;
  for (const ButtonField& field : fields) {
    std::span<const std::uint8_t> data = report;
    if (field.report_id != 0) {
      if (report.empty() || report[0] != field.report_id) continue;
      data = report.subspan(1);
    }
    if (8 * data.size() < field.first_bit + field.count) continue;
    if (!buttons) buttons = 0;
    for (std::size_t i = 0; i < field.count; ++i) {
      const std::size_t bit = field.first_bit + i;
      const std::size_t button = field.first_button + i;
      const bool down = (data[bit / 8] >> (bit % 8) & 1U) != 0;
      if (down && button >= 1 && button <= 32) *buttons |= 1U << (button - 1);
    }
  }
  return buttons;
}

std::optional<CapMotion> capMotion(std::span<const std::uint8_t> report) {
  constexpr std::size_t kBytes = 7;  // Id, three axes; wireless ones append the rotations.
  if (report.size() < kBytes || report[0] != 1) return std::nullopt;
  const auto axis = [&report](std::size_t i) {
    return std::clamp(signedAt(report, 1 + 2 * i) / kFullDeflection, -1.5, 1.5);
  };
  // The device counts right, toward the user, down.
  return CapMotion{axis(0), -axis(2), axis(1)};
}

std::optional<std::uint32_t> capButtons(std::span<const std::uint8_t> report) {
  if (report.size() < 2 || report[0] != 3) return std::nullopt;
  std::uint32_t buttons = 0;
  for (std::size_t i = 1; i < report.size() && i <= 4; ++i) {
    buttons |= static_cast<std::uint32_t>(report[i]) << (8 * (i - 1));
  }
  return buttons;
}

bool isSpaceMouse(std::uint16_t vendor, std::uint16_t product) {
  constexpr std::uint16_t k3Dconnexion = 0x256f, kLogitech = 0x046d;
  if (vendor == k3Dconnexion) return true;
  constexpr std::array<std::uint16_t, 10> kOfLogitech{0xc603, 0xc605, 0xc606, 0xc621, 0xc623,
                                                      0xc625, 0xc626, 0xc627, 0xc628, 0xc62b};
  return vendor == kLogitech &&
         std::find(kOfLogitech.begin(), kOfLogitech.end(), product) != kOfLogitech.end();
}

}  // namespace relievo::hid
