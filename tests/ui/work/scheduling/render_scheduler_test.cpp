// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/scheduling/render_scheduler.h"

#include <gtest/gtest.h>
#include <memory>
#include <QApplication>
#include <QStringList>
#include <QThread>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

TEST(RenderScheduler, BetweenTwoPicturesEventsAreHandled) {
  RenderScheduler turns;
  QObject first, second;
  QStringList done;
  turns.schedule(&first, [&] {
    done << "first picture";
    QMetaObject::invokeMethod(
        &first, [&] { done << "a key"; }, Qt::QueuedConnection);
  });
  turns.schedule(&second, [&] { done << "second picture"; });
  EXPECT_TRUE(done.isEmpty()) << "nothing is drawn by whoever asks";
  ASSERT_TRUE(waitFor([&] { return done.size() == 3; }));
  EXPECT_EQ(done, (QStringList{"first picture", "a key", "second picture"}));
}

TEST(RenderScheduler, WhatCameDuringALongRoundIsHandledFirst) {
  RenderScheduler turns;
  QObject view;
  QStringList done;
  const auto later = [&](const std::function<void()>& work) {
    QMetaObject::invokeMethod(&view, work, Qt::QueuedConnection);
  };
  turns.schedule(&view, [&] { done << "picture"; });
  later([&] {    // In the round in which the turns rest anyway.
    later([&] {  // In the one after it, in which the picture would be drawn.
      QThread::msleep(100);
      later([&] { done << "a key"; });
    });
  });
  ASSERT_TRUE(waitFor([&] { return done.size() == 2; }));
  EXPECT_EQ(done, (QStringList{"a key", "picture"}));
}

TEST(RenderScheduler, WhoIsGoneDoesNotDrawAndHoldsNobodyUp) {
  RenderScheduler turns;
  auto gone = std::make_unique<QObject>();
  QObject stays;
  bool drawn = false, wrong = false;
  turns.schedule(gone.get(), [&] { wrong = true; });
  turns.schedule(&stays, [&] { drawn = true; });
  gone.reset();
  EXPECT_TRUE(waitFor([&] { return drawn; }));
  EXPECT_FALSE(wrong);
}

TEST(RenderScheduler, WhoAsksWhileDrawingIsServedAgain) {
  RenderScheduler turns;
  QObject view;
  int pictures = 0;
  std::function<void()> draw = [&] {
    if (++pictures < 3) turns.schedule(&view, draw);
  };
  turns.schedule(&view, draw);
  EXPECT_TRUE(waitFor([&] { return pictures == 3; }));
}

}  // namespace
}  // namespace relievo
