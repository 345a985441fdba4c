// SPDX-License-Identifier: BSD-3-Clause
// Random ticks with every device's quantum, delay and rate, all settings changed under contact,
// faults, late hands and places that jump, judged from outside: by the inputs, the device's data
// sheet and a second evaluator of the surface, never by what the code under test says of itself.
// 40 000 ticks a device, or as many as RELIEVO_TICKS says, with the seed RELIEVO_SEED.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <limits>
#include <random>

#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/mouse_device.h"
#include "haptics/device/scripted_device.h"
#include "haptics/device/virtual_hand.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/loop/surface_preset.h"
#include "tests/emulator/in_process.h"
#include "tests/haptics/proxy/truth_scenes.h"

namespace relievo {
namespace {

using test::Real;

constexpr std::int64_t kMs = 1'000'000;

double numberFrom(const char* variable, double otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atof(text);
}

/// What lies under the hand at one time.
struct Ground : test::TruthScene {
  /// At a place of the hand, in hand mm.
  Real handHeight(DeviceMm at) const {
    const ViewMm p = space->viewFromDevice(at);
    return static_cast<Real>(space->device_per_view) * height(p.x, p.y) +
           static_cast<Real>(space->device_translation.z);
  }
};

/// Surfaces of every kind whose truth is known, at two scales, some higher than others, with
/// patches that nobody measured.
std::vector<Ground> grounds() {
  using test::Truth;
  std::vector<Ground> all;
  const auto add = [&all](RegionWindow window, SurfaceKind kind, Truth truth) {
    for (std::size_t i = 20'000; i < 30'000; ++i) {
      if (i % 97 < 40) window.origins[i] = CellStatus::interpolated;
    }
    const int detail = static_cast<int>(all.size()) % 4 + 1;
    all.push_back({test::truthScene({}, std::move(window), kind, truth, {detail, 4})});
    all.back().space->device_translation.z += 1.5 * static_cast<double>(all.size() % 3);
    all.back().space->scene_id = all.size();
  };
  add(test::roughWindow(80, 1), SurfaceKind::bilinear, Truth::facets);
  add(test::wavyWindow(80, 2), SurfaceKind::crease_aware, Truth::spline);
  add(test::straightWindow(3), SurfaceKind::crease_aware, Truth::facets);
  add(test::roughWindow(40, 4), SurfaceKind::bilinear, Truth::facets);
  add(test::wavyWindow(40, 5), SurfaceKind::crease_aware, Truth::spline);
  add(test::roughWindow(80, 6), SurfaceKind::spline, Truth::spline);
  return all;
}

/// How a device answers: its data sheet, and how often it has a new place.
struct Model {
  std::string name;
  DeviceInfo info;
  HandImpedance hand;
  double samples_per_s = 0;  ///< 0: one for each tick.
};

std::vector<Model> models() {
  std::vector<Model> all;
  const auto clock = std::make_shared<emulator::TestClock>();
  const falcon::FalconDevice falcon(
      std::make_unique<emulator::InProcessBus>(std::make_shared<emulator::SharedFalcon>(), clock),
      [] { return std::vector<std::uint8_t>{}; });
  for (const HandImpedance& grip : kHandPresets) {
    all.push_back({"falcon_" + std::string(grip.name), falcon.info(), grip, 905});
    all.push_back({"virtual_" + std::string(grip.name),
                   VirtualHand(virtualHandNamed(grip.name)).info(), grip});
  }
  all.push_back({"mouse", MouseDevice().info(), kHandPresets[1]});
  all.push_back({"scripted", ScriptedDevice({DeviceReading{}}, 8).info(), kHandPresets[1]});
  return all;
}

/// A mass in a hand that follows an aim; felt are the device's forces as late as it shows them. It
/// is sampled at the device's own times, in its counts.
class SimulatedHand {
 public:
  explicit SimulatedHand(const Model& model) : model_(model) {}

