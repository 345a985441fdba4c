// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <QElapsedTimer>
#include <QObject>

#include "core/region/region_window.h"
#include "haptics/sound/live_sound.h"
#include "haptics/sound/sound_out.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/touch_parts.h"

namespace relievo {

/// The sounds of a touch while it goes on: on, off and how loud, for menu, keys and panel, and what
/// is said of it. Where no sound server is, everything else goes on. All calls: GUI thread.
class SoundControl : public QObject {
  Q_OBJECT
 public:
  using OpenOut = std::function<std::unique_ptr<sound::SoundOut>(sound::RenderFrames)>;
  /// Where sound has gone, it is tried again so often, without a word until it is back.
  static constexpr qint64 kRetryMs = 5000;
  SoundControl(TouchParts& parts, HandDevice& device, OpenOut open = sound::openSoundServer,
               qint64 retry_ms = kRetryMs);
  ~SoundControl() override;

  /// After a change of the settings.
  enum class Tell : bool { no, yes };
  void applySettings(Tell tell);
  /// Another window comes under the hand.
  void takeWindow(const RegionWindow& window);
  /// The hand's session is about to end, or is another one.
  void leave();
  void begin();
  /// Something was done, as a note was written.
  void strike(sound::Earcon earcon);
  /// Says what became of the sound server, and tries one that was not there again. Once a frame.
  void watch();
  bool isPlaying() const { return out_ && out_->state() == sound::SoundOut::State::playing; }

 private:
  void open();
  void setOn(bool on);
  void changeVolume(int percent);

  TouchParts& parts_;
  HandDevice& device_;
  OpenOut open_;
  sound::HeardWindow window_;  // Under the hand; id 0: none yet.
  std::unique_ptr<sound::LiveSound> live_;
  std::unique_ptr<sound::SoundOut> out_;  // After live_, which it asks.
  qint64 retry_ms_;
  QElapsedTimer opening_, refused_;
  double heights_side_mm_ = 0;  // Of the window whose heights are taken for the object's.
  bool is_on_ = false;          // As was said last.
  bool is_refused_ = false;     // There was no server, and that was said; it is tried again.
};

}  // namespace relievo
