// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/haptic_core.h"

#include <algorithm>
#include <cmath>

#include "core/region/hand.h"
#include "haptics/proxy/blend.h"
#include "haptics/proxy/surface.h"

namespace relievo {

namespace {
// A hand a thousand kilometres away is a broken reading, and its square must stay a number.
constexpr double kFarthestHandMm = 1e9;

bool isPlace(DeviceMm p) RELIEVO_REALTIME {
  return isFinite(p) && std::abs(p.x) <= kFarthestHandMm && std::abs(p.y) <= kFarthestHandMm &&
         std::abs(p.z) <= kFarthestHandMm;
}
}  // namespace

void HapticCore::reset() RELIEVO_REALTIME {
  placed_ = false;
  speed_.forget();
  soft_ = {};
  force_ = {};
  stop_ = {};
  guide_ = {};
  guided_ = false;
  settings_.reset();
  rate_.reset();
  slow_ = {};
  felt_now_ = {};
  fault_ = DeviceFault::none;
  resume_ = false;
}

bool HapticCore::pausedUntil(std::int64_t now_ns) const RELIEVO_REALTIME {
  return resume_ || (placed_ && now_ns - last_ns_ > kPauseNs);
}

/// E306: at a lower rate the same surface would begin to swing.
void HapticCore::keepSteady(const HapticOptions& asked, int detail,
                            DetailStiffness& k) RELIEVO_REALTIME {
  slow_ = {};
  const bool known = asked.bound_by_rate && asked.timing.rate_hz > 0;
  if (!known || !(rate_.slowHz() > 0)) return;
  DeviceTiming timing = asked.timing;
  timing.rate_hz = std::min(timing.rate_hz, rate_.slowHz());
  const double most = kStabilityMargin * stableStiffness(timing);
  const double before = stiffnessForDetail(detail, k);
  for (double& each : k) each = std::min(each, most);
  const double after = stiffnessForDetail(detail, k);
  if (after < before) slow_ = {rate_.slowHz(), before, after};
}

HapticOptions HapticCore::settled(HapticOptions asked, int detail) RELIEVO_REALTIME {
  if (chain_ == ForceChain::bare) return asked;
  FeltSettings wanted{.strength = asked.force.strength,
                      .stiffness_n_per_mm = asked.detail_stiffness,
                      .damping_n_s_per_mm = asked.force.damping_n_s_per_mm,
                      .lift_n = asked.force.lift_n,
                      .static_friction = asked.proxy.static_friction,
                      .dynamic_friction = asked.proxy.dynamic_friction,
                      .fields = asked.fields};
  if (!asked.stiffness_by_detail) {
    wanted.stiffness_n_per_mm.fill(asked.force.stiffness_n_per_mm);
  }
  keepSteady(asked, detail, wanted.stiffness_n_per_mm);
  const FeltSettings now = settings_.toward(wanted, felt_now_, change_.running());
  asked.force.strength = now.strength;
  asked.detail_stiffness = now.stiffness_n_per_mm;
  asked.stiffness_by_detail = true;
  asked.force.damping_n_s_per_mm = now.damping_n_s_per_mm;
  asked.force.lift_n = now.lift_n;
  asked.proxy.static_friction = now.static_friction;
  asked.proxy.dynamic_friction = now.dynamic_friction;
  asked.fields = now.fields;
  return asked;
}

FeltSpring HapticCore::feltSpring(const HapticOptions& options) const RELIEVO_REALTIME {
  if (chain_ == ForceChain::bare) return {.pull_n = options.fields.magnet_n};
  if (options.detent.on || guided_) return {.gain = 0};
  return {.gain = options.force.strength * force_.rise,
          .limit_n = options.force.limit_n,
          .pull_n = options.fields.magnet_n};
}

namespace {
/// Where the spring stops growing, before strength and rise make it weaker.
double feltLimitN(const ForceOptions& options, double rise) RELIEVO_REALTIME {
  const double gain = options.strength * rise;
  return gain > 0 ? options.limit_n / gain : options.limit_n;
}
}  // namespace

DeviceFault HapticCore::latch(const HapticOptions& options,
                              const DeviceReading& reading) RELIEVO_REALTIME {
  if (!options.force.forces_on) fault_ = DeviceFault::none;
  if (reading.fault != DeviceFault::none) {
    fault_ = reading.fault;
  } else if (!isPlace(reading.position)) {
    fault_ = DeviceFault::not_finite;
  } else {
    hip_ = reading.position;
  }
  return fault_;
}

double HapticCore::stiffness(const HapticSpace& space,
                             const HapticOptions& options) const RELIEVO_REALTIME {
  if (!options.stiffness_by_detail) return options.force.stiffness_n_per_mm;
  return change_.running() ? change_.stiffness()
                           : stiffnessForDetail(space.detail, options.detail_stiffness);
}

Fields HapticCore::fields(const HapticSpace& space, const HapticSpace* previous, GridPoint held,
                          double k, const HapticOptions& options) const RELIEVO_REALTIME {
  const Fields now = fieldsAt(space, proxy_, held, k, options.proxy, options.fields);
  if (!change_.running() || previous == nullptr) return now;
  const GridFromGrid was_from_now = gridFromGrid(*previous, space);
  ProxyState was = proxy_;
  was.position = was_from_now(proxy_.position);
  was.hip = was_from_now(proxy_.hip);
  return blended(fieldsAt(*previous, was, was_from_now(held), k, options.proxy, options.fields),
                 now, change_.weight());
}

Fields HapticCore::yielding(const HapticSpace& space, Fields felt, GridPoint held, double k,
                            const HapticOptions& options) RELIEVO_REALTIME {
  const double softest = options.fields.softest_part;
  if (!(softest < 1) || space.firm_everywhere || !proxy_.contact || options.detent.on || guided_) {
    soft_ = {};
    return felt;
  }
  if (change_.running()) {  // The surface pays.
    soft_.watched = false;
  } else {
    const GridPoint way = space.deviceMmPerCell() * (proxy_.position - held);
    const DeviceMm out{way.x, way.y, way.z};
    const DeviceMm aside = (1 / k) * DeviceMm{felt.soft.x, felt.soft.y, felt.soft.z};
    DeviceMm pull = felt.part * out + aside;
    pull = {hand_.along_x * pull.x, hand_.along_y * pull.y, pull.z};
    soft_ = yielded(soft_, {0.5 * felt.part * dot(out, out), pull, hip_, softest / felt.part});
  }
  felt.force = felt.force - (1 - soft_.share) * felt.soft;
  felt.part *= soft_.share;
  return felt;
}

void HapticCore::placeHand(const HapticSpace& space,
                           const HapticOptions& options) RELIEVO_REALTIME {
  const GridPoint hand = space.gridFromDevice(hip_);
  hand_ = options.frame ? SceneFrame::framed(space, hand) : FramedHand{.place = hand};
}

// As high as a hand hovers over what is shown, so that a replay finds the hand that was lifted
// above the surface already.
void HapticCore::liftHand(const HapticSpace& space, const HapticOptions& options) RELIEVO_REALTIME {
  const GridPoint p = hand_.place;
  const double surface = surfaceHeight(space, p.x, p.y);
  if (p.z >= surface) return;
  hip_.z = space.deviceFromGrid({p.x, p.y, surface}).z + kHoverMm;
  placeHand(space, options);
}

SurfaceLift HapticCore::follow(const HapticSpace& space, const HapticSpace* previous,
                               const HapticOptions& options, bool hovers) RELIEVO_REALTIME {
  placeHand(space, options);
  if (hovers) {
    liftHand(space, options);
    speed_.forget();  // Its way through the air is no speed of pressing in.
  }
  const GridPoint hip = hand_.place;
  const bool is_new = !placed_ || !isFelt(space);
  const bool from_previous =
      is_new && placed_ && previous != nullptr && isFelt(*previous) && !hovers;
  if (from_previous) {
    const double fixed = options.force.stiffness_n_per_mm;
    SpringChange spring{fixed, fixed};
    if (options.stiffness_by_detail) {
      spring = {stiffnessForDetail(previous->detail, options.detail_stiffness),
                stiffnessForDetail(space.detail, options.detail_stiffness)};
    }
    spring.softest_part = options.fields.softest_part;
    proxy_ = change_.begin(*previous, space, proxy_, spring);
  } else if (is_new) {
    proxy_ = proxyPlace(space, hip);
    force_ = refade(force_);
    change_.stop();
  }
  felt_ = {space.window_id, space.scene_id, space.surface, felt_.grip};
  placed_ = true;
  if (hovers) {
    proxy_ = {hip, hip, false, false};
    change_.stop();
  } else if (change_.running() && previous != nullptr) {
    return change_.follow(*previous, space, proxy_, hip, options.proxy, feltSpring(options));
  } else if (!is_new) {
    proxy_ = proxyTick(space, proxy_, hip, options.proxy);
  }
  return {};
}

HapticSample HapticCore::describeTick(const HapticSpace& space,
                                      const HapticSpace* previous) const RELIEVO_REALTIME {
  HapticSample sample;
  sample.window_id = space.window_id;
  sample.scene_id = space.scene_id;
  sample.detail = space.detail;
  sample.hip = hip_;
  sample.hip_view = space.viewFromDevice(hip_);
  sample.contact = proxy_.contact;
  if (proxy_.position == proxy_.hip) {  // Free: the same place, to the last bit.
    sample.proxy = sample.hip;
    sample.proxy_view = sample.hip_view;
  } else {
    sample.proxy_view = space.viewFromGrid(proxy_.position);
    sample.proxy = space.deviceFromView(sample.proxy_view);
  }
  sample.normal = change_.running() && previous != nullptr
                      ? change_.normal(*previous, space, proxy_)
                      : proxyNormal(space, proxy_);
  sample.origin = space.originAt(proxy_.position);
  return sample;
}

// With V(h) = spring(c(h)) + cushion(h), c the framed place: the slope over the hand is the slope
// over the place times dc/dh.
void HapticCore::throughFrame(const HapticSpace& space, const HapticOptions& options, Fields& felt,
                              ForceInput& input) const RELIEVO_REALTIME {
  if (!hand_.whole()) {
    const DeviceMm out = input.proxy - space.deviceFromGrid(hand_.place);
    input.spring_mm = norm(out);
    input.hip = input.proxy - DeviceMm{hand_.along_x * out.x, hand_.along_y * out.y, out.z};
    felt.force = {hand_.along_x * felt.force.x, hand_.along_y * felt.force.y, felt.force.z};
  }
  if (!options.frame && !options.cushion) return;
  const Cushion cushion = SceneFrame::cushion(space, options.workspace, hip_, options.frame);
  felt.force = felt.force + cushion.force;
  felt.energy_mj += cushion.energy_mj;
}

namespace {
/// What pulls at the hand in place of the surface.
ForceInput pulled(DeviceMm hip, DeviceN pull, const ForceInput& input,
                  const ForceOptions& options) RELIEVO_REALTIME {
  ForceInput by_pull;
  by_pull.hip = hip;
  // The spring's force from there is the pull.
  by_pull.proxy = hip + (1 / options.stiffness_n_per_mm) * DeviceMm{pull.x, pull.y, pull.z};
  by_pull.contact = true;
  by_pull.velocity = input.velocity;
  by_pull.moved = input.moved;
  by_pull.fault = input.fault;
  by_pull.resumed = input.resumed;
  by_pull.age_s = input.age_s;
  return by_pull;
}
}  // namespace

ForceInput HapticCore::throughDetent(const MoveDetent& detent, const ForceInput& input,
                                     ForceOptions& options) const RELIEVO_REALTIME {
  // A detent is softer than any surface and its own potential: no spring's energy to watch.
  options.passivity.on = false;
  options.damping_n_s_per_mm = 0;
  return pulled(hip_, detentForce(detent, hip_), input, options);
}

GuideInput HapticCore::guideInput(const HapticOptions& options, const ForceInput& input,
                                  std::uint32_t buttons,
                                  const ForceOptions& force) const RELIEVO_REALTIME {
  const double most_n = std::min(GuideLaw::kMostN, force.limit_n);
  const double step_n = force.contact_slew_n_per_s * input.dt_s;
  return {.hand = hip_,
          .velocity = input.velocity,
          .buttons = buttons & ~kHoverBit,
          .scene_id = felt_.scene_id,
          .forces_on = force.forces_on && !input.fault,
          .in_detent = options.detent.on,
          .rise = force_.rise * force_.oscillation.factor,
          .sent_most_n = std::min(most_n, norm(force_.last) + step_n),
          .dt_s = input.dt_s};
}

// Strength is for surfaces, as throughGuide() says.
void HapticCore::pullBack(const HapticOptions& options, GuideInput guide, double strength,
                          ForceInput& input) RELIEVO_REALTIME {
  guide.in_detent = guide.in_detent || guided_;
  const BeaconStep step = pulledBack(options.beacon, guide, cues_.beacon);
  cues_.beacon = step.state;
  if (!(strength > 0) || guide.in_detent) return;
  const double part = 1 / strength;
  input.fields = input.fields + part * step.force;
  input.fields_mj += part * step.energy_mj;
  input.given_mj += part * step.given_mj;
}

void HapticCore::tapHand(const HapticOptions& options, GuideInput guide, double strength,
                         ForceInput& input) RELIEVO_REALTIME {
  guide.in_detent = guide.in_detent || guided_;
  const TapStep step = tapped(options.taps, guide, cues_.taps);
  cues_.taps = step.state;
  if (!(strength > 0) || guide.in_detent) return;
  const double part = 1 / strength;
  input.fields = input.fields + part * step.force;
  input.fields_mj += part * step.energy_mj;
  input.given_mj += part * step.given_mj;
}

GuideStep HapticCore::lead(const HapticOptions& options, const GuidePath* path,
                           const GuideInput& guide) RELIEVO_REALTIME {
  const GuideStep step = guided(options.guide, path, guide, guide_);
  guide_ = step.state;
  if (step.on != guided_) force_ = refade(force_);
  // A target that moves gives energy and takes none back: nothing is owed for it (checkGuide()
  // counts its power).
  if (step.on) force_.passivity = rebased(force_.passivity);
  guided_ = step.on;
  return step;
}

// Strength is for surfaces: what leads arrives as it is, and strength 0 is still zero.
ForceInput HapticCore::throughGuide(const GuideStep& step, const ForceInput& input,
                                    ForceOptions& options) const RELIEVO_REALTIME {
  options.passivity.on = false;
  options.damping_n_s_per_mm = 0;
  options.transient = {};
  options.limit_n = std::min(options.limit_n, GuideLaw::kMostN);
  const double strength = options.strength;
  // Softened as a surface is, if hand and guide began to swing.
  const double part = strength > 0 ? force_.oscillation.factor / strength : 0;
  const DeviceN pull = part * step.force;
  return pulled(hip_, pull, input, options);
}

void HapticCore::check(const ForceOptions& options, const ForceInput& input, bool paused,
                       DeviceN before, DeviceN sent) RELIEVO_REALTIME {
  if (chain_ == ForceChain::bare) return;
  const bool engaged = force_.phase == EngagePhase::rising || force_.phase == EngagePhase::on;
  ForceBounds bounds;
  bounds.zero = paused || !options.forces_on || input.fault || !engaged ||
                !(options.strength > 0) || !(input.age_s < options.stale_zero_s);
  bounds.most_n = std::max(0.0, options.limit_n);
  if (input.age_s > options.stale_after_s) {
    const double fading_s = options.stale_zero_s - options.stale_after_s;
    const double faded = (input.age_s - options.stale_after_s) / fading_s;
    bounds.most_n *= std::max(0.0, 1 - faded);
  }
  bounds.most_step_n = options.contact_slew_n_per_s * input.dt_s;
  audit_ = audited(audit_, bounds, before, sent);
}

void HapticCore::checkGuide(const GuideStep& step, const ForceOptions& options,
                            DeviceN sent) RELIEVO_REALTIME {
  if (chain_ == ForceChain::bare) return;
  const DeviceN lift = liftOf(options, force_.rise);  // Holds the grip, and leads nowhere.
  const DeviceN led = sent == DeviceN{} ? sent : sent - lift;
  const DeviceMm u = step.direction;
  const double along_n = led.x * u.x + led.y * u.y + led.z * u.z;
  audit_ = auditedGuide(audit_, {}, sent, along_n * guide_.speed_mm_per_s);
}

HapticSample HapticCore::tick(const HapticSpace& space, const HapticOptions& options,
                              const DeviceReading& reading, std::int64_t now_ns,
                              const GuidePath* path) RELIEVO_REALTIME {
  return tickOn(space, nullptr, options, reading, now_ns, path);
}

HapticSample HapticCore::tick(const HapticSpace& space, const HapticSpace& previous,
                              const HapticOptions& options, const DeviceReading& reading,
                              std::int64_t now_ns, const GuidePath* path) RELIEVO_REALTIME {
  return tickOn(space, &previous, options, reading, now_ns, path);
}

HapticSample HapticCore::tickOn(const HapticSpace& space, const HapticSpace* previous,
                                const HapticOptions& asked, const DeviceReading& reading,
                                std::int64_t now_ns, const GuidePath* path) RELIEVO_REALTIME {
  // The hand is elsewhere at once, though nobody moved: nothing of before is true of it.
  if (asked.grip != felt_.grip && tick_ > 0) reset();
  felt_.grip = asked.grip;
  rate_.tick(now_ns, reading.time_ns);
  const HapticOptions options = settled(asked, space.detail);
  const DeviceFault fault = latch(options, reading);
  const bool paused = pausedUntil(now_ns);
  if (paused) force_ = resumed(force_);
  resume_ = false;
  last_ns_ = now_ns;
  if (options.detent.on != in_detent_)
    force_ = refade(force_);  // What was felt goes, what comes rises.
  in_detent_ = options.detent.on;
  const SurfaceLift lift = follow(space, previous, options, (reading.buttons & kHoverBit) != 0);

  HapticSample sample = describeTick(space, previous);
  sample.tick = tick_++;
  sample.time_ns = now_ns;
  sample.buttons = reading.buttons;
  sample.fault = fault;

  ForceInput input;
  input.proxy = sample.proxy;
  input.hip = sample.hip;
  const GridPoint held = proxy_.hip;
  if (options.frame) {
    sample.frame = frame_.push(space, space.gridFromDevice(hip_), sample.contact);
  }
  ForceOptions force_options = stop_.applied(options.force, options.stop, reading.buttons, now_ns);
  const double firm = stiffness(space, options) * force_.oscillation.factor;
  Fields felt = yielding(space, fields(space, previous, held, firm, options), held, firm, options);
  force_options.stiffness_n_per_mm = felt.part * firm;
  throughFrame(space, options, felt, input);
  input.fields = felt.force;
  input.fields_mj = felt.energy_mj;
  input.given_mj =
      lift.givenMj(force_options.stiffness_n_per_mm, feltLimitN(force_options, force_.rise));
  input.measured = sample.origin == CellStatus::measured || sample.origin == CellStatus::steep;
  input.normal = {sample.normal.x, sample.normal.y, sample.normal.z};
  speed_.measure(hip_, reading.time_ns, input);
  input.contact = sample.contact;
  input.fault = fault != DeviceFault::none;
  input.resumed = paused;
  input.age_s = 1e-9 * static_cast<double>(now_ns - reading.time_ns);
  const GuideInput hand = guideInput(options, input, reading.buttons, force_options);
  const GuideStep guide = lead(options, path, hand);
  pullBack(options, hand, force_options.strength, input);
  tapHand(options, hand, force_options.strength, input);
  if (options.detent.on) input = throughDetent(options.detent, input, force_options);
  if (guide.on) input = throughGuide(guide, input, force_options);
  const DeviceN before = force_.last;
  const ForceResult result = chain_ == ForceChain::bare ? bareForce(force_options, input, force_)
                                                        : force(force_options, input, force_);
  force_ = result.state;
  check(force_options, input, paused, before, result.force);
  if (guide.on) checkGuide(guide, force_options, result.force);
  sample.force = result.force;
  sample.f_cmd_n = result.command_n;
  sample.clamped = result.limited;
  sample.limit_n = result.limit_n;
  sample.damped_n = norm(result.damped);
  sample.margin_mj = force_.passivity.margin_mj;
  sample.resumed = paused;
  sample.age_s = input.age_s;
  sample.softened = force_.oscillation.softened;
  sample.stiffness_n_per_mm = force_options.stiffness_n_per_mm;
  sample.firm_stiffness_n_per_mm = firm;
  sample.options_id = options.id;
  felt_now_ = {.detail = space.detail,
               .depth_mm = sample.contact ? norm(input.proxy - input.hip) : 0,
               .speed_mm_per_s = norm(input.velocity),
               .rise = force_.rise};
  sample.engaged = force_.phase;
  sample.stopped = stop_.reason();
  sample.guide = guide_.phase;
  sample.guide_end = guide_.end;
  sample.guide_path = guide_.path;
  sample.beacon = cues_.beacon.id;
  sample.beacon_end = cues_.beacon.end;
  sample.pulled_back = cues_.beacon.pulls;
  sample.taps = cues_.taps.id;
  sample.tapped = cues_.taps.left > 0;
  if (sample.engaged != EngagePhase::off) sample.slow = slow_;
  sample.change = change_.running() ? change_.weight() : 1;
  return sample;
}

}  // namespace relievo
