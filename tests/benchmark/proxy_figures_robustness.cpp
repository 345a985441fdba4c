// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "haptics/loop/haptic_core.h"
#include "tests/benchmark/proxy_figures.h"
#include "tests/haptics/hollows.h"
#include "tests/haptics/proxy/measure.h"
#include "tests/haptics/proxy/profiles.h"
#include "tests/haptics/proxy/truth_scenes.h"

namespace relievo {

namespace {
HapticOptions springOnly(double stiffness_n_per_mm) {
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = stiffness_n_per_mm;
  return options;
}

FigureRow finRow() {
  int passes = 0, literal = 0, cases = 0;
  for (const double base_mm : {0.03, 0.0625, 0.25, 1.0}) {
    for (const double speed_mm_per_s : {20.0, 100.0, 1000.0, 10000.0}) {
      ++cases;
      literal += test::passesFin(base_mm, speed_mm_per_s, ProxyKind::equation) ? 1 : 0;
      for (const SurfaceKind kind :
           {SurfaceKind::crease_aware, SurfaceKind::spline, SurfaceKind::bilinear}) {
        passes += test::passesFin(base_mm, speed_mm_per_s, ProxyKind::converged, kind) ? 1 : 0;
      }
    }
  }
  return {"passes through a fin of 8 mm, one cell a side, 0.03 to 1 mm at its base, 0.02 to 10 m/s",
          "0 of 16",
          std::to_string(passes) + " of 16 on each of three surfaces",
          passes == 0,
          "0",
          "equation, ours: " + std::to_string(literal) + " of " + std::to_string(cases)};
}

void addOptimality(std::vector<FigureRow>& rows) {
  const auto space = test::spaceOf(
      80,
      [](double x, double y) {
        return 1.5 * std::sin(0.5 * x) + 1.2 * std::cos(0.43 * y + 0.2 * x) +
               0.3 * std::sin(1.7 * x + y);
      },
      1, {}, SurfaceKind::crease_aware);
  ProxyState state;
  std::vector<double> angles;
  double below = 0;
  for (int n = 0; n < 150000; ++n) {
    const double x = 99.5 + 90 * std::sin(0.0021 * n), y = 99.5 + 90 * std::sin(0.0017 * n + 0.4);
    const double surface = surfaceHeight(*space, x, y);
    const GridPoint hip{x, y, surface + (n == 0 ? 1 : -2.5 * (1 + std::sin(0.01 * n)))};
    state = n == 0 ? proxyPlace(*space, hip) : proxyTick(*space, state, hip, {});
    const GridPoint p = state.position;
    below = std::max(below, space->cell_mm * (surfaceHeight(*space, p.x, p.y) - p.z));
    if (state.contact && norm(p - hip) * space->cell_mm > 0.05) {
      angles.push_back(test::angleDegrees(p - hip, proxyNormal(*space, state)));
    }
  }
  const double most = test::quantile(angles, 1), usual = test::quantile(angles, 0.999);
  rows.push_back({"angle between force and normal at the proxy, three smooth sines, 150 000 ticks",
                  "p99.9 <= 0.0001, max <= 0.01 deg",
                  decimal(usual, 7) + ", " + decimal(most, 6) + " deg",
                  usual <= 1e-4 && most <= 0.01, "0.00002, 0.002", "equation: not converged"});
  rows.push_back({"proxy below its surface, by the evaluator that moved it", "<= 1e-6 mm",
                  decimal(below, 9) + " mm", below <= 1e-6, "0.0000 um",
                  "equation 0.1 to 1.6 mm, HAPI depth surface 0.098"});
}

void addEnergy(std::vector<FigureRow>& rows) {
  const test::Relief relief = test::waves(1, 10);
  double worst = -1;
  for (const SurfaceKind kind :
       {SurfaceKind::crease_aware, SurfaceKind::spline, SurfaceKind::bilinear}) {
    const test::Work work = test::workPerCycle(*test::spaceOf(relief, 100, kind), relief, {});
    worst = std::max(worst, 100 * work.net_mj / work.gross_mj);
  }
  rows.push_back({"work on the hand per closed cycle without friction, of the gross work",
                  "<= +0.02 %", decimal(worst, 4) + " %", worst <= 0.02, "-0.014 %",
                  "equation +1.8 %"});
  worst = -100;
  for (const SurfaceKind kind : {SurfaceKind::crease_aware, SurfaceKind::bilinear}) {
    for (const double depth_mm : {4.0, 5.0, 6.0, 7.0, 8.0, 10.0}) {
      const test::Work work = test::workOverHollows(kind, depth_mm);
      worst = std::max(worst, 100 * work.net_mj / work.gross_mj);
    }
  }
  rows.push_back({"the same, 4 to 10 mm deep from soft hollows over to firm ones and out there",
                  "<= +0.02 %", decimal(worst, 4) + " %", worst <= 0.02, "not tried",
                  "with `1/2 k part d^2` alone: ours +10.9 %"});
  double least_lost = 1e9;
  for (const double mu : {0.1, 0.3, 0.6}) {
    ProxyOptions options;
    options.static_friction = 1.4 * mu;
    options.dynamic_friction = mu;
    const test::Work work =
        test::workPerCycle(*test::spaceOf(relief, 100, SurfaceKind::crease_aware), relief, options);
    least_lost = std::min(least_lost, -100 * work.net_mj / work.gross_mj);
  }
  rows.push_back({"with friction of 0.1, 0.3, 0.6: least work lost", "> 0",
                  decimal(least_lost, 1) + " %", least_lost > 0, "not tried", "-"});
}

struct Change {
  double largest_step_n = 0;
  int ticks = 0;
};

/// Rests at `hip` on one surface until another, 3 mm of view higher, has come.
Change changeUnderAStillHand(const test::Relief& from, const test::Relief& to, DeviceMm hip,
                             double stiffness_n_per_mm) {
  const auto was = test::spaceOf(80, from.height, 1, {}, SurfaceKind::crease_aware);
  const auto now = test::spaceOf(
      80, [&](double x, double y) { return 3 + to.height(x, y); }, 2, {},
      SurfaceKind::crease_aware);
  now->device_translation = was->device_translation;
  HapticCore core(ForceChain::bare);
  DeviceReading reading;
  DeviceN last;
  Change change;
  for (int n = 0; n < 20000; ++n) {
    reading.position = {hip.x, hip.y, std::max(hip.z, 30 - 0.5 * n)};
    reading.time_ns = n * 1'000'000LL;
    const bool settled = n < 200;
    const HapticSample sample = core.tick(settled ? *was : *now, *was,
                                          springOnly(stiffness_n_per_mm), reading, reading.time_ns);
    if (!settled) {
      change.largest_step_n = std::max(change.largest_step_n, norm(sample.force - last));
      ++change.ticks;
    }
    last = sample.force;
    if (n > 201 && !core.changing()) break;
  }
  return change;
}

void addChanges(std::vector<FigureRow>& rows) {
  constexpr double kStiffness = 0.5;
  double largest = 0;
  int longest = 0;
  for (const DeviceMm hip : {DeviceMm{0, 0, -4}, DeviceMm{13, -7, -3}, DeviceMm{-21, 9, -5}}) {
    const Change change =
        changeUnderAStillHand(test::waves(1, 18), test::waves(1.2, 13), hip, kStiffness);
    largest = std::max(largest, change.largest_step_n);
    longest = std::max(longest, change.ticks);
  }
  rows.push_back({"new surface under a hand at rest, 3 mm higher with other relief: step of force",
                  "<= 0.005 N per tick",
                  decimal(largest, 5) + " N, " + std::to_string(longest) + " ticks",
                  largest <= 0.005, "0.0035", "none has it; hard switch 0.456 N"});
  const test::Relief flat = test::plane(0, 0);
  const Change change = changeUnderAStillHand(flat, flat, {0, 0, -3}, kStiffness);
  const double part = change.largest_step_n * change.ticks / (kStiffness * 3);
  rows.push_back({"the same without relief", "<= 1.6 k dz / ticks",
                  decimal(part, 2) + " k dz / ticks", part <= 1.6, "1.5", "-"});
}

/// A million ticks of everything that can happen to a hand.
FigureRow millionRow() {
  std::mt19937 random(77);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<std::unique_ptr<HapticSpace>> spaces;
  for (int i = 0; i < 8; ++i) {
    const double wall = i % 2 == 0 ? 4 : 0;
    spaces.push_back(test::spaceOf(
        30 + 11 * i,
        [&](double x, double y) {
          return std::sin(0.4 * x + i) * std::cos(0.5 * y) + 0.1 * unit(random) +
                 (x > 20 ? wall : 0);
        },
        static_cast<std::uint64_t>(i) + 1, {},
        i == 5 ? SurfaceKind::bilinear : SurfaceKind::crease_aware));
  }
  HapticOptions options;
  options.force.forces_on = true;
  options.proxy.static_friction = 0.2;
  options.proxy.dynamic_friction = 0.15;
  HapticCore core;
  std::size_t was = 0, now = 0;
  DeviceMm hip{0, 0, 30};
  std::int64_t now_ns = 0;
  int wrong = 0, contacts = 0, changes = 0;
  for (int n = 0; n < 1'000'000; ++n) {
    if (!core.changing() && n % 700 == 0) {
      was = now;
      now = static_cast<std::size_t>(random() % spaces.size());
      changes += now == was ? 0 : 1;
    }
    if (n % 501 == 0) hip = {45 * unit(random), 45 * unit(random), 25 * unit(random)};
    hip = hip + DeviceMm{0.2 * unit(random), 0.2 * unit(random), 0.2 * unit(random)};
    DeviceReading reading;
    reading.position = hip;
    if (n % 1009 == 0) reading.position.x = std::numeric_limits<double>::quiet_NaN();
    if (n % 1013 == 0) reading.position.z = -std::numeric_limits<double>::infinity();
    now_ns += n % 4001 == 0 ? 80'000'000 : 1'000'000;
    reading.time_ns = now_ns;
    options.force.forces_on = n % 1009 != 1 && n % 1013 != 1;
    const HapticSample s = core.tick(*spaces[now], *spaces[was], options, reading, now_ns);
    const bool whole = isFinite(s.force) && isFinite(s.proxy) &&
                       norm(s.force) <= options.force.limit_n * (1 + 1e-12);
    bool outside = true;
    if (!core.changing()) {
      const GridPoint p = spaces[now]->gridFromDevice(s.proxy);
      outside = (surfaceHeight(*spaces[now], p.x, p.y) - p.z) * spaces[now]->cell_mm <= 1e-6;
    }
    wrong += whole && outside ? 0 : 1;
    contacts += s.contact ? 1 : 0;
  }
  return {
      "10^6 ticks over random relief with walls, noise, friction, switches of level, jumps of "
      "the hand, NaN, infinite and late hands: force not finite or over its limit, proxy below",
      "0",
      std::to_string(wrong) + " (" + std::to_string(changes) + " switches, " +
          decimal(100.0 * contacts / 1'000'000, 0) + " % in contact)",
      wrong == 0 && changes > 200,
      "-",
      "-"};
}

/// By an evaluator that shares nothing with the core.
void addTruths(std::vector<FigureRow>& rows) {
  for (const test::TruthScene& scene : test::truthScenes()) {
    const int ticks = scene.spline ? 50'000 : 200'000;
    const test::TruthFindings found = test::wanderOver(scene, ticks);
    const auto nano = [](test::Real value) { return decimal(1e9 * static_cast<double>(value), 2); };
    rows.push_back(
        {scene.name + ", against the second evaluator in long double, " + std::to_string(ticks) +
             " ticks: proxy below; force off k d; nearer to the hand around the proxy",
         "<= 1 nm; <= 1 uN; 0",
         nano(found.below_mm * 1e-3L) + " nm; " + nano(found.force_off_n) + " nN; " +
             std::to_string(found.nearer) + " of " + std::to_string(found.judged),
         found.below_mm <= 1e-6L && found.force_off_n <= 1e-6L && found.nearer == 0, "-", "-"});
  }
}

FigureRow springRow() {
  const auto space = test::spaceOf(test::waves(1, 10), 100, SurfaceKind::crease_aware);
  HapticCore core(ForceChain::bare);
  double worst = 0;
  for (int n = 0; n < 20000; ++n) {
    DeviceReading reading;
    reading.position = {30 * std::sin(0.003 * n), 30 * std::cos(0.002 * n), n == 0 ? 20 : -3.0};
    reading.time_ns = n * 1'000'000LL;
    const HapticSample s = core.tick(*space, springOnly(0.5), reading, reading.time_ns);
    const double d = norm(s.proxy - s.hip);
    if (s.contact) worst = std::max(worst, std::abs(norm(s.force) / (0.5 * d) - 1));
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.1e", worst);
  return {
      "force against k d, both of the core", "relative 1e-12", text, worst <= 1e-12, "exact", "-"};
}
}  // namespace

std::vector<FigureRow> robustnessRows() {
  std::vector<FigureRow> rows{finRow()};
  addOptimality(rows);
  rows.push_back(springRow());
  addTruths(rows);
  addEnergy(rows);
  addChanges(rows);
  rows.push_back(millionRow());
  return rows;
}

}  // namespace relievo
