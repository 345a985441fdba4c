// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/events.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

namespace relievo {

namespace {
class Events {
 public:
  void add(const std::string& text) {
    if (!text_.empty()) text_ += "; ";
    text_ += text;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string numberText(double value, int digits) {
  std::array<char, 40> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                          std::chars_format::fixed, digits);
  return error == std::errc() ? std::string(text.data(), end) : std::string("?");
}

std::string_view phaseText(EngagePhase phase) {
  switch (phase) {
    case EngagePhase::off:
      return "forces off";
    case EngagePhase::waiting:
      return "forces wait for a clear hand";
    case EngagePhase::rising:
      return "forces rise";
    case EngagePhase::on:
      return "forces on";
  }
  return "forces unknown";
}

std::string_view guideEndText(GuideEnd end) {
  switch (end) {
    case GuideEnd::none:
      break;
    case GuideEnd::arrived:
      return "it has arrived";
    case GuideEnd::you_lead:
      return "the hand leads";
    case GuideEnd::button:
      return "a button";
    case GuideEnd::asked:
      return "it was asked to";
    case GuideEnd::no_forces:
      return "there are no forces";
    case GuideEnd::surface:
      return "another surface";
  }
  return "it leads still";
}

std::string windowText(const HapticSample& sample) {
  return "window " + std::to_string(sample.window_id) + " of detail " +
         std::to_string(sample.detail);
}

std::string stiffnessText(const HapticSample& sample) {
  return "stiffness " + numberText(1000 * sample.firm_stiffness_n_per_mm, 0) + " N/m";
}

void addButtons(Events& events, std::uint32_t before, std::uint32_t now) {
  for (std::uint32_t i = 0; i < 32; ++i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    if (((before ^ now) & bit) == 0) continue;
    if (bit == kHoverBit) {
      events.add((now & bit) != 0 ? "the hand is lifted" : "the hand is put down");
      continue;
    }
    events.add("button " + std::to_string(i) + ((now & bit) != 0 ? " down" : " up"));
  }
}

template <std::size_t Edges>
void addBins(std::string& to, const char* what, const std::array<std::int64_t, Edges>& edges,
             const std::array<std::uint64_t, Edges + 1>& counts) {
  to.append(what);
  for (std::size_t i = 0; i <= Edges; ++i) {
    to += i < Edges ? " <=" + numberText(1e-3 * static_cast<double>(edges[i]), 1) : " more";
    to += ":" + std::to_string(counts[i]);
  }
  to += '\n';
}
}  // namespace

std::string eventBetween(const HapticSample& before, const HapticSample& now) {
  Events events;
  if (now.tick != before.tick + 1) {
    events.add(std::to_string(now.tick - before.tick - 1) + " samples dropped before this one");
  }
  if (now.resumed) {
    const double ms = 1e-6 * static_cast<double>(now.time_ns - before.time_ns);
    events.add("resumed after " + numberText(ms, 1) + " ms");
  }
  if (now.window_id != before.window_id) events.add("new window: " + windowText(now));
  if (now.fault != before.fault) events.add(std::string(describe(now.fault)));
  if (now.engaged != before.engaged) events.add(std::string(phaseText(now.engaged)));
  if (now.stopped != before.stopped && now.stopped != StopReason::none) {
    events.add(now.stopped == StopReason::held ? "stopped by a held button"
                                               : "the window is silent: forces fade out");
  }
  if (now.guide_path != before.guide_path && now.guide_path != 0) {
    events.add(std::string(kLedEvent));
  }
  if (now.guide == GuidePhase::pausing && before.guide != GuidePhase::pausing) {
    events.add(std::string(kCornerEvent));
  }
  const bool let_go = now.guide == GuidePhase::off && now.guide_end != GuideEnd::none;
  if (let_go && (before.guide != GuidePhase::off || now.guide_path != before.guide_path)) {
    events.add(std::string(kLetGoEvent) + ": " + std::string(guideEndText(now.guide_end)));
  }
  if (now.pulled_back && now.beacon != before.beacon) events.add("a marker pulls the hand");
  if (before.pulled_back && !now.pulled_back) {
    events.add("the marker lets go: " + std::string(guideEndText(now.beacon_end)));
  }
  if (now.tapped && now.taps != before.taps) events.add("a pattern of taps");
  const bool slow = now.slow.rate_hz > 0, was_slow = before.slow.rate_hz > 0;
  if (slow && !was_slow) {
    events.add("E306: update rate " + numberText(now.slow.rate_hz, 0) + " per second; stiffness " +
               numberText(1000 * now.slow.held_n_per_mm, 0) + " instead of " +
               numberText(1000 * now.slow.asked_n_per_mm, 0) + " N/m");
  }
  if (was_slow && !slow) events.add("stiffness is no longer bound by the update rate");
  if (now.softened > before.softened) events.add("softened against swinging");
  if (now.firm_stiffness_n_per_mm != before.firm_stiffness_n_per_mm) {
    events.add(stiffnessText(now));
  }
  addButtons(events, before.buttons, now.buttons);
  return events.take();
}

std::string eventAtStart(const HapticSample& first) {
  return windowText(first) + "; " + stiffnessText(first) + "; " +
         std::string(phaseText(first.engaged)) +
         (first.guide != GuidePhase::off ? "; " + std::string(kLedEvent) : std::string());
}

std::string loopLines(const LoopStats& stats) {
  const ForceAudit& audit = stats.audit;
  std::string lines =
      "loop ticks " + std::to_string(stats.ticks) + ", late " + std::to_string(stats.late_ticks) +
      ", pauses " + std::to_string(stats.pauses) + ", watchdog cuts " +
      std::to_string(stats.watchdog_cuts) + ", rate " + numberText(stats.rate_hz, 1) +
      " Hz, longest period " + numberText(stats.worst_period_ms, 2) + " ms, page faults " +
      std::to_string(stats.page_faults) + " in " + std::to_string(stats.faulty_ticks) + " ticks\n";
  lines += "audit zero demanded " + std::to_string(audit.zero_demanded) + ", zero violations " +
           std::to_string(audit.zero_violations) + ", limit violations " +
           std::to_string(audit.limit_violations) + ", step violations " +
           std::to_string(audit.step_violations) + ", fast falls " +
           std::to_string(audit.fast_falls) + "\n";
  addBins(lines, "wake-up us", LoopStats::kDelayEdgesNs, stats.delays);
  addBins(lines, "work us", LoopStats::kWorkEdgesNs, stats.work);
  return lines;
}

std::string sampleLines(std::span<const HapticSample> samples) {
  std::array<std::uint64_t, LoopStats::kDelayEdgesNs.size() + 1> gaps{};
  std::array<std::uint64_t, LoopStats::kWorkEdgesNs.size() + 1> work{};
  const auto count = [](auto& bins, const auto& edges, std::int64_t ns) {
    ++bins[static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), ns) -
                                    edges.begin())];
  };
  std::uint64_t late = 0, pauses = 0;
  constexpr std::int64_t kPeriodNs = 1'000'000;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    late += samples[i].late ? 1 : 0;
    pauses += samples[i].resumed ? 1 : 0;
    count(work, LoopStats::kWorkEdgesNs, samples[i].tick_ns);
    if (i > 0) {
      const std::int64_t period = samples[i].time_ns - samples[i - 1].time_ns;
      count(gaps, LoopStats::kDelayEdgesNs, std::max<std::int64_t>(0, period - kPeriodNs));
    }
  }
  const double seconds = 1e-9 * static_cast<double>(samples.back().time_ns - samples[0].time_ns);
  const double rate = seconds > 0 ? static_cast<double>(samples.size() - 1) / seconds : 0;
  std::string lines = "loop ticks " + std::to_string(samples.size()) + ", late " +
                      std::to_string(late) + ", pauses " + std::to_string(pauses) + ", rate " +
                      numberText(rate, 1) + " Hz\n";
  addBins(lines, "beyond the period us", LoopStats::kDelayEdgesNs, gaps);
  addBins(lines, "work us", LoopStats::kWorkEdgesNs, work);
  return lines;
}

}  // namespace relievo
