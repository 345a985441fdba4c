// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/link.h"

#include <algorithm>
#include <utility>

namespace relievo::haply {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kTickNs = kMs;
constexpr std::int64_t kSendNs = 20 * kMs;  // On loopback a message waits for nobody.
/// While no loop asks: a question now and then, and looks between them whether it asks again.
constexpr std::int64_t kRestAfterNs = 1000 * kMs, kRestNs = 100 * kMs, kRestLookNs = 20 * kMs;
/// So long a message that comes is waited for between looks at the stop token.
constexpr std::int64_t kLookNs = 20 * kMs;
constexpr std::int64_t kFirstPauseNs = 100 * kMs, kLongestPauseNs = 2000 * kMs;
constexpr int kZeros = 3;

}  // namespace

Link::Link(Service& service, LinkMailbox& mailbox, std::string chosen)
    : service_(service),
      mailbox_(mailbox),
      chosen_(std::move(chosen)),
      set_up_(status_.counts.configurations) {}

void Link::run(const std::stop_token& stop, Inventory inventory) {
  std::int64_t pause_ns = kFirstPauseNs;
  while (!stop.stop_requested()) {
    if (begin(inventory)) {
      port_ = std::move(inventory.port);
      const std::uint64_t answers = status_.counts.answers;
      const Leave leave = operate(stop);
      const std::int64_t now = service_.now();
      if (leave == Leave::stopped || leave == Leave::absent) sendNeutralFrame();
      port_.reset();
      if (leave == Leave::stopped) break;
      ++status_.counts.lost;
      interrupt(leave == Leave::silent ? DeviceFault::timeout : DeviceFault::disconnected, now);
      setState(leave == Leave::absent   ? LinkState::no_device
               : leave == Leave::silent ? LinkState::silent
                                        : LinkState::no_service,
               now);
      publishStatus();
      if (status_.counts.answers - answers > 1000) pause_ns = kFirstPauseNs;
    }
    inventory = {};
    const std::int64_t until = service_.now() + pause_ns;
    while (!stop.stop_requested() && service_.now() < until) {
      service_.sleepUntil(std::min(until, service_.now() + kRestLookNs));
    }
    pause_ns = std::min(2 * pause_ns, kLongestPauseNs);
    if (!stop.stop_requested()) inventory = lookAround(service_, stop);
  }
  setState(LinkState::closed, service_.now());
  publishStatus();
}

/// @return false: the device is not there; the status says why
bool Link::begin(const Inventory& inventory) {
  const Choice choice = choose(inventory, service_, chosen_);
  const LinkCounts counts = status_.counts;
  const bool was_open = status_.was_open;
  status_ = choice.status;
  status_.counts = counts;
  status_.was_open = was_open;
  // What was promised to the loop holds for this kind of device alone.
  const bool same =
      choice.device != nullptr && (device_.type.empty() || choice.device->type == device_.type);
  if (!same) {
    if (choice.device != nullptr) status_.state = LinkState::no_device;
    publishStatus();
    return false;
  }
  device_ = *choice.device;
  chosen_ = device_.id.view();
  status_.was_open = true;
  key_ = forceKeyOf(inventory.version);
  force_ramp_ = ForceRamp({.max_force_n = limitsOf(device_.type.view()).max_force_n});
  return true;
}

Link::Leave Link::operate(const std::stop_token& stop) {
  std::int64_t now = service_.now();
  answered_ns_ = now;
  rate_.restart(now, status_.counts.answers);
  questions_.restart(now);
  zeros_left_ = nonsense_ = 0;
  resting_ = drives_ = false;
  echo_.restart(now);
  told_state_ = LinkState::not_started;
  held_over_ = ~0U;
  reading_.buttons = 0;
  force_ramp_.shut(now);
  set_up_.restart(now);
  setState(LinkState::checking, now);
  publishStatus();
  for (std::int64_t next = now; !stop.stop_requested();) {
    service_.sleepUntil(next);
    now = service_.now();
    if (const auto leave = drain()) return *leave;
    const bool was_resting = std::exchange(resting_, !isWanted(now));
    if (was_resting) next = now;
    if (!resting_ || now - questions_.askedNs() >= kRestNs) {
      if (!ask(now)) return Leave::gone;
      if (const auto leave = answer(stop)) return *leave;
    }
    // Missed ticks are not made up for.
    next = std::max(next + (resting_ ? kRestLookNs : kTickNs), service_.now());
  }
  return Leave::stopped;
}

/// What came without a question, or too late. The next answer is then that of the next question.
std::optional<Link::Leave> Link::drain() {
  constexpr int kMost = 64;  // In a tick: whoever sends more must wait, too.
  for (int i = 0; i < kMost; ++i) {
    const std::int64_t now = service_.now();
    const Port::Incoming in = port_->receive(now);
    if (in.result == PortResult::gone) return Leave::gone;
    if (in.result == PortResult::timeout) break;
    if (questions_.underWay() == 0) ++status_.counts.extra;
    if (const auto leave = takeAnswer(in.text, now)) return leave;
  }
  return std::nullopt;
}

/// Waits for all that was asked.
std::optional<Link::Leave> Link::answer(const std::stop_token& stop) {
  while (questions_.underWay() > 0) {
    const std::int64_t before = service_.now();
    const std::int64_t until = std::clamp(questions_.silentAt(), before, before + kLookNs);
    const Port::Incoming in = port_->receive(until);
    if (in.result == PortResult::gone) return Leave::gone;
    const std::int64_t now = service_.now();
    std::optional<Leave> leave;
    if (in.result == PortResult::ok) {
      leave = takeAnswer(in.text, now);
    } else if (now >= questions_.silentAt()) {
      leave = watch(now);
    }
    if (leave) return leave;
    if (stop.stop_requested()) return Leave::stopped;
  }
  return std::nullopt;
}