  void jump(DeviceMm to) {
    position_ = to;
    velocity_ = {};
  }
  void advance(std::int64_t now_ns, DeviceMm aim) {
    const DeviceMm before = position_;
    const auto delay = static_cast<std::size_t>(model_.info.force_delay_ticks);
    const bool felt = model_.info.max_force_n > 0 && under_way_.size() > delay;
    felt_ = felt ? under_way_[delay] : DeviceN{};
    constexpr int kSteps = 10;
    constexpr double kDt = 1e-3 / kSteps, kMassKg = 0.2;
    const HandImpedance& h = model_.hand;
    const double m = kMassKg + h.mass_kg, b = 0.001 + h.damping_n_s_per_mm;
    for (int i = 0; i < kSteps; ++i) {
      const double per_s = 1000 * kDt / m, slow = 1 / (1 + per_s * b);
      const auto axis = [&](double& v, double& x, double f, double a) {
        v = slow * (v + per_s * (f + h.stiffness_n_per_mm * (a - x)));
        x += kDt * v;
      };
      axis(velocity_.x, position_.x, felt_.x, aim.x);
      axis(velocity_.y, position_.y, felt_.y, aim.y);
      axis(velocity_.z, position_.z, felt_.z, aim.z);
    }
    moved_ = position_ - before;
    if (now_ns < next_sample_ns_) return;
    sampled_ = {counted(position_.x), counted(position_.y), counted(position_.z)};
    sampled_ns_ = now_ns;
    if (model_.samples_per_s > 0) {
      next_sample_ns_ = now_ns + static_cast<std::int64_t>(1e9 / model_.samples_per_s);
    }
  }
  void feel(DeviceN force) {
    under_way_.push_front(force);
    if (under_way_.size() > 4) under_way_.pop_back();
  }
  DeviceReading reading() const { return {sampled_, 0, sampled_ns_, DeviceFault::none}; }
  DeviceMm position() const { return position_; }
  /// Of the device on the hand in this tick: N mm.
  double workMj() const { return felt_.x * moved_.x + felt_.y * moved_.y + felt_.z * moved_.z; }

 private:
  double counted(double mm) const {
    const double step = model_.info.position_step_mm;
    return step > 0 ? step * std::round(mm / step) : mm;
  }
  const Model& model_;
  DeviceMm position_{0, 0, 30}, moved_, sampled_;
  DeviceMm velocity_;  // mm/s.
  DeviceN felt_;
  std::deque<DeviceN> under_way_;
  std::int64_t sampled_ns_ = 0, next_sample_ns_ = 0;
};

/// What is sent against what may be sent, from the inputs and the data sheet alone.
class Judge {
 public:
  explicit Judge(const DeviceInfo& info) : info_(info) {}

  /// @param asked  before the device's limits
  void judge(const HapticOptions& asked, const DeviceReading& reading, std::int64_t now_ns,
             const HapticSample& sample) {
    const ForceOptions& o = asked.force;
    if (!o.forces_on) faulty_ = false;
    const DeviceMm p = reading.position;
    const bool somewhere = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    if (reading.fault != DeviceFault::none || !somewhere) faulty_ = true;
    const double age_s = 1e-9 * static_cast<double>(now_ns - reading.time_ns);
    const bool paused = last_ns_ > 0 && now_ns - last_ns_ > 20 * kMs;
    last_ns_ = now_ns;
    const bool stopped = held(asked, reading.buttons, now_ns);
    const bool zero =
        !o.forces_on || faulty_ || paused || stopped || !(o.strength > 0) || !(age_s < 0.020);
    double most_n = std::max(0.0, o.limit_n);
    if (info_.max_force_n > 0) most_n = std::min(most_n, info_.max_force_n);
    if (age_s > 0.010) most_n *= std::max(0.0, (0.020 - age_s) / 0.010);
    double slew = o.contact_slew_n_per_s, rise = o.engage_slew_n_per_s;
    if (info_.max_slew_n_per_s > 0) slew = std::min(slew, info_.max_slew_n_per_s);
    const DeviceN f = sample.force;
    const double size = norm(f);
    ++ticks;
    in_contact += sample.contact ? 1 : 0;
    largest_n = std::max(largest_n, std::isfinite(size) ? size : 1e9);
    if (!(size <= most_n + 1e-9)) ++over_limit;
    if (zero && size > 0) ++not_zero;
    // A cap that comes down takes hold at once; beyond it nothing changes faster than the slew.
    const double last = norm(last_);
    const DeviceN from = last > most_n ? (most_n / last) * last_ : last_;
    const double step = norm(f - from);
    if (!zero) {
      largest_step_n = std::max(largest_step_n, step);
      if (step > 1e-3 * slew + 1e-9) ++over_slew;
      const bool grows = size > norm(from) + 1e-12;
      if (sample.engaged == EngagePhase::rising && grows && step > 1e-3 * rise + 1e-9) ++over_slew;
    }
    forced += size > 0 ? 1 : 0;
    last_ = f;
  }

