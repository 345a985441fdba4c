// SPDX-License-Identifier: BSD-3-Clause
#include "tests/benchmark/proxy_figures.h"
#include "tests/haptics/proxy/measure.h"
#include "tests/haptics/proxy/profiles.h"

namespace relievo {

namespace {
using test::Accuracy;
using test::Relief;

FigureRow angleRow(const std::string& what, const Accuracy& a, double target,
                   const std::string& prototype, const std::string& others) {
  return {what + ": largest angle of the force",
          "<= " + decimal(target, 2) + " deg",
          decimal(a.angle_max, 3) + " deg (median " + decimal(a.angle_median, 4) + ")",
          a.angle_max <= target,
          prototype,
          others};
}
FigureRow positionRow(const std::string& what, const Accuracy& a, double target,
                      const std::string& prototype, const std::string& others) {
  return {what + ": proxy off",
          "<= " + decimal(target, 0) + " um",
          decimal(a.position_max_um, 2) + " um",
          a.position_max_um <= target,
          prototype,
          others};
}
FigureRow stepRow(const std::string& what, const Accuracy& a, double target,
                  const std::string& prototype, const std::string& others) {
  const double ratio = a.step / a.true_step;
  return {what + ": largest step of force per tick, of truth's",
          target > 0 ? "<= " + decimal(target, 2) + " x" : "-",
          decimal(ratio, 3) + " x",
          target <= 0 || ratio <= target,
          prototype,
          others};
}

struct Wave {
  double amplitude_mm, length_mm;
  std::string name;
  double angle, position, step;
  std::string angle_proto, position_proto, step_proto, angle_peer, position_peer, step_peer;
};

void addWaves(std::vector<FigureRow>& rows) {
  const std::vector<Wave> waves{
      {1, 10, "20 samples per wave", 0.03, 1, 1.02, "0.02", "0.4", "1.004",
       "CHAI3D 21, paper's equation 11.4", "CHAI3D 408", "CHAI3D 10.5, equation 11.5"},
      {0.25, 4, "8 samples per wave", 0.4, 8, 1.02, "0.30", "5.2", "0.998",
       "CHAI3D 25, equation 23.7", "CHAI3D 442", "CHAI3D 9.6, equation 8.3"},
      {0.05, 2, "4 samples per wave", 0.8, 15, 0, "0.67", "11.8", "1.27",
       "CHAI3D 14, equation 13.4", "CHAI3D 249", "CHAI3D 8.0"},
  };
  for (const Wave& wave : waves) {
    const Relief relief = test::waves(wave.amplitude_mm, wave.length_mm);
    const auto aware = test::spaceOf(relief, 100, SurfaceKind::crease_aware);
    const Accuracy a = test::slideOver(*aware, relief, {}, {});
    const auto facets = test::spaceOf(relief, 100, SurfaceKind::bilinear);
    const Accuracy b = test::slideOver(*facets, relief, {}, {});
    rows.push_back(angleRow(wave.name, a, wave.angle, wave.angle_proto,
                            wave.angle_peer + "; our facets " + decimal(b.angle_max, 1)));
    rows.push_back(
        positionRow(wave.name, a, wave.position, wave.position_proto,
                    wave.position_peer + "; our facets " + decimal(b.position_max_um, 0)));
    rows.push_back(stepRow(wave.name, a, wave.step, wave.step_proto,
                           wave.step_peer + "; our facets " + decimal(b.step / b.true_step, 1)));
  }
}

void addCreases(std::vector<FigureRow>& rows) {
  for (const int samples : {20, 40}) {
    const double length_mm = 0.5 * samples;
    const auto ratio = [&](SurfaceKind kind) {
      return test::stepsAcrossCreases(1, length_mm, kind).ratio();
    };
    const double aware = ratio(SurfaceKind::crease_aware);
    rows.push_back({std::to_string(samples) +
                        " samples per wave, a block on it: largest step of force across the gate "
                        "beside it, of truth's",
                    "<= 1.02 x", decimal(aware, 3) + " x", aware <= 1.02, "not tried",
                    "ours: facets " + decimal(ratio(SurfaceKind::bilinear), 1) +
                        ", spline without gate " + decimal(ratio(SurfaceKind::spline), 1)});
  }
}

void addInvariance(std::vector<FigureRow>& rows) {
  const Relief relief = test::waves(2, 40), tilt = test::plane(0.577, 0);
  const auto space = test::spaceOf(relief, 100, SurfaceKind::crease_aware);
  double worst = 0;
  for (const double speed : {70.0, 500.0, 1000.0, 2000.0}) {
    const Accuracy a =
        test::slideOver(*space, relief, {.speed_mm_per_s = speed, .ticks = 4000}, {});
    worst = std::max(worst, a.angle_max);
  }
  rows.push_back({"0.07 to 2 m/s, 80 samples per wave: largest angle", "unchanged",
                  decimal(worst, 4) + " deg", worst <= 0.001, "0.000",
                  "equation 0.22 to 0.77 (median)"});
  const auto tilted = test::spaceOf(tilt, 100, SurfaceKind::crease_aware);
  worst = 0;
  for (const double depth : {1.0, 3.0, 10.0, 25.0}) {
    const Accuracy a = test::slideOver(
        *tilted, tilt, {.depth_mm = depth, .speed_mm_per_s = 73, .ticks = 4000}, {});
    worst = std::max(worst, a.position_max_um);
  }
  rows.push_back({"hand 1 to 25 mm deep in a slope of 30 deg: proxy off", "<= 0.1 um",
                  decimal(worst, 3) + " um", worst <= 0.1, "0.05", "equation 294"});
}

void addProfiles(std::vector<FigureRow>& rows) {
  for (const SurfaceKind kind : {SurfaceKind::bilinear, SurfaceKind::crease_aware}) {
    double farthest = 0;
    int events = 0, bad = 0, ticks = 0;
    for (const test::Profile& scene : test::sharpProfiles()) {
      const test::Agreement found = test::compareWithTruth(scene, kind, 12000);
      farthest = std::max(farthest, found.farthest_mm);
      events += found.events;
      bad += found.bad;
      ticks += found.ticks;
    }
    const std::string name = kind == SurfaceKind::crease_aware ? "gated" : "bilinear";
    rows.push_back({name + ": step, roof, groove, pit, fin against the independent solver",
                    "0 events, <= 0.1 % bad ticks, <= 0.1 um",
                    std::to_string(events) + " events, " + decimal(100.0 * bad / ticks, 3) +
                        " % bad, " + decimal(1000 * farthest, 4) + " um",
                    events == 0 && bad <= 0.001 * ticks && farthest <= 1e-4,
                    "bilinear: 0, 0, 0.0; gated: not tried",
                    "CHAI3D 1 event, 5 to 7 um; equation 4 events, 34 to 53 % bad"});
  }
  for (const SurfaceKind kind : {SurfaceKind::crease_aware, SurfaceKind::spline}) {
    int events = 0, bad = 0, ticks = 0;
    constexpr int kScenes = 150;
    for (int seed = 0; seed < kScenes; ++seed) {
      const test::Agreement found = test::compareWithTruth(test::randomProfile(seed), kind, 5000);
      events += found.events;
      bad += found.bad;
      ticks += found.ticks;
    }
    const bool aware = kind == SurfaceKind::crease_aware;
    rows.push_back(
        {std::string(aware ? "gated" : "spline without gate") +
             ": 150 random profiles of walls, ramps and spikes",
         aware ? "0 events" : "-",
         std::to_string(events) + " events, " + decimal(100.0 * bad / ticks, 3) + " % bad",
         !aware || events == 0, "not tried", "-"});
  }
}
}  // namespace

std::vector<FigureRow> accuracyRows() {
  std::vector<FigureRow> rows;
  addWaves(rows);
  addCreases(rows);
  addInvariance(rows);
  addProfiles(rows);
  return rows;
}

}  // namespace relievo
