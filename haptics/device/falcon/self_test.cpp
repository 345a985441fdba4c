// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/self_test.h"

#include <algorithm>
#include <cstddef>

#include "core/message/catalogue.h"

namespace relievo::falcon {

namespace {
constexpr double kLightSeconds = 0.7;
constexpr double kNudgeN = 0.5, kNudgeSeconds = 0.15, kNudgePauseSeconds = 0.25;
constexpr double kNudgeMm = 5;        // Of a grip that nobody holds; it coasts some more.
constexpr double kLeastRateHz = 800;  // Below, surfaces must be made softer (E306).
constexpr std::uint64_t kMostMalformedPerThousand = 1;
constexpr double kMovedMm = 0.2;
constexpr int kMovedCounts = 200;
constexpr double kEdgeShare = 0.8;  // Of the workspace's half: there its end can be felt.
constexpr std::array<DeviceN, 6> kDirections{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
constexpr std::array<std::uint8_t, 3> kLights{red, green, blue};

NumberArgument fixed(double value, int digits) {
  return {.value = value, .digits = digits};
}

template <MessageId message_id>
Message nudged(const std::array<double, 6>& moved_mm) {
  const auto mm = [&](std::size_t i) { return fixed(moved_mm[i], 1); };
  return said<message_id>(mm(0), mm(1), mm(2), mm(3), mm(4), mm(5));
}

std::vector<Message> missingButtons(std::uint32_t pressed) {
  constexpr std::array<MessageId, 4> kNames{
      MessageId::falcon_button_plus, MessageId::falcon_button_forward,
      MessageId::falcon_button_centre, MessageId::falcon_button_minus};
  std::vector<Message> missing;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if ((pressed >> i & 1U) == 0) missing.push_back({kNames[i], {}});
  }
  return missing;
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
  if (fault_ != DeviceFault::none) return endByFault(now_ns);
  const double since_s = 1e-9 * static_cast<double>(now_ns - began_ns_);
  switch (phase_) {
    case Phase::rate:
      if (since_s > options_.rate_s) {
        judgeRate(since_s);  // A late tick ends it later.
        next(Phase::lights, now_ns);
      }
      break;
    case Phase::lights:
      if (showLight(since_s)) break;
      lines_.push_back({SelfTestLine::Result::not_seen, said<MessageId::self_test_lights>()});
      next(options_.nudges ? Phase::nudges : afterNudges(), now_ns);
      break;
    case Phase::nudges:
      force_ = nudge(reading, since_s);
      if (nudge_ >= static_cast<int>(kDirections.size())) next(afterNudges(), now_ns);
      break;
    case Phase::person:
      if (watchPerson(reading) || since_s > options_.wait_for_person_s) {
        judgePerson();
        next(Phase::done, now_ns);
      }
      break;
    case Phase::done:
      break;
  }
  return phase_ != Phase::done;
}

bool SelfTest::endByFault(std::int64_t now_ns) {
  // What the driver says of it may come a moment later than the reading.
  constexpr std::int64_t kSayingNs = 200'000'000;
  if (device_.status().state == LinkState::ready && now_ns - fault_ns_ < kSayingNs) return true;
  lines_.push_back(
      {SelfTestLine::Result::failed,
       said<MessageId::self_test_ended>(messageOf(fault_), describe(device_.status()))});
  device_.showStateLights();
  next(Phase::done, now_ns);
  return false;
}

bool SelfTest::showLight(double since_s) {
  const auto light = static_cast<std::size_t>(since_s / kLightSeconds);
  if (light < kLights.size()) {
    device_.showLights(kLights[light]);
    return true;
  }
  device_.showStateLights();
  return false;
}

bool SelfTest::watchPerson(const DeviceReading& reading) {
  pressed_ |= reading.buttons;
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    const DeviceN& d = kDirections[i];
    const DeviceMm& p = reading.position;
    reached_mm_[i] = std::max(reached_mm_[i], p.x * d.x + p.y * d.y + p.z * d.z);
  }
  const LinkStatus& status = device_.status();
  bool moved = true;
  for (std::size_t i = 0; i < kArms; ++i) {
    least_[i] = std::min<int>(least_[i], status.encoders[i]);
    most_[i] = std::max<int>(most_[i], status.encoders[i]);
    moved = moved && most_[i] - least_[i] > kMovedCounts;
  }
  return moved && pressed_ == kAllButtons && missingSides().empty();
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
  using Result = SelfTestLine::Result;
  const auto moved = std::count_if(moved_mm_.begin(), moved_mm_.end(),
                                   [](double moved_mm) { return moved_mm > kMovedMm; });
  if (moved == static_cast<std::ptrdiff_t>(moved_mm_.size())) {
    lines_.push_back({Result::passed, nudged<MessageId::self_test_nudges>(moved_mm_)});
  } else if (moved > 0) {
    lines_.push_back({Result::not_seen, nudged<MessageId::self_test_nudges_held>(moved_mm_)});
  } else {
    lines_.push_back({Result::failed, nudged<MessageId::self_test_nudges_nothing>(moved_mm_)});
  }
}

void SelfTest::judgeRate(double measured_s) {
  const LinkStatus& status = device_.status();
  const LinkCounts& now = status.counts;
  const std::uint64_t frames = now.frames - before_.counts.frames;
  const std::uint64_t malformed = now.malformed - before_.counts.malformed;
  const std::uint64_t stalls = now.stalls - before_.counts.stalls;
  const double rate = static_cast<double>(frames) / measured_s;
  lines_.push_back(
      {rate >= kLeastRateHz ? SelfTestLine::Result::passed : SelfTestLine::Result::failed,
       said<MessageId::self_test_rate>(fixed(rate, 0), fixed(kLeastRateHz, 0))});
  const bool clean = 1000 * malformed <= kMostMalformedPerThousand * frames && stalls == 0;
  lines_.push_back(
      {clean ? SelfTestLine::Result::passed : SelfTestLine::Result::failed,
       said<MessageId::self_test_line>(malformed, stalls, now.overruns - before_.counts.overruns)});
  // The edges stand in the sentence.
  static_assert(LinkCounts::kGapEdgesNs ==
                std::array<std::int64_t, 7>{800'000, 1'000'000, 1'200'000, 2'000'000, 5'000'000,
                                            20'000'000, 100'000'000});
  const auto gaps = [&](std::size_t i) { return now.gaps[i] - before_.counts.gaps[i]; };
  const double longest_ms = 1e-6 * static_cast<double>(now.worst_gap_ns);
  lines_.push_back(
      {SelfTestLine::Result::passed,
       said<MessageId::self_test_times>(gaps(0), gaps(1), gaps(2), gaps(3), gaps(4), gaps(5),
                                        gaps(6), gaps(7), fixed(longest_ms, 2))});
  lines_.push_back({SelfTestLine::Result::passed,
                    said<MessageId::self_test_answers>(fixed(status.mean_answer_ms, 2),
                                                       fixed(status.worst_answer_ms, 2))});
}

void SelfTest::judgePerson() {
  const std::vector<Message> missing = missingButtons(pressed_);
  lines_.push_back({missing.empty() ? SelfTestLine::Result::passed : SelfTestLine::Result::not_seen,
                    missing.empty() ? said<MessageId::self_test_buttons>()
                                    : said<MessageId::self_test_buttons_missing>(missing)});
  constexpr std::array<MessageId, kArms> kNames{
      MessageId::falcon_arm_top, MessageId::falcon_arm_right, MessageId::falcon_arm_left};
  for (std::size_t i = 0; i < kArms; ++i) {
    const int range = std::max(0, most_[i] - least_[i]);
    lines_.push_back(
        {range > kMovedCounts ? SelfTestLine::Result::passed : SelfTestLine::Result::not_seen,
         said<MessageId::self_test_encoder>(Message{kNames[i], {}}, range)});
  }
  judgeEdges();
}

std::vector<Message> SelfTest::missingSides() const {
  constexpr std::array<MessageId, 6> kNames{
      MessageId::self_test_side_right, MessageId::self_test_side_left,
      MessageId::self_test_side_up,    MessageId::self_test_side_down,
      MessageId::self_test_side_out,   MessageId::self_test_side_in};
  const DeviceMm& half = device_.info().workspace.half_extent;
  const std::array<double, 6> ends{half.x, half.x, half.y, half.y, half.z, half.z};
  std::vector<Message> missing;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (reached_mm_[i] < kEdgeShare * ends[i]) missing.push_back({kNames[i], {}});
  }
  return missing;
}

