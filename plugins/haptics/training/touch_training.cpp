// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/training/touch_training.h"

#include "core/message/catalogue.h"
#include "core/region/hand.h"

namespace relievo {

namespace {
constexpr std::uint64_t kFirstId = std::uint64_t{1} << 52U;  // No map has so many windows.
}

void TouchTraining::take(const Training::News& news) {
  if (news.over) {
    window_.reset();
  } else if (news.other_shape) {
    window_ = std::make_unique<const RegionWindow>(
        trainingWindow(training_.shape(), kFirstId + ++windows_));
  }
  if (news.found) Q_EMIT found();
  if (!news.say.empty()) host_.messages.say(news.say);
  if (news.over || news.other_shape) Q_EMIT changed();
}

void TouchTraining::begin(const Beginning& beginning, double now_s) {
  std::vector<Message> before;
  if (beginning.shapes == kTrainingShapes) before.push_back(said<MessageId::training_begins>());
  if (beginning.switches_forces_on) before.push_back(said<MessageId::training_forces>());
  take(training_.begin(now_s, std::move(before), beginning.shapes));
}

void TouchTraining::skip(double now_s) {
  if (isOn()) take(training_.skip(now_s));
}

void TouchTraining::repeat() {
  if (isOn()) host_.messages.say({training_.task()});
}

void TouchTraining::stop() {
  if (!isOn()) return;
  window_.reset();
  host_.messages.say({said<MessageId::training_off>()});
  Q_EMIT changed();
}

void TouchTraining::frame(const HapticSample& sample, double now_s) {
  // Until the shape is under the hand nothing of it can be found.
  if (!isOn()) return;
  const bool is_felt = sample.window_id == window_->id;
  take(training_.touch({sample.proxy_view, is_felt && sample.contact}, now_s));
}

ViewMm TouchTraining::target(const HandTarget& target, const RegionWindow& shown) const {
  const double scale = kTrainingSideMm / shown.region.side_mm;
  const double x = scale * (target.position.x - shown.region.x_mm);
  const double y = scale * (target.position.y - shown.region.y_mm);
  const double above_mm =
      target.position.z - windowHeightMm(shown, target.position.x, target.position.y);
  const double above_hand_mm = above_mm * handMapping(shown).device_per_view;
  return {x, y, windowHeightMm(*window_, x, y) + above_hand_mm};
}

}  // namespace relievo