std::optional<Link::Leave> Link::watch(std::int64_t now_ns) {
  force_ramp_.shut(now_ns);
  echo_.disturb(now_ns);
  switch (questions_.nextMeasure()) {
    case 0:
      ++status_.counts.hiccups;
      // The force of the unanswered order must not stay. Nothing more until there are answers.
      if (!drives_) return std::nullopt;
      if (!send(writer_.order(device_, key_, {}, false))) return Leave::gone;
      questions_.add();
      return std::nullopt;
    case 1:
      ++status_.counts.stalls;
      interrupt(DeviceFault::timeout, now_ns);
      setState(LinkState::silent, now_ns);
      publishStatus();
      return std::nullopt;
    default:
      return Leave::silent;
  }
}

bool Link::send(std::string_view text) {
  // A message that is stuck makes the session useless, and closing it is what ends the force.
  return port_->send(text, service_.now() + kSendNs) == PortResult::ok;
}

bool Link::ask(std::int64_t now_ns) {
  mailbox_.commands.update();
  if (std::exchange(retries_seen_, mailbox_.commands.front().retries) != retries_seen_) {
    echo_.forgive();
    if (set_up_.state() == SetUpCheck::State::foreign) set_up_.begin(now_ns);
  }
  if (now_ns - answered_ns_ >= Questions::kStallNs) {
    // Rested, or this thread itself did not run: the place is old, and so is what was made of it.
    ++reading_.epoch;
    force_ramp_.shut(now_ns);
  }
  const ServiceN shown = serviceFromDevice(force(now_ns));
  const double shown_n = norm(shown);
  if (shown_n > 0) zeros_left_ = kZeros;
  drives_ = status_.state == LinkState::ready && !resting_;
  const bool orders = drives_ || zeros_left_ > 0;
  if (shown_n == 0) zeros_left_ = std::max(0, zeros_left_ - 1);
  echo_.noteSent(shown, now_ns);
  const bool everything = set_up_.askForEverything(now_ns);
  questions_.ask(now_ns);
  if (set_up_.takeDue()) {
    // It shows no force; zero goes before it where a force was.
    if (orders && !send(writer_.order(device_, key_, {}, false))) return false;
    if (orders) questions_.add();
    return send(writer_.configuration(device_));
  }
  drives_ = orders;
  return send(orders ? writer_.order(device_, key_, shown, everything)
                     : writer_.question(device_, everything));
}

DeviceN Link::force(std::int64_t now_ns) {
  mailbox_.orders.update();
  std::optional<DeviceN> shown;
  if (status_.state == LinkState::ready && reading_.fault == DeviceFault::none && !resting_ &&
      !set_up_.isDue()) {
    shown =
        force_ramp_.shown(mailbox_.orders.front(), mailbox_.cuts.load(), reading_.epoch, now_ns);
  }
  if (!shown) force_ramp_.shut(now_ns);
  return shown.value_or(DeviceN{});
}

bool Link::isWanted(std::int64_t now_ns) {
  mailbox_.orders.update();
  return now_ns - mailbox_.orders.front().time_ns < kRestAfterNs ||
         status_.state != LinkState::ready;
}

std::optional<Link::Leave> Link::takeAnswer(std::string_view text, std::int64_t now_ns) {
  questions_.answer();
  if (!readState(text, heard_)) {
    ++status_.counts.nonsense;
    interrupt(DeviceFault::protocol, now_ns);
    constexpr int kMostNonsense = 50;  // In a row: another session may begin better.
    if (++nonsense_ < kMostNonsense) return std::nullopt;
    return Leave::gone;
  }
  nonsense_ = 0;
  const ServiceDevice* const device = heard_.find(device_.id.view());
  if (device == nullptr) return Leave::absent;
  countAnswer(now_ns);
  follow(*device, now_ns);
  takeButtons(heard_.buttons);
  status_.position = reading_.position;
  status_.buttons = reading_.buttons;
  mailbox_.readings.write(reading_);
  if (now_ns - published_ns_ > 20 * kMs) publishStatus();
  return std::nullopt;
}

void Link::countAnswer(std::int64_t now_ns) {
  ++status_.counts.answers;
  status_.counts.worst_answer_ns =
      std::max(status_.counts.worst_answer_ns, now_ns - questions_.askedNs());
  forgiveGap(now_ns);
  answered_ns_ = now_ns;
  if (status_.state == LinkState::silent && questions_.underWay() == 0)
    setState(LinkState::checking, now_ns);
  if (const auto rate_hz = rate_.take(now_ns, status_.counts.answers)) status_.rate_hz = *rate_hz;
}

void Link::sendNeutralFrame() {
  const std::int64_t now = service_.now();
  if (!send(writer_.order(device_, key_, {}, false))) return;
  // It was taken when it is answered; the session's end is a second zero.
  port_->receive(now + 5 * kMs);
}

void Link::interrupt(DeviceFault fault, std::int64_t now_ns) {
  reading_.interrupt(fault, now_ns);
  force_ramp_.shut(now_ns);
  echo_.disturb(now_ns);
  held_over_ = ~0U;
  reading_.buttons = 0;
  mailbox_.readings.write(reading_);
}

void Link::setState(LinkState state, std::int64_t now_ns) {
  if (std::exchange(status_.state, state) == state) return;
  if (state == LinkState::ready) force_ramp_.shut(now_ns);
  published_ns_ = 0;  // At once.
}

void Link::publishStatus() {
  published_ns_ = service_.now();
  mailbox_.status.write(status_);
}

}  // namespace relievo::haply
