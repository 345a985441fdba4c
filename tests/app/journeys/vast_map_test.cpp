// SPDX-License-Identifier: BSD-3-Clause
// A map of 10^6 x 10^6 cells, nearly all of them empty: opened, zoomed through all of its levels,
// and touched on each.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <QtTest/QTest>
#include <string>

#include "tests/app/journeys/journey.h"
#include "tests/core/tiles/tile_fixtures.h"
#include "tests/core/tiles/vast_map.h"
#include "tests/emulator/stall_watch.h"

namespace relievo {
namespace {

/// Of /proc/self/status, in MB.
double megabytes(const std::string& what) {
  std::ifstream in("/proc/self/status");
  for (std::string word; in >> word;) {
    if (word != what + ":") continue;
    double kilobytes = 0;
    in >> kilobytes;
    return kilobytes / 1000;
  }
  return 0;
}

/// Hills of every width from 20 mm to 160 m.
double heightMm(double x_mm, double y_mm) {
  double sum = 0;
  for (double width = 20; width < 2e5; width *= 2) {
    sum += width / 40 * (2 + std::sin(x_mm / width) + std::sin(y_mm / width + width));
  }
  return sum;
}

class VastMap : public Journey {
 protected:
  VastMap() : Journey("vast") {}
  void publish() { test::publishVastMap(folder_ / "web", 4 * 2 * 160'000 / 40.0, heightMm); }
  QString map() const { return QString::fromStdString((folder_ / "web" / "map.json").string()); }
  bool feelsTheMiddle() {
    const QPointF middle = QRectF(detail().rect()).center();
    emulator::StallWatch stalls;
    return stalls.repeatAfterStalls(5, [&] {
      move(detail(), middle);
      if (!action("forces")->isChecked()) key(Qt::Key_F5);
      const auto is_here = [&] {
        return probe() && probe()->forces_on && probe()->window_id == document().window()->id;
      };
      if (!eventually(is_here)) return false;
      press(detail(), middle);
      const bool felt = soon([this] { return forceShown() > 0.1 && probe()->touching; });
      release(detail(), middle);
      return felt && eventually([this] { return !probe()->touching; });
    });
  }

  const test::TileFolder folder_;
};

TEST_F(VastMap, IsOpenedZoomedThroughAllLevelsAndTouchedOnEach) {
  publish();
  attach();
  const double before_mb = megabytes("VmRSS");
  const auto start = std::chrono::steady_clock::now();
  window().open(map());
  ASSERT_TRUE(eventually([this] { return document().isOpen() && document().surface()->tiles; }));
  const double opened_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_TRUE(settled());
  const int details = document().details();
  EXPECT_GE(details, 12);
  picture("1_whole");
  for (int detail = 1;; ++detail) {
    SCOPED_TRACE(detail);
    EXPECT_EQ(document().detail(), detail);
    ASSERT_TRUE(eventually([this] {
      return document().window()->region.level == document().project().region.level;
    })) << "nothing coarser takes its place for long";
    EXPECT_TRUE(feelsTheMiddle()) << said().toStdString();
    if (detail == details / 2) picture("2_half");
    if (detail == details) break;
    ASSERT_TRUE(document().region().finer(document().region().aboutCentre()));
    ASSERT_TRUE(settled());
  }
  EXPECT_EQ(document().window()->region.level.value, 0);
  picture("3_finest");
  detach();
  const double grown_mb = megabytes("VmHWM") - before_mb;
  std::printf("opened after %.2f s; %d details; the process had %.0f MB, and %.0f MB at most\n",
              opened_s, details, before_mb, megabytes("VmHWM"));
  EXPECT_LT(grown_mb, 300) << "a list of all of its tiles alone takes 240";
}

}  // namespace
}  // namespace relievo
