// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/self_test.h"

#include <algorithm>
#include <cstdio>

namespace relievo::falcon {

namespace {
constexpr double kLightSeconds = 0.7;
constexpr double kNudgeN = 0.5, kNudgeSeconds = 0.15, kNudgePauseSeconds = 0.25;
constexpr double kNudgeMm = 5;        // Of a grip that nobody holds; it coasts some more.
constexpr double kLeastRateHz = 800;  // Below, surfaces must be made softer (E306).
constexpr std::uint64_t kMostMalformedPerThousand = 1;
constexpr double kMovedMm = 0.2;
constexpr int kMovedCounts = 200;
constexpr std::array<DeviceN, 6> kDirections{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
constexpr std::array<const char*, 6> kDirectionNames{"right", "left", "up", "down", "out", "in"};
constexpr std::array<std::uint8_t, 3> kLights{red, green, blue};

template <class... Values>
std::string format(const char* text, Values... values) {
  std::array<char, 300> line{};
  std::snprintf(line.data(), line.size(), text, values...);
  return line.data();
}

std::string missingButtons(std::uint32_t pressed) {
  constexpr std::array<const char*, 4> kNames{"plus", "forward", "centre", "minus"};
  std::string names;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if ((pressed >> i & 1U) == 0) names += (names.empty() ? "" : ", ") + std::string(kNames[i]);
  }
  return names;
}
}  // namespace

SelfTest::SelfTest(FalconDevice& device, SelfTestOptions options)
    : device_(device), options_(options) {
  least_.fill(INT16_MAX);
  most_.fill(INT16_MIN);
}

void SelfTest::next(Phase phase, std::int64_t now_ns) {
  phase_ = phase;
  began_ns_ = now_ns;
  force_ = {};
}

bool SelfTest::step(std::int64_t now_ns) {
  if (phase_ == Phase::done) return false;
  const DeviceReading reading = device_.exchange(force_, now_ns);
  if (began_ns_ == 0) {
    began_ns_ = now_ns;
    before_ = device_.status();
    device_.measureTimesAnew();
  }
  if (reading.fault != DeviceFault::none && fault_ == DeviceFault::none) {
    fault_ = reading.fault;
    fault_ns_ = now_ns;
    force_ = {};
  }
  if (fault_ != DeviceFault::none) {
    // What the driver says of it may come a moment later than the reading.
    constexpr std::int64_t kSayingNs = 200'000'000;
    if (device_.status().state == LinkState::ready && now_ns - fault_ns_ < kSayingNs) return true;
    lines_.push_back(
        {SelfTestLine::Result::failed, "The test ended early: " + std::string(describe(fault_)) +
                                           ". " + describe(device_.status()).screen});
    device_.showStateLights();
    next(Phase::done, now_ns);
    return false;
  }
  const double since_s = 1e-9 * static_cast<double>(now_ns - began_ns_);
  switch (phase_) {
    case Phase::rate:
      if (since_s > options_.rate_s) {
        judgeRate();
        next(Phase::lights, now_ns);
      }
      break;
    case Phase::lights: {
      const auto light = static_cast<std::size_t>(since_s / kLightSeconds);
      if (light < kLights.size()) {
        device_.showLights(kLights[light]);
        break;
      }
      device_.showStateLights();
      lines_.push_back({SelfTestLine::Result::not_seen,
                        "Lights: red, green and blue were shown one after the other."});
      next(options_.nudges ? Phase::nudges : afterNudges(), now_ns);
      break;
    }
    case Phase::nudges:
      force_ = nudge(reading, since_s);
      if (nudge_ >= static_cast<int>(kDirections.size())) next(afterNudges(), now_ns);
      break;
    case Phase::person: {
      pressed_ |= reading.buttons;
      const LinkStatus& status = device_.status();
      bool moved = true;
      for (std::size_t i = 0; i < kArms; ++i) {
        least_[i] = std::min<int>(least_[i], status.encoders[i]);
        most_[i] = std::max<int>(most_[i], status.encoders[i]);
        moved = moved && most_[i] - least_[i] > kMovedCounts;
      }
      const bool all = moved && pressed_ == kAllButtons;
      if (all || since_s > options_.wait_for_person_s) {
        judgePerson();
        next(Phase::done, now_ns);
      }
      break;
    }
    case Phase::done:
      break;
  }
  return phase_ != Phase::done;
}

DeviceN SelfTest::nudge(const DeviceReading& reading, double since_s) {
  const int index = static_cast<int>(since_s / (kNudgeSeconds + kNudgePauseSeconds));
  if (index != nudge_) {
    nudge_ = index;
    nudge_from_ = reading.position;
    nudged_far_ = false;
    if (index == static_cast<int>(kDirections.size())) judgeNudges();
  }
  if (index >= static_cast<int>(kDirections.size())) return {};
  const auto i = static_cast<std::size_t>(index);
  const DeviceN along = kDirections[i];
  const DeviceMm way = reading.position - nudge_from_;
  const double in_nudge_s = since_s - index * (kNudgeSeconds + kNudgePauseSeconds);
  if (in_nudge_s < kNudgeSeconds) {
    const double moved = way.x * along.x + way.y * along.y + way.z * along.z;
    moved_mm_[i] = std::max(moved_mm_[i], moved);
    nudged_far_ = nudged_far_ || norm(way) > kNudgeMm;
    if (!nudged_far_) return kNudgeN * along;
  }
  return {};
}

void SelfTest::judgeNudges() {
  std::string text = "Nudges of 0.5 N moved the hand by";
  std::size_t moved = 0;
  for (std::size_t i = 0; i < moved_mm_.size(); ++i) {
    text += format("%s %s %.1f mm", i == 0 ? "" : ",", kDirectionNames[i], moved_mm_[i]);
    if (moved_mm_[i] > kMovedMm) ++moved;
  }
  if (moved == moved_mm_.size()) {
    lines_.push_back({SelfTestLine::Result::passed, text + "."});
  } else if (moved > 0) {
    lines_.push_back({SelfTestLine::Result::not_seen, text + "; a hand that holds on moves less."});
  } else {
    lines_.push_back({SelfTestLine::Result::failed,
                      text +
                          "; the motors moved nothing. Check the Falcon's power supply, hold the "
                          "grip loosely or let go of it, and test again."});
  }
}

void SelfTest::judgeRate() {
  const LinkStatus& status = device_.status();
  const LinkCounts& now = status.counts;
  const std::uint64_t frames = now.frames - before_.counts.frames;
  const std::uint64_t malformed = now.malformed - before_.counts.malformed;
  const std::uint64_t stalls = now.stalls - before_.counts.stalls;
  const double rate = static_cast<double>(frames) / options_.rate_s;
  lines_.push_back(
      {rate >= kLeastRateHz ? SelfTestLine::Result::passed : SelfTestLine::Result::failed,
       format("Rate: %.0f answers per second (%.0f are needed).", rate, kLeastRateHz)});
  const bool clean = 1000 * malformed <= kMostMalformedPerThousand * frames && stalls == 0;
  lines_.push_back(
      {clean ? SelfTestLine::Result::passed : SelfTestLine::Result::failed,
       format("Line: %llu damaged answers, %llu stalls, %llu overruns.",
              static_cast<unsigned long long>(malformed), static_cast<unsigned long long>(stalls),
              static_cast<unsigned long long>(now.overruns - before_.counts.overruns))});
  std::string gaps = "Times from answer to answer:";
  for (std::size_t i = 0; i < now.gaps.size(); ++i) {
    const auto count = static_cast<unsigned long long>(now.gaps[i] - before_.counts.gaps[i]);
    const bool last = i == LinkCounts::kGapEdgesNs.size();
    const double edge_ms = 1e-6 * static_cast<double>(LinkCounts::kGapEdgesNs[last ? i - 1 : i]);
    gaps +=
        format("%s %s %.1f ms %llu", i == 0 ? "" : ",", last ? "above" : "up to", edge_ms, count);
  }
  lines_.push_back(
      {SelfTestLine::Result::passed,
       gaps + format("; the longest %.2f ms.", 1e-6 * static_cast<double>(now.worst_gap_ns))});
  lines_.push_back({SelfTestLine::Result::passed,
                    format("From question to answer: %.2f ms on average, %.2f ms at worst.",
                           status.mean_answer_ms, status.worst_answer_ms)});
}

void SelfTest::judgePerson() {
  const std::string missing = missingButtons(pressed_);
  lines_.push_back({missing.empty() ? SelfTestLine::Result::passed : SelfTestLine::Result::not_seen,
                    missing.empty() ? "Buttons: all four work."
                                    : "Buttons that were not pressed: " + missing + "."});
  constexpr std::array<const char*, kArms> kNames{"top", "right", "left"};
  for (std::size_t i = 0; i < kArms; ++i) {
    const int range = std::max(0, most_[i] - least_[i]);
    lines_.push_back(
        {range > kMovedCounts ? SelfTestLine::Result::passed : SelfTestLine::Result::not_seen,
         format("Encoder of the %s arm: moved by %d counts.", kNames[i], range)});
  }
}

std::string SelfTest::prompt() const {
  switch (phase_) {
    case Phase::rate:
      return "Measuring how evenly the Falcon answers.";
    case Phase::lights:
      return "Watch the lights: red, green, blue.";
    case Phase::nudges:
      return "Hold the grip loosely: six small nudges of half a newton.";
    case Phase::person: {
      const std::string missing = missingButtons(pressed_);
      return "Move the grip all round and press each of the four buttons." +
             (missing.empty() ? "" : " Still missing: " + missing + ".");
    }
    case Phase::done:
      return passed() ? "The self test passed." : "The self test found something wrong.";
  }
  return {};
}

bool SelfTest::passed() const {
  return std::none_of(lines_.begin(), lines_.end(), [](const SelfTestLine& line) {
    return line.result == SelfTestLine::Result::failed;
  });
}

}  // namespace relievo::falcon
