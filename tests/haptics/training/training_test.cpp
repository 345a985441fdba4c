// SPDX-License-Identifier: BSD-3-Clause
// The introduction with a simulated hand that knows nothing but what it feels: it sweeps, and finds
// each shape; one that does nothing is through in less than two minutes, too.
#include "haptics/training/training.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/message/catalogue.h"
#include "core/region/hand.h"
#include "haptics/device/virtual_hand.h"
#include "tests/haptics/closed_loop.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using Shape = TrainingShape;
constexpr std::array<Shape, kTrainingShapes> kAll{Shape::plate, Shape::bump, Shape::step,
                                                  Shape::wave, Shape::groove};

std::vector<MessageId> idsOf(const Training::News& news) {
  std::vector<MessageId> ids;
  for (const Message& message : news.say) ids.push_back(message.id);
  return ids;
}

TEST(TrainingShapes, AreAsTheyAreCalledAndAsLargeInTheHand) {
  for (const Shape shape : kAll) {
    const RegionWindow window = trainingWindow(shape, 7);
    EXPECT_EQ(window.id, 7U);
    EXPECT_DOUBLE_EQ(handMapping(window).device_per_view, 1);
    for (const double x : {3.1, 20.0, 39.1, 46.3, 70.2}) {
      for (const double y : {5.0, 30.3, 48.1, 66.0}) {
        if (shape == Shape::step && std::abs(x - kStepX) < 1) continue;
        EXPECT_NEAR(windowHeightMm(window, x, y), trainingHeightMm(shape, x, y), 0.05);
      }
    }
  }
  EXPECT_NEAR(trainingHeightMm(Shape::bump, kBumpX, kBumpY), 6, 1e-9);
  EXPECT_NEAR(trainingHeightMm(Shape::bump, kBumpX + 12, kBumpY), 0, 1e-9);
  EXPECT_EQ(trainingHeightMm(Shape::step, 60, 3) - trainingHeightMm(Shape::step, 20, 3), 3);
  EXPECT_NEAR(trainingHeightMm(Shape::wave, 2, 0) - trainingHeightMm(Shape::wave, 6, 0), 2, 1e-9);
  EXPECT_NEAR(trainingHeightMm(Shape::groove, 9, kGrooveY), -2, 1e-9);
  EXPECT_NEAR(trainingHeightMm(Shape::groove, 9, kGrooveY + 2), 0, 1e-9);
}

TEST(Training, WhoDoesNothingIsThroughInLessThanTwoMinutes) {
  Training training;
  training.begin(5, {});
  int shapes = 1, hints = 0;
  for (double t = 5; t < 5 + 120; t += 0.016) {
    const Training::News news = training.touch({}, t);
    shapes += news.other_shape ? 1 : 0;
    hints += news.say.size() == 1 ? 1 : 0;
    EXPECT_FALSE(news.found);
    if (!news.over) continue;
    EXPECT_EQ(shapes, kTrainingShapes);
    EXPECT_EQ(hints, kTrainingShapes);
    EXPECT_EQ(idsOf(news).back(), MessageId::training_ends);
    return;
  }
  FAIL() << "it did not end";
}

TEST(Training, EachTaskCanBePassedOver) {
  Training training;
  EXPECT_EQ(idsOf(training.begin(0, {})), std::vector{MessageId::training_plate});
  const std::array tasks{MessageId::training_bump, MessageId::training_step,
                         MessageId::training_wave, MessageId::training_groove};
  for (const MessageId task : tasks) {
    EXPECT_EQ(idsOf(training.skip(1)), (std::vector{MessageId::training_goes_on, task}));
    EXPECT_EQ(training.task().id, task);
  }
  EXPECT_TRUE(training.skip(2).over);
}

/// A task whose shape is there, up to a moment.
bool isFoundBy(Shape shape, const std::function<TrainingTouch(double t_s)>& hand, double most_s) {
  Training training;
  training.begin(0, {});
  while (training.shape() != shape) training.skip(0);
  for (double t = 0; t < most_s; t += 0.01) {
    if (training.touch(hand(t), t).found) return true;
  }
  return false;
}

