// SPDX-License-Identifier: BSD-3-Clause
// Running: question and answer, homing, force, and what is done when answers stay away.
#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/device/falcon/link/link.h"

namespace relievo::falcon {

namespace {
constexpr std::int64_t kMs = 1'000'000;
/// While no loop asks: the chip's longest latency and a question now and then, so that nobody is
/// woken for nothing; a look ten times a second whether the loop asks again.
constexpr std::int64_t kRestAfterNs = 1000 * kMs, kRestNs = 500 * kMs, kRestLookNs = 100 * kMs;
constexpr std::int64_t kRestPatienceNs = 2 * kRestNs;
constexpr std::uint8_t kRestLatencyMs = 255;
constexpr int kMostFailedReads = 3;              // In a row; then it is opened anew.
constexpr std::int64_t kHealthyNs = 2000 * kMs;  // So long: failures before it are over.
constexpr int kPurgeEvery = 25, kGiveUp = 100;   // Measures of 20 ms: 500 ms, 2 s.
}  // namespace

Link::Leave Link::operate(const std::stop_token& stop) {
  std::int64_t now = bus_.now();
  operates_since_ns_ = now;
  force_ramp_.shut(now);
  std::uint64_t malformed_seen = reader_.malformed();
  times_.restart(now, status_);
  silence_ = {};
  silence_.restart(now);
  homing_.restart();
  resting_ = false;
  gate_.reset();
  status_.homed = 0;
  forgetButtons();
  jacobian_.reset();
  setState(LinkState::homing);
  std::array<std::uint8_t, 512> bytes{};
  if (!ask(now, true)) return Leave::gone;
  while (!stop.stop_requested()) {
    // At least now and then to the stop token, whatever the clock did.
    const Port::Incoming in = port_->read(
        bytes, resting_ ? now + kRestLookNs : std::clamp(silentAt(), now, now + 50 * kMs));
    lost_ = in.result == PortResult::gone ? in.result : lost_;
    if (lost_ != PortResult::ok) return Leave::gone;
    now = bus_.now();
    if (in.result == PortResult::failed) {
      if (!takeFailure(now)) return Leave::gone;
      continue;
    }
    if (const std::int64_t slept = bus_.slept(); slept != slept_) {
      slept_ = slept;
      forgetButtons();
      interrupt(DeviceFault::timeout, now);
    }
    if (in.bytes > 0 && wasPaused(now)) {
      if (!takePause(now)) return Leave::gone;
      continue;
    }
    if (in.damaged) takeDamage(now);
    for (std::size_t i = 0; i < in.bytes; ++i) {
      if (const auto report = reader_.take(bytes[i])) takeReport(*report, now);
    }
    if (reader_.malformed() != malformed_seen) {
      malformed_seen = reader_.malformed();
      zero_next_ = true;
      force_ramp_.shut(now);
    }
    const bool wanted = isWanted(now);
    measureAnewIfAsked();
    if (wanted && resting_) wake();
    if (silence_.isUnderWay()) {
      if (now < silentAt()) continue;
      if (const auto leave = watch(now)) return *leave;
    } else if (!wanted && !resting_) {
      if (!rest(now)) return Leave::gone;
    } else if (!resting_ || now - silence_.askedNs() >= kRestNs) {
      if (!ask(bus_.now(), false)) return Leave::gone;
    }
  }
  return Leave::stopped;
}

/// 20 ms without an answer are a stall, which watch() notices in time. Unless this thread itself
/// did not run: it was halted, or the processor was not its own. The loop may step as slowly as it
/// likes: only answers count, and they come by themselves.
bool Link::wasPaused(std::int64_t now_ns) const {
  return !resting_ && silence_.step() <= Silence::kStall &&
         now_ns - silence_.lastAnswerNs() >= Silence::measureAfter(Silence::kStall);
}

/// What came meanwhile tells where the hand was. Zero first; the answer to it has the new place,
/// and only forces that are made from that one are shown, rising from zero.
bool Link::takePause(std::int64_t now_ns) {
  ++status_.counts.hiccups;
  ++reading_.epoch;  // The loop learns it with the new place.
  port_->discardInput();
  reader_.reset();
  silence_.restart(now_ns);
  return ask(now_ns, true);
}

/// A read that broke off: zero at once, and on. The answer may be lost, or come all the same.
/// @return false: it goes on failing
bool Link::takeFailure(std::int64_t now_ns) {
  ++status_.counts.failed_reads;
  zero_next_ = true;
  force_ramp_.shut(now_ns);
  const int failed = silence_.failRead();
  if (failed > kMostFailedReads) lost_ = PortResult::failed;
  if (failed > 1) return lost_ == PortResult::ok;
  if (!ask(now_ns, true)) return false;
  silence_.askedAgain(silence_.underWay() > 1);
  return true;
}

/// The bridge chip tells of bytes that are missing or altered: what came is of no use, and the
/// answer is lost. Zero with the next question.
void Link::takeDamage(std::int64_t now_ns) {
  reader_.reset();
  zero_next_ = true;
  force_ramp_.shut(now_ns);
}

void Link::takeReport(const Report& report, std::int64_t now_ns) {
  silence_.answer();
  times_.count({.now_ns = now_ns,
                .gap_ns = now_ns - silence_.lastAnswerNs(),
                .asked_ns = silence_.askedNs(),
                .at_rest = resting_ || silence_.askedAtRest()},
               status_);
  if (status_.state == LinkState::silent) setState(LinkState::homing);
  silence_.heard(now_ns);
  if (now_ns - operates_since_ns_ > kHealthyNs) status_.failed_openings = 0;
  if (!follow(report, now_ns)) return;
  status_.homed = report.homed;
  status_.encoders = report.encoders;
  const LinkState state = homing_.after(status_.state, report.homed, reading_.position.z);
  if (state != status_.state) setState(state);
  reading_.buttons = buttons_.take(report.buttons);
  const bool ready = status_.state == LinkState::ready;
  if (ready) reading_.fault = DeviceFault::none;
  status_.position = reading_.position;
  status_.buttons = reading_.buttons;
  publishReading(now_ns);
  if (now_ns - published_ns_ > 20 * kMs) {
    published_ns_ = now_ns;
    status_.homing_is_long = status_.state == LinkState::homing && homing_.isLong(now_ns);
    publishStatus();
  }
}

/// @return false: the hand cannot be there; nothing of this answer is believed, what is felt stays,
/// and if it goes on, the line is at fault
bool Link::follow(const Report& report, std::int64_t now_ns) {
  const Angles angles = anglesFromEncoders(report.encoders);
  const std::optional<BaseMm> grip = gripFromAngles(angles);
  if (!grip) {
    jacobian_.reset();
    ++status_.counts.impossible_poses;  // The last pose stays, without force.
    zero_next_ = true;
    return true;
  }
  const DeviceMm place = deviceFromBase(*grip);
  // Where no force is shown places may jump: encoders begin anywhere until an arm is homed.
  const bool believed = status_.state != LinkState::ready || report.homed != kAllHomed ||
                        reading_.fault != DeviceFault::none;
  if (believed) gate_.reset();
  if (!gate_.takes(place, {silence_.askedNs(), now_ns})) {
    ++status_.counts.held_poses;
    if (gate_.held() > PoseGate::kMostHeld) {
      gate_.reset();
      interrupt(DeviceFault::protocol, now_ns);
    }
    return false;
  }
  reading_.position = place;
  jacobian_ = angleJacobian(*grip, angles);
  return true;
}

/// After more than a short interruption nobody knows what was done with them meanwhile.
void Link::forgetButtons() {
  buttons_.forget();
  reading_.buttons = status_.buttons = buttons_.down();
}

void Link::measureAnewIfAsked() {
  const std::uint32_t asked = mailbox_.commands.front().measurements;
  if (std::exchange(seen_.measurements, asked) == asked) return;
  times_.measureAnew(status_);
}

std::int64_t Link::silentAt() const {
  return silence_.lastAnswerNs() + (resting_ ? kRestPatienceNs : 0) +
         Silence::measureAfter(silence_.step());
}

std::optional<Link::Leave> Link::watch(std::int64_t now_ns) {
  const int step = silence_.nextMeasure(now_ns);
  zero_next_ = true;
  force_ramp_.shut(now_ns);
  if (step < Silence::kStall) {
    ++status_.counts.hiccups;
  } else {
    if (step == Silence::kStall) ++status_.counts.stalls;
    interrupt(DeviceFault::timeout, now_ns);
    port_->discardInput();  // Too late to tell where the hand is.
    reader_.reset();
  }
  const int stalled = step - Silence::kStall + 1;
  if (stalled >= kGiveUp) return Leave::silent;
  if (stalled > 0 && stalled % kPurgeEvery == 0) {
    ++status_.counts.purges;
    status_.failed_openings = 0;  // Another trouble.
    forgetButtons();
    setState(LinkState::silent);
    if (!requestAll({kPurge1, kPurge2})) return Leave::gone;
    port_->discardInput();
    reader_.reset();
  }
  if (!ask(now_ns, true)) return Leave::gone;
  silence_.askedAgain(step == 0 && !silence_.isDoubtful());  // The first time it may only be late.
  return std::nullopt;
}

bool Link::ask(std::int64_t now_ns, bool neutral) {
  Command command;
  command.lights = lights(now_ns);
  if (!neutral && wasPaused(now_ns)) {  // Since the answer, that is: its place is old.
    ++reading_.epoch;
    zero_next_ = true;
  }
  if (neutral || zero_next_) {
    force_ramp_.shut(now_ns);
  } else {
    command.motors = motorCounts(now_ns);
  }
  zero_next_ = false;
  if (write(encode(command)) == PortResult::gone) return false;
  // What the device did not take counts as under way: silence is noticed, and zero sent.
  silence_.ask(now_ns, resting_);
  return true;
}

std::array<std::int16_t, kArms> Link::motorCounts(std::int64_t now_ns) {
  mailbox_.orders.update();
  std::optional<DeviceN> force;
  if (status_.state == LinkState::ready && jacobian_) {
    force =
        force_ramp_.shown(mailbox_.orders.front(), mailbox_.cuts.load(), reading_.epoch, now_ns);
  }
  if (!force) force_ramp_.shut(now_ns);
  if (!force || norm(*force) == 0) return {};
  const std::optional<Torques> torques = torquesForForce(*jacobian_, *force);
  if (!torques) return {};
  mailbox_.commands.update();
  force_ns_ = now_ns;
  return countsForTorques(*torques, mailbox_.commands.front().counts_per_n_mm);
}

std::uint8_t Link::lights(std::int64_t now_ns) const {
  const LinkCommand& wish = mailbox_.commands.front();
  if (wish.show_lights) return wish.lights;
  if (status_.state == LinkState::pull_out) return blue;
  if (status_.state != LinkState::ready || reading_.fault != DeviceFault::none) return red;
  constexpr std::int64_t kGreenNs = 2000 * kMs;
  return force_ns_ != 0 && now_ns - force_ns_ < kGreenNs ? green : blue;
}

bool Link::isWanted(std::int64_t now_ns) {
  mailbox_.orders.update();
  mailbox_.commands.update();
  return now_ns - mailbox_.orders.front().time_ns < kRestAfterNs ||
         mailbox_.commands.front().show_lights || status_.state != LinkState::ready;
}

void Link::wake() {
  request(latencyTimer(1));
  resting_ = false;
  zero_next_ = true;  // The place that is known is as old as the rest.
  silence_.wake(bus_.now());
  times_.restart(silence_.lastAnswerNs(), status_);
}

bool Link::rest(std::int64_t now_ns) {
  resting_ = true;
  const bool asked = ask(now_ns, true);  // Whatever the motors showed, they rest as well.
  request(latencyTimer(kRestLatencyMs));
  return asked;
}

void Link::sendNeutralFrame(const Frame& frame) {
  // More than one: nobody repeats a frame that is lost now. Reading may fail; it paces them.
  constexpr int kFrames = 3;
  for (int i = 0; i < kFrames; ++i) {
    std::array<std::uint8_t, 64> bytes{};
    if (port_->write(frame) == PortResult::gone) return;
    if (port_->read(bytes, bus_.now() + 5 * kMs).result == PortResult::gone) return;
  }
}

}  // namespace relievo::falcon
