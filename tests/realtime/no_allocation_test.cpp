// SPDX-License-Identifier: BSD-3-Clause
// A tick must not allocate. Every operator new and delete of this program is counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "haptics/device/haply/messages.h"
#include "haptics/device/mouse_device.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/sound/live_sound.h"
#include "haptics/sound/synth.h"
#include "tests/haptics/haptic_fixture.h"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
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

/// Allocations while something runs.
template <class Work>
long allocationsIn(const Work& work) {
  const long before = allocations.load();
  work();
  return allocations.load() - before;
}

TEST(NoAllocation, TheGuardSeesAPlantedAllocation) {
  EXPECT_EQ(allocationsIn([] {
              std::unique_ptr<int> planted(new int(3));
              // Keeps the compiler from leaving the pair out.
              asm volatile("" : : "g"(planted.get()) : "memory");
            }),
            1);
  EXPECT_EQ(allocationsIn([] {}), 0);
}

TEST(NoAllocation, SoundAllocatesNothing) {
  sound::TouchEvents touch;
  sound::Synth synth;
  std::array<sound::Frame, 256> frames{};
  float loudest = 0;
  const long allocated = allocationsIn([&] {
    for (int i = 0; i < 2000; ++i) {
      const bool contact = i / 50 % 2 == 1;
      synth.take(
          touch.next({.t_s = 0.001 * i,
                      .hand = {0.1 * i, 0, contact ? 0.0 : 5.0},
                      .proxy = {0.1 * i, 0, 0},
                      .force_n = 2,
                      .contact = contact,
                      .origin = i % 70 > 35 ? CellStatus::interpolated : CellStatus::measured,
                      .detail = i / 400 + 1}));
      synth.render(frames);
      loudest = std::max(loudest, std::abs(frames[0].left));
    }
  });
  EXPECT_EQ(allocated, 0);
  EXPECT_GT(loudest, 0.01F) << "it was not silent";
}

TEST(NoAllocation, TheSoundOfATouchThatGoesOnAllocatesNothing) {
  const auto ring = std::make_unique<HeardRing>();
  const auto live = std::make_unique<sound::LiveSound>(*ring);
  live->setWindow({.id = 1, .region = {0, 0, 80, Level{0}}, .heights = {0, 10}});
  std::array<sound::Frame, 48> frames{};
  float loudest = 0;
  const long allocated = allocationsIn([&] {
    for (int i = 0; i < 4000; ++i) {
      HapticSample sample;
      sample.time_ns = 1'000'000LL * i;
      sample.window_id = i < 2000 ? 1 : 2;
      sample.contact = i / 50 % 2 == 1;
      sample.hip = {0.1 * i, 0, sample.contact ? 0.0 : 5.0};
      sample.force = {0, 0, 2};
      if (i == 2000) live->setWindow({.id = 2, .region = {0, 0, 40, Level{1}}, .heights = {0, 10}});
      if (i % 700 == 600) live->setVolume(i / 100);
      sample.fault = i % 900 < 20 ? DeviceFault::timeout : DeviceFault::none;
      ring->push(sample);
      live->render(frames);
      loudest = std::max(loudest, std::abs(frames[0].left));
    }
  });
  EXPECT_EQ(allocated, 0);
  EXPECT_GT(loudest, 0.01F) << "it was not silent";
}

TEST(NoAllocation, ATickAllocatesNothingWithAnyProxyAndSurface) {
  for (const SurfaceKind surface :
       {SurfaceKind::crease_aware, SurfaceKind::spline, SurfaceKind::bilinear}) {
    const auto space = test::spaceOf(
        80,
        [](double x, double y) {
          return 3 * std::sin(0.9 * x) * std::cos(0.7 * y) + (x > 40 ? 6 : 0);
        },
        1, {}, surface);
    for (const ProxyKind kind :
         {ProxyKind::converged, ProxyKind::equation, ProxyKind::successive}) {
      HapticOptions options;
      options.proxy.kind = kind;
      options.proxy.static_friction = 0.3;
      options.proxy.dynamic_friction = 0.2;
      options.force.damping_n_s_per_mm = 0.001;
      options.force.forces_on = true;
      options.fields = {.softest_part = 0.5, .texture_mm = 0.02, .magnet_n = 0.3};
      options.force.transient = {.contact_n = 0.3, .crossing_n = 0.1};
      HapticCore core;
      double sum = 0;
      const long count = allocationsIn([&] {
        for (int i = 0; i < 4000; ++i) {
          DeviceReading reading;
          reading.time_ns = i * 1'000'000LL;
          reading.position = {39 * std::sin(0.01 * i), 39 * std::cos(0.013 * i),
                              i < 1200 ? 20. : -3.};
          sum += core.tick(*space, options, reading, reading.time_ns).force.z;
        }
      });
      EXPECT_EQ(count, 0);
      EXPECT_GT(sum, 0) << "and did push back";
    }
  }
}