  std::uint64_t ticks = 0, in_contact = 0, forced = 0;
  std::uint64_t over_limit = 0, not_zero = 0, over_slew = 0;
  double largest_n = 0, largest_step_n = 0;

 private:
  /// Held for 1.5 s, in a press that began while forces were asked for: until they are not.
  bool held(const HapticOptions& asked, std::uint32_t buttons, std::int64_t now_ns) {
    const bool down = (buttons & asked.stop.buttons) != 0;
    if (down && !down_) {
      since_ns_ = now_ns;
      counts_ = asked.force.forces_on;
    }
    down_ = down;
    if (down && counts_ && now_ns - since_ns_ >= 1'500 * kMs) latched_ = true;
    if (!asked.force.forces_on) latched_ = false;
    return latched_;
  }

  const DeviceInfo& info_;
  bool faulty_ = false, down_ = false, counts_ = false, latched_ = false;
  std::int64_t last_ns_ = 0, since_ns_ = 0;
  DeviceN last_;
};

class Draws {
 public:
  explicit Draws(std::uint32_t seed) : random_(seed) {}
  double within(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool once(int in) { return std::uniform_int_distribution<int>(1, in)(random_) == 1; }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  DeviceMm place(double reach_mm) {
    return {within(-reach_mm, reach_mm), within(-reach_mm, reach_mm), within(-reach_mm, reach_mm)};
  }

 private:
  std::mt19937 random_;
};

/// Everything that people, panels and the window can set.
void setAnother(HapticOptions& o, Draws& draws) {
  switch (draws.below(12)) {
    case 0:
      o.force.strength = draws.once(6) ? 0 : draws.within(0, 1);
      break;
    case 1:
      o.stiffness_by_detail = false;
      o.force.stiffness_n_per_mm = std::exp(draws.within(std::log(0.01), std::log(100)));
      break;
    case 2:
      o.stiffness_by_detail = true;
      for (double& k : o.detail_stiffness) k = std::exp(draws.within(std::log(0.05), std::log(3)));
      break;
    case 3:
      o.proxy.static_friction = draws.within(0, kMostFriction);
      o.proxy.dynamic_friction = draws.within(0, 1) * o.proxy.static_friction;
      break;
    case 4:
      o.force.damping_n_s_per_mm = draws.within(0, 0.02);
      break;
    case 5:
    case 6: {
      const SurfacePreset& preset = kSurfacePresets[draws.below(kSurfacePresets.size())];
      if (preset.feel.proxy == ProxyKind::converged) setFeel(o, preset.feel);
      break;
    }
    case 7:
      o.fields = {draws.within(kLeastSoftPart, 1), draws.within(0, kMostTextureMm),
                  draws.within(0, kMostMagnetN), draws.within(kLeastReachMm, kMostReachMm)};
      break;
    case 8:
      o.force.transient.contact_n = draws.within(0, kMostContactN);
      o.force.transient.crossing_n = draws.within(0, kMostCrossingN);
      break;
    case 9:
      o.force.limit_n = draws.within(0.2, 20);
      break;
    case 10:
      o.frame = !o.frame;
      o.cushion = draws.once(2);
      break;
    default:
      o.force.passivity.on = !draws.once(4);
      o.force.oscillation.on = !draws.once(4);
      o.force.contact_slew_n_per_s = draws.once(2) ? 200 : draws.within(100, 5000);
      break;
  }
}

struct Findings {
  std::uint64_t below = 0, unjudged = 0, changes = 0, settings = 0, faults = 0, late = 0, jumps = 0,
                calm = 0;
  Real deepest_mm = 0;
  double gross_mj = 0, net_mj = 0, worst_mj = 0, worst_part = 0;
  std::uint64_t touches = 0;
};

class RandomTicks : public ::testing::TestWithParam<std::size_t> {
 protected:
  static void SetUpTestSuite() {
    std::cout
        << "| device | ticks | in contact | with force | settings changed | surfaces | faults "
           "| late hands | jumps | over limit | not zero | over slew | largest N | largest "
           "step N | below | deepest mm | calm touches | gross mJ | net mJ | worst touch mJ "
           "|\n";
  }
};

/// Wild stretches, in which everything changes, and calm ones, in which a hand touches and lifts
/// off again and again and nothing is changed: over those the surface may give no energy.
TEST_P(RandomTicks, KeepLimitSlewProxyAndEnergy) {
  const std::vector<Model> all_models = models();
  const Model& model = all_models[GetParam()];
  const auto ticks = static_cast<std::uint64_t>(numberFrom("RELIEVO_TICKS", 40'000));
  const auto seed = static_cast<std::uint32_t>(numberFrom("RELIEVO_SEED", 1));
  SCOPED_TRACE(model.name + ", seed " + std::to_string(seed));
  const std::vector<Ground> ground = grounds();
  Draws draws(seed + 1000 * static_cast<std::uint32_t>(GetParam()));
  SimulatedHand hand(model);
  Judge judge(model.info);
  HapticCore core;
  HapticOptions options;
  options.force.forces_on = true;
  std::size_t now = 0, was = 0;
  const bool gradual = model.info.max_force_n > 0;
  Findings found;
  std::int64_t now_ns = 1'000 * kMs;
  DeviceMm aim{0, 0, 20}, centre{0, 0, 2};
  std::uint32_t buttons = 0;
  DeviceFault fault = DeviceFault::none;
  double net_mj = 0, gross_mj = 0;  // Of this touch.
  bool touching = false, whole = false;
  constexpr std::uint64_t kWild = 1500, kStretch = 3500;
  for (std::uint64_t n = 0; n < ticks; ++n) {
    const std::uint64_t at = n % kStretch;
    const bool wild = at < kWild;
    std::int64_t step_ns = kMs;
    std::int64_t late_ns = 0;
    if (at == 0) centre = {draws.within(-20, 20), draws.within(-20, 20), draws.within(-2, 4)};
    if (at == kWild) {  // Calm from here on, and forces on again.
      fault = DeviceFault::none;
      buttons = 0;
      options.force.passivity.on = options.force.oscillation.on = true;
      options.force.contact_slew_n_per_s = 200;
      options.force.limit_n = 6;
      options.force.strength = std::max(0.2, options.force.strength);
      // Nothing is felt in the air, so that a touch begins and ends with no energy stored.
      options.detent.on = options.frame = options.cushion = false;
      options.fields.magnet_n = 0;
      options.force.stiffness_n_per_mm = std::min(options.force.stiffness_n_per_mm, 1.0);
      for (double& k : options.detail_stiffness) k = std::min(k, 0.8);
    }
    const bool mends = at == kWild;
    options.force.forces_on = !mends && !(wild && draws.once(700));
    if (wild) {
      if (draws.once(40)) {
        setAnother(options, draws);
        ++found.settings;
      }
      if (draws.once(400)) {
        options.detent.on = !options.detent.on;
        options.detent.centre = hand.position();
        options.detent.blocked = static_cast<std::uint8_t>(draws.below(16));
      }
      if (draws.once(120)) aim = centre + draws.place(draws.once(5) ? 30 : 8);
      if (draws.once(fault == DeviceFault::none ? 500 : 20)) {
        fault = fault == DeviceFault::none ? static_cast<DeviceFault>(1 + draws.below(6))
                                           : DeviceFault::none;
        ++found.faults;
      }
      if (draws.once(600)) buttons ^= 4U;
      if (draws.once(300)) {
        hand.jump(draws.place(45));
        ++found.jumps;
      }
      if (draws.once(150)) {
        late_ns = static_cast<std::int64_t>(draws.within(0, 45e6));
        ++found.late;
      }
      if (draws.once(200)) step_ns += static_cast<std::int64_t>(draws.within(0, 60e6));
    } else {
      // In and out, along a smooth way; out of contact for a while each time.
      const double t = 1e-3 * static_cast<double>(at - kWild);
      aim = centre + DeviceMm{6 * std::sin(5 * t), 6 * std::cos(3 * t), 9 * std::cos(9 * t) + 3};
    }
    const bool wants_another = wild ? draws.once(250) : at == kWild;
    if (wants_another && !(gradual && core.changing())) {
      was = now;
      now = draws.below(ground.size());
      found.changes += now != was ? 1 : 0;
    }
    now_ns += step_ns;
    hand.advance(now_ns, aim);
    DeviceReading reading = hand.reading();
    reading.time_ns -= late_ns;
    reading.buttons = buttons;
    reading.fault = fault;
    if (wild && draws.once(900)) reading.position.y = std::numeric_limits<double>::quiet_NaN();
    if (wild && draws.once(900)) reading.position.z = -std::numeric_limits<double>::infinity();
    if (wild && draws.once(500)) reading.position = reading.position + draws.place(40);
    const HapticOptions used = withinDevice(options, model.info);
    const HapticSpace& space = *ground[now].space;
    const HapticSample sample = gradual
                                    ? core.tick(space, *ground[was].space, used, reading, now_ns)
                                    : core.tick(space, used, reading, now_ns);
    hand.feel(sample.force);
    judge.judge(options, reading, now_ns, sample);

    // Between two surfaces the proxy is nowhere below the lower of both. A free proxy is told to be
    // where the hand is; beside the window, where the hand has a frame under it and no surface,
    // that says nothing.
    const DeviceMm first = space.deviceFromGrid({0, 0, 0});
    const DeviceMm last = space.deviceFromGrid({kWindowSamples - 1, kWindowSamples - 1, 0});
    const DeviceMm p = sample.proxy;
    const bool beside = std::min({p.x - first.x, last.x - p.x, p.y - first.y, last.y - p.y}) <
                        SceneFrame::kRoundingMm;
    const bool judged = sample.contact || !used.frame || !beside;
    Real lowest = ground[now].handHeight(p);
    if (core.changing()) lowest = std::min(lowest, ground[was].handHeight(p));
    const Real below_mm = judged ? lowest - static_cast<Real>(p.z) : 0;
    if (isFinite(p)) found.deepest_mm = std::max(found.deepest_mm, below_mm);
    if (!isFinite(p) || below_mm > 1e-6L) ++found.below;
    found.unjudged += judged ? 0 : 1;

    // A touch that began and ends free in one calm stretch, after the changes have come.
    const bool calm = !wild && !core.changing() && sample.engaged == EngagePhase::on;
    if (!calm) whole = false;
    const bool free = sample.force == DeviceN{};
    if (calm && free) {
      if (touching && whole) {
        ++found.touches;
        found.net_mj += net_mj;
        found.gross_mj += gross_mj;
        found.worst_mj = std::max(found.worst_mj, net_mj);
      }
      net_mj = gross_mj = 0;
      whole = true;
      touching = false;
    }
    touching = touching || !free;
    net_mj += hand.workMj();
    gross_mj += std::abs(hand.workMj());
    found.calm += calm ? 1 : 0;
  }
  std::cout << "| " << model.name << " | " << judge.ticks << " | " << judge.in_contact << " | "
            << judge.forced << " | " << found.settings << " | " << found.changes << " | "
            << found.faults << " | " << found.late << " | " << found.jumps << " | "
            << judge.over_limit << " | " << judge.not_zero << " | " << judge.over_slew << " | "
            << judge.largest_n << " | " << judge.largest_step_n << " | " << found.below << " | "
            << static_cast<double>(found.deepest_mm) << " | " << found.touches << " | "
            << found.gross_mj << " | " << found.net_mj << " | " << found.worst_mj << " |\n";
  EXPECT_EQ(judge.over_limit, 0U) << judge.largest_n << " N";
  EXPECT_EQ(judge.not_zero, 0U);
  EXPECT_EQ(judge.over_slew, 0U) << judge.largest_step_n << " N";
  EXPECT_EQ(found.below, 0U) << static_cast<double>(found.deepest_mm) << " mm";
  EXPECT_LT(found.unjudged, ticks / 10);
  EXPECT_GT(judge.in_contact, ticks / 10);
  EXPECT_GT(found.settings, ticks / 200);
  if (gradual) {
    EXPECT_GT(found.touches, ticks / 10'000);
    EXPECT_LE(found.net_mj, 0.0002 * found.gross_mj);
    // Of one touch: what counts and delay give before the passivity stage has taken it back.
    EXPECT_LE(found.worst_mj, 0.2);
  }
}
INSTANTIATE_TEST_SUITE_P(Devices, RandomTicks, ::testing::Range<std::size_t>(0, models().size()),
                         [](const auto& which) { return models()[which.param].name; });

}  // namespace
}  // namespace relievo
