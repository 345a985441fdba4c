// SPDX-License-Identifier: BSD-3-Clause
// A hand rests on a map from the web while the window goes over it. The test holds and lets go what
// the server answers, and counts the ticks itself: nothing here depends on a clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <new>
#include <set>

#include "core/base/failure.h"
#include "core/tiles/published/publish.h"
#include "core/tiles/published/published_tiles.h"
#include "tests/core/tiles/slow_web_server.h"
#include "tests/core/tiles/tile_fixtures.h"
#include "tests/haptics/web_walk.h"

namespace {
// Other threads fetch meanwhile; only the ticks of this one are looked at.
thread_local bool in_tick = false;
thread_local long allocated_in_ticks = 0;

void* counted(std::size_t size) {
  if (in_tick) ++allocated_in_ticks;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new[](std::size_t size) {
  return counted(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace relievo {
namespace {

constexpr std::chrono::minutes kPatience{3};  // Only a hang takes so long.

/// The windows of the walk as they come, laid into the loop's buffer, and what is said of them.
class Windows {
 public:
  Windows(const std::shared_ptr<const TiledMap>& map, SceneBuffer<HapticSpace>& scenes)
      : ahead_(map, {.give =
                         [this, &scenes](const WindowsAhead::Given& given) {
                           const std::scoped_lock lock(mutex_);
                           newest_ = *given.window;
                           test::layWindow(scenes, newest_, ++laid_);
                           changed_.notify_all();
                         },
                     .say =
                         [this](const Message& message) {
                           const std::scoped_lock lock(mutex_);
                           said_.insert(message.id);
                           changed_.notify_all();
                         }}) {}

  void want(const Region& region) { ahead_.want(region); }
  /// Is one of this place, as fine as this or coarser than that, laid for the loop?
  bool waitFor(const Region& place, const std::function<bool(int level)>& is_right) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] {
      return newest_.region.x_mm == place.x_mm && newest_.region.y_mm == place.y_mm &&
             is_right(newest_.region.level.value);
    });
  }
  int timesSaid(MessageId id) const {
    const std::scoped_lock lock(mutex_);
    return static_cast<int>(said_.count(id));
  }
  bool waitToHear(std::initializer_list<MessageId> any_of) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] {
      return std::any_of(any_of.begin(), any_of.end(),
                         [this](MessageId id) { return said_.contains(id); });
    });
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  RegionWindow newest_;
  std::uint64_t laid_ = 0;
  std::multiset<MessageId> said_;
  WindowsAhead ahead_;  ///< Last: it calls the others until it is gone.
};

class WebWalk : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    ::unsetenv("RELIEVO_MAP_CACHE_MB");
    test::writeWalkRelief(folder_ / "map.tif");
    publish(TiledMap(folder_ / "map.tif"), folder_ / "web", {});
    server_ =
        std::make_unique<test::SlowWebServer>(folder_ / "web", test::SlowWebServer::Options{});
    map_ = std::make_shared<const TiledMap>(webMap(server_->address()).manifest);
    scenes_ = std::make_unique<SceneBuffer<HapticSpace>>();
    hand_ = std::make_unique<test::WalkingHand>(*scenes_);
    windows_ = std::make_unique<Windows>(map_, *scenes_);
  }

  static Region place(double x_mm, double y_mm) {
    return {.x_mm = x_mm, .y_mm = y_mm, .side_mm = test::kWalkSideMm, .level = {0}};
  }
  bool isComplete(const Region& region) {
    return windows_->waitFor(region, [](int level) { return level == 0; });
  }
  bool isCoarser(const Region& region) {
    return windows_->waitFor(region, [](int level) { return level > 0; });
  }
  struct Ticks {
    long all = 0, coarser = 0, contact = 0;
  };
  /// At least so many, and until the loop has blended in what was laid.
  Ticks tick(long least = 300) {
    Ticks ticks;
    constexpr long kMost = 20'000;
    while ((ticks.all < least || hand_->changing()) && ticks.all < kMost) {
      in_tick = true;
      const HapticSample sample = hand_->tick();
      in_tick = false;
      ++ticks.all;
      ticks.coarser += sample.detail < map_->ladder().levels() ? 1 : 0;
      ticks.contact += sample.contact ? 1 : 0;
    }
    EXPECT_LT(ticks.all, kMost) << "a change of surfaces never ends";
    return ticks;
  }

  const test::TileFolder folder_;
  std::unique_ptr<test::SlowWebServer> server_;
  std::shared_ptr<const TiledMap> map_;
  std::unique_ptr<SceneBuffer<HapticSpace>> scenes_;
  std::unique_ptr<test::WalkingHand> hand_;
  std::unique_ptr<Windows> windows_;
};

