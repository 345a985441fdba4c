// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/sound/recorded_sound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "core/base/failure.h"
#include "core/recording/log_table.h"
#include "core/region/window.h"
#include "haptics/device/device.h"
#include "haptics/record/events.h"
#include "haptics/sound/touch_mixer.h"

namespace relievo::sound {
namespace {

constexpr double kTailS = 0.2;  // So that what is struck at the end is heard to its end.
constexpr std::size_t kFramesAtOnce = 4800;

NumberArgument plain(double value) {
  return {.value = value, .digits = 3, .form = NumberArgument::Form::trimmed};
}

/// Is it something that went wrong? The words are those of haptics/record/events.h.
bool tellsAProblem(std::string_view event) {
  constexpr std::array<std::string_view, 3> kProblems{"E306: update rate", "the window is silent",
                                                      "softened against swinging"};
  const auto has = [event](std::string_view words) {
    return event.find(words) != std::string_view::npos;
  };
  if (std::any_of(kProblems.begin(), kProblems.end(), has)) return true;
  using enum DeviceFault;
  constexpr std::array kFaults{timeout, disconnected, protocol, overheated, not_finite, not_ready};
  return std::any_of(kFaults.begin(), kFaults.end(),
                     [&](DeviceFault fault) { return has(describe(fault)); });
}

bool tells(std::string_view event, std::string_view words) {
  return event.find(words) != std::string_view::npos;
}

/// Whether the hand is led, by the events up to a time.
class Led {
 public:
  explicit Led(const TouchRecording& recording)
      : next_(recording.events.begin()), end_(recording.events.end()) {}
  bool at(double t_s) {
    for (; next_ != end_ && next_->t_s <= t_s; ++next_) {
      if (next_->is_note) continue;
      if (tells(next_->text, kLedEvent)) is_led_ = true;
      if (tells(next_->text, kLetGoEvent)) is_led_ = false;
    }
    return is_led_;
  }

 private:
  decltype(TouchRecording::events)::const_iterator next_, end_;
  bool is_led_ = false;
};

/// Windows by the row, which mostly has the one of the row before.
class Windows {
 public:
  explicit Windows(const TouchRecording& recording) : recording_(recording) {}
  const TouchedWindow* of(const TouchRow& row) {
    if (!is_known_ || row.window_id != id_) {
      window_ = windowOf(recording_, row);
      // Of a state that has no view nothing can be measured.
      if (window_ != nullptr && !(window_->region.side_mm > 0)) window_ = nullptr;
      // One that was placed for the eye has edges that nobody met.
      if (window_ != nullptr && !window_->known) window_ = nullptr;
      id_ = row.window_id;
      is_known_ = true;
    }
    return window_;
  }

 private:
  const TouchRecording& recording_;
  const TouchedWindow* window_ = nullptr;
  std::uint64_t id_ = 0;
  bool is_known_ = false;
};

double gainOf(const TouchedWindow* window) {
  return window == nullptr ? 1 : window->gain;
}

/// Renders and gives away part by part.
class Sink {
 public:
  Sink(TouchMixer& mixer, const std::function<void(std::span<const Frame>)>& take, const Task& task)
      : mixer_(mixer), take_(take), task_(task), frames_(kFramesAtOnce) {}

  void renderTo(std::uint64_t frame) {
    while (done_ < frame) {
      const std::size_t count = std::min<std::uint64_t>(kFramesAtOnce, frame - done_);
      const std::span<Frame> part(frames_.data(), count);
      task_.check();
      mixer_.render(part);
      for (const Frame& f : part) {
        peak_ = std::max({peak_, std::abs(double{f.left}), std::abs(double{f.right})});
      }
      take_(part);
      done_ += count;
    }
  }
  double peak() const { return peak_; }

