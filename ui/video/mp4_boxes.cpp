// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video/mp4_boxes.h"

#include <algorithm>

namespace relievo {
namespace {

constexpr std::size_t kMostFragment = 1U << 22U;  // A "moof" lists samples; it holds none.

std::uint64_t bigEndian(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8U | byte;
  return value;
}

/// Samples of the first track in the content of a "moof" or "traf" (8.8.7, "tfhd"; 8.8.8, "trun").
std::uint64_t samplesIn(std::span<const std::uint8_t> content) {
  std::uint64_t samples = 0;
  while (content.size() >= 8) {
    const std::uint64_t size = bigEndian(content.first(4));
    if (size < 8 || size > content.size()) return samples;
    const std::string type(content.begin() + 4, content.begin() + 8);
    const auto inside = content.subspan(8, size - 8);
    if (type == "traf") samples += samplesIn(inside);
    if (type == "tfhd" && inside.size() >= 8 && bigEndian(inside.subspan(4, 4)) > 1) return 0;
    if (type == "trun" && inside.size() >= 8) samples += bigEndian(inside.subspan(4, 4));
    content = content.subspan(size);
  }
  return samples;
}

}  // namespace

void Mp4Boxes::add(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    if (left_ == 0) {
      head_.push_back(bytes.front());
      bytes = bytes.subspan(1);
      ++seen_;
      begin();
      continue;
    }
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size()));
    if (type_ == "moof" && fragment_.size() < kMostFragment) {
      fragment_.insert(fragment_.end(), bytes.begin(),
                       bytes.begin() + static_cast<std::ptrdiff_t>(part));
    }
    bytes = bytes.subspan(part);
    seen_ += part;
    left_ -= part;
    if (left_ == 0) end();
  }
}

void Mp4Boxes::begin() {
  if (head_.size() < 8) return;
  std::uint64_t size = bigEndian(std::span(head_).first(4));
  std::uint64_t head_bytes = 8;
  if (size == 1) {  // A large one: its size follows.
    if (head_.size() < 16) return;
    size = bigEndian(std::span(head_).last(8));
    head_bytes = 16;
  }
  type_.assign(head_.begin() + 4, head_.begin() + 8);
  head_.clear();
  fragment_.clear();
  left_ = size > head_bytes ? size - head_bytes : 0;
  if (left_ == 0) end();
}

void Mp4Boxes::end() {
  if (type_ == "moof") frames_ += samplesIn(fragment_);
  if (type_ == "moov" || type_ == "mdat") {
    whole_bytes_ = seen_;
    whole_frames_ = frames_;
  }
}

}  // namespace relievo