TEST(NoAllocation, AChangeOfSurfaceAllocatesNothing) {
  const auto was = test::spaceOf(
      80, [](double x, double y) { return std::sin(0.4 * x) * std::cos(0.5 * y); }, 1, {},
      SurfaceKind::crease_aware);
  const auto now = test::spaceOf(
      40, [](double x, double) { return x > 20 ? 4.0 : 0.0; }, 2, {}, SurfaceKind::crease_aware);
  HapticOptions options;
  options.force.forces_on = true;
  options.frame = true;
  HapticCore core;
  int changing = 0;
  const long count = allocationsIn([&] {
    for (int i = 0; i < 3000; ++i) {
      DeviceReading reading;
      reading.time_ns = i * 1'000'000LL;
      reading.position = {45 * std::sin(0.01 * i), 30 * std::cos(0.013 * i), i < 500 ? 20. : -3.};
      core.tick(i < 1000 ? *was : *now, *was, options, reading, reading.time_ns);
      changing += core.changing() ? 1 : 0;
    }
  });
  EXPECT_EQ(count, 0);
  EXPECT_GT(changing, 100);
}

TEST(NoAllocation, AHandThatIsLedAllocatesNothing) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  std::vector<DeviceMm> star;
  for (int i = 0; i < 10; ++i) {
    const double a = std::acos(-1.0) * i / 5, r = i % 2 == 0 ? 30 : 14;
    star.push_back({r * std::cos(a), r * std::sin(a), 0});
  }
  GuidePath path = guidePath(star, true, 3);
  path.id = 1;
  HapticOptions options;
  options.force.forces_on = true;
  options.guide.path = 1;
  HapticCore core;
  int led = 0;
  DeviceMm hand{10, 10, 5};
  const long count = allocationsIn([&] {
    for (int i = 0; i < 20000; ++i) {
      DeviceReading reading;
      reading.time_ns = i * 1'000'000LL;
      reading.position = hand;
      const HapticSample sample = core.tick(*space, options, reading, reading.time_ns, &path);
      hand = hand + 0.05 * DeviceMm{sample.force.x, sample.force.y, sample.force.z};
      led += sample.guide != GuidePhase::off ? 1 : 0;
      if (sample.guide == GuidePhase::off) ++options.guide.path, ++path.id;
    }
  });
  EXPECT_EQ(count, 0);
  EXPECT_GT(led, 15000);
}

TEST(NoAllocation, BuffersRingsAndTheMouseAllocateNothing) {
  MouseDevice mouse;
  const auto ring = std::make_unique<SampleRing>();
  TripleBuffer<HapticSample> latest;
  EXPECT_EQ(allocationsIn([&] {
              for (int i = 0; i < 10000; ++i) {
                mouse.moveTo({0.01 * i, 0, 0});
                HapticSample sample;
                sample.hip = mouse.exchange({}, i * 1'000'000LL).position;
                latest.write(sample);
                latest.update();
                ring->push(sample);
              }
            }),
            0);
}

/// A thousand times a second, by a thread that the loop waits for.
TEST(NoAllocation, AStateOfHaplysServiceIsReadAndAnOrderWritten) {
  const char* const text =
      R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"inverse3","preset":"a",)"
      R"("basis":{"permutation":"XYZ"},"odd":[1,{"deep":[true,null,"x"]}]},"state":)"
      R"({"cursor_position":{"x":0.0123456789,"y":-1.2e-1,"z":0.15},"current_cursor_force":)"
      R"({"x":0,"y":0.25,"z":0}},"status":{"calibrated":true,"ready":true,"started":true}}],)"
      R"("wireless_verse_grip":[{"state":{"buttons":{"a":true}}}]})";
  haply::ServiceState state;
  haply::MessageWriter writer;
  bool understood = true;
  const long count = allocationsIn([&] {
    for (int i = 0; i < 100; ++i) {
      understood = understood && haply::readState(text, state) && state.device_count == 1;
      const auto said = writer.order(state.devices[0], haply::ForceKey::vector, {1, 2, 3}, true);
      understood = understood && !said.empty();
    }
  });
  EXPECT_TRUE(understood);
  EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace relievo
