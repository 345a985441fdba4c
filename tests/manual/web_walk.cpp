// SPDX-License-Identifier: BSD-3-Clause
// A hand rests on a map that comes over a slow line while the window walks over it. 6 s for each
// delay; RELIEVO_WALK_SECONDS=60 for longer walks.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <thread>

#include "core/tiles/published/publish.h"
#include "core/tiles/published/published_tiles.h"
#include "tests/core/tiles/slow_web_server.h"
#include "tests/core/tiles/tile_fixtures.h"
#include "tests/haptics/web_walk.h"

namespace {
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

/// Where the window is at a time: to and fro by steps, and every 3 s somewhere else.
Region placeAt(double t_s) {
  const int leg = static_cast<int>(t_s / 3);
  const double along = 0.1 * std::floor((t_s - 3 * leg) / 0.2);
  const double x = std::fmod(37.0 * leg, 250) + along * test::kWalkSideMm;
  const double y = std::fmod(91.0 * leg, 270);
  return {.x_mm = std::min(x, 280.0), .y_mm = y, .side_mm = test::kWalkSideMm, .level = {0}};
}

struct Walk {
  double largest_step_n = 0, largest_n = 0;
  long ticks = 0, coarser = 0, contact = 0, allocated = 0;
  int windows = 0;
};

Walk walk(const std::shared_ptr<const TiledMap>& map, double seconds) {
  using Clock = std::chrono::steady_clock;
  auto scenes = std::make_unique<SceneBuffer<HapticSpace>>();
  std::atomic<int> windows = 0;
  WindowsAhead ahead(map, {.give =
                               [&](const WindowsAhead::Given& given) {
                                 test::layWindow(*scenes, *given.window,
                                                 static_cast<std::uint64_t>(++windows));
                               },
                           .say = {}});
  ahead.want(placeAt(0));
  while (windows == 0) std::this_thread::yield();
  // A thread of its own walks, as people do by keys; the ticks know nothing of it.
  std::jthread walker([&](const std::stop_token& stop) {
    const auto start = Clock::now();
    for (int step = 1; !stop.stop_requested(); ++step) {
      std::this_thread::sleep_until(start + step * std::chrono::milliseconds(200));
      ahead.want(placeAt(0.2 * step));
    }
  });
  Walk done;
  test::WalkingHand hand(*scenes);
  const auto start = Clock::now();
  const int detail = map->ladder().levels();
  for (long tick = 0; tick < static_cast<long>(1000 * seconds); ++tick) {
    if (tick % 5 == 0) std::this_thread::sleep_until(start + tick * std::chrono::milliseconds(1));
    in_tick = true;
    const HapticSample sample = hand.tick();
    in_tick = false;
    if (tick <= test::kRestsAfterTicks) continue;
    ++done.ticks;
    done.coarser += sample.detail < detail ? 1 : 0;
    done.contact += sample.contact ? 1 : 0;
    done.largest_n = std::max(done.largest_n, norm(sample.force));
  }
  done.largest_step_n = hand.largestStepN();
  done.allocated = allocated_in_ticks;
  done.windows = windows;
  return done;
}

class WebWalk : public testing::TestWithParam<int> {};

TEST_P(WebWalk, NoForceStepIsAboveTheBlendsAndNoTickWaits) {
  const test::TileFolder folder;
  ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
  test::writeWalkRelief(folder / "map.tif");
  publish(TiledMap(folder / "map.tif"), folder / "web", {});
  test::SlowWebServer server(
      folder / "web", {.delay = std::chrono::milliseconds(GetParam()), .bytes_per_s = 20e6 / 8});
  const char* const given = std::getenv("RELIEVO_WALK_SECONDS");
  const double seconds = given == nullptr ? 6 : std::atof(given);
  const Walk far =
      walk(std::make_shared<const TiledMap>(webMap(server.address()).manifest), seconds);
  std::printf(
      "delay %d ms, 20 Mbit/s, %.0f s: %.1f %% of the time on a coarser level, largest step "
      "%.4f N, largest force %.2f N, contact %.1f %%, %d windows, %d requests\n",
      GetParam(), seconds,
      100.0 * static_cast<double>(far.coarser) / static_cast<double>(far.ticks), far.largest_step_n,
      far.largest_n, 100.0 * static_cast<double>(far.contact) / static_cast<double>(far.ticks),
      far.windows, server.requests());
  EXPECT_LE(far.largest_step_n, test::kMostWalkStepN);
  EXPECT_EQ(far.allocated, 0);
  EXPECT_GT(far.coarser, 0) << "the line was never too slow: nothing was tried";
  EXPECT_GT(far.contact, 0);
  EXPECT_GT(far.largest_n, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Delays, WebWalk, testing::Values(50, 200));

}  // namespace
}  // namespace relievo