TEST_F(WebWalk, WhatIsOnItsWayIsFeltCoarserAndBlendedIn) {
  windows_->want(place(10, 10));
  ASSERT_TRUE(isComplete(place(10, 10)));
  tick(test::kRestsAfterTicks + 300);

  // Nothing of these places was fetched ahead: no two steps are alike. In the middle of each is a
  // hill, so that the hand meets it.
  const std::vector<Region> walk{place(120, 34), place(46, 199), place(255, 126), place(174, 262)};
  for (const Region& region : walk) {
    server_->hold();
    windows_->want(region);
    ASSERT_TRUE(isCoarser(region));
    const Ticks meanwhile = tick();
    EXPECT_GT(meanwhile.coarser, 0);
    EXPECT_GT(meanwhile.contact, 0);
    server_->letGo();
    ASSERT_TRUE(isComplete(region));
    tick();
    EXPECT_EQ(tick().coarser, 0) << "what has come is felt";
  }

  // A server that goes: what is here is felt, until it is back.
  server_->stop();
  windows_->want(place(75, 105));
  ASSERT_TRUE(windows_->waitToHear({MessageId::web_server_lost}));
  ASSERT_TRUE(isCoarser(place(75, 105)));
  EXPECT_GT(tick().coarser, 0);
  server_->start();
  ASSERT_TRUE(isComplete(place(75, 105)));
  ASSERT_TRUE(windows_->waitToHear({MessageId::web_server_back}));
  tick();
  // Once each: what was held for long may have been taken for lost, too, and was back then.
  EXPECT_EQ(windows_->timesSaid(MessageId::web_server_lost),
            windows_->timesSaid(MessageId::web_server_back));

  EXPECT_EQ(tick(1000).coarser, 0);
  EXPECT_LE(hand_->largestStepN(), test::kMostWalkStepN);
  EXPECT_EQ(allocated_in_ticks, 0);
}

TEST_F(WebWalk, ADamagedTileIsNeverFelt) {
  windows_->want(place(10, 10));
  ASSERT_TRUE(isComplete(place(10, 10)));
  tick(test::kRestsAfterTicks + 300);
  // Of this place the records are known, so that it is tiles that are damaged.
  const Region damaged = place(120, 34);
  server_->damage("L0.p0.tiles");
  windows_->want(damaged);
  ASSERT_TRUE(
      windows_->waitToHear({MessageId::published_tile_damaged, MessageId::published_file_damaged}));
  ASSERT_TRUE(isCoarser(damaged));
  const Ticks felt = tick(1000);
  EXPECT_GT(felt.contact, 0);
  EXPECT_GT(tick(300).coarser, 0);
  EXPECT_EQ(tick(300).coarser, 300) << "the coarser level stays";
  server_->damage("");
  windows_->want(place(46, 199));
  ASSERT_TRUE(isComplete(place(46, 199)));
  tick();
  EXPECT_EQ(tick().coarser, 0);
  EXPECT_LE(hand_->largestStepN(), test::kMostWalkStepN);
  EXPECT_EQ(allocated_in_ticks, 0);
}

}  // namespace
}  // namespace relievo
