// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/force_echo.h"

#include <algorithm>
#include <utility>

namespace relievo::haply {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr double kMuchN = 0.5, kHeardPart = 0.1;
constexpr int kUnheard = 50;
constexpr double kExcessN = 1;
constexpr std::int64_t kExcessNs = 20 * kMs, kPushedNs = 2000 * kMs;
constexpr int kExcesses = 10;
constexpr std::int64_t kToldLateNs = 50 * kMs;  // What is told may be of so long before.
constexpr std::size_t kLastAsks = 4;            // And of one of these, however slow they are.
constexpr std::int64_t kSteadyNs = 100 * kMs;   // So long a service may smooth what it tells.

/// How far a force is from a part of what was sent: a service may damp, and may not add.
double beyond(ServiceN told, ServiceN sent) {
  const double sent2 = dot(sent, sent);
  const double part = sent2 > 0 ? std::clamp(dot(told, sent) / sent2, 0.0, 1.0) : 0;
  return norm(told - part * sent);
}
}  // namespace

void ForceEcho::restart(std::int64_t now_ns) {
  *this = {};
  unsteady_ns_ = now_ns;
}

void ForceEcho::noteSent(ServiceN force, std::int64_t now_ns) {
  for (const Sent& sent : sent_) {
    // Whoever still told that would seem to push.
    if (now_ns - sent.time_ns <= kToldLateNs && beyond(sent.force, force) > kExcessN) {
      unsteady_ns_ = now_ns;
    }
  }
  std::rotate(sent_.begin(), sent_.end() - 1, sent_.end());
  sent_.front() = {force, now_ns};
}

void ForceEcho::check(ServiceN told, std::int64_t now_ns) {
  checkHeard(norm(told));
  checkExcess(told, now_ns);
}

bool ForceEcho::wasPushed(std::int64_t now_ns) const {
  return pushed_ns_ != 0 && now_ns - pushed_ns_ < kPushedNs;
}

void ForceEcho::checkHeard(double told_n) {
  double least_n = norm(sent_.front().force);
  for (std::size_t i = 1; i < kLastAsks; ++i) {
    least_n = std::min(least_n, norm(sent_[i].force));
  }
  if (least_n <= kMuchN) return;
  unheard_ = told_n < kHeardPart * least_n ? unheard_ + 1 : 0;
  if (unheard_ < kUnheard || disobeyed_) return;
  disobeyed_ = true;
  unheard_ = 0;
  ordered_n_ = least_n;
  told_n_ = told_n;
}

void ForceEcho::checkExcess(ServiceN told, std::int64_t now_ns) {
  double excess_n = beyond(told, sent_.front().force);
  for (std::size_t i = 1; i < sent_.size(); ++i) {
    if (i >= kLastAsks && now_ns - sent_[i].time_ns > kToldLateNs) break;
    excess_n = std::min(excess_n, beyond(told, sent_[i].force));
  }
  if (excess_n <= kExcessN || now_ns - unsteady_ns_ < kSteadyNs) {
    excess_ns_ = 0;
    excesses_ = 0;
    return;
  }
  if (std::exchange(excesses_, excesses_ + 1) == 0) excess_ns_ = now_ns;
  if (excesses_ >= kExcesses && now_ns - excess_ns_ >= kExcessNs) pushed_ns_ = now_ns;
}

}  // namespace relievo::haply
