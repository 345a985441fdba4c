// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/steered_hand.h"

#include <algorithm>

#include "core/region/window.h"

namespace relievo {

void SteeredHand::takeSurface(const RegionWindow& window, const HandMapping& mapping,
                              const HapticSample& last, bool first) {
  mapping_ = mapping;
  if (device_ == nullptr) return;
  const Region& r = window.region;
  ViewMm over = mapping_.device_from_view.inverseOfSimilarity()(last.hip);
  if (first) over = {r.centreX(), r.centreY(), 0};
  over.x = std::clamp(over.x, r.x_mm, r.x_mm + r.side_mm);
  over.y = std::clamp(over.y, r.y_mm, r.y_mm + r.side_mm);
  const double depth = norm(last.proxy - last.hip);
  const bool pressing = !first && !hovers_ && last.contact;
  const ViewMm place = handOver(window, over.x, over.y, pressing, depth);
  sent_ = mapping_.device_from_view(place);
  device_->placeAt(sent_);
  if (!pressing) hoverAt(place);
}

void SteeredHand::hoverAt(ViewMm target) {
  sent_ = mapping_.device_from_view(target);
  device_->hoverAt(sent_);
  hovers_ = true;
}

void SteeredHand::moveTo(const RegionWindow& window, ViewMm target) {
  if (device_ == nullptr) return;
  const bool presses = target.z < windowHeightMm(window, target.x, target.y);
  if (!presses) return hoverAt(target);
  if (hovers_) hoverAt(handOver(window, target.x, target.y, false, 0));
  hovers_ = false;
  sent_ = mapping_.device_from_view(target);
  device_->moveTo(sent_);
}

void SteeredHand::giveWay(DeviceMm hip) {
  if (device_ == nullptr) return;
  constexpr double kPart = 0.08;  // Of the way in a frame: an arm that gives way in 0.2 s.
  sent_ = sent_ + kPart * (hip - sent_);
  hovers_ = false;
  device_->moveTo(sent_);
}

void SteeredHand::push(DeviceMm by, DeviceMm hip) {
  if (device_ == nullptr) return;
  const double lead = norm(sent_ - hip);
  // A hand that a surface holds back is not pushed ever harder.
  if (lead > kMostLeadMm) sent_ = hip + (kMostLeadMm / lead) * (sent_ - hip);
  sent_ = sent_ + by;
  hovers_ = false;
  device_->moveTo(sent_);
}

}  // namespace relievo