 private:
  TouchMixer& mixer_;
  const std::function<void(std::span<const Frame>)>& take_;
  const Task& task_;
  std::vector<Frame> frames_;
  std::uint64_t done_ = 0;
  double peak_ = 0;
};

}  // namespace

RecordedSound::RecordedSound(const TouchRecording& recording, const SoundRequest& request)
    : recording_(recording), request_(request) {
  if (recording.rows.empty()) throw noRecording(recording.name);
  const double length_s = recording.endS() - recording.startS();
  from_s_ = std::max(0.0, request.from_s.value_or(0));
  to_s_ = std::min(length_s, request.to_s.value_or(length_s));
  if (!(to_s_ >= from_s_)) {
    throw failure<MessageId::video_beyond_recording>(
        plain(request.from_s.value_or(0)), plain(request.to_s.value_or(length_s)), plain(length_s));
  }
  const double frames = std::ceil(((to_s_ - from_s_) / request.speed + kTailS) * kSampleRateHz);
  constexpr double kMost = 9e15;  // Beyond any file; what can be written is the writer's limit.
  frames_ = static_cast<std::uint64_t>(std::min(frames, kMost));

  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ToneHeights touched{kInfinity, -kInfinity};
  double left = kInfinity, right = -kInfinity;
  bool has_hand = false, has_windows = true;
  Windows windows(recording);
  Led led(recording);
  for (const TouchRow& row : recording.rows) {
    const TouchedWindow* const window = windows.of(row);
    has_hand = has_hand || row.hand_hip != DeviceMm{};
    has_windows = has_windows && window != nullptr;
    if (!led.at(row.t_s) && !row.contact) continue;
    const double height_mm = row.proxy.z / gainOf(window);
    touched = {std::min(touched.low_mm, height_mm), std::max(touched.high_mm, height_mm)};
    left = std::min(left, row.proxy.x);
    right = std::max(right, row.proxy.x);
  }
  // Earlier builds did not write the hand; a window tells how large the object was in it.
  if (!has_hand && !has_windows) throw withoutColumn(recording.name, "dev_hip_x_mm");
  tells_hand_ = has_hand;
  if (left <= right) {
    heights_ = touched;
    left_mm_ = left;
    right_mm_ = right;
  }
  if (request.heights) heights_ = *request.heights;
}

TouchSample RecordedSound::sampleOf(const TouchRow& row, const TouchedWindow* window) const {
  TouchSample sample = touchSampleOf(row, {.region = window == nullptr ? nullptr : &window->region,
                                           .gain = gainOf(window),
                                           .heights = heights_,
                                           .left_mm = left_mm_,
                                           .right_mm = right_mm_});
  if (window != nullptr && !tells_hand_) {
    const double scale = kHandWidthMm / window->region.side_mm;
    sample.hand = {scale * row.hip.x, scale * row.hip.y, scale * row.hip.z};
    sample.proxy = {scale * row.proxy.x, scale * row.proxy.y, scale * row.proxy.z};
  }
  return sample;
}

RecordedSound::Summary RecordedSound::render(
    const std::function<void(std::span<const Frame>)>& take, const Task& task) const {
  Summary summary;
  // Rows that stand farther apart are not missing.
  TouchMixer mixer(request_.synth, TouchMixer::kHoldS / request_.speed);
  Sink sink(mixer, take, task);
  const double start_s = recording_.startS() + from_s_;
  const auto frame_at = [&](double t_s) {
    return static_cast<std::int64_t>(
        std::llround((t_s - start_s) / request_.speed * kSampleRateHz));
  };
  const auto render_to = [&](std::int64_t frame) {
    sink.renderTo(static_cast<std::uint64_t>(std::max<std::int64_t>(0, frame)));
  };
  auto event = recording_.events.begin();
  Windows windows(recording_);
  Led led(recording_);
  for (const TouchRow& row : recording_.rows) {
    // A thousandth of a millisecond's grace: times are sums of floating-point steps.
    if (row.t_s > recording_.startS() + to_s_ + 1e-6) break;
    const bool is_in = row.t_s >= start_s - 1e-6;
    const std::int64_t frame = frame_at(row.t_s);
    if (is_in) render_to(frame);
    // Earlier events strike nothing; sounds that last are heard from the start.
    TouchSample sample = sampleOf(row, windows.of(row));
    sample.led = led.at(row.t_s);
    const Heard heard = mixer.place(
        sample, frame, is_in ? TouchMixer::Happenings::heard : TouchMixer::Happenings::unheard);
    for (std::size_t i = 0; i < heard.count; ++i) {
      ++summary.struck[static_cast<std::size_t>(heard.struck[i].earcon)];
    }
    for (; event != recording_.events.end() && event->t_s <= row.t_s; ++event) {
      const bool is_problem = !event->is_note && tellsAProblem(event->text);
      const bool is_corner = !event->is_note && tells(event->text, kCornerEvent);
      if (!is_in || (!event->is_note && !is_problem && !is_corner)) continue;
      const Earcon earcon = is_problem  ? Earcon::problem
                            : is_corner ? Earcon::corner
                                        : Earcon::done;
      mixer.strike(earcon);
      ++summary.struck[static_cast<std::size_t>(earcon)];
    }
  }
  // Nothing sounds on because the recording has ended.
  render_to(frame_at(recording_.startS() + to_s_));
  mixer.fallSilent();
  sink.renderTo(frames_);
  summary.peak = sink.peak();
  return summary;
}

}  // namespace relievo::sound