void SelfTest::judgeEdges() {
  const auto mm = [this](std::size_t i) { return fixed(reached_mm_[i], 0); };
  const std::vector<Message> missing = missingSides();
  if (missing.empty()) {
    lines_.push_back({SelfTestLine::Result::passed,
                      said<MessageId::self_test_edges>(mm(0), mm(1), mm(2), mm(3), mm(4), mm(5))});
  } else {
    lines_.push_back(
        {SelfTestLine::Result::not_seen, said<MessageId::self_test_edges_missing>(
                                             mm(0), mm(1), mm(2), mm(3), mm(4), mm(5), missing)});
  }
}

Message SelfTest::prompt() const {
  switch (phase_) {
    case Phase::rate:
      return said<MessageId::self_test_measuring>();
    case Phase::lights:
      return said<MessageId::self_test_watch_lights>();
    case Phase::nudges:
      return said<MessageId::self_test_hold_loosely>();
    case Phase::person: {
      std::vector<Message> missing = missingButtons(pressed_);
      for (Message& side : missingSides()) missing.push_back(std::move(side));
      return missing.empty() ? said<MessageId::self_test_move_and_press>()
                             : said<MessageId::self_test_still_missing>(missing);
    }
    case Phase::done:
      break;
  }
  return passed() ? said<MessageId::self_test_passed>() : said<MessageId::self_test_failed>();
}

bool SelfTest::passed() const {
  return std::none_of(lines_.begin(), lines_.end(), [](const SelfTestLine& line) {
    return line.result == SelfTestLine::Result::failed;
  });
}

}  // namespace relievo::falcon
