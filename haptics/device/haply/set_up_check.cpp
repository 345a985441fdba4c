// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/set_up_check.h"

#include <utility>

namespace relievo::haply {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kEverythingNs = 100 * kMs;
constexpr std::int64_t kSetUpNs = 500 * kMs;       // So long it may take until ours is told.
constexpr std::int64_t kToldAgainNs = 1000 * kMs;  // So long without any configuration is doubt.
constexpr std::int64_t kForeignNs = 10'000 * kMs;  // Twice in this time: others insist.
}  // namespace

void SetUpCheck::restart(std::int64_t now_ns) {
  foreign_ns_ = 0;
  begin(now_ns);
}

void SetUpCheck::begin(std::int64_t now_ns) {
  state_ = State::asked;
  since_ns_ = told_ns_ = now_ns;
  due_ = true;
  mount_.reset();
  ++count_;
}

void SetUpCheck::doubt(std::int64_t now_ns) {
  state_ = State::asked;
  since_ns_ = now_ns;
}

void SetUpCheck::forgiveGap(std::int64_t now_ns) {
  told_ns_ = now_ns;
  if (state_ == State::asked) since_ns_ = now_ns;
}

bool SetUpCheck::takeDue() {
  return std::exchange(due_, false);
}

bool SetUpCheck::askForEverything(std::int64_t now_ns) {
  const bool everything = state_ == State::asked || now_ns - everything_ns_ >= kEverythingNs;
  if (everything) everything_ns_ = now_ns;
  return everything;
}

/// Sets the device up anew; where others do so again, it is theirs.
void SetUpCheck::takeForeign(std::int64_t now_ns) {
  const bool again = foreign_ns_ != 0 && now_ns - foreign_ns_ < kForeignNs;
  foreign_ns_ = now_ns;
  begin(now_ns);
  if (!again) return;
  state_ = State::foreign;
  due_ = false;
}

void SetUpCheck::check(const ServiceDevice& device, std::int64_t now_ns) {
  if (state_ == State::foreign) {
    if (now_ns - since_ns_ >= kForeignNs) begin(now_ns);
    return;
  }
  const bool turned = !device.transform.isLike({});
  if (device.has_configuration) {
    told_ns_ = now_ns;
    const bool ours = !turned && device.preset.view() == kPreset &&
                      (device.basis.empty() || device.basis.view() == kBasis) &&
                      (!mount_ || mount_->isLike(device.mount));
    if (ours) {
      mount_ = device.mount;
      state_ = State::ours;
      return;
    }
    // Until ours was told, it may not have been done yet.
    if (state_ == State::ours || mount_) return takeForeign(now_ns);
  } else if (turned && state_ == State::ours) {
    return takeForeign(now_ns);
  }
  const bool too_long =
      state_ == State::asked ? now_ns - since_ns_ >= kSetUpNs : now_ns - told_ns_ >= kToldAgainNs;
  if (too_long) takeForeign(now_ns);
}

}  // namespace relievo::haply
