// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <QString>
#include <utility>
#include <vector>

#include "core/base/vec3.h"
#include "core/message/message.h"
#include "plugins/api/host.h"

namespace relievo {

/// Something to say: sentences of the catalogue, in whatever language the voice has when it says
/// them, or a text, which has its own.
struct Speech {
  std::vector<Message> sentences;
  QString text;
};

/// When what is said: what was asked for at once, in place of everything else; what was noticed
/// when the hand has rested for as long as people pause, the newest of it alone, and never in the
/// middle of something else. No clock: time is an argument.
class SpeechQueue {
 public:
  static constexpr double kRestS = 0.8;     ///< Stops while exploring last 0.07 to 0.33 s.
  static constexpr double kRestMmPerS = 5;  ///< Slower is at rest, mm of hand.
  static constexpr double kSpanS = 0.2;     ///< Over this long: a hand that trembles rests.

  void say(Speech speech, SaidBecause why);
  /// Nothing that waits is said any more.
  void hush();
  void hand(const DeviceMm& position, double now_s);
  /// What is to be said now, if anything. @param speaking  something is being said
  std::optional<Speech> take(double now_s, bool speaking);
  /// Another said it at once: it is what was said last.
  void saidElsewhere(Speech speech) { last_ = std::move(speech); }
  /// What was said last; nothing: nothing was.
  const std::optional<Speech>& last() const { return last_; }

 private:
  struct Felt {
    DeviceMm at;
    double s = 0;
  };

  std::optional<Speech> asked_, noticed_, last_;
  std::deque<Felt> felt_;  // The first is as old as the span, once there are such.
  double rests_since_s_ = 0;
};

}  // namespace relievo