TEST(Training, WhatWasNotDoneIsNotFound) {
  const auto at = [](double x, double y, double z, bool contact) {
    return [=](double) { return TrainingTouch{{x, y, z}, contact}; };
  };
  EXPECT_FALSE(isFoundBy(Shape::plate, at(40, 40, 0, true), 5.9));
  EXPECT_TRUE(isFoundBy(Shape::plate, at(40, 40, 0, true), 6.1));
  EXPECT_FALSE(isFoundBy(Shape::bump, at(kBumpX, kBumpY, 6, false), 15)) << "above it";
  EXPECT_FALSE(isFoundBy(Shape::bump, at(kBumpX - 9, kBumpY, 2, true), 15)) << "at its foot";
  EXPECT_TRUE(isFoundBy(Shape::bump, at(kBumpX - 7, kBumpY, 4, true), 0.5));
  EXPECT_FALSE(isFoundBy(Shape::step, at(20, 40, 0, true), 15)) << "one side alone";
  EXPECT_FALSE(isFoundBy(Shape::wave, at(20, 40, 0, true), 15)) << "at rest";
  EXPECT_FALSE(isFoundBy(
      Shape::wave,
      [](double t) {
        return TrainingTouch{{10, 10 + 5 * t, 0}, true};
      },
      10))
      << "along a crest";
  EXPECT_FALSE(isFoundBy(
      Shape::groove,
      [](double t) {
        return TrainingTouch{{5 + 5 * t, 20, 0}, true};
      },
      10))
      << "beside it";
  EXPECT_TRUE(isFoundBy(
      Shape::groove,
      [](double t) {
        return TrainingTouch{{5 + 5 * t, 48, -1.8}, true};
      },
      10));
}

/// A hand that sweeps over the window, row by row, pressed down lightly and lifted at the ends of
/// rows; it knows of no shape. @param way_s  it is slower where it feels that something rises
DeviceMm sweep(double way_s) {
  constexpr double kMmPerS = 45, kWidthMm = 64, kLiftedMm = 8, kRowMm = 9;
  constexpr int kRows = 7;
  const double way = kMmPerS * way_s;
  const int row = static_cast<int>(way / kWidthMm);
  const double part = way - row * kWidthMm;
  const double x = row % 2 == 0 ? part : kWidthMm - part;
  const bool lifted = part > kWidthMm - kLiftedMm;
  return {x - kWidthMm / 2, 26 - kRowMm * (row % kRows), lifted ? 14.0 : -4.0};
}

TEST(Training, AHandThatSweepsFindsEveryShapeInItsTime) {
  for (const HandImpedance& grip : kHandPresets) {
    SCOPED_TRACE(std::string(grip.name));
    Training training;
    double now_s = 0;
    training.begin(now_s, {});
    int found = 0;
    for (const Shape shape : kAll) {
      ASSERT_EQ(training.shape(), shape);
      auto space = std::make_unique<HapticSpace>();
      fill(*space, trainingWindow(shape, 1), {}, SurfaceKind::crease_aware);
      HapticOptions options;
      options.force.strength = 1;
      test::ClosedLoop loop(*space, {.hand = grip}, options);
      loop.switchOn({-32, 26, 14});
      Training::News news;
      double way_s = 0, lowest_mm = 1e9;
      for (int i = 0; !news.other_shape && !news.over; ++i) {
        const HapticSample sample = loop.tick(sweep(way_s));
        if (sample.contact) lowest_mm = std::min(lowest_mm, sample.proxy_view.z);
        const bool feels_a_rise = sample.contact && sample.proxy_view.z > lowest_mm + 1.5;
        way_s += feels_a_rise ? 0.0003 : 0.001;
        now_s += 0.001;
        if (i % 16 == 0) news = training.touch({sample.proxy_view, sample.contact}, now_s);
      }
      found += news.found ? 1 : 0;
      EXPECT_TRUE(news.found) << "shape " << static_cast<int>(shape);
    }
    EXPECT_EQ(found, kTrainingShapes);
    EXPECT_LT(now_s, 120);
  }
}

}  // namespace
}  // namespace relievo
