// SPDX-License-Identifier: BSD-3-Clause
// Running: question and answer, homing, force, and what is done when answers stay away.
#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/device/falcon/link.h"

namespace relievo::falcon {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr double kPulledOutMm = 170 - kCentre.z;
constexpr int kSureFrames = 3;  // In a row, before arms count as homed or a button as pressed.
constexpr std::int64_t kHomingHintNs = 20'000 * kMs;
/// While no loop asks: the chip's longest latency and a question now and then, so that nobody is
/// woken for nothing; a look ten times a second whether the loop asks again.
constexpr std::int64_t kRestAfterNs = 1000 * kMs, kRestNs = 500 * kMs, kRestLookNs = 100 * kMs;
constexpr std::int64_t kRestPatienceNs = 2 * kRestNs;
constexpr std::uint8_t kRestLatencyMs = 255;
constexpr int kMostFailedReads = 3;              // In a row; then it is opened anew.
constexpr std::int64_t kHealthyNs = 2000 * kMs;  // So long: failures before it are over.

/// Measures against silence: after 5, 10 and 15 ms, then one every 20 ms. All ask again, with zero
/// force: a bad line gets many chances before the processor is taken for dead.
constexpr std::int64_t kFirstMeasureNs = 5 * kMs, kNextMeasureNs = 20 * kMs;
constexpr int kStall = 3;                       // At 20 ms.
constexpr int kPurgeEvery = 25, kGiveUp = 100;  // Of 20 ms: 500 ms, 2 s.
constexpr std::int64_t measureAfter(int step) {
  return step < kStall ? (step + 1) * kFirstMeasureNs : (step - kStall + 1) * kNextMeasureNs;
}
}  // namespace

Link::Leave Link::operate(const std::stop_token& stop) {
  std::int64_t now = bus_.now();
  last_answer_ns_ = rate_mark_ns_ = operates_since_ns_ = now;
  force_gate_.shut(now);
  malformed_seen_ = reader_.malformed();
  rate_frames_ = status_.counts.frames;
  under_way_ = silence_step_ = homed_frames_ = failed_reads_ = 0;
  seen_unhomed_ = resting_ = doubtful_ = false;
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
    if (reader_.malformed() != malformed_seen_) {
      malformed_seen_ = reader_.malformed();
      zero_next_ = true;
      force_gate_.shut(now);
    }
    const bool wanted = isWanted(now);
    measureAnewIfAsked();
    if (wanted && resting_) wake();
    if (under_way_ > 0) {
      if (now < silentAt()) continue;
      if (const auto leave = watch(now)) return *leave;
    } else if (!wanted && !resting_) {
      if (!rest(now)) return Leave::gone;
    } else if (!resting_ || now - asked_ns_ >= kRestNs) {
      if (!ask(bus_.now(), false)) return Leave::gone;
    }
  }
  return Leave::stopped;
}

/// 20 ms without an answer are a stall, which watch() notices in time. Unless this thread itself
/// did not run: it was halted, or the processor was not its own. The loop may step as slowly as it
/// likes: only answers count, and they come by themselves.
bool Link::wasPaused(std::int64_t now_ns) const {
  return !resting_ && silence_step_ <= kStall && now_ns - last_answer_ns_ >= measureAfter(kStall);
}

/// What came meanwhile tells where the hand was. Zero first; the answer to it has the new place,
/// and only forces that are made from that one are shown, rising from zero.
bool Link::takePause(std::int64_t now_ns) {
  ++status_.counts.hiccups;
  ++reading_.epoch;  // The loop learns it with the new place.
  port_->discardInput();
  reader_.reset();
  last_answer_ns_ = now_ns;
  under_way_ = silence_step_ = 0;
  doubtful_ = false;
  return ask(now_ns, true);
}

/// A read that broke off: zero at once, and on. The answer may be lost, or come all the same.
/// @return false: it goes on failing
bool Link::takeFailure(std::int64_t now_ns) {
  ++status_.counts.failed_reads;
  zero_next_ = true;
  force_gate_.shut(now_ns);
  if (++failed_reads_ > kMostFailedReads) lost_ = PortResult::failed;
  if (failed_reads_ > 1) return lost_ == PortResult::ok;
  if (!ask(now_ns, true)) return false;
  doubtful_ = under_way_ > 1;
  under_way_ = doubtful_ ? 2 : 1;
  return true;
}

