// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/training/training.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/message/catalogue.h"

namespace relievo {

namespace {
double bumpHeight(double x_mm, double y_mm) {
  // Cap of a sphere of this radius.
  constexpr double kSphere =
      (kBumpRadiusMm * kBumpRadiusMm + kBumpHighMm * kBumpHighMm) / (2 * kBumpHighMm);
  const double away = std::hypot(x_mm - kBumpX, y_mm - kBumpY);
  if (away >= kBumpRadiusMm) return 0;
  return std::sqrt(kSphere * kSphere - away * away) - (kSphere - kBumpHighMm);
}

struct Words {
  MessageId task, hint;
};
Words wordsOf(TrainingShape shape) {
  switch (shape) {
    case TrainingShape::plate:
      return {MessageId::training_plate, MessageId::training_hint_plate};
    case TrainingShape::bump:
      return {MessageId::training_bump, MessageId::training_hint_bump};
    case TrainingShape::step:
      return {MessageId::training_step, MessageId::training_hint_step};
    case TrainingShape::wave:
      return {MessageId::training_wave, MessageId::training_hint_wave};
    case TrainingShape::groove:
      break;
  }
  return {MessageId::training_groove, MessageId::training_hint_groove};
}
}  // namespace

double trainingHeightMm(TrainingShape shape, double x_mm, double y_mm) {
  switch (shape) {
    case TrainingShape::plate:
      return 0;
    case TrainingShape::bump:
      return bumpHeight(x_mm, y_mm);
    case TrainingShape::step:
      return x_mm > kStepX ? kStepHighMm : 0;
    case TrainingShape::wave:
      return kWaveHighMm * std::sin(2 * std::numbers::pi * x_mm / kWaveMm);
    case TrainingShape::groove:
      break;
  }
  // Round, so that nobody is caught at its edges.
  const double across = std::abs(y_mm - kGrooveY) / (kGrooveWideMm / 2);
  return across < 1 ? -kGrooveDeepMm * (1 + std::cos(std::numbers::pi * across)) / 2 : 0;
}

RegionWindow trainingWindow(TrainingShape shape, std::uint64_t id) {
  RegionWindow window;
  window.id = id;
  window.region = {0, 0, kTrainingSideMm, {}};
  window.heights_mm.reserve(kWindowCount);
  window.origins.assign(kWindowCount, CellStatus::measured);
  for (int row = 0; row < kWindowSamples; ++row) {
    for (int col = 0; col < kWindowSamples; ++col) {
      window.heights_mm.push_back(static_cast<float>(trainingHeightMm(
          shape, (col + 0.5) * window.spacingMm(), (row + 0.5) * window.spacingMm())));
    }
  }
  const auto [low, high] = std::minmax_element(window.heights_mm.begin(), window.heights_mm.end());
  window.min_mm = *low;
  window.max_mm = *high;
  return window;
}

Message Training::task() const {
  return {wordsOf(shape_).task, {}};
}

void Training::enter(TrainingShape shape, double now_s) {
  const int shapes = shapes_;
  *this = Training();
  shapes_ = shapes;
  shape_ = shape;
  since_s_ = last_s_ = now_s;
}

Training::News Training::begin(double now_s, std::vector<Message> before, int shapes) {
  shapes_ = shapes;
  enter(TrainingShape::plate, now_s);
  News news{.say = std::move(before), .other_shape = true};
  news.say.push_back(task());
  return news;
}

Training::News Training::next(Message why, double now_s) {
  News news;
  news.say.push_back(std::move(why));
  const int after = static_cast<int>(shape_) + 1;
  news.over = after == shapes_;
  if (news.over) {
    news.say.push_back(said<MessageId::training_ends>());
    return news;
  }
  news.other_shape = true;
  enter(static_cast<TrainingShape>(after), now_s);
  news.say.push_back(task());
  return news;
}

Training::News Training::skip(double now_s) {
  return next(said<MessageId::training_goes_on>(), now_s);
}

bool Training::isFound(const TrainingTouch& touch, double now_s, double dt_s) {
  lifted_s_ = touch.contact ? 0 : lifted_s_ + dt_s;
  if (lifted_s_ > kPauseS) way_mm_ = 0;
  const std::optional<ViewMm> before =
      std::exchange(before_, touch.contact ? std::optional<ViewMm>(touch.proxy) : std::nullopt);
  if (!touch.contact) {
    if (shape_ == TrainingShape::bump) contact_s_ = 0;
    return false;
  }
  const double along_mm = before ? std::abs(touch.proxy.x - before->x) : 0;
  switch (shape_) {
    case TrainingShape::plate:
      contact_s_ += dt_s;
      return contact_s_ >= kPlateS;
    case TrainingShape::bump: {
      const double away = std::hypot(touch.proxy.x - kBumpX, touch.proxy.y - kBumpY);
      contact_s_ = away < kBumpWithinMm ? contact_s_ + dt_s : 0;
      return contact_s_ >= kBumpS;
    }
    case TrainingShape::step:
      if (touch.proxy.x < kStepX - kStepBesideMm) left_s_ = now_s;
      if (touch.proxy.x > kStepX + kStepBesideMm) right_s_ = now_s;
      return std::abs(left_s_ - right_s_) < kStepS && left_s_ > 0 && right_s_ > 0;
    case TrainingShape::wave:
      way_mm_ += along_mm;
      return way_mm_ >= kWaveWayMm;
    case TrainingShape::groove:
      way_mm_ += touch.proxy.z < -kGrooveDeepMm / 2 ? along_mm : 0;
      return way_mm_ >= kGrooveWayMm;
  }
  return false;
}

Training::News Training::touch(const TrainingTouch& touch, double now_s) {
  const double dt_s = std::clamp(now_s - last_s_, 0.0, 0.5);
  last_s_ = now_s;
  if (isFound(touch, now_s, dt_s)) {
    News news = next(said<MessageId::training_found>(), now_s);
    news.found = true;
    return news;
  }
  if (now_s - since_s_ >= kMostS) return skip(now_s);
  News news;
  if (!hinted_ && now_s - since_s_ >= kHintS) {
    hinted_ = true;
    news.say.push_back({wordsOf(shape_).hint, {}});
  }
  return news;
}

}  // namespace relievo
