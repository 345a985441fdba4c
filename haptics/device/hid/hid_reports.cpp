// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/hid/hid_reports.h"

#include <algorithm>
#include <cmath>

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

/// Collects the fields of buttons while the items of a report descriptor go by.
class ButtonFieldFinder {
 public:
  /// @return false: the descriptor claims more than any device has; the rest is not read
  bool take(const Item& item) {
    switch (item.tag_and_type) {
      case usage_page:
        now_.page = item.value;
        break;
      case report_size:
        now_.size = item.value;
        break;
      case report_count:
        now_.count = item.value;
        break;
      case report_id:
        now_.id = static_cast<std::uint8_t>(item.value);
        break;
      case push:
        if (stack_.size() < kMostFields) stack_.push_back(now_);
        break;
      case pop:
        restore();
        break;
      case usage:
      case usage_minimum:
        if (first_usage_ == kNoUsage) first_usage_ = item.value & 0xffffU;
        break;
      case input:
        return takeInput(item.value);
      case output:
      case collection:
      case feature:
      case end_collection:
        first_usage_ = kNoUsage;  // Local items end at each main item.
        break;
      default:
        break;
    }
    return true;
  }
  const std::vector<ButtonField>& fields() const { return fields_; }

 private:
  enum Tag : std::uint8_t {
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
  static constexpr std::uint32_t kNoUsage = 0;  // Undefined on every page.

  void restore() {
    if (stack_.empty()) return;
    now_ = stack_.back();
    stack_.pop_back();
  }
  bool takeInput(std::uint32_t flags) {
    const std::uint64_t more = std::uint64_t{now_.size} * now_.count;
    if (more > kMostBits || bits_[now_.id] + more > kMostBits) return false;
    constexpr std::uint32_t kConstant = 1, kVariable = 2;
    const bool buttons = now_.page == kButtonPage && now_.size == 1 && now_.count > 0 &&
                         (flags & kVariable) != 0 && (flags & kConstant) == 0;
    if (buttons && fields_.size() < kMostFields) {
      fields_.push_back({now_.id, bits_[now_.id], now_.count,
                         static_cast<std::uint16_t>(std::max<std::uint32_t>(first_usage_, 1))});
    }
    bits_[now_.id] += more;
    first_usage_ = kNoUsage;
    return true;
  }

  std::vector<ButtonField> fields_;
  Globals now_;
  std::vector<Globals> stack_;
  std::array<std::size_t, 256> bits_{};  // So far, of the input reports by id.
  std::uint32_t first_usage_ = kNoUsage;
};

std::int16_t signedAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] | static_cast<unsigned>(bytes[at + 1]) << 8U);
}
}  // namespace

std::vector<ButtonField> buttonFields(std::span<const std::uint8_t> descriptor) {
  ButtonFieldFinder finder;
  Items items(descriptor);
  while (const std::optional<Item> item = items.next()) {
    if (!finder.take(*item)) break;
  }
  return finder.fields();
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

std::optional<CapMotion> capMotion(std::span<const std::uint8_t> report, const CapMotion& before) {
  constexpr std::size_t kThreeAxes = 7, kSixAxes = 13;  // With the id.
  if (report.size() < kThreeAxes || report[0] < 1 || report[0] > 2) return std::nullopt;
  const auto axis = [&report](std::size_t i) {
    return std::clamp(signedAt(report, 1 + 2 * i) / kFullDeflection, -1.5, 1.5);
  };
  // The device counts right, toward the user, down, and turns by the right-hand rule about these
  // (HID Usage Tables, 4.2).
  CapMotion now = before;
  const bool pushes = report[0] == 1;
  if (pushes) {
    now.right = axis(0);
    now.up = -axis(2);
    now.toward = axis(1);
  }
  if (pushes && report.size() < kSixAxes) return now;
  const std::size_t first = pushes ? 3 : 0;
  now.about_right = axis(first);
  now.about_up = -axis(first + 2);
  now.about_toward = axis(first + 1);
  return now;
}

CapMotion beyondRest(const CapMotion& motion) {
  constexpr double kRest = 0.04;  // 14 counts of 350.
  const auto beyond = [](double push) {
    return std::copysign(std::max(std::abs(push) - kRest, 0.0) / (1 - kRest), push);
  };
  return {beyond(motion.right),       beyond(motion.up),       beyond(motion.toward),
          beyond(motion.about_right), beyond(motion.about_up), beyond(motion.about_toward)};
}

void CapReports::take(std::span<const std::uint8_t> report, double now_s) {
  const std::optional<CapMotion> motion = capMotion(report, told_);
  if (!motion) return;
  told_ = *motion;
  told_s_ = now_s;
}

CapMotion CapReports::motion(double now_s) const {
  return now_s - told_s_ > kLastsS ? CapMotion{} : beyondRest(told_);
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