/// The bridge chip tells of bytes that are missing or altered: what came is of no use, and the
/// answer is lost. Zero with the next question.
void Link::takeDamage(std::int64_t now_ns) {
  reader_.reset();
  zero_next_ = true;
  force_gate_.shut(now_ns);
}

void Link::takeReport(const Report& report, std::int64_t now_ns) {
  under_way_ = std::max(0, under_way_ - 1);
  if (under_way_ == 0) doubtful_ = false;
  countFrame(now_ns);
  if (status_.state == LinkState::silent) setState(LinkState::homing);
  last_answer_ns_ = now_ns;
  silence_step_ = failed_reads_ = 0;
  if (now_ns - operates_since_ns_ > kHealthyNs) status_.failed_openings = 0;
  if (!follow(report, now_ns)) return;
  homed_frames_ = report.homed == kAllHomed ? std::min(homed_frames_ + 1, kSureFrames) : 0;
  status_.homed = report.homed;
  status_.encoders = report.encoders;
  if (homed_frames_ == 0) {
    seen_unhomed_ = true;
    if (status_.state != LinkState::homing) setState(LinkState::homing);
  } else if (homed_frames_ == kSureFrames && status_.state == LinkState::homing) {
    // One that was homed before we came may be anywhere, and the loop waits until it is clear.
    setState(seen_unhomed_ ? LinkState::pull_out : LinkState::ready);
  } else if (status_.state == LinkState::pull_out && reading_.position.z > kPulledOutMm) {
    setState(LinkState::ready);
  }
  debounce(report.buttons);
  const bool ready = status_.state == LinkState::ready;
  if (ready) reading_.fault = DeviceFault::none;
  status_.position = reading_.position;
  status_.buttons = reading_.buttons;
  publishReading(now_ns);
  if (now_ns - published_ns_ > 20 * kMs) {
    published_ns_ = now_ns;
    status_.homing_is_long =
        status_.state == LinkState::homing && now_ns - homing_since_ns_ > kHomingHintNs;
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
  if (!gate_.takes(place, {asked_ns_, now_ns})) {
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

void Link::debounce(std::uint8_t raw) {
  for (std::size_t i = 0; i < button_frames_.size(); ++i) {
    const std::uint32_t bit = 1U << i;
    const bool held_over = (held_over_ & bit) != 0;
    const bool differs = held_over ? (raw & bit) == 0 : (raw & bit) != (reading_.buttons & bit);
    button_frames_[i] = differs ? static_cast<std::uint8_t>(button_frames_[i] + 1) : 0;
    if (button_frames_[i] < kSureFrames) continue;
    (held_over ? held_over_ : reading_.buttons) ^= bit;
    button_frames_[i] = 0;
  }
}

/// After more than a short interruption nobody knows what was done with them meanwhile.
void Link::forgetButtons() {
  reading_.buttons = status_.buttons = 0;
  held_over_ = kAllButtons;
  button_frames_ = {};
}

void Link::countFrame(std::int64_t now_ns) {
  LinkCounts& counts = status_.counts;
  const std::int64_t gap = now_ns - last_answer_ns_;
  if (!resting_ && !asked_at_rest_) {
    std::size_t bin = 0;
    while (bin < LinkCounts::kGapEdgesNs.size() && gap > LinkCounts::kGapEdgesNs[bin]) ++bin;
    ++counts.gaps[bin];
    counts.worst_gap_ns = std::max(counts.worst_gap_ns, gap);
    const double answer_ms = 1e-6 * static_cast<double>(now_ns - asked_ns_);
    answer_sum_ms_ += answer_ms;
    status_.mean_answer_ms = answer_sum_ms_ / static_cast<double>(++answers_timed_);
    status_.worst_answer_ms = std::max(status_.worst_answer_ms, answer_ms);
  }
  ++counts.frames;
  constexpr std::uint64_t kFramesPerRate = 256;
  const std::uint64_t frames = counts.frames - rate_frames_;
  if (frames >= kFramesPerRate && now_ns > rate_mark_ns_) {
    status_.rate_hz =
        1e9 * static_cast<double>(frames) / static_cast<double>(now_ns - rate_mark_ns_);
    rate_frames_ = counts.frames;
    rate_mark_ns_ = now_ns;
  }
}

void Link::measureAnewIfAsked() {
  const std::uint32_t asked = mailbox_.wishes.front().measurements;
  if (std::exchange(measurements_seen_, asked) == asked) return;
  status_.counts.worst_gap_ns = 0;
  status_.mean_answer_ms = status_.worst_answer_ms = answer_sum_ms_ = 0;
  answers_timed_ = 0;
}

std::int64_t Link::silentAt() const {
  return last_answer_ns_ + (resting_ ? kRestPatienceNs : 0) + measureAfter(silence_step_);
}

std::optional<Link::Leave> Link::watch(std::int64_t now_ns) {
  // A write that waits for the bridge takes longer than several measures.
  while (silence_step_ < kStall && now_ns - last_answer_ns_ >= measureAfter(silence_step_ + 1)) {
    ++silence_step_;
  }
  const int step = silence_step_++;
  zero_next_ = true;
  force_gate_.shut(now_ns);
  if (step < kStall) {
    ++status_.counts.hiccups;
  } else {
    if (step == kStall) ++status_.counts.stalls;
    interrupt(DeviceFault::timeout, now_ns);
    port_->discardInput();  // Too late to tell where the hand is.
    reader_.reset();
  }
  const int stalled = step - kStall + 1;
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
  // The first time the answer may only be late, and two will come; else one would stay queued for
  // ever. If only one comes, the next silence settles it.
  doubtful_ = step == 0 && !doubtful_;
  under_way_ = doubtful_ ? 2 : 1;
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
    force_gate_.shut(now_ns);
  } else {
    command.motors = motorCounts(now_ns);
  }
  zero_next_ = false;
  if (write(encode(command)) == PortResult::gone) return false;
  if (under_way_ == 0) {  // Else the answer is waited for since the first of them.
    asked_ns_ = now_ns;
    asked_at_rest_ = resting_;
  }
  // What the device did not take counts as under way: silence is noticed, and zero sent.
  ++under_way_;
  return true;
}

std::array<std::int16_t, kArms> Link::motorCounts(std::int64_t now_ns) {
  mailbox_.orders.update();
  std::optional<DeviceN> force;
  if (status_.state == LinkState::ready && jacobian_) {
    force =
        force_gate_.shown(mailbox_.orders.front(), mailbox_.cuts.load(), reading_.epoch, now_ns);
  }
  if (!force) force_gate_.shut(now_ns);
  if (!force || norm(*force) == 0) return {};
  const std::optional<Torques> torques = torquesForForce(*jacobian_, *force);
  if (!torques) return {};
  mailbox_.wishes.update();
  force_ns_ = now_ns;
  return countsForTorques(*torques, mailbox_.wishes.front().counts_per_n_mm);
}

std::uint8_t Link::lights(std::int64_t now_ns) const {
  const LinkWish& wish = mailbox_.wishes.front();
  if (wish.show_lights) return wish.lights;
  if (status_.state == LinkState::pull_out) return blue;
  if (status_.state != LinkState::ready || reading_.fault != DeviceFault::none) return red;
  constexpr std::int64_t kGreenNs = 2000 * kMs;
  return force_ns_ != 0 && now_ns - force_ns_ < kGreenNs ? green : blue;
}

bool Link::isWanted(std::int64_t now_ns) {
  mailbox_.orders.update();
  mailbox_.wishes.update();
  return now_ns - mailbox_.orders.front().time_ns < kRestAfterNs ||
         mailbox_.wishes.front().show_lights || status_.state != LinkState::ready;
}

void Link::wake() {
  request(latencyTimer(1));
  resting_ = false;
  silence_step_ = 0;
  zero_next_ = true;  // The place that is known is as old as the rest.
  last_answer_ns_ = rate_mark_ns_ = bus_.now();
  rate_frames_ = status_.counts.frames;
}

bool Link::rest(std::int64_t now_ns) {
  resting_ = true;
  const bool asked = ask(now_ns, true);  // Whatever the motors showed, they rest as well.
  request(latencyTimer(kRestLatencyMs));
  return asked;
}

void Link::sayGoodbye(const Frame& frame) {
  // More than one: nobody repeats a frame that is lost now. Reading may fail; it paces them.
  constexpr int kFrames = 3;
  for (int i = 0; i < kFrames; ++i) {
    std::array<std::uint8_t, 64> bytes{};
    if (port_->write(frame) == PortResult::gone) return;
    if (port_->read(bytes, bus_.now() + 5 * kMs).result == PortResult::gone) return;
  }
}

}  // namespace relievo::falcon
