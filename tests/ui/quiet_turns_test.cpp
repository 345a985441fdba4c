// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/quiet_turns.h"

#include <gtest/gtest.h>
#include <memory>
#include <QApplication>
#include <QStringList>
#include <QThread>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

TEST(QuietTurns, BetweenTwoPicturesEventsAreHandled) {
  QuietTurns turns;
  QObject first, second;
  QStringList done;
  turns.ask(&first, [&] {
    done << "first picture";
    QMetaObject::invokeMethod(
        &first, [&] { done << "a key"; }, Qt::QueuedConnection);
  });
  turns.ask(&second, [&] { done << "second picture"; });
  EXPECT_TRUE(done.isEmpty()) << "nothing is drawn by whoever asks";
  ASSERT_TRUE(waitFor([&] { return done.size() == 3; }));
  EXPECT_EQ(done, (QStringList{"first picture", "a key", "second picture"}));
}

TEST(QuietTurns, WhatCameDuringALongRoundIsHandledFirst) {
  QuietTurns turns;
  QObject view;
  QStringList done;
  const auto later = [&](const std::function<void()>& work) {
    QMetaObject::invokeMethod(&view, work, Qt::QueuedConnection);
  };
  turns.ask(&view, [&] { done << "picture"; });
  later([&] {    // In the round in which the turns rest anyway.
    later([&] {  // In the one after it, in which the picture would be drawn.
      QThread::msleep(100);
      later([&] { done << "a key"; });
    });
  });
  ASSERT_TRUE(waitFor([&] { return done.size() == 2; }));
  EXPECT_EQ(done, (QStringList{"a key", "picture"}));
}

TEST(QuietTurns, WhoIsGoneDoesNotDrawAndHoldsNobodyUp) {
  QuietTurns turns;
  auto gone = std::make_unique<QObject>();
  QObject stays;
  bool drawn = false, wrong = false;
  turns.ask(gone.get(), [&] { wrong = true; });
  turns.ask(&stays, [&] { drawn = true; });
  gone.reset();
  EXPECT_TRUE(waitFor([&] { return drawn; }));
  EXPECT_FALSE(wrong);
}

TEST(QuietTurns, WhoAsksWhileDrawingIsServedAgain) {
  QuietTurns turns;
  QObject view;
  int pictures = 0;
  std::function<void()> draw = [&] {
    if (++pictures < 3) turns.ask(&view, draw);
  };
  turns.ask(&view, draw);
  EXPECT_TRUE(waitFor([&] { return pictures == 3; }));
}

}  // namespace
}  // namespace relievo
