// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/sound/sound_control.h"

#include <algorithm>
#include <QAction>
#include <QSignalBlocker>
#include <utility>

namespace relievo {

namespace {
// A server that is there answers in milliseconds; one that is stopped never does.
constexpr qint64 kMostOpeningMs = 5000;
}  // namespace

SoundControl::SoundControl(TouchParts& parts, HandDevice& device, OpenOut open, qint64 retry_ms)
    : parts_(parts), device_(device), open_(std::move(open)), retry_ms_(retry_ms) {
  const TouchActions& actions = parts_.actions;
  connect(actions.sound, &QAction::toggled, this, &SoundControl::setOn);
  connect(actions.louder, &QAction::triggered, this, [this] { changeVolume(kVolumeStep); });
  connect(actions.quieter, &QAction::triggered, this, [this] { changeVolume(-kVolumeStep); });
  connect(&device_, &HandDevice::leaving, this, &SoundControl::leave);
  connect(&device_, &HandDevice::changed, this, &SoundControl::begin);
}

SoundControl::~SoundControl() {
  leave();
}

void SoundControl::leave() {
  out_.reset();  // On return nobody asks for frames.
  if (live_ && device_.session()) device_.session()->loop().listen(false);
  live_.reset();
}

void SoundControl::begin() {
  if (!is_refused_) open();
}

void SoundControl::open() {
  LoopSession* const session = device_.session();
  if (!parts_.settings.sound.on || out_ || session == nullptr) return;
  live_ = std::make_unique<sound::LiveSound>(session->loop().heard());
  live_->setVolume(parts_.settings.sound.volume_percent);
  if (window_.id != 0) live_->setWindow(window_);
  session->loop().listen(true);
  opening_.start();
  out_ = open_([live = live_.get()](std::span<sound::Frame> frames) { live->render(frames); });
}

void SoundControl::watch() {
  if (live_) live_->setSpeech(parts_.host.messages.isSpeaking());
  if (!out_ && is_refused_ && refused_.elapsed() >= retry_ms_) open();
  if (!out_) return;
  const sound::SoundOut::State state = out_->state();
  if (state == sound::SoundOut::State::playing && std::exchange(is_refused_, false)) {
    parts_.host.messages.announce(tr("Sounds of touch on."), SaidBecause::noticed);
  }
  const bool is_mute =
      state == sound::SoundOut::State::opening && opening_.elapsed() > kMostOpeningMs;
  if (state != sound::SoundOut::State::gone && !is_mute) return;
  const QString why =
      is_mute ? tr("the sound server does not answer") : QString::fromStdString(out_->problem());
  leave();
  refused_.start();
  if (std::exchange(is_refused_, true)) return;
  parts_.host.messages.announce(
      tr("There is no sound: %1. Touch goes on without it. Switch the sounds off and on to try "
         "again.")
          .arg(why),
      SaidBecause::noticed);
}

void SoundControl::setOn(bool on) {
  if (on == parts_.settings.sound.on) return;
  parts_.settings.sound.on = on;
  parts_.showSettings();
  applySettings(Tell::yes);
}

void SoundControl::changeVolume(int percent) {
  int& volume = parts_.settings.sound.volume_percent;
  volume = std::clamp(volume + percent, 0, 100);
  parts_.showSettings();
  applySettings(Tell::yes);
  parts_.host.messages.announce(tr("Sounds of touch at %1 percent.").arg(volume));
}

void SoundControl::applySettings(Tell tell) {
  const SoundSettings& requested = parts_.settings.sound;
  QAction* const action = parts_.actions.sound;
  const bool was_on = action->isChecked();
  if (was_on != requested.on) {
    const QSignalBlocker blocker(action);
    action->setChecked(requested.on);
  }
  if (live_) live_->setVolume(requested.volume_percent);
  if (requested.on == is_on_) return;
  is_on_ = requested.on;
  is_refused_ = false;
  if (tell == Tell::yes) {
    parts_.host.messages.announce(requested.on ? tr("Sounds of touch on.")
                                               : tr("Sounds of touch off."));
  }
  if (requested.on) {
    begin();
  } else {
    leave();
  }
}

void SoundControl::takeWindow(const RegionWindow& window) {
  const double gain = window.gain != 0 ? window.gain : 1;
  const sound::ToneHeights here{window.min_mm / gain, window.max_mm / gain};
  // The object's heights are those of the largest window of it that was under the hand. At the
  // first detail a window is of the whole object, perhaps of another one.
  const bool is_whole = window.levels - window.region.level.value <= 1;
  const bool is_part = window_.id != 0 && !is_whole && window.region.side_mm < heights_side_mm_;
  if (!is_part) heights_side_mm_ = window.region.side_mm;
  window_ = {.id = window.id,
             .region = window.region,
             .gain = gain,
             .heights = is_part ? window_.heights : here};
  if (live_) live_->setWindow(window_);
}

void SoundControl::strike(sound::Earcon earcon) {
  if (live_) live_->strike(earcon);
}

}  // namespace relievo
