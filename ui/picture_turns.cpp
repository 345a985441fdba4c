// SPDX-License-Identifier: BSD-3-Clause
#include "ui/picture_turns.h"

#include <utility>

namespace relievo {

void PictureTurns::ask(QObject* who, std::function<void()> draw) {
  turns_.push_back({who, std::move(draw)});
  if (!next_.isActive()) next_.start(0, this);
}

// The timer may come in the same round as what asked, or as the painting of the picture before.
void PictureTurns::timerEvent(QTimerEvent* /*event*/) {
  rested_ = !rested_;
  if (rested_) return;
  while (!turns_.empty()) {
    const Turn turn = std::move(turns_.front());
    turns_.pop_front();
    if (!turn.who) continue;
    turn.draw();
    break;
  }
  if (turns_.empty()) next_.stop();
}

}  // namespace relievo
